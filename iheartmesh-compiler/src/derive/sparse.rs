//! Derivatives of vectors that are sparse matrices: where each entry takes a few items of the variable, and where sparse
//! matrices are multiplied with such vectors.

use super::algebra::SMALL;
use super::hessian::is_local;
use super::jacobian::{self, Rows};
use super::normal::{Normal, is_vector};
use super::reverse::{Reverse, Target};
use super::stencil::{self, Stencil, Wanted};
use super::{Trouble, count, size};
use crate::ir::{Binary, ExprId, Fold, Kind, Unary};
use crate::optimize::rewrite;
use crate::types::{Atom, Dimension, Shape, Type};

/// The derivative of a vector in normal form by `x`, as a sparse matrix; nothing where it is not known to be one.
pub(super) fn of(normal: &mut Normal<'_>, y: ExprId, x: ExprId) -> Result<Option<ExprId>, Trouble> {
    let ty = normal.algebra().ty(x);
    let width = match count(&ty) {
        Some(width) if width.value().is_none() => width,
        _ => return Ok(None),
    };
    let columns = size(normal, x);
    let is_count = |n: &Dimension| matches!(n.as_atom(), Some(Atom::Count(_)));
    let of_items = match (&ty, ty.shape()) {
        (Type::Sequence { .. }, _) => true,
        (_, Some(Shape::Vector(n))) => is_count(&n),
        (_, Some(Shape::Matrix(n, m))) => is_count(&n) || is_count(&m),
        _ => false,
    };
    let mut sparse = Sparse {
        normal,
        x,
        columns,
        width,
    };
    sparse.of(y, of_items)
}

struct Sparse<'n, 'a> {
    normal: &'n mut Normal<'a>,
    x: ExprId,
    columns: ExprId,
    width: Dimension,
}

impl Sparse<'_, '_> {
    fn ty(&self, y: ExprId) -> Option<Type> {
        let Some(Shape::Vector(rows)) = self.normal.program.arena.ty(y).shape() else {
            return None;
        };
        Some(sparse_matrix(rows, self.width.clone()))
    }

    /// The derivative of a vector; `entries` says whether one that is known by its entries gives a sparse matrix, as it does
    /// where the variable is made of items.
    fn of(&mut self, y: ExprId, entries: bool) -> Result<Option<ExprId>, Trouble> {
        let Some(ty) = self.ty(y) else {
            return Ok(None);
        };
        let sizes = [jacobian::length(self.normal, y), self.columns];
        if !self.normal.is_active(y) {
            return Ok(Some(zero(self.normal, sizes, ty)));
        }
        if jacobian::is_assembled(self.normal, y) && self.has_local_blocks(y) {
            let mut rows = Rows {
                normal: self.normal,
                x: self.x,
                sizes,
                ty,
            };
            return rows.of(y).map(Some);
        }
        if entries && matches!(self.normal.kind(y), Kind::Unary(Unary::Stack, a) if a == self.x) {
            let kind = Kind::Identity(self.columns);
            return Ok(Some(self.normal.program.arena.add(kind, ty)));
        }
        if entries && let Some(found) = self.by_entries(y, sizes, &ty)? {
            return Ok(Some(found));
        }
        let y = self.spread(y);
        match self.normal.kind(y) {
            Kind::Binary(op @ (Binary::Add | Binary::Subtract), a, b) => {
                let (Some(a), Some(b)) = (self.of(a, entries)?, self.of(b, entries)?) else {
                    return Ok(None);
                };
                let mut s = self.normal.algebra();
                Ok(Some(match op {
                    Binary::Add => s.add(a, b),
                    _ => s.subtract(a, b),
                }))
            }
            Kind::Unary(Unary::Negate, a) => {
                let inner = self.of(a, entries)?;
                Ok(inner.map(|inner| self.normal.algebra().negate(inner)))
            }
            Kind::Binary(Binary::Multiply, k, a) if !self.normal.is_active(k) => {
                let inner = self.of(a, entries)?;
                Ok(inner.map(|inner| self.normal.algebra().scale(k, inner)))
            }
            Kind::Binary(Binary::Divide, a, k) if !self.normal.is_active(k) => {
                let inner = self.of(a, entries)?;
                Ok(inner.map(|inner| self.normal.algebra().divide(inner, k)))
            }
            Kind::Binary(Binary::Product, m, a) if !self.normal.is_active(m) => {
                self.product(m, a, &ty)
            }
            Kind::Unary(Unary::Stack, a) => match self.normal.kind(a) {
                Kind::Binary(Binary::Product, m, a) if !self.normal.is_active(m) => {
                    self.stacked_product(m, a, &ty)
                }
                _ => Ok(None),
            },
            Kind::Unary(Unary::Reshape, a) | Kind::Agree(_, _, a)
                if is_vector(self.normal.program.arena.ty(a)) =>
            {
                self.of(a, entries)
            }
            _ => Ok(None),
        }
    }

