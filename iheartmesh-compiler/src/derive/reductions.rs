//! Arrays by their entries: sums and extrema over all of them, functions of each, determinants.

use super::Trouble;
use super::algebra::{Algebra, SMALL};
use super::normal::{Normal, is_vector};
use crate::ir::{Binary, ExprId, Fold, Kind, Layout, Range};
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
