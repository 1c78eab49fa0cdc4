//! What an index stands at, and which elements of a mesh it runs over.

use super::Checker;
use super::scope::Found;
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, Kind};
use crate::resolve::{Meaning, ModuleId};
use crate::syntax::ast::{
    Condition, ConditionKind, Definition, Expr, ExprKind, Head, Name, NormSubscript, Subscript,
};
use crate::types::display::plural;
use crate::types::{Atom, Dimension, Element, Type};

impl<'a> Checker<'a> {
    /// The elements of a mesh that an index runs over: those that index what it stands alone at as a subscript, or that a
    /// function takes there. A size that is the number of elements, as in `ℝ^(#V)`, is counted through where the index
    /// is used as a number.
    pub(super) fn element_index(
        &mut self,
        index: &Name,
        of: &[&'a Expr],
        conditions: &[&'a Condition],
        left: Option<Element>,
    ) -> Option<Element> {
        let mut bases: Vec<(&'a Name, usize)> = Vec::new();
        for e in of {
            subscripted(e, &index.text, &mut bases);
        }
        for condition in conditions {
            condition_parts(condition, &mut |e| {
                subscripted(e, &index.text, &mut bases);
            });
        }
        let mut counted = left;
        for (name, position) in bases {
            let value = match self.find(name) {
                Found::Value(value) => value,
                Found::Functions(meanings) => match self.element_taken(&meanings, position) {
                    None => continue,
                    element => return element,
                },
                _ => continue,
            };
            match (self.ty(value), position) {
                (Type::Sequence { index, .. }, 0) if index.is_some() => return *index,
                (
                    Type::Matrix {
                        spaces: Some((rows, columns)),
                        ..
                    },
                    _,
                ) => return Some(if position == 0 { *rows } else { *columns }),
                (ty, _) => counted = counted.or(counted_through(ty, position)),
            }
        }
        let text = &index.text;
        let counts = of.iter().any(|e| is_number_in(e, text))
            || conditions.iter().any(|c| is_number_in_condition(c, text));
        counted.filter(|_| !counts)
    }

    /// The elements that a function takes as one of its arguments; nothing where there are several such functions.
    fn element_taken(
        &mut self,
        meanings: &[(ModuleId, Meaning)],
        position: usize,
    ) -> Option<Element> {
        let [(module, Meaning::Functions(items))] = meanings else {
            return None;
        };
        let [item] = items.as_slice() else {
            return None;
        };
        let signature = self.signature(*module, *item)?;
        match signature.parameters.get(position)? {
            Type::Element(element) => Some(*element),
            _ => None,
        }
    }

    /// The number of elements of a kind, as a dimension and as a value: the range of an index over all of them.
    pub(super) fn count(&mut self, element: Element) -> (Dimension, ExprId) {
        let dimension = Dimension::atom(Atom::Count(element));
        let size = self.add(Kind::Size(dimension.clone()), Type::INTEGER);
        (dimension, size)
    }

    /// Whether an axis of what is defined has an entry for each of the elements that index it.
    pub(super) fn is_counted_by(
        &mut self,
        ty: &Type,
        axis: usize,
        element: Element,
        index: &Name,
    ) -> bool {
        let size = match (ty, axis) {
            (Type::Vector { length, .. }, _) => length,
            (Type::Matrix { rows, .. }, 0) => rows,
            (Type::Matrix { columns, .. }, _) => columns,
            (Type::Sequence { length, .. }, _)
                if matches!(length.as_atom(), Some(Atom::Count(_))) =>
            {
                length
            }
            _ => return true,
        };
        if *size == Dimension::atom(Atom::Count(element)) {
            return true;
        }
        let kinds = plural(element.kind);
        let (what, help) = match ty {
            Type::Sequence { .. } => (
                "items",
                format!(
                    "a sequence over the {kinds} is declared `y : V → …` with the set `V` of all of them"
                ),
            ),
            _ => (
                "entries",
                format!(
                    "a size that is the number of {kinds} is written `#V` with the set `V` of all of them"
                ),
            ),
        };
        let described = Type::Element(element).described();
        let message = format!("`{}` is {described} and indexes {size} {what}", index.text);
        self.report(Diagnostic::error(index.span, message).help(help));
        false
    }
}

/// The elements that a size of a vector or matrix, or the length of a sequence, is the number of.
pub(super) fn counted_through(ty: &Type, axis: usize) -> Option<Element> {
    let size = match (ty, axis) {
        (Type::Vector { length, .. }, 0) => length,
        (Type::Matrix { rows, .. }, 0) => rows,
        (Type::Matrix { columns, .. }, 1) => columns,
        (Type::Sequence { length, .. }, 0) => length,
        _ => return None,
    };
    match size.as_atom() {
        Some(Atom::Count(element)) => Some(*element),
        _ => None,
    }
}

/// Adds the names in an expression that have the index alone as a subscript, each with the position of that subscript.
pub(super) fn subscripted<'a>(e: &'a Expr, index: &str, found: &mut Vec<(&'a Name, usize)>) {
    if let ExprKind::Subscript { base, subscripts } = &e.kind
        && let ExprKind::Name(name) = &base.kind
    {
        for (position, subscript) in subscripts.iter().enumerate() {
            if let Subscript::Expr(e) = subscript
                && matches!(&e.kind, ExprKind::Name(name) if name.text == index)
            {
                found.push((name, position));
            }
        }
    }
    if let ExprKind::Call {
        function,
        subscripts,
        ..
    } = &e.kind
    {
        for (position, subscript) in subscripts.iter().enumerate() {
            if is_named(subscript, index) {
                found.push((function, position));
            }
        }
    }
    parts(e, index, &mut |part| subscripted(part, index, found));
}

fn is_named(e: &Expr, index: &str) -> bool {
    matches!(&e.kind, ExprKind::Name(name) if name.text == index)
}

/// Whether an index stands where a number stands, and not only alone as a subscript or an argument, in tuples, or beside
/// names in comparisons.
pub(super) fn is_number_in(e: &Expr, index: &str) -> bool {
    let number = |e: &Expr| is_number_in(e, index);
    let beside = |e: &Expr| !is_named(e, index) && is_number_in(e, index);
    match &e.kind {
        ExprKind::Name(name) => name.text == index,
        ExprKind::Subscript { base, subscripts } => {
            let subscript = |s: &Subscript| matches!(s, Subscript::Expr(e) if beside(e));
            number(base) || subscripts.iter().any(subscript)
        }
        ExprKind::Call {
            subscripts,
            arguments,
            ..
        } => subscripts.iter().chain(arguments).any(beside),
        ExprKind::Vector(items) | ExprKind::Set(items) => items.iter().any(beside),
        ExprKind::Piecewise {
            branches,
            otherwise,
        } => {
            let branch = |(value, condition): &(Expr, Condition)| {
                number(value) || is_number_in_condition(condition, index)
            };
            branches.iter().any(branch) || otherwise.iter().any(|e| number(e))
        }
        ExprKind::Big {
            head: Head::Filtered(name, condition),
            ..
        } if name.text != index && is_number_in_condition(condition, index) => true,
        ExprKind::Big {
            head: Head::Filtered(name, _),
            body,
            ..
        } if name.text != index => number(body),
        _ => {
            let mut found = false;
            parts(e, index, &mut |part| found |= is_number_in(part, index));
            found
        }
    }
}

/// Whether a condition compares an index with a number.
pub(super) fn is_number_in_condition(condition: &Condition, index: &str) -> bool {
    let beside = |e: &Expr| !is_named(e, index) && is_number_in(e, index);
    match &condition.kind {
        ConditionKind::And(a, b) | ConditionKind::Or(a, b) => {
            is_number_in_condition(a, index) || is_number_in_condition(b, index)
        }
        ConditionKind::Compare { left, right, .. } => {
            let is_element = |e: &Expr| {
                matches!(
                    e.kind,
                    ExprKind::Name(_) | ExprKind::Subscript { .. } | ExprKind::Call { .. }
                )
            };
            beside(left)
                || beside(right)
                || is_named(left, index) && !is_element(right)
                || is_named(right, index) && !is_element(left)
        }
        ConditionKind::Member { item, set, .. } => beside(item) || is_number_in(set, index),
        ConditionKind::Error => false,
    }
}

/// The expressions of a condition.
pub(super) fn condition_parts<'a>(condition: &'a Condition, visit: &mut dyn FnMut(&'a Expr)) {
    match &condition.kind {
        ConditionKind::And(a, b) | ConditionKind::Or(a, b) => {
            condition_parts(a, visit);
            condition_parts(b, visit);
        }
        ConditionKind::Compare { left, right, .. } => {
            visit(left);
            visit(right);
        }
        ConditionKind::Member { item, set, .. } => {
            visit(item);
            visit(set);
        }
        ConditionKind::Error => {}
    }
}

/// The expressions that an expression is made of, without those in which the index has another meaning.
fn parts<'a>(e: &'a Expr, index: &str, visit: &mut dyn FnMut(&'a Expr)) {
    let is_index = |name: &Name| name.text == index;
    match &e.kind {
        ExprKind::Subscript { base, subscripts } => {
            visit(base);
            for subscript in subscripts {
                if let Subscript::Expr(e) = subscript {
                    visit(e);
                }
            }
        }
        ExprKind::Call {
            subscripts,
            arguments,
            ..
        } => subscripts.iter().chain(arguments).for_each(visit),
        ExprKind::Unary { operand, .. } => visit(operand),
        ExprKind::Binary { left, right, .. } => {
            visit(left);
            visit(right);
        }
        ExprKind::Norm {
            operand, subscript, ..
        } => {
            visit(operand);
            if let Some(NormSubscript::Expr(e)) = subscript {
                visit(e);
            }
        }
        ExprKind::Inner {
            left,
            right,
            weight,
        } => {
            visit(left);
            visit(right);
            weight.iter().for_each(|e| visit(e));
        }
        ExprKind::Vector(items) | ExprKind::Set(items) => items.iter().for_each(visit),
        ExprKind::Matrix(rows) => rows.iter().flatten().for_each(visit),
        ExprKind::Builder {
            element,
            variables,
            range,
            condition,
        } => {
            visit(range);
            if !variables.iter().any(is_index) {
                visit(element);
                condition.iter().for_each(|c| condition_parts(c, visit));
            }
        }
        ExprKind::Big {
            head, body, locals, ..
        } => {
            let bound = match head {
                Head::Index(name) => is_index(name),
                Head::Filtered(name, condition) => {
                    let bound = is_index(name);
                    if !bound {
                        condition_parts(condition, visit);
                    }
                    bound
                }
                Head::Members(names, range) => {
                    visit(range);
                    names.iter().any(is_index)
                }
                Head::Range(name, from, to) => {
                    visit(from);
                    visit(to);
                    is_index(name)
                }
            };
            let hides = |d: &Definition| d.targets.iter().any(|t| is_index(&t.name));
            if !bound && !locals.iter().any(hides) {
                visit(body);
                locals.iter().for_each(|d| visit(&d.value));
            }
        }
        ExprKind::Piecewise {
            branches,
            otherwise,
        } => {
            for (value, condition) in branches {
                visit(value);
                condition_parts(condition, visit);
            }
            otherwise.iter().for_each(|e| visit(e));
        }
        ExprKind::NumberMatrix { rows, columns, .. } => {
            visit(rows);
            columns.iter().for_each(|e| visit(e));
        }
        _ => {}
    }
}
