//! Operators: which operands they take and what they give.

use super::Checker;
use super::wording::{KINDS, NOT_NUMBERS, ONE_MESH};
use crate::diagnostic::Diagnostic;
use crate::ir::{Binary, Boundary, ExprId, Kind, SetOp, Unary};
use crate::span::Span;
use crate::syntax::ast::{BinaryOp, Expr, ExprKind, UnaryOp};
use crate::types::display::plural;
use crate::types::{Dimension, Number, Shape, Type};

impl<'a> Checker<'a> {
    pub(super) fn unary(&mut self, e: &'a Expr, op: UnaryOp, operand: &'a Expr) -> ExprId {
        let value = self.expr(operand);
        let ty = self.ty(value).clone();
        if ty.is_error() {
            return value;
        }
        let one = Dimension::known(1);
        match (op, ty.shape()) {
            (UnaryOp::Negate, Some(_)) => self.negate(value),
            (UnaryOp::SquareRoot, Some(Shape::Scalar)) => {
                let value = self.real(value);
                self.add(Kind::Unary(Unary::SquareRoot, value), Type::REAL)
            }
            (UnaryOp::Transpose, Some(Shape::Scalar)) => value,
            (UnaryOp::Transpose, Some(Shape::Vector(n))) => {
                self.real_unary(Unary::Transpose, value, Shape::Matrix(one, n))
            }
            (UnaryOp::Transpose, Some(Shape::Matrix(n, m))) => {
                if let Kind::Unary(Unary::Transpose, inner) = *self.program.arena.kind(value)
                    && matches!(self.ty(inner), Type::Matrix { .. })
                {
                    return inner;
                }
                self.real_unary(Unary::Transpose, value, Shape::Matrix(m, n))
            }
            (UnaryOp::Transpose, None) if matches!(ty, Type::Matrix { .. }) => {
                match self.program.arena.kind(value).clone() {
                    Kind::Boundary(boundary) => self.boundary(Boundary {
                        transposed: !boundary.transposed,
                        ..boundary
                    }),
                    _ => self.unsupported(e.span, "this transpose is"),
                }
            }
            (UnaryOp::Inverse, Some(Shape::Scalar)) => {
                let one = self.program.arena.real(1.0);
                let value = self.real(value);
                self.add(Kind::Binary(Binary::Divide, one, value), Type::REAL)
            }
            (UnaryOp::Inverse, Some(Shape::Matrix(n, m))) => {
                if n.differs(&m) {
                    return self.not_square(e.span, "invert", operand.span, &ty);
                }
                let inverse = self.real_unary(Unary::Inverse, value, Shape::Matrix(n, m));
                self.program.arena.note_origin(inverse, e.span);
                inverse
            }
            (UnaryOp::PseudoInverse, Some(Shape::Matrix(n, m))) => {
                self.real_unary(Unary::PseudoInverse, value, Shape::Matrix(m, n))
            }
            (UnaryOp::Size, Some(Shape::Matrix(..))) => {
                let sizes = vec![
                    self.add(Kind::Extent(value, 0), Type::INTEGER),
                    self.add(Kind::Extent(value, 1), Type::INTEGER),
                ];
                self.add(
                    Kind::Tuple(sizes),
                    Type::Tuple(vec![Type::INTEGER, Type::INTEGER]),
                )
            }
            (UnaryOp::Size, Some(Shape::Vector(_))) => self.extent(value, 0),
            (UnaryOp::Size, None) if matches!(ty, Type::Set(_)) => {
                self.add(Kind::Cardinality(value), Type::INTEGER)
            }
            (UnaryOp::Size, None) if matches!(ty, Type::Sequence { .. }) => self.extent(value, 0),
            _ => {
                let (name, takes) = match op {
                    UnaryOp::Negate => ("negate", "numbers, vectors and matrices"),
                    UnaryOp::SquareRoot => ("take the square root of", "numbers"),
                    UnaryOp::Transpose => ("transpose", "vectors and matrices"),
                    UnaryOp::Inverse => ("invert", "numbers and square matrices"),
                    UnaryOp::PseudoInverse => ("take the pseudo-inverse of", "matrices"),
                    UnaryOp::Size => ("take the size of", "sets, sequences, vectors and matrices"),
                };
                let help = match ty.is_element() {
                    true => NOT_NUMBERS.to_owned(),
                    false => format!("only {takes} have this operation"),
                };
                let message = format!("cannot {name} {}", ty.described());
                let diagnostic = Diagnostic::error(e.span, message)
                    .label(operand.span, format!("this is {}", ty.described()))
                    .help(help);
                let diagnostic = self.with_origins(diagnostic, &[operand]);
                self.report(diagnostic)
            }
        }
    }

