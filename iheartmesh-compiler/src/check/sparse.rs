//! Sparse matrices by conditions: `K_ij = { … if (i, j) ∈ P`, with `K` declared.
//!
//! Cells that no condition matches are 0. Where every condition has `(i, j) ∈ P`, `j ∈ S` or `i = j` in it, only these cells are
//! looked at; otherwise all cells are.

use super::Checker;
use super::index::counted_through;
use super::scope::{Binding, Scope};
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, Fold, InputId, Kind, Layout, Pairs, Range, SetOp, Unary, VariableId};
use crate::resolve::names::FreeNames;
use crate::syntax::ast::{self, CompareOp, Condition, ConditionKind, Expr, ExprKind, Name};
use crate::types::{Element, Type};

impl<'a> Checker<'a> {
    /// The cells of a matrix of a type with known sizes.
    pub(super) fn sparse_cells(
        &mut self,
        definition: &'a ast::Definition,
        names: [&'a Name; 2],
        branches: &'a [(Expr, Condition)],
        otherwise: Option<&'a Expr>,
        ty: &Type,
    ) -> ExprId {
        if let Some(value) = otherwise
            && !self.is_zero(value)
        {
            let name = &definition.targets[0].name.text;
            return self.report(
                Diagnostic::error(value.span, "cells of a sparse matrix that no condition matches are 0")
                    .label(definition.targets[0].name.span, format!("`{name}` is sparse, since it is declared"))
                    .help(format!(
                        "write `0 otherwise` or leave it out; without a declaration of `{name}` this is a dense matrix"
                    )),
            );
        }
        let values: Vec<&'a Expr> = branches.iter().map(|(value, _)| value).collect();
        let conditions: Vec<&'a Condition> = branches.iter().map(|(_, c)| c).collect();
        let elements = [0, 1].map(|axis| {
            let left = counted_through(ty, axis);
            self.element_index(names[axis], &values, &conditions, left)
        });
        let mut sets: Vec<ExprId> = Vec::new();
        for condition in conditions {
            let set = cells_of(condition, names);
            let Some(value) = set.and_then(|cells| self.pairs(cells, names, elements)) else {
                return self.all_cells(definition, names, branches, (ty, elements));
            };
            if self.is_error(value) {
                return value;
            }
            sets.push(value);
        }
        let first = self.ty(sets[0]).clone();
        let members = match &first {
            Type::Set(member) => match &**member {
                Type::Tuple(items) if items.len() == 2 => items.clone(),
                _ => Vec::new(),
            },
            _ => Vec::new(),
        };
        let index = |ty: &Type| *ty == Type::INTEGER || ty.is_element();
        if !members.iter().all(index)
            || members.is_empty()
            || sets.iter().any(|set| *self.ty(*set) != first)
        {
            // what does not fit is reported where it stands in a condition
            return self.all_cells(definition, names, branches, (ty, elements));
        }
        self.cells_of_pairs(definition, names, branches, (&sets, &members), ty)
    }

    fn is_zero(&mut self, value: &'a Expr) -> bool {
        matches!(&value.kind, ExprKind::Integer(0))
            || matches!(&value.kind, ExprKind::Real(value) if *value == 0.0)
    }

    /// The set of the pairs that a condition may hold for, in error where it has been reported; nothing where it is not
    /// known beforehand.
    fn pairs(
        &mut self,
        cells: Cells<'a>,
        names: [&'a Name; 2],
        elements: [Option<Element>; 2],
    ) -> Option<ExprId> {
        let (outer, set) = match cells {
            Cells::Pairs(set) => return Some(self.expr(set)),
            Cells::InRow(set) => (0, Some(set)),
            Cells::InColumn(set) => (1, Some(set)),
            Cells::Diagonal => (0, None),
        };
        // of numbers, those outside of the matrix do not count
        let element = elements[outer]?;
        let index = Type::Element(element);
        // all rows, or all columns
        let all = Type::set_of(index.clone());
        let range = Range::Set(self.add(Kind::AllElements(element), all));
        let mut scope = Scope::default();
        let variable = self.bind(&mut scope, names[outer], index.clone());
        let own = self.program.arena.variable(variable);
        let body = match set {
            None => {
                let pair = Type::Tuple(vec![index.clone(), index]);
                let both = self.add(Kind::Tuple(vec![own, own]), pair.clone());
                self.add(Kind::Set(vec![both]), Type::set_of(pair))
            }
            Some(set) => {
                let set = self.with_scope(scope, |checker| checker.expr(set));
                let other = match self.ty(set) {
                    Type::Set(member) => (**member).clone(),
                    _ => return Some(set),
                };
                let name = &names[1 - outer].text;
                let member = self.program.arena.new_variable(name, other.clone());
                let mut pair = [own, self.program.arena.variable(member)];
                let mut types = [index, other];
                if outer == 1 {
                    pair.reverse();
                    types.reverse();
                }
                let types = Type::Tuple(types.to_vec());
                let pair = self.add(Kind::Tuple(pair.to_vec()), types.clone());
                self.add(
                    Kind::Fold {
                        op: Fold::Collect,
                        variable: member,
                        range: Range::Set(set),
                        condition: None,
                        body: pair,
                    },
                    Type::set_of(types),
                )
            }
        };
        if self.is_error(body) {
            return Some(body);
        }
        let all = self.ty(body).clone();
        let kind = Kind::Fold {
            op: Fold::Union,
            variable,
            range,
            condition: None,
            body,
        };
        Some(self.add(kind, all))
    }

    /// The cells at the members of sets of pairs.
    fn cells_of_pairs(
        &mut self,
        definition: &'a ast::Definition,
        names: [&'a Name; 2],
        branches: &'a [(Expr, Condition)],
        (sets, members): (&[ExprId], &[Type]),
        ty: &Type,
    ) -> ExprId {
        let set_type = self.ty(sets[0]).clone();
        let mut set = sets[0];
        for other in &sets[1..] {
            if *other != set {
                set = self.add(Kind::SetOp(SetOp::Union, set, *other), set_type.clone());
            }
        }
        let member = Type::Tuple(members.to_vec());
        let text = format!("{}, {}", names[0].text, names[1].text);
        let variable = self.program.arena.new_variable(&text, member);
        let pair = self.program.arena.variable(variable);
        let mut scope = Scope::default();
        let mut place = Vec::new();
        let mut notes: Vec<VariableId> = Vec::new();
        for (k, name) in names.into_iter().enumerate() {
            let item = self.project(pair, k, members[k].clone());
            scope.names.insert(name.text.clone(), Binding::Value(item));
            scope.spans.insert(name.text.clone(), name.span);
            let note = self.program.arena.new_variable(&name.text, Type::INTEGER);
            self.note_left_index(note, name, ty, k);
            notes.push(note);
            place.push(match &members[k] {
                Type::Element(_) => self.add(Kind::Unary(Unary::ToInteger, item), Type::INTEGER),
                _ => {
                    self.index_items.insert(item, note);
                    item
                }
            });
        }
        let value = self.with_scope(scope, |checker| match branches {
            // all members of the set meet the only condition
            [
                (
                    value,
                    Condition {
                        kind: ConditionKind::Member { .. },
                        ..
                    },
                ),
            ] => {
                let value = checker.expr(value);
                checker.number_of_cell(definition, value)
            }
            _ => checker.cases(definition, branches),
        });
        let mut sizes = Vec::new();
        for ((name, note), member) in names.into_iter().zip(&notes).zip(members) {
            if self.is_error(value) {
                self.index_uses.remove(note);
                continue;
            }
            let Some((dimension, size)) = self.index_range(*note, name) else {
                return self.error();
            };
            if let Type::Element(element) = member
                && !self.is_counted_by(ty, sizes.len(), *element, name)
            {
                return self.error();
            }
            sizes.push((dimension, size));
        }
        let [(rows, n), (columns, m)] = sizes.as_slice() else {
            return self.error();
        };
        for set in sets {
            if let Some((input, first)) = self.input_of(*set)
                && members.iter().all(|ty| *ty == Type::INTEGER)
            {
                let pairs = Pairs {
                    matrix: definition.targets[0].name.text.clone(),
                    sizes: [rows.clone(), columns.clone()],
                    first,
                };
                let list = &mut self.program.inputs[input.0 as usize].pairs;
                if !list.contains(&pairs) {
                    list.push(pairs);
                }
            }
        }
        self.add_at(
            definition.span,
            Kind::Scatter {
                variable,
                set,
                sizes: [*n, *m],
                place: [place[0], place[1]],
                body: value,
            },
            Type::sparse_matrix(rows.clone(), columns.clone()),
        )
    }

    /// All cells, each tried with all conditions.
    fn all_cells(
        &mut self,
        definition: &'a ast::Definition,
        names: [&'a Name; 2],
        branches: &'a [(Expr, Condition)],
        (ty, elements): (&Type, [Option<Element>; 2]),
    ) -> ExprId {
        let mut scope = Scope::default();
        let mut variables = Vec::new();
        for (k, name) in names.into_iter().enumerate() {
            variables.push(match elements[k] {
                Some(element) => {
                    if !self.is_counted_by(ty, k, element, name) {
                        return self.error();
                    }
                    self.bind(&mut scope, name, Type::Element(element))
                }
                None => {
                    let variable = self.bind_index(&mut scope, name);
                    self.note_left_index(variable, name, ty, k);
                    variable
                }
            });
        }
        let body = self.with_scope(scope, |checker| checker.cases(definition, branches));
        let mut ranges = Vec::new();
        for ((variable, name), element) in variables.iter().zip(names).zip(elements) {
            if self.is_error(body) {
                self.index_uses.remove(variable);
                continue;
            }
            if let Some(element) = element {
                ranges.push(self.count(element));
                continue;
            }
            ranges.extend(self.index_range(*variable, name));
        }
        let [(rows, n), (columns, m)] = ranges.as_slice() else {
            return self.error();
        };
        self.add_at(
            definition.span,
            Kind::Tabulate {
                layout: Layout::Sparse,
                variables,
                sizes: vec![*n, *m],
                body,
            },
            Type::sparse_matrix(rows.clone(), columns.clone()),
        )
    }

    /// The value of the first case whose condition holds, and 0 where there is none.
    fn cases(
        &mut self,
        definition: &'a ast::Definition,
        branches: &'a [(Expr, Condition)],
    ) -> ExprId {
        let mut cases = Vec::new();
        let outer = std::mem::replace(&mut self.guarded, true);
        for (value, condition) in branches {
            let condition = self.condition(condition);
            let value = self.expr(value);
            cases.push((condition, self.number_of_cell(definition, value)));
        }
        self.guarded = outer;
        let mut all = self.program.arena.real(0.0);
        for (condition, value) in cases.into_iter().rev() {
            if self.is_error(value) {
                return value;
            }
            all = self.add(Kind::If(condition, value, all), Type::REAL);
        }
        all
    }

    /// A number as the value of a cell.
    fn number_of_cell(&mut self, definition: &'a ast::Definition, value: ExprId) -> ExprId {
        let ty = self.ty(value).clone();
        if ty.is_error() || ty.is_scalar() {
            return self.real(value);
        }
        let (name, ty) = (&definition.targets[0].name, ty.described());
        let message = format!("`{}` cannot be defined entry by entry by {ty}", name.text);
        self.report(
            Diagnostic::error(name.span, message)
                .label(definition.value.span, format!("this has {ty} in it"))
                .help("the entries of a matrix are numbers"),
        )
    }

    /// The parameter that a set is, and what the host calls the first row in it.
    pub(super) fn input_of(&self, set: ExprId) -> Option<(InputId, i64)> {
        match self.program.arena.kind(set) {
            Kind::Input(input) => Some((*input, 1)),
            Kind::Unary(Unary::FromHost, of) => Some((self.input_of(*of)?.0, 0)),
            Kind::Global(global) => self.input_of(self.program.global(*global).value),
            _ => None,
        }
    }
}

/// Which cells a condition may hold for.
#[derive(Clone, Copy)]
enum Cells<'a> {
    /// `(i, j) ∈ P`.
    Pairs(&'a Expr),
    /// `j ∈ S`, where `S` may depend on `i`.
    InRow(&'a Expr),
    /// `i ∈ S`, where `S` may depend on `j`.
    InColumn(&'a Expr),
    /// `i = j`.
    Diagonal,
}

/// The cells that a condition, alone or joined to others by `and`, may hold for, where it says so by a set.
fn cells_of<'a>(condition: &'a Condition, names: [&Name; 2]) -> Option<Cells<'a>> {
    let is = |e: &Expr, k: usize| matches!(&e.kind, ExprKind::Name(n) if n.text == names[k].text);
    let is_free_of = |set: &Expr, k: usize| {
        let mut free = true;
        let mut found = |name: &Name| free &= name.text != names[k].text;
        FreeNames::new(Vec::new(), &mut found).expr(set);
        free
    };
    match &condition.kind {
        ConditionKind::And(a, b) => cells_of(a, names).or_else(|| cells_of(b, names)),
        ConditionKind::Compare {
            op: CompareOp::Equal,
            left,
            right,
        } if is(left, 0) && is(right, 1) || is(left, 1) && is(right, 0) => Some(Cells::Diagonal),
        ConditionKind::Member {
            item,
            negated: false,
            set,
        } => match &item.kind {
            ExprKind::Vector(items)
                if matches!(items.as_slice(), [i, j] if is(i, 0) && is(j, 1))
                    && is_free_of(set, 0)
                    && is_free_of(set, 1) =>
            {
                Some(Cells::Pairs(set))
            }
            _ if is(item, 1) && is_free_of(set, 1) => Some(Cells::InRow(set)),
            _ if is(item, 0) && is_free_of(set, 0) => Some(Cells::InColumn(set)),
            _ => None,
        },
        _ => None,
    }
}
