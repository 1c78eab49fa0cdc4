//! Derivatives of sums of terms that each take a few items of the variable: of a triangle those of its corners, say.
//!
//! A term becomes a formula of the entries of its items (`formula`), which is differentiated once for all of them
//! (`differentiate`): one block of the derivative for each term. Often it depends on fewer numbers that are linear in these
//! entries, such as those of a deformation gradient `y = B x` (`frontier`): it is differentiated by these, and its second
//! derivatives by `x` are `Bᵀ K B`, where `K` are those by `y`. Where moving all items together changes no `y`, the part of
//! one of the items is minus the sum of those of the others.
//!
//! Terms of other kinds, such as sums over neighbours, are left to `reverse` and `hessian`.

mod array;
mod blocks;
mod differentiate;
mod formula;
mod frontier;
mod numbers;
mod slopes;

use std::collections::BTreeSet;

use super::hessian::is_local;
use super::normal::Normal;
use super::{Trouble, algebra::Algebra};
use crate::ir::{Binary, Block, ExprId, Fold, Kind, Range, Unary, VariableId};
use crate::types::{Shape, Type};

use formula::{Formulas, Stop};

/// So many cases of a term are told apart at most, and so many entries of items taken.
const CASES: usize = 4;
const ENTRIES: usize = 36;

/// What is computed of a sum of terms.
#[derive(Clone, Copy)]
pub(super) enum Wanted {
    /// Its value, in the formulas of its derivatives, so that they have in common what they can.
    Value,
    /// A vector of its first derivatives.
    First,
    /// These as a row of a matrix.
    Row(ExprId),
    /// A matrix of its second derivatives.
    Second,
}

/// Puts together what is wanted of a sum of terms.
pub(super) struct Stencil<'n, 'a, F> {
    pub(super) normal: &'n mut Normal<'a>,
    pub(super) x: ExprId,
    pub(super) wanted: Wanted,
    /// The sizes and type of the derivatives.
    pub(super) sizes: Vec<ExprId>,
    pub(super) ty: Type,
    /// The derivative of a term in another way, or its value.
    pub(super) otherwise: F,
}

