//! Rules for loops and blocks.

use super::algebra::SMALL;
use super::normal::is_vector;
use super::reverse::Reverse;
use crate::ir::{Binary, Block, ExprId, Fold, Kind, Layout, Range};
use crate::optimize::rewrite;
use crate::syntax::ast::CompareOp;
use crate::types::{Dimension, Shape, Type};

impl Reverse<'_, '_> {
    /// `∏ t_i`: each term by the product of all others, so that a factor 0 divides nothing.
    pub(super) fn product_over(&mut self, product: &Kind, region: usize, d: ExprId) {
        let Kind::Fold {
            variable,
            range,
            condition,
            body,
            ..
        } = *product
        else {
            return;
        };
        let mut other = variable;
        let all = self.normal.fresh(&mut [&mut other]);
        let arena = &mut self.normal.program.arena;
        let (this, that) = (arena.variable(variable), arena.variable(other));
        let factor = rewrite::substitute(arena, body, &all);
        let taken = condition.map(|c| rewrite::substitute(arena, c, &all));
        let differs = arena.add(
            Kind::Compare(CompareOp::NotEqual, that, this),
            Type::Boolean,
        );
        let taken = match taken {
            Some(taken) => arena.add(Kind::And(differs, taken), Type::Boolean),
            None => differs,
        };
        let others = arena.add(
            Kind::Fold {
                op: Fold::Product,
                variable: other,
                range,
                condition: Some(taken),
                body: factor,
            },
            Type::REAL,
        );
        let inside = self.inside_of_loop(region, variable, range, condition);
        let adjoint = self.algebra().scale(d, others);
        self.give(body, inside, adjoint);
    }

    /// The least or greatest term: the mean of the derivatives of the terms that are.
    pub(super) fn extreme_over(&mut self, e: ExprId, terms: &Kind, region: usize, d: ExprId) {
        let Kind::Fold {
            variable,
            range,
            condition,
            body,
            ..
        } = *terms
        else {
            return;
        };
        let arena = &mut self.normal.program.arena;
        let is_best = arena.add(Kind::Compare(CompareOp::Equal, body, e), Type::Boolean);
        // how many terms are best
        let mut other = variable;
        let all = self.normal.fresh(&mut [&mut other]);
        let arena = &mut self.normal.program.arena;
        let also = rewrite::substitute(arena, is_best, &all);
        let taken = condition.map(|c| rewrite::substitute(arena, c, &all));
        let also = match taken {
            Some(taken) => arena.add(Kind::And(taken, also), Type::Boolean),
            None => also,
        };
        let one = arena.real(1.0);
        let ties = arena.add(
            Kind::Fold {
                op: Fold::Sum,
                variable: other,
                range,
                condition: Some(also),
                body: one,
            },
            Type::REAL,
        );
        let inside = self.inside_of_loop(region, variable, range, condition);
        let (best, _) = self.branches(inside, is_best);
        let share = self.algebra().divide(d, ties);
        self.give(body, best, share);
    }

    /// The part of an adjoint that belongs to a block, in its shape.
    pub(super) fn piece(&mut self, d: ExprId, block: &Block) -> ExprId {
        let value = block.value;
        let ty = self.algebra().dense(value);
        let flat = block.columns.is_empty();
        let (n, m) = (self.algebra().size(value, 0), self.algebra().size(value, 1));
        let one = self.algebra().arena.integer(1);
        let several = block.rows.len() > 1 || block.columns.len() > 1;
        // of the entry in a row and column of the value: the place in the whole
        let entry = |this: &mut Self, i: ExprId, j: ExprId| {
            let mut s = this.algebra();
            if flat {
                let all = s.count(Binary::Multiply, n, m);
                let k = s.inside(j, n, i);
                let place = spread(&mut s, &block.rows, all, k);
                return s.entry(d, place);
            }
            let row = spread(&mut s, &block.rows, n, i);
            let column = spread(&mut s, &block.columns, m, j);
            s.at(d, row, column)
        };
        if let (true, Some((rows, columns))) = (several, self.algebra().fixed(value)) {
            let mut lines = Vec::new();
            for i in 1..=rows {
                let mut line = Vec::new();
                for j in 1..=columns {
                    let arena = &mut self.normal.program.arena;
                    let (i, j) = (arena.integer(i), arena.integer(j));
                    line.push(entry(self, i, j));
                }
                lines.push(line);
            }
            let kind = match is_vector(&ty) {
                true => Kind::Vector(lines.into_iter().flatten().collect()),
                false => Kind::Blocks(lines),
            };
            return self.algebra().arena.add(kind, ty);
        }
        self.build(&ty, (n, m), one, entry)
    }

    /// A number, vector or matrix by its entries.
    fn build(
        &mut self,
        ty: &Type,
        (n, m): (ExprId, ExprId),
        one: ExprId,
        entry: impl Fn(&mut Self, ExprId, ExprId) -> ExprId,
    ) -> ExprId {
        match ty.shape() {
            Some(Shape::Vector(length)) => {
                if let Some(length) = length.value().filter(|n| *n <= SMALL) {
                    let mut items = Vec::new();
                    for k in 1..=length {
                        let k = self.algebra().arena.integer(k);
                        items.push(entry(self, k, one));
                    }
                    return self.algebra().arena.add(Kind::Vector(items), ty.clone());
                }
                let (i, row) = self.normal.index("i");
                let body = entry(self, row, one);
                let kind = Kind::Tabulate {
                    layout: Layout::Vector,
                    variables: vec![i],
                    sizes: vec![n],
                    body,
                };
                self.algebra().arena.add(kind, ty.clone())
            }
            Some(Shape::Matrix(..)) => {
                let (i, row) = self.normal.index("i");
                let (j, column) = self.normal.index("j");
                let body = entry(self, row, column);
                let kind = Kind::Tabulate {
                    layout: Layout::Matrix,
                    variables: vec![i, j],
                    sizes: vec![n, m],
                    body,
                };
                self.algebra().arena.add(kind, ty.clone())
            }
            _ => entry(self, one, one),
        }
    }