    /// Entry by entry, where each takes a few items of the variable.
    fn by_entries(
        &mut self,
        y: ExprId,
        sizes: [ExprId; 2],
        ty: &Type,
    ) -> Result<Option<ExprId>, Trouble> {
        let mut pieces = Vec::new();
        if let Some((n, _)) = self.normal.algebra().fixed(y) {
            if n > SMALL {
                return Ok(None);
            }
            for k in 1..=n {
                let k = self.normal.program.arena.integer(k);
                pieces.push((jacobian::entry_at(self.normal, y, k)?, k));
            }
            return self.rows(&pieces, sizes, ty);
        }
        let (vector, dimension) = match self.normal.kind(y) {
            Kind::Unary(Unary::Stack, a) => return self.entries_of_stack(a, sizes, ty),
            _ => match self.normal.program.arena.ty(y).shape() {
                Some(Shape::Vector(n)) => (y, n),
                _ => return Ok(None),
            },
        };
        let (variable, place, range) =
            rewrite::each(&mut self.normal.program.arena, &dimension, sizes[0]);
        let entry = jacobian::entry_at(self.normal, vector, place)?;
        let rows = self.rows(&[(entry, place)], sizes, ty)?;
        Ok(rows.map(|rows| self.normal.summed(variable, range, None, rows)))
    }

    /// The entries of all items of a sequence, or of all rows or columns of a matrix.
    fn entries_of_stack(
        &mut self,
        a: ExprId,
        sizes: [ExprId; 2],
        ty: &Type,
    ) -> Result<Option<ExprId>, Trouble> {
        let own = self.normal.program.arena.ty(a).clone();
        let (length, items) = match (&own, own.shape()) {
            (Type::Sequence { item, length, .. }, _) => {
                let (n, m) = match item.shape() {
                    Some(Shape::Scalar) => (Some(1), Some(1)),
                    Some(Shape::Vector(n)) => (n.value(), Some(1)),
                    Some(Shape::Matrix(n, m)) => (n.value(), m.value()),
                    None => (None, None),
                };
                match (n, m) {
                    (Some(n), Some(m)) => (length.clone(), Items::Sequence(n, m)),
                    _ => return Ok(None),
                }
            }
            (_, Some(Shape::Matrix(n, m))) => match (n.value(), m.value()) {
                (None, Some(m)) => (n, Items::Rows(m)),
                (Some(n), None) => (m, Items::Columns(n)),
                _ => return Ok(None),
            },
            _ => return Ok(None),
        };
        let number = self.normal.algebra().size(a, items.axis());
        let (variable, place, range) =
            rewrite::each(&mut self.normal.program.arena, &length, number);
        let (height, width) = items.size();
        if height * width > SMALL {
            return Ok(None);
        }
        let mut pieces = Vec::new();
        for j in 1..=width {
            for i in 1..=height {
                let arena = &mut self.normal.program.arena;
                let all = arena.integer(height * width);
                let within = arena.integer((j - 1) * height + i);
                let (i, j) = (arena.integer(i), arena.integer(j));
                let mut s = self.normal.algebra();
                let place_of_item = s.place(place);
                let (entry, row) = match items {
                    Items::Sequence(..) => {
                        let Type::Sequence { item, .. } = &own else {
                            return Ok(None);
                        };
                        let raw = s.arena.add(Kind::Item(a, place), (**item).clone());
                        let row = s.inside(place, all, within);
                        let item = self.normal.rule(raw)?;
                        let entry = self.normal.algebra().at(item, i, j);
                        (entry, row)
                    }
                    Items::Rows(_) => {
                        let row = s.inside(j, number, place_of_item);
                        (s.at(a, place_of_item, j), row)
                    }
                    Items::Columns(_) => {
                        let row = s.inside(place, all, i);
                        (s.at(a, i, place_of_item), row)
                    }
                };
                let entry = match self.normal.kind(entry) {
                    Kind::Component(..) | Kind::At(..) => self.normal.rule(entry)?,
                    _ => entry,
                };
                let entry = rewrite::at_elements(&mut self.normal.program.arena, entry);
                pieces.push((entry, row));
            }
        }
        let rows = self.rows(&pieces, sizes, ty)?;
        Ok(rows.map(|rows| self.normal.summed(variable, range, None, rows)))
    }

