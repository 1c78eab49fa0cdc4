//! Arrays by their entries: sums and extrema over all of them, functions of each, determinants.

use super::Trouble;
use super::algebra::{Algebra, SMALL};
use super::normal::{Normal, is_vector};
use crate::ir::{Binary, ExprId, Fold, Kind, Layout, Range, Unary};
use crate::optimize::rewrite;
use crate::types::{Shape, Type};

impl Normal<'_> {
    /// The determinant of the rows and columns of a matrix with these numbers, by the first column.
    pub(super) fn determinant(
        &mut self,
        a: ExprId,
        rows: &[i64],
        columns: &[i64],
    ) -> Result<ExprId, Trouble> {
        let Some((&column, others)) = columns.split_first() else {
            return Ok(self.algebra().real(1.0));
        };
        let mut sum = self.algebra().real(0.0);
        for (k, &row) in rows.iter().enumerate() {
            let entry = self.entry(a, row, column)?;
            let mut left = rows.to_vec();
            left.remove(k);
            let minor = self.determinant(a, &left, others)?;
            let mut algebra = self.algebra();
            let term = algebra.scale(entry, minor);
            sum = match k % 2 {
                0 => algebra.add(sum, term),
                _ => algebra.subtract(sum, term),
            };
        }
        Ok(sum)
    }

    /// The sum of what is made of each entry of a value.
    pub(super) fn sum_of_entries(
        &mut self,
        a: ExprId,
        f: impl Fn(&mut Algebra<'_>, ExprId) -> ExprId,
    ) -> Result<ExprId, Trouble> {
        if let Some((n, m)) = self.algebra().fixed(a).filter(|(n, m)| n * m <= SMALL) {
            let mut sum = self.algebra().real(0.0);
            for j in 1..=m {
                for i in 1..=n {
                    let entry = self.entry(a, i, j)?;
                    let term = f(&mut self.algebra(), entry);
                    sum = self.algebra().add(sum, term);
                }
            }
            return Ok(sum);
        }
        self.fold_entries(Fold::Sum, a, f)
    }

    /// The sum of the products of the entries of two values in normal form.
    pub(super) fn inner(&mut self, a: ExprId, b: ExprId) -> Result<ExprId, Trouble> {
        let whole = self.algebra().inner(a, b);
        match self.kind(whole) {
            Kind::Binary(Binary::Dot | Binary::Frobenius, a, b) => {
                self.inner_of_entries(a, b, whole)
            }
            _ => Ok(whole),
        }
    }

    /// The same, entry by entry where one of them is known by its entries and the other does not take long to find them of.
    pub(super) fn inner_of_entries(
        &mut self,
        a: ExprId,
        b: ExprId,
        whole: ExprId,
    ) -> Result<ExprId, Trouble> {
        if let Some(sum) = self.inner_of_stacks(a, b)? {
            return Ok(sum);
        }
        let shape = self.program.arena.ty(a).shape();
        let is_fixed = self.algebra().fixed(a).is_some() || self.algebra().fixed(b).is_some();
        let known = [a, b].map(|e| self.is_known_by_entries(e));
        if is_fixed || known.contains(&None) || !known.contains(&Some(true)) {
            return Ok(whole);
        }
        let term = |this: &mut Self, i: ExprId, j: Option<ExprId>| {
            let mut entries = [a, b];
            for entry in &mut entries {
                let active = this.is_active(*entry);
                let kind = match j {
                    None => Kind::Component(*entry, i),
                    Some(j) => Kind::At(*entry, i, j),
                };
                *entry = this.program.arena.add(kind, Type::REAL);
                if active {
                    *entry = this.rule(*entry)?;
                }
                *entry = rewrite::at_elements(&mut this.program.arena, *entry);
            }
            Ok(this.algebra().scale(entries[0], entries[1]))
        };
        let (dimensions, short) = match shape {
            Some(Shape::Vector(n)) => (vec![(0, n)], None),
            Some(Shape::Matrix(n, m)) => match (n.value(), m.value()) {
                (None, Some(m)) if m <= SMALL => (vec![(0, n)], Some(m)),
                (Some(n), None) if n <= SMALL => (vec![(1, m)], Some(n)),
                _ => (vec![(0, n), (1, m)], None),
            },
            _ => return Ok(whole),
        };
        let mut loops = Vec::new();
        for (axis, dimension) in &dimensions {
            let size = self.algebra().size(a, *axis);
            loops.push(rewrite::each(&mut self.program.arena, dimension, size));
        }
        let places: Vec<ExprId> = loops.iter().map(|(_, place, _)| *place).collect();
        let places: Vec<ExprId> = places
            .into_iter()
            .map(|p| self.algebra().place(p))
            .collect();
        let mut sum = match (short, &places[..]) {
            (Some(few), [place]) => {
                let mut sum = self.algebra().real(0.0);
                for k in 1..=few {
                    let k = self.program.arena.integer(k);
                    let product = match dimensions[0].0 {
                        0 => term(self, *place, Some(k))?,
                        _ => term(self, k, Some(*place))?,
                    };
                    sum = self.algebra().add(sum, product);
                }
                sum
            }
            (_, [i]) => term(self, *i, None)?,
            (_, [i, j]) => term(self, *i, Some(*j))?,
            _ => return Ok(whole),
        };
        for (variable, _, range) in loops.into_iter().rev() {
            let kind = Kind::Fold {
                op: Fold::Sum,
                variable,
                range,
                condition: None,
                body: sum,
            };
            sum = self.program.arena.add(kind, Type::REAL);
        }
        Ok(sum)
    }

    /// `vec(a) ⋅ vec(b)`, and of sums of such: over the items of sequences, or the entries of matrices.
    fn inner_of_stacks(&mut self, a: ExprId, b: ExprId) -> Result<Option<ExprId>, Trouble> {
        let (mut length, mut tabulated) = (None, false);
        for e in [a, b] {
            let mut open = vec![e];
            while let Some(e) = open.pop() {
                match self.kind(e) {
                    Kind::Unary(Unary::Stack, inner) => {
                        tabulated |= match self.kind(inner) {
                            Kind::Tabulate { .. } => true,
                            Kind::Input(_) | Kind::Variable(_) => self.is_active(inner),
                            _ => false,
                        };
                        length = length.or(match self.program.arena.ty(inner) {
                            Type::Sequence { length, .. } => Some((length.clone(), inner)),
                            _ => None,
                        });
                    }
                    Kind::Binary(Binary::Add | Binary::Subtract, a, b) => open.extend([a, b]),
                    Kind::Unary(Unary::Negate, a)
                    | Kind::Binary(Binary::Multiply, _, a)
                    | Kind::Binary(Binary::Divide, a, _) => open.push(a),
                    _ => return Ok(None),
                }
            }
        }
        if !tabulated {
            return Ok(None);
        }
        let Some((length, sequence)) = length else {
            let of = [self.of_stack(a, None)?, self.of_stack(b, None)?];
            return match of {
                [Some(a), Some(b)] => self.inner(a, b).map(Some),
                _ => Ok(None),
            };
        };
        let size = self.algebra().size(sequence, 0);
        let (variable, place, range) = rewrite::each(&mut self.program.arena, &length, size);
        let (Some(a), Some(b)) = (
            self.of_stack(a, Some(place))?,
            self.of_stack(b, Some(place))?,
        ) else {
            return Ok(None);
        };
        let body = self.inner(a, b)?;
        let kind = Kind::Fold {
            op: Fold::Sum,
            variable,
            range,
            condition: None,
            body,
        };
        Ok(Some(self.program.arena.add(kind, Type::REAL)))
    }

    /// What is stacked: a matrix, or the item of a sequence at a place.
    fn of_stack(&mut self, e: ExprId, place: Option<ExprId>) -> Result<Option<ExprId>, Trouble> {
        match self.kind(e) {
            Kind::Unary(Unary::Stack, a) => {
                let (item, place) = match (self.program.arena.ty(a), place) {
                    (Type::Sequence { item, .. }, Some(place)) => ((**item).clone(), place),
                    (ty, None) if ty.shape().is_some() => return Ok(Some(a)),
                    _ => return Ok(None),
                };
                let active = self.is_active(a);
                let item = self.program.arena.add(Kind::Item(a, place), item);
                let item = match active {
                    true => self.rule(item)?,
                    false => item,
                };
                Ok(Some(rewrite::at_elements(&mut self.program.arena, item)))
            }
            Kind::Binary(op @ (Binary::Add | Binary::Subtract), a, b) => {
                let (Some(a), Some(b)) = (self.of_stack(a, place)?, self.of_stack(b, place)?)
                else {
                    return Ok(None);
                };
                let mut s = self.algebra();
                Ok(Some(match op {
                    Binary::Add => s.add(a, b),
                    _ => s.subtract(a, b),
                }))
            }
            Kind::Unary(Unary::Negate, a) => {
                let inner = self.of_stack(a, place)?;
                Ok(inner.map(|inner| self.algebra().negate(inner)))
            }
            Kind::Binary(Binary::Multiply, k, a) => {
                let inner = self.of_stack(a, place)?;
                Ok(inner.map(|inner| self.algebra().scale(k, inner)))
            }
            Kind::Binary(Binary::Divide, a, k) => {
                let inner = self.of_stack(a, place)?;
                Ok(inner.map(|inner| self.algebra().divide(inner, k)))
            }
            _ => Ok(None),
        }
    }

    /// Whether a value is given entry by entry, or made of such; nothing where an entry is as much work as all of them.
    fn is_known_by_entries(&mut self, e: ExprId) -> Option<bool> {
        if !self.is_active(e) {
            return Some(false);
        }
        match self.kind(e) {
            Kind::Tabulate { layout, .. } => (layout != Layout::Sequence).then_some(true),
            Kind::Unary(Unary::Negate | Unary::Transpose, a)
            | Kind::Binary(Binary::Multiply, _, a)
            | Kind::Binary(Binary::Divide, a, _)
            | Kind::Agree(_, _, a) => self.is_known_by_entries(a),
            Kind::Binary(Binary::Add | Binary::Subtract | Binary::Hadamard, a, b) => {
                let (a, b) = (self.is_known_by_entries(a)?, self.is_known_by_entries(b)?);
                Some(a || b)
            }
            Kind::Binary(Binary::Product, m, a) => match self.kind(m) {
                Kind::Unary(Unary::Diagonal, factors)
                    if is_vector(self.program.arena.ty(factors))
                        && is_vector(self.program.arena.ty(a)) =>
                {
                    let factors = self.is_known_by_entries(factors)?;
                    Some(factors | self.is_known_by_entries(a)?)
                }
                _ => None,
            },
            Kind::Input(_) | Kind::Variable(_) => Some(false),
            _ => None,
        }
    }

    /// The least or greatest of what is made of each entry.
    pub(super) fn extreme(
        &mut self,
        fold: Fold,
        a: ExprId,
        f: impl Fn(&mut Algebra<'_>, ExprId) -> ExprId,
    ) -> Result<ExprId, Trouble> {
        let op = match fold {
            Fold::Min => Binary::Min,
            _ => Binary::Max,
        };
        if let Some((n, m)) = self.algebra().fixed(a).filter(|(n, m)| n * m <= SMALL) {
            let mut best = None;
            for j in 1..=m {
                for i in 1..=n {
                    let entry = self.entry(a, i, j)?;
                    let value = f(&mut self.algebra(), entry);
                    best = Some(match best {
                        None => value,
                        Some(best) => self.algebra().binary(op, best, value, Type::REAL),
                    });
                }
            }
            return Ok(best.unwrap_or(a));
        }
        self.fold_entries(fold, a, f)
    }

    fn fold_entries(
        &mut self,
        op: Fold,
        a: ExprId,
        f: impl Fn(&mut Algebra<'_>, ExprId) -> ExprId,
    ) -> Result<ExprId, Trouble> {
        let matrix = matches!(self.program.arena.ty(a).shape(), Some(Shape::Matrix(..)));
        let sequence = matches!(self.program.arena.ty(a), Type::Sequence { .. });
        let (i, row) = self.index("i");
        let (j, column) = self.index("j");
        let entry = match (matrix, sequence) {
            (true, _) => self.program.arena.add(Kind::At(a, row, column), Type::REAL),
            (_, true) => self.program.arena.add(Kind::Item(a, row), Type::REAL),
            _ => self.program.arena.add(Kind::Component(a, row), Type::REAL),
        };
        let entry = self.rule(entry)?;
        let mut body = f(&mut self.algebra(), entry);
        let axes = match matrix {
            true => vec![(i, 0), (j, 1)],
            false => vec![(i, 0)],
        };
        for (variable, axis) in axes {
            let size = self.algebra().size(a, axis);
            let one = self.program.arena.integer(1);
            let kind = Kind::Fold {
                op,
                variable,
                range: Range::Integers(one, size),
                condition: None,
                body,
            };
            body = self.program.arena.add(kind, Type::REAL);
        }
        Ok(body)
    }

    /// A vector or matrix by what is done to each entry.
    pub(super) fn entry_by_entry(
        &mut self,
        e: ExprId,
        a: ExprId,
        f: impl Fn(&mut Algebra<'_>, ExprId) -> ExprId,
    ) -> Result<ExprId, Trouble> {
        let ty = self.algebra().dense(e);
        let (i, row) = self.index("i");
        if !is_vector(&ty) {
            let (j, column) = self.index("j");
            let entry = self.program.arena.add(Kind::At(a, row, column), Type::REAL);
            let entry = self.rule(entry)?;
            let body = f(&mut self.algebra(), entry);
            let sizes = vec![self.algebra().size(a, 0), self.algebra().size(a, 1)];
            let kind = Kind::Tabulate {
                layout: Layout::Matrix,
                variables: vec![i, j],
                sizes,
                body,
            };
            return Ok(self.program.arena.add(kind, ty));
        }
        if let Some((n, _)) = self.algebra().fixed(a).filter(|(n, _)| *n <= SMALL) {
            let mut items = Vec::new();
            for k in 1..=n {
                let entry = self.entry(a, k, 1)?;
                items.push(f(&mut self.algebra(), entry));
            }
            return Ok(self.program.arena.add(Kind::Vector(items), ty));
        }
        let entry = self.program.arena.add(Kind::Component(a, row), Type::REAL);
        let entry = self.rule(entry)?;
        let body = f(&mut self.algebra(), entry);
        let kind = Kind::Tabulate {
            layout: Layout::Vector,
            variables: vec![i],
            sizes: vec![self.algebra().size(a, 0)],
            body,
        };
        Ok(self.program.arena.add(kind, ty))
    }

    /// An entry by numbers, from 1.
    fn entry(&mut self, a: ExprId, i: i64, j: i64) -> Result<ExprId, Trouble> {
        let i = self.program.arena.integer(i);
        let j = self.program.arena.integer(j);
        let entry = self.algebra().at(a, i, j);
        match entry == a {
            true => Ok(entry),
            false => self.rule(entry),
        }
    }
}
