//! Derivatives of vectors.

use super::algebra::SMALL;
use super::loops::spread;
use super::normal::Normal;
use super::reverse::{Reverse, Target};
use super::{Trouble, count, gradient, size, sparse, tabulated};
use crate::ir::{Binary, Block, ExprId, Fold, Kind, Layout, Range};
use crate::types::{Dimension, Shape, Type};

/// The derivative of a vector in normal form by `x`: a vector where `x` is a number, else a matrix, a sparse one where the
/// vector is known to be the derivative of a sum of terms of a few items each.
pub(super) fn jacobian(
    normal: &mut Normal<'_>,
    y: ExprId,
    x: ExprId,
    is_sum: bool,
) -> Result<ExprId, Trouble> {
    let ty = normal.algebra().dense(y);
    let Some(Shape::Vector(rows)) = ty.shape() else {
        return Err(Trouble::new(
            normal.program.arena.origin(y),
            "only numbers and vectors are differentiated".to_owned(),
            "write `vec(A)` for the entries of a matrix",
        ));
    };
    let n = length(normal, y);
    if normal.algebra().ty(x).is_scalar() {
        if let Some(known) = rows.value().filter(|n| *n <= SMALL) {
            let mut items = Vec::new();
            for k in 1..=known {
                let entry = entry(normal, y, k)?;
                items.push(gradient(normal, entry, x)?);
            }
            return Ok(normal.algebra().arena.add(Kind::Vector(items), ty));
        }
        return tabulated(normal, Layout::Vector, n, ty, |normal, k| {
            let entry = entry_at(normal, y, k)?;
            gradient(normal, entry, x)
        });
    }
    if !is_sum && let Some(sparse) = sparse::of(normal, y, x)? {
        return Ok(sparse);
    }
    let columns = size(normal, x);
    let width = count(&normal.algebra().ty(x)).unwrap_or_else(|| Dimension::known(0));
    let is_fixed = rows.value().is_some() && width.value().is_some();
    let mut ty = Type::real_matrix(rows, width);
    if let Type::Matrix { sparse: stored, .. } = &mut ty {
        *stored = is_sum && !is_fixed;
    }
    let mut rows = Rows {
        normal,
        x,
        sizes: [n, columns],
        ty,
    };
    rows.of(y)
}

/// The number of entries of a vector.
pub(super) fn length(normal: &mut Normal<'_>, y: ExprId) -> ExprId {
    let mut open = vec![y];
    while let Some(e) = open.pop() {
        match normal.kind(e) {
            Kind::Assemble { sizes, .. } => return sizes[0],
            Kind::Binary(Binary::Add, a, b) | Kind::If(_, a, b) => open.extend([a, b]),
            Kind::Fold { body, .. } => open.push(body),
            _ => {}
        }
    }
    normal.algebra().size(y, 0)
}

fn entry(normal: &mut Normal<'_>, y: ExprId, k: i64) -> Result<ExprId, Trouble> {
    let k = normal.program.arena.integer(k);
    entry_at(normal, y, k)
}

/// An entry of a vector, in normal form.
pub(super) fn entry_at(normal: &mut Normal<'_>, y: ExprId, k: ExprId) -> Result<ExprId, Trouble> {
    let raw = normal.algebra().entry(y, k);
    match normal.kind(raw) {
        Kind::Component(..) => normal.rule(raw),
        _ => Ok(raw),
    }
}

/// Collects the rows of a matrix of derivatives.
pub(super) struct Rows<'n, 'a> {
    pub(super) normal: &'n mut Normal<'a>,
    pub(super) x: ExprId,
    pub(super) sizes: [ExprId; 2],
    pub(super) ty: Type,
}

impl Rows<'_, '_> {
    /// The derivatives of a vector.
    pub(super) fn of(&mut self, y: ExprId) -> Result<ExprId, Trouble> {
        if !self.normal.is_active(y) {
            return Ok(self.zero());
        }
        if !is_assembled(self.normal, y) {
            return self.dense(y);
        }
        match self.normal.kind(y) {
            Kind::Assemble { blocks, .. } => {
                let mut sum = self.zero();
                for block in blocks {
                    let rows = self.block(&block)?;
                    sum = self.normal.algebra().add(sum, rows);
                }
                Ok(sum)
            }
            Kind::Binary(Binary::Add, a, b) => {
                let (a, b) = (self.of(a)?, self.of(b)?);
                Ok(self.normal.algebra().add(a, b))
            }
            Kind::If(condition, a, b) => {
                let (a, b) = (self.of(a)?, self.of(b)?);
                Ok(self.normal.algebra().choose(condition, a, b))
            }
            Kind::Fold {
                variable,
                range,
                condition,
                body,
                ..
            } => {
                let body = self.of(body)?;
                Ok(self.normal.summed(variable, range, condition, body))
            }
            _ => self.dense(y),
        }
    }