    /// An operation of linear algebra with a dense or sparse real result.
    pub(super) fn real_unary(&mut self, op: Unary, value: ExprId, shape: Shape) -> ExprId {
        let sparse = self.ty(value).is_sparse() && matches!(op, Unary::Transpose | Unary::Negate);
        let value = self.real(value);
        let mut ty = shape.real();
        if sparse && let Type::Matrix { sparse, .. } | Type::Vector { sparse, .. } = &mut ty {
            *sparse = true;
        }
        self.add(Kind::Unary(op, value), ty)
    }

    pub(super) fn not_square(
        &mut self,
        span: Span,
        verb: &str,
        operand: Span,
        ty: &Type,
    ) -> ExprId {
        self.report(
            Diagnostic::error(span, format!("cannot {verb} {ty}: it is not square"))
                .label(operand, format!("this is {ty}"))
                .help("the matrix must have as many rows as columns"),
        )
    }

    fn negate(&mut self, value: ExprId) -> ExprId {
        let ty = self.ty(value).clone();
        match self.program.arena.kind(value) {
            Kind::Integer(v) => {
                let v = -*v;
                self.program.arena.integer(v)
            }
            Kind::Real(bits) => {
                let v = -f64::from_bits(*bits);
                self.program.arena.real(v)
            }
            _ => self.add(Kind::Unary(Unary::Negate, value), ty),
        }
    }

    /// A boundary matrix as a value.
    pub(super) fn boundary(&mut self, boundary: Boundary) -> ExprId {
        let (rows, columns) = self.boundary_spaces(boundary);
        let count = |element| crate::types::Dimension::atom(crate::types::Atom::Count(element));
        let ty = Type::Matrix {
            number: Number::Integer,
            rows: count(rows),
            columns: count(columns),
            sparse: true,
            spaces: Some((rows, columns)),
        };
        self.add(Kind::Boundary(boundary), ty)
    }

    /// What the rows and the columns of a boundary matrix stand for.
    pub(super) fn boundary_spaces(
        &self,
        boundary: Boundary,
    ) -> (crate::types::Element, crate::types::Element) {
        let element = |dimension: u8| crate::types::Element {
            kind: crate::types::ELEMENT_KINDS[dimension as usize],
            mesh: boundary.mesh,
        };
        let (rows, columns) = (element(boundary.dimension - 1), element(boundary.dimension));
        if boundary.transposed {
            (columns, rows)
        } else {
            (rows, columns)
        }
    }

