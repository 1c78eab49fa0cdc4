//! Sparse matrices by conditions: `K_ij = { … if (i, j) ∈ P`, with `K` declared.
//!
//! Cells that no condition matches are 0. Where every condition has `(i, j) ∈ P` in it, only the members of the sets are
//! looked at; otherwise all cells are.

use super::Checker;
use super::scope::{Binding, Scope};
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, InputId, Kind, Layout, Pairs, SetOp, Unary, VariableId};
use crate::resolve::names::FreeNames;
use crate::syntax::ast::{self, Condition, ConditionKind, Expr, ExprKind, Name};
use crate::types::display::plural;
use crate::types::{Atom, Dimension, Type};

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
        let mut sets: Vec<(ExprId, &'a Expr)> = Vec::new();
        for (_, condition) in branches {
            let Some(set) = pairs_of(condition, names) else {
                return self.all_cells(definition, names, branches, ty);
            };
            let value = self.expr(set);
            if self.is_error(value) {
                return value;
            }
            sets.push((value, set));
        }
        let first = self.ty(sets[0].0).clone();
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
            || sets.iter().any(|(set, _)| *self.ty(*set) != first)
        {
            // what does not fit is reported where it stands in a condition
            return self.all_cells(definition, names, branches, ty);
        }
        self.cells_of_pairs(definition, names, branches, (&sets, &members), ty)
    }

    fn is_zero(&mut self, value: &'a Expr) -> bool {
        matches!(&value.kind, ExprKind::Integer(0))
            || matches!(&value.kind, ExprKind::Real(value) if *value == 0.0)
    }

    /// The cells at the members of sets of pairs.
    fn cells_of_pairs(
        &mut self,
        definition: &'a ast::Definition,
        names: [&'a Name; 2],
        branches: &'a [(Expr, Condition)],
        (sets, members): (&[(ExprId, &'a Expr)], &[Type]),
        ty: &Type,
    ) -> ExprId {
        let set_type = self.ty(sets[0].0).clone();
        let mut set = sets[0].0;
        for (other, _) in &sets[1..] {
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
                && dimension != Dimension::atom(Atom::Count(*element))
            {
                let kinds = plural(element.kind);
                let message = format!(
                    "`{}` is {} and indexes {dimension} entries",
                    name.text,
                    member.described()
                );
                return self.report(
                    Diagnostic::error(name.span, message)
                        .label(sets[0].1.span, format!("this is {}", set_type.described()))
                        .help(format!("a size that is the number of {kinds} is written `#V` with the set `V` of all of them")),
                );
            }
            sizes.push((dimension, size));
        }
        let [(rows, n), (columns, m)] = sizes.as_slice() else {
            return self.error();
        };
        for (set, _) in sets {
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
        ty: &Type,
    ) -> ExprId {
        let mut scope = Scope::default();
        let mut variables = Vec::new();
        for (k, name) in names.into_iter().enumerate() {
            let variable = self.bind_index(&mut scope, name);
            self.note_left_index(variable, name, ty, k);
            variables.push(variable);
        }
        let body = self.with_scope(scope, |checker| checker.cases(definition, branches));
        let mut ranges = Vec::new();
        for (variable, name) in variables.iter().zip(names) {
            if self.is_error(body) {
                self.index_uses.remove(variable);
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
        for (value, condition) in branches {
            let condition = self.condition(condition);
            let value = self.expr(value);
            cases.push((condition, self.number_of_cell(definition, value)));
        }
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

/// The set in `(i, j) ∈ P`, alone or joined to others by `and`, where it is the same for all cells.
fn pairs_of<'a>(condition: &'a Condition, names: [&Name; 2]) -> Option<&'a Expr> {
    match &condition.kind {
        ConditionKind::And(a, b) => pairs_of(a, names).or_else(|| pairs_of(b, names)),
        ConditionKind::Member {
            item,
            negated: false,
            set,
        } => {
            let ExprKind::Vector(items) = &item.kind else {
                return None;
            };
            let is =
                |e: &Expr, name: &Name| matches!(&e.kind, ExprKind::Name(n) if n.text == name.text);
            let pair = matches!(items.as_slice(), [i, j] if is(i, names[0]) && is(j, names[1]));
            let mut same = true;
            let mut found = |name: &Name| same &= names.iter().all(|index| index.text != name.text);
            FreeNames::new(Vec::new(), &mut found).expr(set);
            (pair && same).then_some(&**set)
        }
        _ => None,
    }
}
