//! Products and solves: which operands they take and what they give.

use super::Checker;
use super::operator::{Sides, differ, extents};
use super::wording::{NOT_NUMBERS, ONE_MESH};
use crate::ir::{Binary, ExprId, Kind, Unary};
use crate::span::Span;
use crate::syntax::ast::ExprKind;
use crate::types::display::plural;
use crate::types::{Atom, Dimension, Number, Shape, Type};

impl<'a> Checker<'a> {
    /// A sequence of numbers as a vector, where it stands beside a vector or a matrix; anything else as it is. `axis` says
    /// which size of a matrix it must have.
    pub(super) fn with_entries(
        &mut self,
        e: ExprId,
        span: Span,
        other: ExprId,
        axis: u8,
    ) -> ExprId {
        let wanted = match (self.ty(other), axis) {
            (
                Type::Vector {
                    length,
                    space: None,
                    ..
                },
                _,
            ) => length.clone(),
            (Type::Matrix { rows, .. }, 0) => rows.clone(),
            (Type::Matrix { columns, .. }, _) => columns.clone(),
            _ => return e,
        };
        // one that is transposed stands beside rows
        let (sequence, transposed) = match *self.program.arena.kind(e) {
            Kind::Unary(Unary::Transpose, column) => match *self.program.arena.kind(column) {
                Kind::Unary(Unary::Stack, sequence) => (sequence, true),
                _ => return e,
            },
            _ => (e, false),
        };
        let Type::Sequence { item, length, .. } = self.ty(sequence).clone() else {
            return e;
        };
        if !item.is_scalar() {
            return e;
        }
        let mut own = self.numbers_of(sequence);
        if let Some(Atom::Length(letter)) = length.as_atom() {
            let wanted_vector = Type::real_vector(wanted.clone());
            if self.tie([&length, &wanted], letter) {
                let kind = self.program.arena.kind(own).clone();
                own = self.add(kind, wanted_vector);
            } else if let (Some(n), Some(m)) = (self.size(&wanted), self.size(&length)) {
                own = self.add_at(span, Kind::Agree(n, m, own), wanted_vector);
            }
        }
        match (transposed, self.ty(own).shape()) {
            (true, Some(Shape::Vector(n))) => {
                let row = Shape::Matrix(Dimension::known(1), n);
                self.real_unary(Unary::Transpose, own, row)
            }
            _ => own,
        }
    }

    /// The vector of the numbers in a sequence.
    pub(super) fn numbers_of(&mut self, sequence: ExprId) -> ExprId {
        let Type::Sequence { item, length, .. } = self.ty(sequence).clone() else {
            return sequence;
        };
        let reals = Type::Sequence {
            item: Box::new(Type::REAL),
            length: length.clone(),
            index: None,
        };
        let items = match item.is_integer() {
            true => self.convert(sequence, &reals),
            false => sequence,
        };
        self.add(Kind::Unary(Unary::Stack, items), Type::real_vector(length))
    }