    /// The derivatives of numbers, each in a row.
    fn rows(
        &mut self,
        pieces: &[(ExprId, ExprId)],
        sizes: [ExprId; 2],
        ty: &Type,
    ) -> Result<Option<ExprId>, Trouble> {
        let x = self.x;
        if !pieces.iter().all(|(e, _)| is_local(self.normal, *e, &[x])) {
            return Ok(None);
        }
        let mut sum = zero(self.normal, sizes, ty.clone());
        for (entry, row) in pieces {
            let target = Target::Row(*row, sizes, ty.clone());
            let slope = match stencil::has_items(&self.normal.algebra(), x) {
                true => {
                    let mut stencil = Stencil {
                        normal: self.normal,
                        x,
                        wanted: Wanted::Row(*row),
                        sizes: sizes.to_vec(),
                        ty: ty.clone(),
                        otherwise: |normal: &mut Normal<'_>, term| {
                            Reverse::of(normal, term, x, target.clone())
                        },
                    };
                    stencil.of(*entry)?
                }
                false => Reverse::of(self.normal, *entry, x, target)?,
            };
            sum = self.normal.algebra().add(sum, slope);
        }
        Ok(Some(sum))
    }

    /// The derivative of the product of a sparse matrix and a vector.
    fn product(&mut self, m: ExprId, a: ExprId, ty: &Type) -> Result<Option<ExprId>, Trouble> {
        let Some(m) = self.sparse_and_real(m) else {
            return Ok(None);
        };
        if a == self.x {
            return Ok(Some(of_type(self.normal, m, ty)));
        }
        let inner = self.of(a, true)?;
        Ok(inner.map(|inner| self.times(m, inner, ty)))
    }

    fn times(&mut self, m: ExprId, a: ExprId, ty: &Type) -> ExprId {
        match self.normal.kind(a) {
            Kind::Identity(_) => of_type(self.normal, m, ty),
            _ => self
                .normal
                .algebra()
                .binary(Binary::Product, m, a, ty.clone()),
        }
    }

    /// A sparse matrix of real numbers; nothing for a dense one.
    fn sparse_and_real(&mut self, m: ExprId) -> Option<ExprId> {
        let own = self.normal.program.arena.ty(m).clone();
        let Some(Shape::Matrix(rows, columns)) = own.shape() else {
            return None;
        };
        let ty = sparse_matrix(rows, columns);
        match (own.is_sparse(), own.is_integer()) {
            (false, _) => None,
            (true, false) => Some(m),
            (true, true) => Some(self.normal.algebra().unary(Unary::ToReal, m, ty)),
        }
    }

    /// `vec(M A)` is `(I ⊗ M) vec(A)`.
    fn stacked_product(
        &mut self,
        m: ExprId,
        a: ExprId,
        ty: &Type,
    ) -> Result<Option<ExprId>, Trouble> {
        let Some(m) = self.sparse_and_real(m) else {
            return Ok(None);
        };
        let (Some(Shape::Matrix(n, k)), Some(Shape::Matrix(rows, _))) = (
            self.normal.program.arena.ty(a).shape(),
            self.normal.program.arena.ty(m).shape(),
        ) else {
            return Ok(None);
        };
        let (Some(long), Some(high)) = (n.multiply(&k), rows.multiply(&k)) else {
            return Ok(None);
        };
        let stack = Type::real_vector(long.clone());
        let inner = self.normal.algebra().unary(Unary::Stack, a, stack);
        let Some(inner) = self.of(inner, true)? else {
            return Ok(None);
        };
        let mut s = self.normal.algebra();
        let columns = s.size(a, 1);
        let identity = Kind::Identity(columns);
        let identity = s.arena.add(identity, sparse_matrix(k.clone(), k));
        let repeated = sparse_matrix(high, long);
        let repeated = s.binary(Binary::Kronecker, identity, m, repeated);
        Ok(Some(self.times(repeated, inner, ty)))
    }

    /// `vec(a + b)` as `vec(a) + vec(b)`, and so on.
    fn spread(&mut self, y: ExprId) -> ExprId {
        let Kind::Unary(Unary::Stack, a) = self.normal.kind(y) else {
            return y;
        };
        let ty = self.normal.program.arena.ty(y).clone();
        let inner = self.normal.kind(a);
        let arena = &mut self.normal.program.arena;
        let mut stack = |a: ExprId| arena.add(Kind::Unary(Unary::Stack, a), ty.clone());
        let kind = match inner {
            Kind::Binary(op @ (Binary::Add | Binary::Subtract), a, b) => {
                Kind::Binary(op, stack(a), stack(b))
            }
            Kind::Unary(Unary::Negate, a) => Kind::Unary(Unary::Negate, stack(a)),
            Kind::Binary(Binary::Multiply, k, a) => Kind::Binary(Binary::Multiply, k, stack(a)),
            Kind::Binary(Binary::Divide, a, k) => Kind::Binary(Binary::Divide, stack(a), k),
            _ => return y,
        };
        self.normal.program.arena.add(kind, ty)
    }

    /// Whether what is put together from blocks has blocks that take a few items of the variable each, and nothing else.
    fn has_local_blocks(&mut self, e: ExprId) -> bool {
        if !self.normal.is_active(e) {
            return true;
        }
        match self.normal.kind(e) {
            Kind::Assemble { blocks, .. } => blocks
                .iter()
                .all(|block| is_local(self.normal, block.value, &[self.x])),
            Kind::Binary(Binary::Add, a, b) | Kind::If(_, a, b) => {
                self.has_local_blocks(a) && self.has_local_blocks(b)
            }
            Kind::Fold {
                op: Fold::Sum,
                body,
                ..
            } => self.has_local_blocks(body),
            _ => false,
        }
    }
}

