//! Operators: which operands they take and what they give.

use super::Checker;
use crate::diagnostic::Diagnostic;
use crate::ir::{Binary, Boundary, ExprId, Kind, SetOp, Unary};
use crate::span::Span;
use crate::syntax::ast::{BinaryOp, Expr, ExprKind, NormSubscript, UnaryOp};
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
                self.report(
                    Diagnostic::error(e.span, format!("cannot {name} {ty}"))
                        .label(operand.span, format!("this is {ty}"))
                        .help(format!("it is defined for {takes}")),
                )
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
        if self.is_error(a) || self.is_error(b) {
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
                _ => self.mismatch(sides, "divide", "by", &ta, &tb, "the right side of `/` is a number"),
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
                    "to the power",
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

    fn mismatch(
        &mut self,
        sides: Sides<'a>,
        verb: &str,
        preposition: &str,
        a: &Type,
        b: &Type,
        help: &str,
    ) -> ExprId {
        self.report(
            Diagnostic::error(
                sides.left.span,
                format!("cannot {verb} {a} {preposition} {b}"),
            )
            .here(format!("this is {a}"))
            .label(sides.right.span, format!("this is {b}"))
            .help(help),
        )
    }

    fn sum(&mut self, sides: Sides<'a>, op: Binary, a: ExprId, b: ExprId) -> ExprId {
        let (ta, tb) = (self.ty(a).clone(), self.ty(b).clone());
        let (verb, preposition) = match op {
            Binary::Add => ("add", "and"),
            _ => ("subtract, from", "this:"),
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
                let ty = if sparse { self.ty(a).clone() } else { shape.real() };
                self.add(Kind::Binary(op, a, b), ty)
            }
            (Type::Element(_), _) | (_, Type::Element(_)) => self.mismatch(
                sides,
                verb,
                preposition,
                &ta,
                &tb,
                "elements of a mesh are not numbers; use the values that belong to them, as in `x_v`",
            ),
            (Type::Scalar(_), Type::Vector { .. }) | (Type::Vector { .. }, Type::Scalar(_)) => self.mismatch(
                sides,
                verb,
                preposition,
                &ta,
                &tb,
                "a number and a vector have no sum; `‖u‖` is the length of a vector `u`",
            ),
            _ => self.mismatch(sides, verb, preposition, &ta, &tb, "both sides must have one type and size"),
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
            _ if matches!((ta.shape(), tb.shape()), (Some(Shape::Matrix(..)), Some(_)) | (Some(_), Some(Shape::Matrix(..)))) => {
                self.matrix_product(sides, a, b)
            }
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
                if columns.mesh != space.mesh {
                    return self.owners(sides, *columns, *space);
                }
                if columns != space {
                    return self.mismatch(
                        sides,
                        "multiply",
                        "and",
                        &ta,
                        &tb,
                        "the columns of the matrix and the entries of the chain must stand for the same elements",
                    );
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
                    return self.owners(sides, *columns, *rows);
                }
                let (left, right) = (sides.left.span, sides.right.span);
                self.report(
                    Diagnostic::error(left, "products of two boundary matrices are not supported yet")
                        .label(right, format!("this is a {tb}"))
                        .help("parenthesise the product of a matrix and a chain, as in `B (C δ)`"),
                )
            }
            (Type::Element(_), _) | (_, Type::Element(_)) => self.mismatch(
                sides,
                "multiply",
                "and",
                &ta,
                &tb,
                "elements of a mesh are not numbers; use the values that belong to them, as in `x_v`",
            ),
            _ => self.mismatch(sides, "multiply", "and", &ta, &tb, "their sizes do not fit"),
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

    /// Values of two meshes that meet.
    fn owners(
        &mut self,
        sides: Sides<'a>,
        a: crate::types::Element,
        b: crate::types::Element,
    ) -> ExprId {
        let (ma, mb) = (self.mesh_name(a.mesh), self.mesh_name(b.mesh));
        self.report(
            Diagnostic::error(
                sides.e.span,
                format!("elements of `{ma}` and of `{mb}` do not go together"),
            )
            .label(sides.left.span, format!("this is of `{ma}`"))
            .label(sides.right.span, format!("this is of `{mb}`"))
            .help("elements, sets and matrices of one expression must belong to one mesh"),
        )
    }

    pub(super) fn mesh_name(&self, mesh: crate::types::MeshId) -> String {
        self.program.mesh(mesh).name.clone()
    }

    fn set_operation(&mut self, sides: Sides<'a>, op: SetOp, a: ExprId, b: ExprId) -> ExprId {
        let (mut ta, mut tb) = (self.ty(a).clone(), self.ty(b).clone());
        let (verb, preposition, sign) = match op {
            SetOp::Union => ("unite", "and", "∪"),
            SetOp::Intersection => ("intersect", "and", "∩"),
            SetOp::Difference => ("subtract, from", "this:", "-"),
        };
        let (mut a, mut b) = (a, b);
        // an empty literal takes the type of the other side
        if self.is_empty_set(a) {
            ta = tb.clone();
            a = self.add(Kind::Set(Vec::new()), ta.clone());
        } else if self.is_empty_set(b) {
            tb = ta.clone();
            b = self.add(Kind::Set(Vec::new()), tb.clone());
        }
        match (&ta, &tb) {
            (Type::Set(x), Type::Set(y)) if x == y => self.add(Kind::SetOp(op, a, b), ta),
            (Type::Set(x), Type::Set(y)) => match (&**x, &**y) {
                (Type::Element(x), Type::Element(y)) if x.mesh != y.mesh => {
                    self.owners(sides, *x, *y)
                }
                (Type::Element(_), Type::Element(_)) => self.mismatch(
                    sides,
                    verb,
                    preposition,
                    &ta,
                    &tb,
                    "vertices, edges, faces and cells are different kinds of elements",
                ),
                _ => self.mismatch(
                    sides,
                    verb,
                    preposition,
                    &ta,
                    &tb,
                    "both sets must have members of one type",
                ),
            },
            (Type::Set(item), other) if **item == *other => {
                let help = format!(
                    "write `… {sign} {{{}}}` for the set with this one member",
                    "a"
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

    pub(super) fn norm(
        &mut self,
        e: &'a Expr,
        double: bool,
        operand: &'a Expr,
        subscript: Option<&'a NormSubscript>,
    ) -> ExprId {
        let value = self.expr(operand);
        let ty = self.ty(value).clone();
        if ty.is_error() {
            return value;
        }
        match (&ty, double) {
            (Type::Scalar(number), false) if subscript.is_none() => {
                self.add(Kind::Unary(Unary::Absolute, value), Type::Scalar(*number))
            }
            (Type::Set(_), false) if subscript.is_none() => {
                self.add(Kind::Cardinality(value), Type::INTEGER)
            }
            (Type::Sequence { .. }, false) if subscript.is_none() => self.extent(value, 0),
            (Type::Vector { space: None, .. }, true) => self.vector_norm(e, value, subscript),
            (Type::Matrix { spaces: None, .. }, true) => self.matrix_norm(e, value, subscript),
            (
                Type::Matrix {
                    rows,
                    columns,
                    spaces: None,
                    ..
                },
                false,
            ) if subscript.is_none() => {
                if rows.differs(columns) {
                    return self.not_square(e.span, "take the determinant of", operand.span, &ty);
                }
                self.real_unary(Unary::Determinant, value, Shape::Scalar)
            }
            (Type::Vector { .. }, false) => self.bars(
                e.span,
                &ty,
                operand.span,
                "write `‖u‖` for the length of a vector",
            ),
            (Type::Scalar(_), true) => self.bars(
                e.span,
                &ty,
                operand.span,
                "write `|a|` for the absolute value of a number",
            ),
            (Type::Set(_), true) => self.bars(
                e.span,
                &ty,
                operand.span,
                "write `|S|` for the number of members of a set",
            ),
            _ => self.bars(
                e.span,
                &ty,
                operand.span,
                "bars are defined for numbers, vectors, matrices, sets and sequences",
            ),
        }
    }

    fn vector_norm(
        &mut self,
        e: &'a Expr,
        value: ExprId,
        subscript: Option<&'a NormSubscript>,
    ) -> ExprId {
        let exponent = match subscript {
            None => return self.real_unary(Unary::Norm, value, Shape::Scalar),
            Some(NormSubscript::Infinity) => {
                return self.real_unary(Unary::NormMax, value, Shape::Scalar);
            }
            Some(NormSubscript::Nuclear) => return self.norm_subscript(e.span, "a vector"),
            Some(NormSubscript::Expr(p)) => p,
        };
        match exponent.kind {
            ExprKind::Integer(0) => return self.real_unary(Unary::NormZero, value, Shape::Scalar),
            ExprKind::Integer(1) => return self.real_unary(Unary::NormOne, value, Shape::Scalar),
            ExprKind::Integer(2) => return self.real_unary(Unary::Norm, value, Shape::Scalar),
            _ => {}
        }
        let p = self.expr(exponent);
        let (tp, ty) = (self.ty(p).clone(), self.ty(value).clone());
        match (tp.shape(), ty.shape()) {
            (None, _) if tp.is_error() => p,
            (Some(Shape::Scalar), _) => {
                let (value, p) = (self.real(value), self.real(p));
                self.add(Kind::Binary(Binary::NormPower, value, p), Type::REAL)
            }
            (Some(Shape::Matrix(n, m)), Some(Shape::Vector(k)))
                if !n.differs(&k) && !m.differs(&k) =>
            {
                let (value, p) = (self.real(value), self.real(p));
                self.add(Kind::Binary(Binary::NormWeighted, value, p), Type::REAL)
            }
            _ => self.norm_subscript(exponent.span, "a vector"),
        }
    }

    fn matrix_norm(
        &mut self,
        e: &'a Expr,
        value: ExprId,
        subscript: Option<&'a NormSubscript>,
    ) -> ExprId {
        match subscript {
            None => self.real_unary(Unary::Norm, value, Shape::Scalar),
            Some(NormSubscript::Nuclear) => {
                self.real_unary(Unary::NormNuclear, value, Shape::Scalar)
            }
            Some(NormSubscript::Expr(p)) if matches!(&p.kind, ExprKind::Name(n) if n.text == "F") => {
                self.real_unary(Unary::Norm, value, Shape::Scalar)
            }
            Some(_) => self.norm_subscript(e.span, "a matrix"),
        }
    }

    fn norm_subscript(&mut self, span: Span, of: &str) -> ExprId {
        let help = match of {
            "a vector" => {
                "the norms of a vector are `‖u‖`, `‖u‖_p` with a number `p`, `‖u‖_∞`, and `‖u‖_P` with a square matrix `P`"
            }
            _ => {
                "the norms of a matrix are `‖A‖` and `‖A‖_F`, the same, and `‖A‖_*`, the nuclear norm"
            }
        };
        self.report(Diagnostic::error(span, format!("this is no norm of {of}")).help(help))
    }

    fn bars(&mut self, span: Span, ty: &Type, operand: Span, help: &str) -> ExprId {
        self.report(
            Diagnostic::error(span, format!("these bars are not defined for {ty}"))
                .label(operand, format!("this is {ty}"))
                .help(help),
        )
    }

    pub(super) fn inner(
        &mut self,
        e: &'a Expr,
        left: &'a Expr,
        right: &'a Expr,
        weight: Option<&'a Expr>,
    ) -> ExprId {
        let a = self.expr(left);
        let b = self.expr(right);
        let weight = weight.map(|w| (w, self.expr(w)));
        let (ta, tb) = (self.ty(a).clone(), self.ty(b).clone());
        if ta.is_error() || tb.is_error() || weight.is_some_and(|(_, w)| self.is_error(w)) {
            return self.error();
        }
        if let (Some(Shape::Vector(n)), Some(Shape::Vector(m))) = (ta.shape(), tb.shape())
            && !n.differs(&m)
        {
            let (a, b) = (self.real(a), self.real(b));
            let Some((syntax, w)) = weight else {
                return self.add(Kind::Binary(Binary::Dot, a, b), Type::REAL);
            };
            let tw = self.ty(w).clone();
            return match tw.shape() {
                Some(Shape::Matrix(p, q)) if !p.differs(&n) && !q.differs(&n) => {
                    let w = self.real(w);
                    let weighted =
                        self.add(Kind::Binary(Binary::Product, w, a), Type::real_vector(n));
                    self.add(Kind::Binary(Binary::Dot, b, weighted), Type::REAL)
                }
                _ => self.report(
                    Diagnostic::error(
                        syntax.span,
                        format!("the weight of an inner product in {ta} cannot be {tw}"),
                    )
                    .here(format!("this is {tw}"))
                    .help("the weight is a square matrix with as many rows as the vectors"),
                ),
            };
        }
        let sides = Sides { e, left, right };
        self.mismatch(
            sides,
            "take the inner product of",
            "and",
            &ta,
            &tb,
            "both sides must be vectors of one length",
        )
    }
}

/// An operator's expression with its operands, for messages.
#[derive(Clone, Copy)]
struct Sides<'a> {
    e: &'a Expr,
    left: &'a Expr,
    right: &'a Expr,
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
