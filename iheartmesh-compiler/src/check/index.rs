//! What an index stands at: the names that have it alone as a subscript.

use crate::syntax::ast::{
    Condition, ConditionKind, Definition, Expr, ExprKind, Head, Name, NormSubscript, Subscript,
};

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