    pub(super) fn binary(
        &mut self,
        e: &'a Expr,
        op: BinaryOp,
        left: &'a Expr,
        right: &'a Expr,
    ) -> ExprId {
        let a = self.expr(left);
        let b = self.expr(right);
        if self.is_wrong(a) || self.is_wrong(b) {
            return self.error();
        }
        let (ta, tb) = (self.ty(a).clone(), self.ty(b).clone());
        let sides = Sides { e, left, right };
        match op {
            BinaryOp::Add if matches!(ta, Type::Set(_)) => self.set_operation(sides, SetOp::Union, a, b),
            BinaryOp::Subtract | BinaryOp::Solve if matches!(ta, Type::Set(_)) => {
                self.set_operation(sides, SetOp::Difference, a, b)
            }
            BinaryOp::Union => self.set_operation(sides, SetOp::Union, a, b),
            BinaryOp::Intersection => self.set_operation(sides, SetOp::Intersection, a, b),
            BinaryOp::Add => self.sum(sides, Binary::Add, a, b),
            BinaryOp::Subtract => self.sum(sides, Binary::Subtract, a, b),
            BinaryOp::Juxtapose => self.product(sides, a, b, false),
            BinaryOp::Dot => self.product(sides, a, b, true),
            BinaryOp::Divide => match (ta.shape(), tb.shape()) {
                (Some(_), Some(Shape::Scalar)) => {
                    let (a, b) = (self.real(a), self.real(b));
                    if let (Kind::Real(x), Kind::Real(y)) =
                        (self.program.arena.kind(a), self.program.arena.kind(b))
                    {
                        let quotient = f64::from_bits(*x) / f64::from_bits(*y);
                        return self.program.arena.real(quotient);
                    }
                    let ty = self.ty(a).clone();
                    self.add(Kind::Binary(Binary::Divide, a, b), ty)
                }
                _ if ta.is_element() || tb.is_element() => {
                    self.mismatch(sides, "divide", "by", &ta, &tb, NOT_NUMBERS)
                }
                _ if tb.is_scalar() => {
                    self.mismatch(sides, "divide", "by", &ta, &tb, "numbers and vectors can be divided by a number")
                }
                _ => self.mismatch(sides, "divide", "by", &ta, &tb, "only a number can stand below; `‖u‖` is the length of a vector `u`"),
            },
            BinaryOp::Power => match (ta.shape(), tb.shape()) {
                (Some(Shape::Scalar), Some(Shape::Scalar)) => {
                    let (a, b) = (self.real(a), self.real(b));
                    self.add(Kind::Binary(Binary::Power, a, b), Type::REAL)
                }
                (Some(Shape::Matrix(n, m)), Some(Shape::Scalar)) => {
                    if n.differs(&m) {
                        return self.not_square(e.span, "take a power of", left.span, &ta);
                    }
                    let (a, b) = (self.real(a), self.real(b));
                    self.add_at(e.span, Kind::Binary(Binary::MatrixPower, a, b), Type::real_matrix(n, m))
                }
                _ => self.mismatch(
                    sides,
                    "raise",
                    "to the power of",
                    &ta,
                    &tb,
                    "powers are defined for numbers and square matrices; write `‖u‖²` or `u⋅u` for a vector `u`",
                ),
            },
            BinaryOp::Cross => match (ta.fixed_vector(), tb.fixed_vector()) {
                (Some(3), Some(3)) => {
                    let (a, b) = (self.real(a), self.real(b));
                    self.add(Kind::Binary(Binary::Cross, a, b), Type::vector(3))
                }
                _ => {
                    let help = if ta.is_scalar() || tb.is_scalar() {
                        "`×` is the cross product; numbers are multiplied by writing them side by side"
                    } else {
                        "the cross product is defined for two vectors of length 3"
                    };
                    self.mismatch(sides, "take the cross product of", "and", &ta, &tb, help)
                }
            },
            BinaryOp::PlusMinus => self.unsupported(e.span, "`±` is"),
            BinaryOp::Hadamard => match (ta.shape(), tb.shape()) {
                (Some(x), Some(y)) if !differ(&x, &y) => self.entrywise(Binary::Hadamard, a, b, x),
                _ => self.mismatch(sides, "multiply, entry by entry,", "and", &ta, &tb, "both sides must have one size"),
            },
            BinaryOp::Frobenius => match (ta.shape(), tb.shape()) {
                (Some(x), Some(y)) if !differ(&x, &y) => self.entrywise(Binary::Frobenius, a, b, Shape::Scalar),
                _ => self.mismatch(
                    sides,
                    "take the Frobenius product of",
                    "and",
                    &ta,
                    &tb,
                    "both sides must be vectors or matrices of one size",
                ),
            },
            BinaryOp::Kronecker => match (ta.shape().and_then(extents), tb.shape().and_then(extents)) {
                (Some((n, m)), Some((p, q))) => {
                    let rows = n.multiply(&p).unwrap_or_else(|| self.new_dimension());
                    let columns = m.multiply(&q).unwrap_or_else(|| self.new_dimension());
                    let (a, b) = (self.real(a), self.real(b));
                    self.add(Kind::Binary(Binary::Kronecker, a, b), Type::real_matrix(rows, columns))
                }
                _ => self.mismatch(
                    sides,
                    "take the Kronecker product of",
                    "and",
                    &ta,
                    &tb,
                    "it is defined for vectors and matrices",
                ),
            },
            BinaryOp::Solve => self.solve(sides, a, b),
        }
    }

    /// An operation on operands of one size.
    fn entrywise(&mut self, op: Binary, a: ExprId, b: ExprId, shape: Shape) -> ExprId {
        let (a, b) = (self.real(a), self.real(b));
        if matches!(shape, Shape::Scalar) && self.ty(a).is_scalar() {
            return self.add(Kind::Binary(Binary::Multiply, a, b), Type::REAL);
        }
        self.add(Kind::Binary(op, a, b), shape.real())
    }

