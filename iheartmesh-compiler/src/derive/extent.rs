//! The sizes of values.

use super::algebra::Algebra;
use crate::ir::{Binary, ExprId, Kind, Layout, Unary};
use crate::types::{Shape, Type};

impl Algebra<'_> {
    /// Number of rows or columns of an expression as a value.
    pub(super) fn size(&mut self, e: ExprId, axis: u8) -> ExprId {
        let known = match self.ty(e).shape() {
            Some(Shape::Scalar) => Some(1),
            Some(Shape::Vector(n)) => match axis {
                0 => n.value(),
                _ => Some(1),
            },
            Some(Shape::Matrix(n, m)) => match axis {
                0 => n.value(),
                _ => m.value(),
            },
            None => None,
        };
        match known {
            Some(n) => self.arena.integer(n),
            None => self.size_of_parts(e, axis),
        }
    }

    /// The same from what a value is made of, so that it need not be computed for its size.
    fn size_of_parts(&mut self, e: ExprId, axis: u8) -> ExprId {
        let is_vector = |s: &Self, e: ExprId| matches!(s.ty(e).shape(), Some(Shape::Vector(_)));
        match self.kind(e) {
            Kind::Tabulate { layout, sizes, .. } => match (layout, axis) {
                (Layout::Matrix, _) => sizes[usize::from(axis)],
                (Layout::Columns, 1) | (Layout::Vector | Layout::Sequence | Layout::Rows, 0) => {
                    sizes[0]
                }
                _ => self.arena.add(Kind::Extent(e, axis), Type::INTEGER),
            },
            Kind::Filled(_, sizes) if sizes.len() > usize::from(axis) => sizes[usize::from(axis)],
            Kind::Identity(n) => n,
            Kind::Unary(Unary::Negate | Unary::ToReal | Unary::Apply(_), a)
            | Kind::Binary(
                Binary::Add | Binary::Subtract | Binary::Hadamard | Binary::Divide,
                a,
                _,
            )
            | Kind::Binary(Binary::Multiply, _, a) => self.size(a, axis),
            Kind::Unary(Unary::Transpose, a) if !is_vector(self, a) => self.size(a, 1 - axis),
            Kind::Unary(Unary::Stack, a) if axis == 0 && self.ty(a).shape().is_some() => {
                let (n, m) = (self.size(a, 0), self.size(a, 1));
                self.count(Binary::Multiply, n, m)
            }
            Kind::Unary(Unary::Stack, a) if axis == 0 => {
                let each = match self.ty(a) {
                    Type::Sequence { item, .. } => super::count(&item).and_then(|n| n.value()),
                    _ => None,
                };
                match each {
                    Some(each) => {
                        let (each, n) = (self.arena.integer(each), self.size(a, 0));
                        self.count(Binary::Multiply, each, n)
                    }
                    None => self.arena.add(Kind::Extent(e, axis), Type::INTEGER),
                }
            }
            Kind::Binary(Binary::Product, a, _)
                if axis == 0 && matches!(self.ty(a).shape(), Some(Shape::Matrix(..))) =>
            {
                self.size(a, 0)
            }
            _ => self.arena.add(Kind::Extent(e, axis), Type::INTEGER),
        }
    }

    /// Rows and columns where both are known.
    pub(super) fn fixed(&self, e: ExprId) -> Option<(i64, i64)> {
        match self.arena.ty(e).shape()? {
            Shape::Scalar => Some((1, 1)),
            Shape::Vector(n) => Some((n.value()?, 1)),
            Shape::Matrix(n, m) => Some((n.value()?, m.value()?)),
        }
    }
}