    fn zero(&mut self) -> ExprId {
        let kind = Kind::Assemble {
            sizes: self.sizes.to_vec(),
            blocks: Vec::new(),
        };
        self.normal.program.arena.add(kind, self.ty.clone())
    }

    /// The derivatives of a number, in the row of this number.
    fn row(&mut self, y: ExprId, row: ExprId) -> Result<ExprId, Trouble> {
        let target = Target::Row(row, self.sizes, self.ty.clone());
        Reverse::of(self.normal, y, self.x, target)
    }

    /// The rows of a block.
    fn block(&mut self, block: &Block) -> Result<ExprId, Trouble> {
        if !block.columns.is_empty() {
            return Err(Trouble::new(
                None,
                "third derivatives are known of numbers only".to_owned(),
                "differentiate a number by numbers",
            ));
        }
        let value = block.value;
        let mut s = self.normal.algebra();
        let fixed = s
            .fixed(value)
            .filter(|(n, m)| n * m <= SMALL || block.rows.len() > 1);
        let (n, m) = (s.size(value, 0), s.size(value, 1));
        let all = s.count(Binary::Multiply, n, m);
        if let Some((n, m)) = fixed {
            let mut sum = self.zero();
            for k in 1..=n * m {
                let mut s = self.normal.algebra();
                let (i, j) = (
                    s.arena.integer((k - 1) % n + 1),
                    s.arena.integer((k - 1) / n + 1),
                );
                let k = s.arena.integer(k);
                let row = spread(&mut s, &block.rows, all, k);
                let entry = self.entry(value, i, j)?;
                let rows = self.row(entry, row)?;
                sum = self.normal.algebra().add(sum, rows);
            }
            return Ok(sum);
        }
        let (i, up) = self.normal.index("i");
        let (j, across) = self.normal.index("j");
        let mut s = self.normal.algebra();
        let k = s.inside(across, n, up);
        let row = spread(&mut s, &block.rows, all, k);
        let one = s.arena.integer(1);
        let matrix = matches!(s.ty(value).shape(), Some(Shape::Matrix(..)));
        let (entry, row) = match matrix {
            true => (self.entry(value, up, across)?, row),
            false => {
                let row = spread(&mut s, &block.rows, all, up);
                (self.entry(value, up, one)?, row)
            }
        };
        let mut sum = self.row(entry, row)?;
        sum = self.normal.summed(i, Range::Integers(one, n), None, sum);
        if matrix {
            sum = self.normal.summed(j, Range::Integers(one, m), None, sum);
        }
        Ok(sum)
    }

    fn entry(&mut self, value: ExprId, i: ExprId, j: ExprId) -> Result<ExprId, Trouble> {
        let raw = self.normal.algebra().at(value, i, j);
        match self.normal.kind(raw) {
            Kind::Component(..) | Kind::At(..) if raw != value => self.normal.rule(raw),
            _ => Ok(raw),
        }
    }

    /// The derivatives of a vector entry by entry.
    fn dense(&mut self, y: ExprId) -> Result<ExprId, Trouble> {
        if let Some((n, _)) = self.normal.algebra().fixed(y).filter(|(n, _)| *n <= SMALL) {
            let mut sum = self.zero();
            for k in 1..=n {
                let entry = entry(self.normal, y, k)?;
                let k = self.normal.program.arena.integer(k);
                let row = self.row(entry, k)?;
                sum = self.normal.algebra().add(sum, row);
            }
            return Ok(sum);
        }
        let x = self.x;
        let (n, ty) = (self.sizes[0], self.ty.clone());
        tabulated(self.normal, Layout::Rows, n, ty, |normal, k| {
            let entry = entry_at(normal, y, k)?;
            gradient(normal, entry, x)
        })
    }
}

/// Whether a vector is put together from blocks.
pub(super) fn is_assembled(normal: &Normal<'_>, e: ExprId) -> bool {
    match normal.kind(e) {
        Kind::Assemble { .. } => true,
        Kind::Binary(Binary::Add, a, b) | Kind::If(_, a, b) => {
            is_assembled(normal, a) || is_assembled(normal, b)
        }
        Kind::Fold {
            op: Fold::Sum,
            body,
            ..
        } => is_assembled(normal, body),
        _ => false,
    }
}