/// What the entries of a matrix or sequence are taken from, one after the other; with the sizes that are known.
#[derive(Clone, Copy)]
enum Items {
    Sequence(i64, i64),
    Rows(i64),
    Columns(i64),
}

impl Items {
    /// Rows and columns of an item.
    fn size(self) -> (i64, i64) {
        match self {
            Self::Sequence(n, m) => (n, m),
            Self::Rows(m) => (1, m),
            Self::Columns(n) => (n, 1),
        }
    }

    fn axis(self) -> u8 {
        match self {
            Self::Sequence(..) | Self::Rows(_) => 0,
            Self::Columns(_) => 1,
        }
    }
}

fn zero(normal: &mut Normal<'_>, sizes: [ExprId; 2], ty: Type) -> ExprId {
    let kind = Kind::Assemble {
        sizes: sizes.to_vec(),
        blocks: Vec::new(),
    };
    normal.program.arena.add(kind, ty)
}

/// A matrix as one of a type whose sizes have other names. They are known to be equal: what has them stands beside one another
/// in a product.
pub(super) fn of_type(normal: &mut Normal<'_>, matrix: ExprId, ty: &Type) -> ExprId {
    if normal.program.arena.ty(matrix) == ty {
        return matrix;
    }
    let n = normal.algebra().size(matrix, 0);
    let kind = Kind::Agree(n, n, matrix);
    normal.program.arena.add(kind, ty.clone())
}

pub(super) fn sparse_matrix(rows: Dimension, columns: Dimension) -> Type {
    let mut ty = Type::real_matrix(rows, columns);
    if let Type::Matrix { sparse, .. } = &mut ty {
        *sparse = true;
    }
    ty
}
