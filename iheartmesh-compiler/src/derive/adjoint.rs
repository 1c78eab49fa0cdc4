//! Single entries of adjoints, found where they can be without the vector or matrix that they stand in.
//!
//! The adjoint of a matrix that is used entry by entry is put together from blocks, and that of the `L` in `u ⋅ L v` is `u vᵀ`:
//! as many numbers as the matrix has rows times columns. A sparse matrix asks for few of them:
//!
//! ```text
//! (∑_v ∑_w  a(v, w) at v, w)[p, q]   is   a(p, q)
//! (u vᵀ)[p, q]                       is   u_p v_q
//! ```

use std::collections::HashMap;

use super::algebra::Algebra;
use crate::ir::{Binary, Block, ExprId, Fold, Kind, Range, Unary, VariableId};
use crate::optimize::rewrite;
use crate::syntax::ast::CompareOp;
use crate::types::{Shape, Type};

/// A loop around blocks.
#[derive(Clone, Copy)]
struct Around {
    variable: VariableId,
    range: Range,
    condition: Option<ExprId>,
}

impl Algebra<'_> {
    /// The entry of an adjoint at a place in a vector, or at a row and column of a matrix.
    pub(super) fn entry_of_adjoint(&mut self, d: ExprId, at: &[ExprId]) -> ExprId {
        match self.found(d, at) {
            Some(entry) => entry,
            None => self.read(d, at),
        }
    }

    fn read(&mut self, d: ExprId, at: &[ExprId]) -> ExprId {
        match *at {
            [i, j] => self.at(d, i, j),
            [i] => self.entry(d, i),
            _ => d,
        }
    }

    /// Nothing where the entry is as easily read.
    fn found(&mut self, d: ExprId, at: &[ExprId]) -> Option<ExprId> {
        match self.kind(d) {
            _ if self.is_zero(d) => Some(self.real(0.0)),
            Kind::Binary(op @ (Binary::Add | Binary::Subtract), a, b) => {
                let found = [self.found(a, at), self.found(b, at)];
                if found == [None, None] {
                    return None;
                }
                let [a, b] = [(found[0], a), (found[1], b)]
                    .map(|(found, e)| found.unwrap_or_else(|| self.read(e, at)));
                Some(match op {
                    Binary::Add => self.add(a, b),
                    _ => self.subtract(a, b),
                })
            }
            Kind::Unary(Unary::Negate, a) => {
                let a = self.found(a, at)?;
                Some(self.negate(a))
            }
            Kind::Binary(Binary::Multiply, k, a) => {
                let a = self.found(a, at)?;
                Some(self.scale(k, a))
            }
            Kind::Binary(Binary::Divide, a, k) => {
                let a = self.found(a, at)?;
                Some(self.divide(a, k))
            }
            Kind::Unary(Unary::Transpose, a) => match (at, self.ty(a).shape()) {
                ([i, j], Some(Shape::Matrix(..))) => {
                    let at = [*j, *i];
                    self.found(a, &at)
                }
                _ => None,
            },
            Kind::If(condition, a, b) => {
                let found = [self.found(a, at), self.found(b, at)];
                if found == [None, None] {
                    return None;
                }
                let [a, b] = [(found[0], a), (found[1], b)]
                    .map(|(found, e)| found.unwrap_or_else(|| self.read(e, at)));
                Some(self.choose(condition, a, b))
            }
            Kind::Binary(Binary::Product, u, row) => {
                let (Kind::Unary(Unary::Transpose, v), [i, j]) = (self.kind(row), at) else {
                    return None;
                };
                let is_vector = |e: ExprId| matches!(self.ty(e).shape(), Some(Shape::Vector(_)));
                if !is_vector(u) || !is_vector(v) {
                    return None;
                }
                let (up, across) = ([*i], [*j]);
                let a = self.entry_of_adjoint(u, &up);
                let b = self.entry_of_adjoint(v, &across);
                Some(self.scale(a, b))
            }
            Kind::Filled(value, _) => Some(value),
            Kind::Fold { op: Fold::Sum, .. } | Kind::Assemble { .. } => {
                self.of_blocks(d, at, &mut Vec::new())
            }
            _ => None,
        }
    }

    /// The entry of what is put together from blocks, each of one number, inside of loops over its places.
    fn of_blocks(&mut self, d: ExprId, at: &[ExprId], loops: &mut Vec<Around>) -> Option<ExprId> {
        match self.kind(d) {
            Kind::Fold {
                op: Fold::Sum,
                variable,
                range,
                condition,
                body,
            } => {
                loops.push(Around {
                    variable,
                    range,
                    condition,
                });
                let entry = self.of_blocks(body, at, loops);
                loops.pop();
                entry
            }
            Kind::Binary(Binary::Add, a, b) => {
                let (a, b) = (self.of_blocks(a, at, loops)?, self.of_blocks(b, at, loops)?);
                Some(self.add(a, b))
            }
            Kind::Assemble { blocks, .. } => {
                let mut sum = self.real(0.0);
                for block in &blocks {
                    let entry = self.of_block(block, at, loops)?;
                    sum = self.add(sum, entry);
                }
                Some(sum)
            }
            _ => None,
        }
    }

    fn of_block(&mut self, block: &Block, at: &[ExprId], loops: &[Around]) -> Option<ExprId> {
        let places: Vec<ExprId> = block.rows.iter().chain(&block.columns).copied().collect();
        let is_number = self.ty(block.value).is_scalar();
        if !is_number || places.len() != at.len() || block.rows.len() != 1 {
            return None;
        }
        // the round of each loop that adds to the entry, with what must hold for there to be one
        let mut rounds: HashMap<VariableId, ExprId> = HashMap::new();
        let mut equal = Vec::new();
        for (place, at) in places.into_iter().zip(at) {
            let variable = match self.kind(place) {
                Kind::Variable(v) => Some(v),
                Kind::Unary(Unary::ToInteger, a) => match self.kind(a) {
                    Kind::Variable(v) => Some(v),
                    _ => None,
                },
                _ => None,
            };
            let tied = variable
                .filter(|v| loops.iter().any(|l| l.variable == *v) && !rounds.contains_key(v));
            match tied {
                Some(v) => {
                    let ty = self.arena.variable_type(v).clone();
                    let round = match ty.is_element() {
                        true => self.element(*at, ty),
                        false => self.place(*at),
                    };
                    rounds.insert(v, round);
                }
                None => {
                    let place = self.place(place);
                    equal.push((place, self.place(*at)));
                }
            }
        }
        if loops.iter().any(|l| !rounds.contains_key(&l.variable)) {
            return None;
        }
        let put = |s: &mut Self, e: ExprId| {
            let e = rewrite::substitute(s.arena, e, &rounds);
            rewrite::at_elements(s.arena, e)
        };
        let mut entry = put(self, block.value);
        let mut conditions = Vec::new();
        for (place, at) in equal {
            let place = put(self, place);
            if place != at {
                conditions.push(self.compare(CompareOp::Equal, place, at));
            }
        }
        for around in loops.iter().rev() {
            conditions.extend(around.condition.map(|c| put(self, c)));
            let round = rounds[&around.variable];
            match around.range {
                Range::Set(set) if self.is_all_of(set, round) => {}
                Range::Set(set) => {
                    let set = put(self, set);
                    let member = Kind::Member(round, set);
                    conditions.push(self.arena.add(member, Type::Boolean));
                }
                Range::Integers(from, to) => {
                    let (from, to) = (put(self, from), put(self, to));
                    conditions.push(self.compare(CompareOp::LessOrEqual, round, to));
                    conditions.push(self.compare(CompareOp::LessOrEqual, from, round));
                }
                Range::Rows { .. } => return None,
            }
        }
        // the outermost is asked first
        for condition in conditions {
            let zero = self.real(0.0);
            entry = self.choose(condition, entry, zero);
        }
        Some(entry)
    }

    /// Whether a set is that of all elements of a kind, and an element is one of them.
    fn is_all_of(&self, set: ExprId, e: ExprId) -> bool {
        match self.arena.kind(set) {
            Kind::AllElements(element) => *self.arena.ty(e) == Type::Element(*element),
            _ => false,
        }
    }
}