    /// A matrix of blocks: to each its part.
    pub(super) fn blocks(&mut self, rows: Vec<Vec<ExprId>>, region: usize, d: ExprId) {
        let zero = self.algebra().arena.integer(0);
        let one = self.algebra().arena.integer(1);
        let mut above = zero;
        for row in rows {
            let mut left = zero;
            for block in &row {
                let block = *block;
                let ty = self.algebra().dense(block);
                let (n, m) = (self.algebra().size(block, 0), self.algebra().size(block, 1));
                if self.is_active(block) {
                    let adjoint = self.build(&ty, (n, m), one, |this, i, j| {
                        let mut s = this.algebra();
                        let i = s.count(Binary::Add, above, i);
                        let j = s.count(Binary::Add, left, j);
                        s.at(d, i, j)
                    });
                    self.give(block, region, adjoint);
                }
                left = self.algebra().count(Binary::Add, left, m);
            }
            if let Some(first) = row.first() {
                let height = self.algebra().size(*first, 0);
                above = self.algebra().count(Binary::Add, above, height);
            }
        }
    }

    /// `a ⊗ b`: `a̅_ij` is the sum of the products of `b` and the block of the adjoint at `i, j`.
    pub(super) fn kronecker(&mut self, a: ExprId, b: ExprId, region: usize, d: ExprId) {
        for (this, other, outer) in [(a, b, true), (b, a, false)] {
            if !self.is_active(this) {
                continue;
            }
            let ty = self.algebra().dense(this);
            let one = self.algebra().arena.integer(1);
            let (n, m) = (self.algebra().size(this, 0), self.algebra().size(this, 1));
            let (p, q) = (self.algebra().size(b, 0), self.algebra().size(b, 1));
            let adjoint = self.build(&ty, (n, m), one, |this, i, j| {
                let (k, row) = this.normal.index("k");
                let (l, column) = this.normal.index("l");
                let mut s = this.algebra();
                let factor = s.at(other, row, column);
                let (up, across) = match outer {
                    true => (s.inside(i, p, row), s.inside(j, q, column)),
                    false => (s.inside(row, p, i), s.inside(column, q, j)),
                };
                let entry = s.at(d, up, across);
                let mut sum = s.scale(entry, factor);
                for (variable, axis) in [(k, 0), (l, 1)] {
                    let size = s.size(other, axis);
                    let kind = Kind::Fold {
                        op: Fold::Sum,
                        variable,
                        range: Range::Integers(one, size),
                        condition: None,
                        body: sum,
                    };
                    sum = s.arena.add(kind, Type::REAL);
                }
                sum
            });
            self.give(this, region, adjoint);
        }
    }

    /// The pseudo-inverse `P` of `A`, where the rank stays the same:
    /// `A̅ = -Pᵀ P̅ Pᵀ + (I - A P) P̅ᵀ P Pᵀ + Pᵀ P P̅ᵀ (I - P A)` (Golub and Pereyra 1973).
    pub(super) fn pseudo_inverse(&mut self, p: ExprId, a: ExprId, region: usize, d: ExprId) {
        let ty = self.algebra().dense(a);
        let mut s = self.algebra();
        let (Some(Shape::Matrix(n, m)), Some((rows, columns))) =
            (ty.shape(), Some((s.size(a, 0), s.size(a, 1))))
        else {
            return;
        };
        let square = |n: &Dimension| Type::real_matrix(n.clone(), n.clone());
        let (back, across) = (s.transpose(p), s.transpose(d));
        let inner = s.product(back, d, &square(&n));
        let first = s.product(inner, back, &ty);
        let projected = s.product(a, p, &square(&n));
        let identity = s.arena.add(Kind::Identity(rows), square(&n));
        let left = s.subtract(identity, projected);
        let gram = s.product(p, back, &square(&m));
        let second = s.product(left, across, &ty);
        let second = s.product(second, gram, &ty);
        let projected = s.product(p, a, &square(&m));
        let identity = s.arena.add(Kind::Identity(columns), square(&m));
        let right = s.subtract(identity, projected);
        let gram = s.product(back, p, &square(&n));
        let third = s.product(gram, across, &ty);
        let third = s.product(third, right, &ty);
        let sum = s.subtract(second, first);
        let sum = s.add(sum, third);
        self.give(a, region, sum);
    }
}

/// Where the `k`-th of `n` rows goes, that are divided evenly among places.
pub(super) fn spread(
    s: &mut super::algebra::Algebra<'_>,
    places: &[ExprId],
    n: ExprId,
    k: ExprId,
) -> ExprId {
    if let [place] = places {
        return s.inside(*place, n, k);
    }
    // several places only stand where the size is in the text
    let (Kind::Integer(n), Kind::Integer(k)) = (s.kind(n), s.kind(k)) else {
        return k;
    };
    let height = (n / places.len() as i64).max(1);
    let place = places[((k - 1) / height) as usize];
    let height_value = s.arena.integer(height);
    let inside = s.arena.integer((k - 1) % height + 1);
    s.inside(place, height_value, inside)
}