    /// `A \\ b`, `A⁻¹ b`.
    fn solve(&mut self, sides: Sides<'a>, a: ExprId, b: ExprId) -> ExprId {
        let (ta, tb) = (self.ty(a).clone(), self.ty(b).clone());
        match (ta.shape(), tb.shape()) {
            (Some(Shape::Scalar), Some(_)) => {
                let (a, b) = (self.real(a), self.real(b));
                let ty = self.ty(b).clone();
                self.add(Kind::Binary(Binary::Divide, b, a), ty)
            }
            (Some(Shape::Matrix(n, m)), Some(right @ (Shape::Vector(_) | Shape::Matrix(..)))) => {
                if n.differs(&m) {
                    return self.not_square(sides.e.span, "solve with", sides.left.span, &ta);
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
                let (a, b) = (self.real(a), self.real(b));
                self.add_at(
                    sides.e.span,
                    Kind::Binary(Binary::Solve, a, b),
                    right.real(),
                )
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

    /// The operands do not fit. What is taken `from` something stands on the right.
    #[track_caller]
    pub(super) fn mismatch(
        &mut self,
        sides: Sides<'a>,
        verb: &str,
        preposition: &str,
        a: &Type,
        b: &Type,
        help: &str,
    ) -> ExprId {
        let (left, right) = self.described_both(a, b);
        let message = match preposition {
            "from" => format!("cannot {verb} {right} {preposition} {left}"),
            _ => format!("cannot {verb} {left} {preposition} {right}"),
        };
        let diagnostic = Diagnostic::error(sides.left.span, message)
            .here(format!("this is {left}"))
            .label(sides.right.span, format!("this is {right}"))
            .help(help);
        let diagnostic = self.with_origins(diagnostic, &[sides.left, sides.right]);
        self.report(diagnostic)
    }

    fn sum(&mut self, sides: Sides<'a>, op: Binary, a: ExprId, b: ExprId) -> ExprId {
        let (ta, tb) = (self.ty(a).clone(), self.ty(b).clone());
        let (verb, preposition) = match op {
            Binary::Add => ("add", "and"),
            _ => ("subtract", "from"),
        };
        match (&ta, &tb) {
            (Type::Scalar(_), Type::Scalar(_)) => {
                let (a, b) = self.common(a, b);
                let ty = self.ty(a).clone();
                self.add(Kind::Binary(op, a, b), ty)
            }
            _ if self.same_shape(&ta, &tb).is_some() => {
                let shape = self.same_shape(&ta, &tb).unwrap_or(Shape::Scalar);
                let (a, b) = (self.shaped(a, &shape), self.shaped(b, &shape));
                let sparse = self.ty(a).is_sparse() && self.ty(b).is_sparse();
                let ty = if sparse {
                    self.ty(a).clone()
                } else {
                    shape.real()
                };
                self.add(Kind::Binary(op, a, b), ty)
            }
            (Type::Element(_), _) | (_, Type::Element(_)) => {
                self.mismatch(sides, verb, preposition, &ta, &tb, NOT_NUMBERS)
            }
            (Type::Scalar(_), Type::Vector { .. }) | (Type::Vector { .. }, Type::Scalar(_)) => self
                .mismatch(
                    sides,
                    verb,
                    preposition,
                    &ta,
                    &tb,
                    "a number and a vector have no sum; `‖u‖` is the length of a vector `u`",
                ),
            (Type::Vector { .. }, Type::Vector { .. }) => self.mismatch(
                sides,
                verb,
                preposition,
                &ta,
                &tb,
                "both vectors must have the same length",
            ),
            _ => self.mismatch(
                sides,
                verb,
                preposition,
                &ta,
                &tb,
                "both sides must have the same type and size",
            ),
        }
    }

    fn product(&mut self, sides: Sides<'a>, a: ExprId, b: ExprId, dot: bool) -> ExprId {
        let (ta, tb) = (self.ty(a).clone(), self.ty(b).clone());
        match (&ta, &tb) {
            (Type::Scalar(_), Type::Scalar(_)) => {
                let (a, b) = self.common(a, b);
                let ty = self.ty(a).clone();
                self.add(Kind::Binary(Binary::Multiply, a, b), ty)
            }
            (Type::Scalar(_), _) if tb.shape().is_some() => {
                let (a, b) = (self.real(a), self.real(b));
                let ty = self.ty(b).clone();
                self.add(Kind::Binary(Binary::Multiply, a, b), ty)
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
                if columns != space {
                    let help = match columns.mesh == space.mesh {
                        true => format!("this matrix takes chains of {}", plural(columns.kind)),
                        false => ONE_MESH.to_owned(),
                    };
                    return self.mismatch(sides, "multiply", "and", &ta, &tb, &help);
                }
                let Kind::Boundary(boundary) = self.program.arena.kind(a).clone() else {
                    return self.unsupported(sides.left.span, "this product is");
                };
                self.apply(boundary, b)
            }
            (
                Type::Matrix {
                    spaces: Some((_, columns)),
                    ..
                },
                Type::Matrix {
                    spaces: Some((rows, _)),
                    ..
                },
            ) => {
                if columns.mesh != rows.mesh {
                    return self.mismatch(sides, "multiply", "and", &ta, &tb, ONE_MESH);
                }
                let diagnostic = Diagnostic::error(
                    sides.e.span,
                    "products of two boundary matrices are not supported yet",
                )
                .label(sides.left.span, format!("this is {}", ta.described()))
                .label(sides.right.span, format!("this is {}", tb.described()))
                .help("multiply the matrix on the right and the chain first, as in `B (C δ)`");
                self.report(diagnostic)
            }
            (Type::Element(_), _) | (_, Type::Element(_)) => {
                self.mismatch(sides, "multiply", "and", &ta, &tb, NOT_NUMBERS)
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
            let help = format!("the left side has {k} columns, the right side {l} rows");
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

    /// The product of a boundary matrix and a chain.
    fn apply(&mut self, boundary: Boundary, chain: ExprId) -> ExprId {
        let (rows, _) = self.boundary_spaces(boundary);
        let ty = self.chain(rows);
        self.add(Kind::Apply(boundary, chain), ty)
    }

    /// The type of chains of these elements.
    pub(super) fn chain(&self, space: crate::types::Element) -> Type {
        Type::Vector {
            number: Number::Integer,
            length: crate::types::Dimension::atom(crate::types::Atom::Count(space)),
            sparse: true,
            space: Some(space),
        }
    }

    fn set_operation(&mut self, sides: Sides<'a>, op: SetOp, a: ExprId, b: ExprId) -> ExprId {
        let (mut ta, mut tb) = (self.ty(a).clone(), self.ty(b).clone());
        let (verb, preposition, sign) = match op {
            SetOp::Union => ("unite", "and", "∪"),
            SetOp::Intersection => ("intersect", "and", "∩"),
            SetOp::Difference => ("subtract", "from", "-"),
        };
        let (mut a, mut b) = (a, b);
        // an empty literal takes the type of the other side
        if self.is_empty_set(a) && matches!(tb, Type::Set(_)) {
            ta = tb.clone();
            a = self.add(Kind::Set(Vec::new()), ta.clone());
        } else if self.is_empty_set(b) && matches!(ta, Type::Set(_)) {
            tb = ta.clone();
            b = self.add(Kind::Set(Vec::new()), tb.clone());
        }
        match (&ta, &tb) {
            (Type::Set(x), Type::Set(y)) if x == y => self.add(Kind::SetOp(op, a, b), ta),
            (Type::Set(x), Type::Set(y)) => match (&**x, &**y) {
                (Type::Element(x), Type::Element(y)) if x.mesh != y.mesh => {
                    self.mismatch(sides, verb, preposition, &ta, &tb, ONE_MESH)
                }
                (Type::Element(_), Type::Element(_)) => {
                    self.mismatch(sides, verb, preposition, &ta, &tb, KINDS)
                }
                _ => self.mismatch(
                    sides,
                    verb,
                    preposition,
                    &ta,
                    &tb,
                    "the members of both sets must have the same type",
                ),
            },
            (Type::Set(item), other) if **item == *other => {
                let member = match &sides.right.kind {
                    ExprKind::Name(name) => name.text.as_str(),
                    ExprKind::Integer(_) => "1",
                    _ => "…",
                };
                let help = format!(
                    "`{{{member}}}` is the set with this one member: `… {sign} {{{member}}}`"
                );
                self.mismatch(sides, verb, preposition, &ta, &tb, &help)
            }
            _ => self.mismatch(
                sides,
                verb,
                preposition,
                &ta,
                &tb,
                "both sides must be sets",
            ),
        }
    }
}

/// An operator's expression with its operands, for messages.
#[derive(Clone, Copy)]
pub(super) struct Sides<'a> {
    pub(super) e: &'a Expr,
    pub(super) left: &'a Expr,
    pub(super) right: &'a Expr,
}

/// Rows and columns: a number is 1×1, a vector has one column.
pub(super) fn extents(shape: Shape) -> Option<(Dimension, Dimension)> {
    match shape {
        Shape::Scalar => Some((Dimension::known(1), Dimension::known(1))),
        Shape::Vector(n) => Some((n, Dimension::known(1))),
        Shape::Matrix(n, m) => Some((n, m)),
    }
}

/// Whether two shapes are known to be different.
fn differ(a: &Shape, b: &Shape) -> bool {
    match (a, b) {
        (Shape::Scalar, Shape::Scalar) => false,
        (Shape::Vector(n), Shape::Vector(m)) => n.differs(m),
        (Shape::Matrix(n, m), Shape::Matrix(p, q)) => n.differs(p) || m.differs(q),
        _ => true,
    }
}
