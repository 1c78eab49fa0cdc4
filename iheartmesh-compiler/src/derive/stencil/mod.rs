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
mod differentiate;
mod formula;
mod frontier;
mod numbers;
mod slopes;

use std::collections::{BTreeMap, BTreeSet};

use super::normal::Normal;
use super::{Trouble, algebra::Algebra};
use crate::ir::{Binary, Block, ExprId, Fold, Kind, Range, Unary};
use crate::types::{Dimension, Shape, Type};

use differentiate::{Leaves, Sparse};
use formula::{Formulas, Item, Stop};

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
                && !matches!(range, Range::Set(set) if self.is_active(set)) =>
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

impl Formulas<'_, '_> {
    /// The items that a formula takes, with all of their entries in order.
    fn stencil(&mut self) -> Option<(Vec<Item>, Vec<ExprId>)> {
        let items: Vec<Item> = self.items.values().cloned().collect();
        let entries: Vec<ExprId> = items.iter().flat_map(|i| i.entries.clone()).collect();
        let each = items.first().map_or(0, |item| item.entries.len());
        let even = items.iter().all(|item| item.entries.len() == each);
        (even && entries.len() <= ENTRIES).then_some((items, entries))
    }

    fn matrix(&mut self, n: usize, entry: impl Fn(usize, usize) -> ExprId) -> ExprId {
        let size = Dimension::known(n as i64);
        let rows = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect());
        match n {
            1 => entry(0, 0),
            _ => self.normal.program.arena.add(
                Kind::Blocks(rows.collect()),
                Type::real_matrix(size.clone(), size),
            ),
        }
    }

    /// The first derivatives of a formula; no block where they are 0.
    fn first_block(&mut self, e: ExprId) -> Option<Option<Block>> {
        let (items, entries) = self.stencil()?;
        let leaves = Leaves::new(entries);
        let gradient = self.gradient(e, &leaves)?;
        if gradient.is_empty() {
            return Some(None);
        }
        let zero = self.numbers().real(0.0);
        let entry = |k| gradient.get(&k).copied().unwrap_or(zero);
        let n = leaves.all.len();
        let value = match n {
            1 => entry(0),
            _ => self.normal.program.arena.add(
                Kind::Vector((0..n).map(entry).collect()),
                Type::real_vector(Dimension::known(n as i64)),
            ),
        };
        Some(Some(Block {
            rows: items.iter().map(|item| item.place).collect(),
            columns: Vec::new(),
            value,
            core: None,
        }))
    }

    /// First derivatives in a row of a matrix.
    fn in_row(&mut self, block: Block, row: ExprId) -> Block {
        let mut s = self.normal.algebra();
        let value = match s.ty(block.value).is_scalar() {
            true => block.value,
            false => s.transpose(block.value),
        };
        Block {
            rows: vec![row],
            columns: block.rows,
            value,
            core: None,
        }
    }

    /// The second derivatives of a formula; no block where they are 0.
    fn second_block(&mut self, e: ExprId) -> Option<Option<Block>> {
        let (items, entries) = self.stencil()?;
        let n = entries.len();
        let zero = self.numbers().real(0.0);
        let mut frontier = self.frontier(e, &entries);
        if frontier.len() >= n {
            frontier.clone_from(&entries);
        }
        let small = frontier.len();
        let leaves = Leaves::new(frontier);
        let inner = self.second(e, &leaves)?;
        if inner.is_empty() {
            return Some(None);
        }
        let core = |i: usize, j: usize| {
            let entry = inner.get(&(i.max(j), i.min(j)));
            entry.copied().unwrap_or(zero)
        };
        let mut block = Block {
            rows: items.iter().map(|item| item.place).collect(),
            columns: items.iter().map(|item| item.place).collect(),
            value: zero,
            core: None,
        };
        if leaves.all == entries {
            block.value = self.matrix(n, core);
            return Some(Some(block));
        }
        let by_entries = Leaves::new(entries);
        let mut linear = Vec::new();
        for y in &leaves.all {
            linear.push(self.gradient(*y, &by_entries)?);
        }
        let outer = self.expanded(small, &core, &linear, items.len(), n);
        let outer = |i: usize, j: usize| {
            let entry = outer.get(&(i.max(j), i.min(j)));
            entry.copied().unwrap_or(zero)
        };
        block.value = self.matrix(n, outer);
        if small < n {
            block.core = Some(self.matrix(small, core));
        }
        Some(Some(block))
    }

    /// The lower triangle of `Bᵀ K B`; the rows of `B` are given.
    fn expanded(
        &mut self,
        small: usize,
        core: &impl Fn(usize, usize) -> ExprId,
        linear: &[Sparse],
        items: usize,
        n: usize,
    ) -> BTreeMap<(usize, usize), ExprId> {
        let each = n / items;
        let left_out = self.left_out(linear, items, each);
        let is_in = |k: usize| left_out != Some(k / each);
        let mut all = BTreeMap::new();
        for j in (0..n).filter(|j| is_in(*j)) {
            // a column of K B
            let column = linear.iter().enumerate();
            let column: Vec<_> = column
                .filter_map(|(y, row)| Some((y, *row.get(&j)?)))
                .collect();
            let product: Vec<ExprId> = (0..small)
                .map(|i| {
                    let mut s = self.numbers();
                    let zero = s.real(0.0);
                    column.iter().fold(zero, |sum, (y, b)| {
                        let term = s.multiply(core(i, *y), *b);
                        s.add(sum, term)
                    })
                })
                .collect();
            for i in (j..n).filter(|i| is_in(*i)) {
                let mut s = self.numbers();
                let mut sum = s.real(0.0);
                for (y, row) in linear.iter().enumerate() {
                    if let Some(b) = row.get(&i) {
                        let term = s.multiply(*b, product[y]);
                        sum = s.add(sum, term);
                    }
                }
                all.insert((i, j), sum);
            }
        }
        let Some(out) = left_out else {
            return all;
        };
        // minus the sum over the other items, first across, then down
        let at = |all: &BTreeMap<(usize, usize), ExprId>, i: usize, j: usize| {
            all.get(&(i.max(j), i.min(j))).copied()
        };
        let others: Vec<usize> = (0..items).filter(|p| *p != out).collect();
        for columns in [&others[..], &[out]] {
            for j in columns.iter().flat_map(|p| p * each..(p + 1) * each) {
                for k in 0..each {
                    let i = out * each + k;
                    let mut sum = self.numbers().real(0.0);
                    for p in &others {
                        if let Some(entry) = at(&all, p * each + k, j) {
                            sum = self.numbers().add(sum, entry);
                        }
                    }
                    let sum = self.numbers().negate(sum);
                    all.insert((i.max(j), i.min(j)), sum);
                }
            }
        }
        all
    }

    /// An item whose part follows from those of the others, since moving all of them together changes nothing: the one
    /// with the longest formulas.
    fn left_out(&mut self, linear: &[Sparse], items: usize, each: usize) -> Option<usize> {
        let mut lengths = vec![0; items];
        for row in linear {
            for k in 0..each {
                let mut sum = BTreeMap::new();
                for (p, length) in lengths.iter_mut().enumerate() {
                    if let Some(entry) = row.get(&(p * each + k)) {
                        let mut own = BTreeMap::new();
                        self.numbers().terms(*entry, 1.0, &mut own);
                        *length += own.len();
                        for (term, count) in own {
                            *sum.entry(term).or_insert(0.0) += count;
                        }
                    }
                }
                if sum.values().any(|count| *count != 0.0) {
                    return None;
                }
            }
        }
        let longest = (0..items).max_by_key(|p| lengths[*p]);
        longest.filter(|_| items > 1)
    }
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