impl<F> Stencil<'_, '_, F>
where
    F: FnMut(&mut Normal<'_>, ExprId) -> Result<ExprId, Trouble>,
{
    /// What is wanted of a number in normal form.
    pub(super) fn of(&mut self, y: ExprId) -> Result<ExprId, Trouble> {
        self.sum(y, None, &[])
    }

    fn is_active(&mut self, e: ExprId) -> bool {
        let x = self.x;
        self.normal.changes_with(e, x)
    }

    fn assembled(&mut self, blocks: Vec<Block>) -> ExprId {
        let sizes = self.sizes.clone();
        let kind = Kind::Assemble { sizes, blocks };
        self.normal.program.arena.add(kind, self.ty.clone())
    }

    /// What is wanted of `factor` times a sum of terms.
    fn sum(
        &mut self,
        y: ExprId,
        factor: Option<ExprId>,
        facts: &[(ExprId, bool)],
    ) -> Result<ExprId, Trouble> {
        if !self.is_active(y) {
            return Ok(match self.wanted {
                Wanted::Value => self.scaled(y, factor),
                _ => self.assembled(Vec::new()),
            });
        }
        let times = |normal: &mut Normal<'_>, k: ExprId| match factor {
            Some(factor) => normal.algebra().scale(factor, k),
            None => k,
        };
        match self.normal.kind(y) {
            Kind::Binary(op @ (Binary::Add | Binary::Subtract), a, b) => {
                if self.is_one(a, b)
                    && let Some(whole) = self.term(y, factor, facts)
                {
                    return Ok(whole);
                }
                let left = self.sum(a, factor, facts)?;
                let other = match op {
                    Binary::Add => factor,
                    _ => {
                        let minus = self.normal.algebra().real(-1.0);
                        Some(times(self.normal, minus))
                    }
                };
                let right = self.sum(b, other, facts)?;
                Ok(self.normal.algebra().add(left, right))
            }
            Kind::Binary(Binary::Multiply, k, a) if !self.is_active(k) => {
                let k = times(self.normal, k);
                self.sum(a, Some(k), facts)
            }
            Kind::Binary(Binary::Multiply, a, k) if !self.is_active(k) => {
                let k = times(self.normal, k);
                self.sum(a, Some(k), facts)
            }
            Kind::Binary(Binary::Divide, a, k) if !self.is_active(k) => {
                let mut s = self.normal.algebra();
                let one = s.real(1.0);
                let k = s.divide(one, k);
                let k = times(self.normal, k);
                self.sum(a, Some(k), facts)
            }
            Kind::Unary(Unary::Negate, a) => {
                let minus = self.normal.algebra().real(-1.0);
                let k = times(self.normal, minus);
                self.sum(a, Some(k), facts)
            }
            Kind::If(condition, a, b) => {
                let inside = self.informed(facts, condition, true);
                let then = self.sum(a, factor, &inside)?;
                let inside = self.informed(facts, condition, false);
                let otherwise = self.sum(b, factor, &inside)?;
                let condition = self.condition(condition);
                Ok(self.normal.algebra().choose(condition, then, otherwise))
            }
            Kind::Fold {
                op: Fold::Sum,
                variable,
                range,
                condition,
                body,
            } if !is_short(self.normal, range)
                && !matches!(range, Range::Set(set) if self.is_active(set))
                && !self.has_shared(body, variable) =>
            {
                let body = self.sum(body, factor, facts)?;
                Ok(self.normal.summed(variable, range, condition, body))
            }
            _ => match self.term(y, factor, facts) {
                Some(term) => Ok(term),
                None => {
                    let y = self.scaled(y, factor);
                    (self.otherwise)(self.normal, y)
                }
            },
        }
    }

    fn scaled(&mut self, y: ExprId, factor: Option<ExprId>) -> ExprId {
        match factor {
            Some(factor) => self.normal.algebra().scale(factor, y),
            None => y,
        }
    }

    /// A condition with formulas in it, as terms have them.
    fn condition(&mut self, condition: ExprId) -> ExprId {
        Formulas::new(self.normal, self.x, &[]).condition(condition)
    }

    fn informed(
        &mut self,
        facts: &[(ExprId, bool)],
        condition: ExprId,
        holds: bool,
    ) -> Vec<(ExprId, bool)> {
        let mut facts = facts.to_vec();
        let mut open = vec![condition];
        while let Some(condition) = open.pop() {
            facts.push((condition, holds));
            facts.push((self.condition(condition), holds));
            // each part of a conjunction holds, and no part of a disjunction that does not
            match (self.normal.kind(condition), holds) {
                (Kind::And(a, b), true) | (Kind::Or(a, b), false) => open.extend([a, b]),
                _ => {}
            }
        }
        facts
    }

    /// Whether two terms are differentiated together: one takes no items that the other does not take.
    fn is_one(&mut self, a: ExprId, b: ExprId) -> bool {
        let (a, b) = (self.places(a), self.places(b));
        match (a, b) {
            (Some(a), Some(b)) => a.is_subset(&b) || b.is_subset(&a),
            _ => false,
        }
    }

    /// The places of the items that a term takes; `None` where that is not known.
    fn places(&mut self, e: ExprId) -> Option<BTreeSet<ExprId>> {
        let mut places = BTreeSet::new();
        let mut seen = BTreeSet::new();
        let mut open = vec![e];
        while let Some(e) = open.pop() {
            if !self.is_active(e) || !seen.insert(e) {
                continue;
            }
            let kind = self.normal.kind(e);
            match &kind {
                Kind::Item(s, place) | Kind::Component(s, place) if *s == self.x => {
                    places.insert(*place);
                }
                Kind::Fold { .. } => return None,
                _ if e == self.x => return None,
                _ => kind.operands(|a| open.push(a)),
            }
        }
        Some(places)
    }

    /// Whether the terms of a loop share something that takes many items: its derivative is asked for once, not in each
    /// round.
    fn has_shared(&mut self, body: ExprId, variable: VariableId) -> bool {
        let mut seen = BTreeSet::new();
        let mut open = vec![body];
        while let Some(e) = open.pop() {
            if !self.is_active(e) || !seen.insert(e) {
                continue;
            }
            if self.normal.program.arena.depends_on(e, variable) {
                self.normal.kind(e).operands(|operand| open.push(operand));
            } else if e != self.x && !is_local(self.normal, e, &[self.x]) {
                return true;
            }
        }
        false
    }

    /// What is wanted of one term, if it has a formula.
    fn term(
        &mut self,
        y: ExprId,
        factor: Option<ExprId>,
        facts: &[(ExprId, bool)],
    ) -> Option<ExprId> {
        self.cases(y, factor, facts, CASES)
    }

    fn cases(
        &mut self,
        y: ExprId,
        factor: Option<ExprId>,
        facts: &[(ExprId, bool)],
        left: usize,
    ) -> Option<ExprId> {
        let wanted = self.wanted;
        let mut formulas = Formulas::new(self.normal, self.x, facts);
        let found = formulas.number(y).and_then(|mut e| {
            if let Some(factor) = factor {
                e = formulas.numbers().multiply(factor, e);
            }
            let block = match wanted {
                Wanted::Value => return Ok(Err(e)),
                Wanted::First => formulas.first_block(e),
                Wanted::Row(row) => {
                    let block = formulas.first_block(e);
                    block.map(|block| block.map(|block| formulas.in_row(block, row)))
                }
                Wanted::Second => formulas.second_block(e),
            };
            block.map(Ok).ok_or(Stop::Unknown)
        });
        match found {
            Ok(Ok(block)) => Some(self.assembled(block.into_iter().collect())),
            Ok(Err(value)) => Some(value),
            Err(Stop::Cases(condition)) if left > 1 => {
                let then = self.informed(facts, condition, true);
                let then = self.cases(y, factor, &then, left / 2)?;
                let otherwise = self.informed(facts, condition, false);
                let otherwise = self.cases(y, factor, &otherwise, left / 2)?;
                let condition = self.condition(condition);
                Some(self.normal.algebra().choose(condition, then, otherwise))
            }
            Err(_) => None,
        }
    }
}

/// Whether a loop is over a few integers in the text: one term.
fn is_short(normal: &Normal<'_>, range: Range) -> bool {
    let is_known = |e: ExprId| matches!(normal.program.arena.kind(e), Kind::Integer(_));
    matches!(range, Range::Integers(from, to) if is_known(from) && is_known(to))
}

/// Whether a variable has items whose derivatives are blocks.
pub(super) fn has_items(algebra: &Algebra<'_>, x: ExprId) -> bool {
    match algebra.ty(x) {
        Type::Sequence { item, .. } => match item.shape() {
            Some(Shape::Scalar) => true,
            Some(Shape::Vector(n)) => n.value().is_some(),
            Some(Shape::Matrix(n, m)) => n.value().is_some() && m.value().is_some(),
            None => false,
        },
        Type::Vector { length, .. } => length.value().is_none(),
        _ => false,
    }
}