    pub(super) fn product(&mut self, sides: Sides<'a>, a: ExprId, b: ExprId, dot: bool) -> ExprId {
        let (ta, tb) = (self.ty(a).clone(), self.ty(b).clone());
        if let (
            Type::Matrix {
                spaces: Some((_, columns)),
                ..
            },
            Type::Matrix {
                spaces: Some((rows, _)),
                ..
            },
        ) = (&ta, &tb)
            && columns.mesh != rows.mesh
        {
            return self.mismatch(sides, "multiply", "and", &ta, &tb, ONE_MESH);
        }
        let is_chain = matches!(tb, Type::Vector { space: Some(_), .. });
        let (a, b) = match is_chain {
            true => (a, b),
            false => (
                self.in_numbers_beside(a, &tb),
                self.in_numbers_beside(b, &ta),
            ),
        };
        let (ta, tb) = (self.ty(a).clone(), self.ty(b).clone());
        match (&ta, &tb) {
            (Type::Scalar(_), Type::Scalar(_)) => {
                let (a, b) = self.common(a, b);
                let ty = self.ty(a).clone();
                self.add_at(sides.e.span, Kind::Binary(Binary::Multiply, a, b), ty)
            }
            (Type::Scalar(_), _) if tb.shape().is_some() => {
                let (a, b) = (self.real(a), self.real(b));
                let ty = self.ty(b).clone();
                self.add_at(sides.e.span, Kind::Binary(Binary::Multiply, a, b), ty)
            }
            (_, Type::Scalar(_)) if ta.shape().is_some() => {
                let (a, b) = (self.real(a), self.real(b));
                let ty = self.ty(a).clone();
                self.add(Kind::Binary(Binary::Multiply, b, a), ty)
            }
            (Type::Vector { space: None, .. }, Type::Vector { space: None, .. })
                if dot && self.same_shape(&ta, &tb).is_some() =>
            {
                let (a, b) = (self.real(a), self.real(b));
                self.add(Kind::Binary(Binary::Dot, a, b), Type::REAL)
            }
            _ if matches!(
                (ta.shape(), tb.shape()),
                (Some(Shape::Matrix(..)), Some(_)) | (Some(_), Some(Shape::Matrix(..)))
            ) =>
            {
                self.matrix_product(sides, a, b)
            }
            (Type::Vector { space: None, .. }, Type::Vector { space: None, .. }) if dot => self
                .mismatch(
                    sides,
                    "take the dot product of",
                    "and",
                    &ta,
                    &tb,
                    "both vectors must have the same length",
                ),
            (Type::Vector { .. }, Type::Vector { .. }) if !dot => self.mismatch(
                sides,
                "multiply",
                "and",
                &ta,
                &tb,
                "write `u⋅v` for the dot product and `u × v` for the cross product",
            ),
            (
                Type::Matrix {
                    spaces: Some((_, columns)),
                    ..
                },
                Type::Vector {
                    space: Some(space), ..
                },
            ) => {
                if columns == space {
                    let (a, b) = (self.in_numbers(a), self.in_numbers(b));
                    return self.product(sides, a, b, dot);
                }
                let help = match columns.mesh == space.mesh {
                    true => format!("this matrix takes chains of {}", plural(columns.kind)),
                    false => ONE_MESH.to_owned(),
                };
                self.mismatch(sides, "multiply", "and", &ta, &tb, &help)
            }
            (Type::Sequence { .. }, Type::Scalar(Number::Integer) | Type::Element(_))
            | (Type::Vector { space: None, .. }, Type::Element(_))
                if let (ExprKind::Name(u), ExprKind::Name(v)) =
                    (&sides.left.kind, &sides.right.kind) =>
            {
                let (u, v) = (&u.text, &v.text);
                let help = format!(
                    "write `{u}_{v}` for what `{u}` has for `{v}`; only functions are called with parentheses"
                );
                self.mismatch(sides, "multiply", "and", &ta, &tb, &help)
            }
            (Type::Element(_), _) | (_, Type::Element(_)) => {
                self.mismatch(sides, "multiply", "and", &ta, &tb, NOT_NUMBERS)
            }
            (Type::Sequence { .. }, _) | (_, Type::Sequence { .. }) => self.mismatch(
                sides,
                "multiply",
                "and",
                &ta,
                &tb,
                "a sequence has no products; `x_i` is an item of `x`, and `y_i = 2x_i` a sequence",
            ),
            (Type::Vector { space: Some(_), .. }, _) | (_, Type::Vector { space: Some(_), .. }) => {
                self.mismatch(
                    sides,
                    "multiply",
                    "and",
                    &ta,
                    &tb,
                    "chains are multiplied by boundary matrices and their transposes, the one beside the chain first, as in `B (C δ)`",
                )
            }
            _ => self.mismatch(
                sides,
                "multiply",
                "and",
                &ta,
                &tb,
                "numbers, vectors and matrices have products, sets and tuples have none",
            ),
        }
    }

    /// The product of a matrix and a vector or another matrix; `A⁻¹ b` is the solution of `A x = b`.
    fn matrix_product(&mut self, sides: Sides<'a>, a: ExprId, b: ExprId) -> ExprId {
        if let Kind::Unary(Unary::Inverse, matrix) = *self.program.arena.kind(a) {
            return self.solve(sides, matrix, b);
        }
        let (ta, tb) = (self.ty(a).clone(), self.ty(b).clone());
        let one = Dimension::known(1);
        let (Some((n, k)), Some((l, m))) =
            (ta.shape().and_then(extents), tb.shape().and_then(extents))
        else {
            return self.mismatch(sides, "multiply", "and", &ta, &tb, "their sizes do not fit");
        };
        if k.differs(&l) {
            let help = match (ta.shape(), tb.shape()) {
                (Some(Shape::Vector(_)), Some(Shape::Matrix(_, m))) if m == one => {
                    "a matrix with one column is no vector here: write it as `(a, b)`".to_owned()
                }
                _ => format!(
                    "the left side has {}, the right side {}",
                    counted(&k, "column"),
                    counted(&l, "row")
                ),
            };
            return self.mismatch(sides, "multiply", "and", &ta, &tb, &help);
        }
        let ty = match tb.shape() {
            _ if n == one && m == one => Type::REAL,
            Some(Shape::Vector(_)) => Type::real_vector(n),
            _ => Type::Matrix {
                number: Number::Real,
                rows: n,
                columns: m,
                sparse: ta.is_sparse() && tb.is_sparse(),
                spaces: None,
            },
        };
        let (a, b) = (self.real(a), self.real(b));
        self.add(Kind::Binary(Binary::Product, a, b), ty)
    }

