//! Gradients and second derivatives of formulas, by leaves: entries of a variable, or numbers that are linear in them.
//!
//! Second derivatives are collected backward as the coefficients `W_pq` of products of gradients,
//!
//! ```text
//! H = ∑ W_pp ∇p ∇pᵀ + ∑ W_pq (∇p ∇qᵀ + ∇q ∇pᵀ)
//! ```
//!
//! Each operation `v` of `p` and `q` adds its own second derivatives, times the derivative of the result by `v`. A number
//! that is made of one other hands its coefficients on to it; one that is made of several keeps them, and its gradient is
//! formed once. So the determinant of a matrix, say, of which reciprocals, roots and logarithms are taken, has one gradient
//! and one coefficient.

use std::collections::{BTreeMap, BTreeSet};

use super::formula::Formulas;
use super::slopes::Slopes;
use crate::ir::ExprId;

/// Numbers by the leaves that they belong to; others are 0.
pub(super) type Sparse = BTreeMap<usize, ExprId>;

/// The second derivatives by pairs of leaves, the later one first.
pub(super) type Lower = BTreeMap<(usize, usize), ExprId>;

/// Coefficients of products with the gradients of others.
type Row = BTreeMap<ExprId, ExprId>;

/// What formulas are differentiated by.
pub(super) struct Leaves {
    pub(super) all: Vec<ExprId>,
    numbers: BTreeMap<ExprId, usize>,
}

impl Leaves {
    pub(super) fn new(all: Vec<ExprId>) -> Self {
        let numbers = all.iter().enumerate().map(|(k, e)| (*e, k)).collect();
        Self { all, numbers }
    }
}

impl Formulas<'_, '_> {
    /// The derivatives of an operation by what changes; `None` where they are not known.
    fn slopes(&mut self, e: ExprId) -> Option<Slopes> {
        let mut slopes = match self.reciprocals.get(&e).copied() {
            Some(determinant) => self.numbers().slopes_of_reciprocal(e, determinant),
            None => self.numbers().slopes(e)?,
        };
        let mut active = |e: &ExprId| self.is_active(*e);
        slopes.first.retain(|(a, _)| active(a));
        slopes.second.retain(|(a, b, _)| active(a) && active(b));
        Some(slopes)
    }

    fn accumulate<K: Ord>(&mut self, all: &mut BTreeMap<K, ExprId>, key: K, value: ExprId) {
        if self.numbers().is_zero(value) {
            return;
        }
        let sum = match all.remove(&key) {
            Some(sum) => self.numbers().add(sum, value),
            None => value,
        };
        if !self.numbers().is_zero(sum) {
            all.insert(key, sum);
        }
    }

    /// The derivatives of a number by the leaves.
    pub(super) fn gradient(&mut self, e: ExprId, leaves: &Leaves) -> Option<Sparse> {
        let mut gradient = Sparse::new();
        let mut open = BTreeMap::new();
        if self.is_active(e) {
            open.insert(e, self.numbers().real(1.0));
        }
        // operands come before what they are operands of
        while let Some((e, adjoint)) = open.pop_last() {
            if let Some(leaf) = leaves.numbers.get(&e) {
                gradient.insert(*leaf, adjoint);
                continue;
            }
            for (a, slope) in self.slopes(e)?.first {
                let share = self.numbers().multiply(adjoint, slope);
                self.accumulate(&mut open, a, share);
            }
        }
        Some(gradient)
    }

    /// The second derivatives of a number by the leaves.
    pub(super) fn second(&mut self, e: ExprId, leaves: &Leaves) -> Option<Lower> {
        let mut weights: BTreeMap<ExprId, Row> = BTreeMap::new();
        let mut adjoints = BTreeMap::new();
        let mut open = BTreeSet::new();
        if self.is_active(e) {
            open.insert(e);
            adjoints.insert(e, self.numbers().real(1.0));
        }
        while let Some(v) = open.pop_last() {
            if leaves.numbers.contains_key(&v) {
                continue;
            }
            let slopes = self.slopes(v)?;
            if let [(a, slope)] = slopes.first.as_slice() {
                let row = weights.remove(&v).unwrap_or_default();
                for (q, weight) in row {
                    if q != v
                        && let Some(other) = weights.get_mut(&q)
                    {
                        other.remove(&v);
                    }
                    let mut pushed = self.numbers().multiply(weight, *slope);
                    let mut to = q;
                    if q == v {
                        pushed = self.numbers().multiply(pushed, *slope);
                        to = *a;
                    } else if q == *a {
                        pushed = self.numbers().times(2.0, pushed);
                    }
                    self.weigh(&mut weights, *a, to, pushed);
                }
            }
            let adjoint = adjoints.remove(&v);
            for (p, q, curve) in slopes.second {
                if let Some(adjoint) = adjoint {
                    let weight = self.numbers().multiply(adjoint, curve);
                    self.weigh(&mut weights, p, q, weight);
                }
            }
            for (a, slope) in slopes.first {
                open.insert(a);
                if let Some(adjoint) = adjoint {
                    let share = self.numbers().multiply(adjoint, slope);
                    self.accumulate(&mut adjoints, a, share);
                }
            }
        }
        self.collected(weights, leaves)
    }

    fn weigh(&mut self, all: &mut BTreeMap<ExprId, Row>, p: ExprId, q: ExprId, weight: ExprId) {
        for (p, q) in [(p, q), (q, p)] {
            let mut row = all.remove(&p).unwrap_or_default();
            self.accumulate(&mut row, q, weight);
            all.insert(p, row);
            if p == q {
                break;
            }
        }
    }

    /// The sum of products of gradients.
    fn collected(&mut self, mut weights: BTreeMap<ExprId, Row>, leaves: &Leaves) -> Option<Lower> {
        weights.retain(|_, row| !row.is_empty());
        let mut left: BTreeSet<ExprId> = weights.keys().copied().collect();
        let mut gradients = BTreeMap::new();
        for v in &left {
            gradients.insert(*v, self.gradient(*v, leaves)?);
        }
        let mut all = Lower::new();
        // what has most partners first
        while let Some(p) = left
            .iter()
            .copied()
            .max_by_key(|p| (weights.get(p).map_or(0, BTreeMap::len), *p))
        {
            left.remove(&p);
            let row = weights.remove(&p).unwrap_or_default();
            let own = &gradients[&p];
            // H += u vᵀ + v uᵀ with u = ∇p
            let mut others = Sparse::new();
            let single = row.len() == 1 && row.contains_key(&p);
            for (q, weight) in row {
                let weight = match q == p && !single {
                    true => self.numbers().times(0.5, weight),
                    false => weight,
                };
                if q != p
                    && let Some(other) = weights.get_mut(&q)
                {
                    other.remove(&p);
                }
                for (k, entry) in &gradients[&q] {
                    let term = self.numbers().multiply(weight, *entry);
                    self.accumulate(&mut others, *k, term);
                }
            }
            for (i, u) in own {
                for (j, v) in &others {
                    let product = self.numbers().multiply(*u, *v);
                    if single {
                        if i >= j {
                            self.accumulate(&mut all, (*i, *j), product);
                        }
                    } else if i == j {
                        let twice = self.numbers().times(2.0, product);
                        self.accumulate(&mut all, (*i, *i), twice);
                    } else {
                        self.accumulate(&mut all, (*i.max(j), *i.min(j)), product);
                    }
                }
            }
        }
        Some(all)
    }
}
