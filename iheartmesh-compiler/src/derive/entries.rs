//! Entries, rows and columns are taken of what an array is made from.

use super::Trouble;
use super::normal::{Normal, is_vector};
use crate::ir::{Binary, ExprId, Kind, Layout, Unary};
use crate::types::{Shape, Type};

impl Normal<'_> {
    /// An item out of the entries of all items.
    pub(super) fn unstacked(
        &mut self,
        ty: &Type,
        entries: ExprId,
        index: ExprId,
    ) -> Result<ExprId, Trouble> {
        let (Some(n), Some(m)) = (match ty.shape() {
            Some(Shape::Scalar) => (Some(1), Some(1)),
            Some(Shape::Vector(n)) => (n.value(), Some(1)),
            Some(Shape::Matrix(n, m)) => (n.value(), m.value()),
            None => (None, None),
        }) else {
            return Err(Trouble::new(
                None,
                "items of a size that is not known cannot be differentiated here".to_owned(),
                "declare the items with a size in numbers, as in `x_i ∈ ℝ³`",
            ));
        };
        let size = self.program.arena.integer(n * m);
        let mut items = Vec::new();
        for k in 1..=n * m {
            let k = self.program.arena.integer(k);
            let place = self.algebra().inside(index, size, k);
            let entry = self.algebra().entry(entries, place);
            items.push(self.component(entry, entries, place)?);
        }
        Ok(match ty.shape() {
            Some(Shape::Scalar) => items[0],
            Some(Shape::Vector(_)) => self.program.arena.add(Kind::Vector(items), ty.clone()),
            _ => {
                let row = |i: i64| (0..m).map(|j| items[(i + j * n) as usize]).collect();
                let rows = (0..n).map(row).collect();
                self.program.arena.add(Kind::Blocks(rows), ty.clone())
            }
        })
    }

    fn added(&mut self, kind: Kind, ty: Type) -> Result<ExprId, Trouble> {
        let e = self.program.arena.add(kind, ty);
        self.rule(e)
    }

    /// An entry of a vector.
    pub(super) fn component(
        &mut self,
        e: ExprId,
        vector: ExprId,
        k: ExprId,
    ) -> Result<ExprId, Trouble> {
        let entry = |inner| Kind::Component(inner, k);
        let dynamic = self.algebra().fixed(vector).is_none();
        match self.kind(vector) {
            Kind::Vector(items) => Ok(match self.kind(k) {
                Kind::Integer(k) if k >= 1 && k <= items.len() as i64 => items[k as usize - 1],
                _ => e,
            }),
            Kind::Tabulate {
                layout: Layout::Vector,
                variables,
                body,
                ..
            } => self.beta(body, &[(variables[0], k)]),
            Kind::Filled(value, _) => Ok(value),
            Kind::ColumnOf(a, j) => self.added(Kind::At(a, k, j), Type::REAL),
            Kind::RowOf(a, i) => self.added(Kind::At(a, i, k), Type::REAL),
            Kind::Agree(_, _, inner) => self.added(entry(inner), Type::REAL),
            Kind::Unary(Unary::Reshape, a) => match self.program.arena.ty(a).shape() {
                Some(Shape::Scalar) => Ok(a),
                Some(Shape::Vector(_)) => self.added(entry(a), Type::REAL),
                _ => {
                    let one = self.program.arena.integer(1);
                    self.added(Kind::At(a, k, one), Type::REAL)
                }
            },
            _ if !dynamic => Ok(e),
            Kind::Unary(Unary::Negate, a) => {
                let inner = self.added(entry(a), Type::REAL)?;
                Ok(self.algebra().negate(inner))
            }
            Kind::Unary(Unary::Diagonal, a) => self.added(Kind::At(a, k, k), Type::REAL),
            Kind::Binary(op @ (Binary::Add | Binary::Subtract | Binary::Hadamard), a, b) => {
                let a = self.entry_of(a, k)?;
                let b = self.entry_of(b, k)?;
                let mut algebra = self.algebra();
                Ok(match op {
                    Binary::Add => algebra.add(a, b),
                    Binary::Subtract => algebra.subtract(a, b),
                    _ => algebra.scale(a, b),
                })
            }
            Kind::Binary(Binary::Multiply, factor, a) => {
                let a = self.added(entry(a), Type::REAL)?;
                Ok(self.algebra().scale(factor, a))
            }
            Kind::Binary(Binary::Divide, a, divisor) => {
                let a = self.added(entry(a), Type::REAL)?;
                Ok(self.algebra().divide(a, divisor))
            }
            Kind::Binary(Binary::Product, a, b)
                if is_vector(self.program.arena.ty(b)) && !is_vector(self.program.arena.ty(a)) =>
            {
                if let Kind::Unary(Unary::Diagonal, factors) = self.kind(a)
                    && is_vector(self.program.arena.ty(factors))
                {
                    let factor = self.added(Kind::Component(factors, k), Type::REAL)?;
                    let b = self.added(entry(b), Type::REAL)?;
                    return Ok(self.algebra().scale(factor, b));
                }
                let Some(Shape::Matrix(_, m)) = self.program.arena.ty(a).shape() else {
                    return Ok(e);
                };
                let row = self.added(Kind::RowOf(a, k), Type::real_vector(m))?;
                Ok(self.algebra().inner(b, row))
            }
            _ => Ok(e),
        }
    }

    /// An entry of a vector or of a matrix with one column.
    fn entry_of(&mut self, a: ExprId, k: ExprId) -> Result<ExprId, Trouble> {
        match is_vector(self.program.arena.ty(a)) {
            true => self.added(Kind::Component(a, k), Type::REAL),
            false => {
                let one = self.program.arena.integer(1);
                self.added(Kind::At(a, k, one), Type::REAL)
            }
        }
    }

    /// An entry of a matrix.
    pub(super) fn at(
        &mut self,
        e: ExprId,
        a: ExprId,
        i: ExprId,
        j: ExprId,
    ) -> Result<ExprId, Trouble> {
        let dynamic = self.algebra().fixed(a).is_none();
        match self.kind(a) {
            Kind::Tabulate {
                layout: Layout::Matrix,
                variables,
                body,
                ..
            } => self.beta(body, &[(variables[0], i), (variables[1], j)]),
            Kind::Tabulate {
                layout: Layout::Rows,
                variables,
                body,
                ..
            } => {
                let row = self.beta(body, &[(variables[0], i)])?;
                self.added(Kind::Component(row, j), Type::REAL)
            }
            Kind::Tabulate {
                layout: Layout::Columns,
                variables,
                body,
                ..
            } => {
                let column = self.beta(body, &[(variables[0], j)])?;
                self.added(Kind::Component(column, i), Type::REAL)
            }
            Kind::Filled(value, _) => Ok(value),
            Kind::Agree(_, _, inner) => self.added(Kind::At(inner, i, j), Type::REAL),
            Kind::Unary(Unary::Transpose, inner) => match is_vector(self.program.arena.ty(inner)) {
                true => self.added(Kind::Component(inner, j), Type::REAL),
                false => self.added(Kind::At(inner, j, i), Type::REAL),
            },
            Kind::Unary(Unary::Reshape, inner) => match self.program.arena.ty(inner).shape() {
                Some(Shape::Scalar) => Ok(inner),
                Some(Shape::Vector(_)) => self.added(Kind::Component(inner, i), Type::REAL),
                _ => self.added(Kind::At(inner, i, j), Type::REAL),
            },
            // a table of numbers
            Kind::Blocks(rows)
                if rows
                    .iter()
                    .flatten()
                    .all(|b| self.program.arena.ty(*b).is_scalar()) =>
            {
                Ok(match (self.kind(i), self.kind(j)) {
                    (Kind::Integer(i), Kind::Integer(j)) if i >= 1 && j >= 1 => rows
                        .get(i as usize - 1)
                        .and_then(|row| row.get(j as usize - 1))
                        .copied()
                        .unwrap_or(e),
                    _ => e,
                })
            }
            Kind::Blocks(rows) if rows.len() == 1 => {
                let columns = &rows[0];
                let all = columns.iter().all(|b| is_vector(self.program.arena.ty(*b)));
                match (all, self.kind(j)) {
                    (true, Kind::Integer(j)) if j >= 1 && j <= columns.len() as i64 => {
                        self.added(Kind::Component(columns[j as usize - 1], i), Type::REAL)
                    }
                    _ => Ok(e),
                }
            }
            _ if !dynamic => Ok(e),
            Kind::Unary(Unary::Negate, a) => {
                let entry = self.added(Kind::At(a, i, j), Type::REAL)?;
                Ok(self.algebra().negate(entry))
            }
            Kind::Binary(op @ (Binary::Add | Binary::Subtract | Binary::Hadamard), a, b) => {
                let a = self.added(Kind::At(a, i, j), Type::REAL)?;
                let b = self.added(Kind::At(b, i, j), Type::REAL)?;
                let mut algebra = self.algebra();
                Ok(match op {
                    Binary::Add => algebra.add(a, b),
                    Binary::Subtract => algebra.subtract(a, b),
                    _ => algebra.scale(a, b),
                })
            }
            Kind::Binary(Binary::Multiply, factor, a) => {
                let entry = self.added(Kind::At(a, i, j), Type::REAL)?;
                Ok(self.algebra().scale(factor, entry))
            }
            Kind::Binary(Binary::Divide, a, divisor) => {
                let entry = self.added(Kind::At(a, i, j), Type::REAL)?;
                Ok(self.algebra().divide(entry, divisor))
            }
            _ => Ok(e),
        }
    }

    /// A row of a matrix as a vector.
    pub(super) fn row_of(&mut self, e: ExprId, a: ExprId, i: ExprId) -> Result<ExprId, Trouble> {
        match self.kind(a) {
            Kind::Tabulate {
                layout: Layout::Rows,
                variables,
                body,
                ..
            } => self.beta(body, &[(variables[0], i)]),
            Kind::Unary(Unary::Transpose, inner) => {
                let ty = self.program.arena.ty(e).clone();
                match is_vector(self.program.arena.ty(inner)) {
                    true => Ok(inner),
                    false => self.added(Kind::ColumnOf(inner, i), ty),
                }
            }
            _ => Ok(e),
        }
    }

    /// A column of a matrix as a vector.
    pub(super) fn column_of(&mut self, e: ExprId, a: ExprId, j: ExprId) -> Result<ExprId, Trouble> {
        match self.kind(a) {
            Kind::Tabulate {
                layout: Layout::Columns,
                variables,
                body,
                ..
            } => self.beta(body, &[(variables[0], j)]),
            Kind::Unary(Unary::Transpose, inner) if !is_vector(self.program.arena.ty(inner)) => {
                let ty = self.program.arena.ty(e).clone();
                self.added(Kind::RowOf(inner, j), ty)
            }
            Kind::Blocks(rows) if rows.len() == 1 => {
                let columns = &rows[0];
                let all = columns.iter().all(|b| is_vector(self.program.arena.ty(*b)));
                Ok(match (all, self.kind(j)) {
                    (true, Kind::Integer(j)) if j >= 1 && j <= columns.len() as i64 => {
                        columns[j as usize - 1]
                    }
                    _ => e,
                })
            }
            _ => Ok(e),
        }
    }
}