    /// The shape of two values that can be added: the same, or a vector and a matrix with one column, or a number and a
    /// 1×1 matrix.
    pub(super) fn same_shape(&self, a: &Type, b: &Type) -> Option<Shape> {
        let (a, b) = (a.shape()?, b.shape()?);
        if !differ(&a, &b) {
            return Some(a);
        }
        let one = Dimension::known(1);
        match (&a, &b) {
            (Shape::Vector(n), Shape::Matrix(m, k)) | (Shape::Matrix(m, k), Shape::Vector(n))
                if *k == one && !n.differs(m) =>
            {
                Some(Shape::Vector(n.clone()))
            }
            (Shape::Scalar, Shape::Matrix(n, m)) | (Shape::Matrix(n, m), Shape::Scalar)
                if *n == one && *m == one =>
            {
                Some(Shape::Scalar)
            }
            _ => None,
        }
    }

    /// A value in a shape that it can take.
    pub(super) fn shaped(&mut self, value: ExprId, shape: &Shape) -> ExprId {
        let value = self.real(value);
        match self.ty(value).shape() {
            Some(own) if std::mem::discriminant(&own) == std::mem::discriminant(shape) => value,
            _ => self.add(Kind::Unary(Unary::Reshape, value), shape.clone().real()),
        }
    }

    /// A power of a sparse matrix with a small exponent that stands in the text: products, which are sparse.
    pub(super) fn sparse_power(&mut self, a: ExprId, exponent: ExprId) -> Option<ExprId> {
        const MOST: i64 = 16;
        let a = self.real(a);
        let ty = self.ty(a).clone();
        let mut k = match self.program.arena.kind(exponent) {
            Kind::Integer(k) if ty.is_sparse() && (1..=MOST).contains(k) => *k,
            _ => return None,
        };
        // by repeated squaring
        let (mut square, mut power) = (a, None);
        loop {
            if k % 2 == 1 {
                power = Some(match power {
                    None => square,
                    Some(p) => self.add(Kind::Binary(Binary::Product, p, square), ty.clone()),
                });
            }
            k /= 2;
            if k == 0 {
                return power;
            }
            square = self.add(Kind::Binary(Binary::Product, square, square), ty.clone());
        }
    }

    /// An operation on operands of one size.
    pub(super) fn entrywise(&mut self, op: Binary, a: ExprId, b: ExprId, shape: Shape) -> ExprId {
        let (a, b) = (self.real(a), self.real(b));
        if matches!(shape, Shape::Scalar) && self.ty(a).is_scalar() {
            return self.add(Kind::Binary(Binary::Multiply, a, b), Type::REAL);
        }
        let is_sparse = self.ty(a).is_sparse() || self.ty(b).is_sparse();
        let ty = match shape {
            // what is 0 on one side is 0
            Shape::Matrix(rows, columns) if is_sparse => Type::sparse_matrix(rows, columns),
            shape => shape.real(),
        };
        self.add(Kind::Binary(op, a, b), ty)
    }

    /// `A \\ b`, `A⁻¹ b`.
    pub(super) fn solve(&mut self, sides: Sides<'a>, a: ExprId, b: ExprId) -> ExprId {
        let (ta, tb) = (self.ty(a).clone(), self.ty(b).clone());
        match (ta.shape(), tb.shape()) {
            (Some(Shape::Scalar), Some(_)) => {
                let (a, b) = (self.real(a), self.real(b));
                let ty = self.ty(b).clone();
                self.add(Kind::Binary(Binary::Divide, b, a), ty)
            }
            (Some(Shape::Matrix(n, m)), Some(right @ (Shape::Vector(_) | Shape::Matrix(..)))) => {
                if n.differs(&m) {
                    // of `A⁻¹ b` the matrix is `A`
                    let matrix = match &sides.left.kind {
                        ExprKind::Unary { operand, .. } => operand,
                        _ => sides.left,
                    };
                    return self.not_square(sides.e.span, "solve with", matrix, &ta);
                }
                let rows = match &right {
                    Shape::Vector(rows) | Shape::Matrix(rows, _) => rows.clone(),
                    Shape::Scalar => return self.error(),
                };
                if n.differs(&rows) {
                    return self.mismatch(
                        sides,
                        "solve with",
                        "and the right side",
                        &ta,
                        &tb,
                        "the right side must have as many rows as the matrix",
                    );
                }
                let a = self.squared(sides.e.span, a);
                let (a, b) = (self.real(a), self.real(b));
                let ty = match right {
                    Shape::Matrix(n, m) if ta.is_sparse() && tb.is_sparse() => {
                        Type::sparse_matrix(n, m)
                    }
                    right => right.real(),
                };
                self.add_at(sides.e.span, Kind::Binary(Binary::Solve, a, b), ty)
            }
            _ => self.mismatch(
                sides,
                "solve with",
                "and the right side",
                &ta,
                &tb,
                "`A \\ b` takes a square matrix and a vector or matrix",
            ),
        }
    }
}

/// `3 columns`, `1 column`, `n columns`.
fn counted(n: &Dimension, noun: &str) -> String {
    match n.value() {
        Some(1) => format!("1 {noun}"),
        _ => format!("{n} {noun}s"),
    }
}
