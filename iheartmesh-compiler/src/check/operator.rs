//! Operators: which operands they take and what they give. Products stand in [`super::product`].

use super::Checker;
use super::wording::{ITEM_BY_ITEM, NOT_NUMBERS};
use crate::diagnostic::Diagnostic;
use crate::ir::{Binary, Boundary, ExprId, Kind, SetOp, Unary};
use crate::span::Span;
use crate::syntax::ast::{BinaryOp, Expr, UnaryOp};
use crate::types::{Atom, Dimension, Shape, Type};

impl<'a> Checker<'a> {
    pub(super) fn unary(&mut self, e: &'a Expr, op: UnaryOp, operand: &'a Expr) -> ExprId {
        let value = self.expr(operand);
        let value = match (op, self.program.arena.kind(value)) {
            // the transpose of a boundary matrix is another one
            (UnaryOp::Transpose, Kind::Boundary(_)) => value,
            _ => self.in_numbers(value),
        };
        let ty = self.ty(value).clone();
        if ty.is_error() {
            return value;
        }
        let one = Dimension::known(1);
        match (op, ty.shape()) {
            (UnaryOp::Negate, Some(_)) => {
                let negative = self.negate(value);
                self.program.arena.note_origin(negative, e.span);
                negative
            }
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
            (UnaryOp::Transpose, None) if matches!(&ty, Type::Sequence { item, .. } if item.is_scalar()) =>
            {
                let column = self.numbers_of(value);
                match self.ty(column).shape() {
                    Some(Shape::Vector(n)) => {
                        self.real_unary(Unary::Transpose, column, Shape::Matrix(one, n))
                    }
                    _ => column,
                }
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
                    return self.not_square(e.span, "invert", operand, &ty);
                }
                let value = self.squared(e.span, value);
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
            (UnaryOp::Size, None) if matches!(ty, Type::Sequence { .. }) => {
                self.sizes_of_sequence(value)
            }
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
        let sparse = self.ty(value).is_sparse()
            && matches!(op, Unary::Transpose | Unary::Negate | Unary::Inverse);
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
        operand: &Expr,
        ty: &Type,
    ) -> ExprId {
        let diagnostic = Diagnostic::error(span, format!("cannot {verb} {ty}: it is not square"))
            .label(operand.span, format!("this is {ty}"))
            .help("the matrix must have as many rows as columns");
        let diagnostic = self.with_origins(diagnostic, &[operand]);
        self.report(diagnostic)
    }

    pub(super) fn negate(&mut self, value: ExprId) -> ExprId {
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
        let is_product = matches!(op, BinaryOp::Juxtapose | BinaryOp::Dot);
        if is_product && let Some(chain) = self.applied(a, b) {
            return chain;
        }
        let (a, b) = self.both_in_numbers(a, b, is_product);
        // a right side has as many rows as the matrix, a factor as its columns
        let axis = u8::from(op != BinaryOp::Solve);
        let (a, b) = (
            self.with_entries(a, left.span, b, 0),
            self.with_entries(b, right.span, a, axis),
        );
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
                        return self.not_square(e.span, "take a power of", left, &ta);
                    }
                    let a = self.squared(e.span, a);
                    if let Some(power) = self.sparse_power(a, b) {
                        return power;
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
            BinaryOp::PlusMinus => match &mut self.plus_minus {
                Some((sign, uses)) => {
                    *uses += 1;
                    let sign = *sign;
                    self.sum(sides, sign, a, b)
                }
                None => self.report(
                    Diagnostic::error(e.span, "`±` stands for two values")
                        .help("only conditions may leave open which one, as in `x = a ± b`; otherwise write both"),
                ),
            },
            BinaryOp::Hadamard => match (ta.shape(), tb.shape()) {
                (Some(x), Some(y)) if !differ(&x, &y) => self.entrywise(Binary::Hadamard, a, b, x),
                _ => self.mismatch(sides, "multiply, entry by entry,", "and", &ta, &tb, "both sides must have the same size"),
            },
            BinaryOp::Frobenius => match (ta.shape(), tb.shape()) {
                (Some(x), Some(y)) if !differ(&x, &y) => self.entrywise(Binary::Frobenius, a, b, Shape::Scalar),
                _ => self.mismatch(
                    sides,
                    "take the Frobenius product of",
                    "and",
                    &ta,
                    &tb,
                    "both sides must be vectors or matrices of the same size",
                ),
            },
            BinaryOp::Kronecker => match (ta.shape().and_then(extents), tb.shape().and_then(extents)) {
                (Some((n, m)), Some((p, q))) => {
                    let rows = n.multiply(&p).unwrap_or_else(|| self.new_dimension());
                    let columns = m.multiply(&q).unwrap_or_else(|| self.new_dimension());
                    let (a, b) = (self.real(a), self.real(b));
                    let ty = match ta.is_sparse() || tb.is_sparse() {
                        true => Type::sparse_matrix(rows, columns),
                        false => Type::real_matrix(rows, columns),
                    };
                    self.add(Kind::Binary(Binary::Kronecker, a, b), ty)
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
            .help(items_of_elements(a, b).unwrap_or_else(|| help.to_owned()));
        let diagnostic = self.with_origins(diagnostic, &[sides.left, sides.right]);
        self.report(diagnostic)
    }

    /// An identity, or a multiple of one, as a sparse matrix; other matrices stay as they are.
    fn sparse_identity(&mut self, e: ExprId) -> ExprId {
        let Some(Shape::Matrix(n, m)) = self.ty(e).shape() else {
            return e;
        };
        match *self.program.arena.kind(e) {
            Kind::Identity(size) => self.add(Kind::Identity(size), Type::sparse_matrix(n, m)),
            Kind::Binary(op @ Binary::Multiply, k, of) => {
                let of = self.sparse_identity(of);
                let ty = self.ty(of).clone();
                self.add(Kind::Binary(op, k, of), ty)
            }
            Kind::Binary(op @ Binary::Divide, of, k) => {
                let of = self.sparse_identity(of);
                let ty = self.ty(of).clone();
                self.add(Kind::Binary(op, of, k), ty)
            }
            _ => e,
        }
    }

    /// The sum or difference of numbers, vectors or matrices; nothing where they do not fit.
    pub(super) fn sum_of(
        &mut self,
        span: Span,
        op: Binary,
        a: ExprId,
        b: ExprId,
    ) -> Option<ExprId> {
        let (ta, tb) = (self.ty(a).clone(), self.ty(b).clone());
        match (&ta, &tb) {
            (Type::Scalar(_), Type::Scalar(_)) => {
                let (a, b) = self.common(a, b);
                let ty = self.ty(a).clone();
                Some(self.add_at(span, Kind::Binary(op, a, b), ty))
            }
            (Type::Set(_), Type::Set(_)) if op == Binary::Add => {
                let (a, b) = self.common(a, b);
                let ty = self.ty(a).clone();
                (ty == *self.ty(b) && !ty.is_error())
                    .then(|| self.add(Kind::SetOp(SetOp::Union, a, b), ty))
            }
            _ if self.same_shape(&ta, &tb).is_some() => {
                let shape = self.same_shape(&ta, &tb).unwrap_or(Shape::Scalar);
                let (a, b) = (self.shaped(a, &shape), self.shaped(b, &shape));
                // an identity beside a sparse matrix is sparse
                let (a, b) = match (ta.is_sparse(), tb.is_sparse()) {
                    (true, false) => (a, self.sparse_identity(b)),
                    (false, true) => (self.sparse_identity(a), b),
                    _ => (a, b),
                };
                let (ta, tb) = (self.ty(a).clone(), self.ty(b).clone());
                let ty = match (ta.is_sparse(), tb.is_sparse()) {
                    (true, true) => ta,
                    // what has no fixed size decides
                    _ if !tb.is_fixed() => tb.shape().map_or(ta, Shape::real),
                    _ => shape.real(),
                };
                let (a, b) = (self.represented(a, &ty), self.represented(b, &ty));
                Some(self.add_at(span, Kind::Binary(op, a, b), ty))
            }
            _ => None,
        }
    }

    fn sum(&mut self, sides: Sides<'a>, op: Binary, a: ExprId, b: ExprId) -> ExprId {
        let (ta, tb) = (self.ty(a).clone(), self.ty(b).clone());
        let (verb, preposition) = match op {
            Binary::Add => ("add", "and"),
            _ => ("subtract", "from"),
        };
        if let Some(sum) = self.sum_of(sides.e.span, op, a, b) {
            return sum;
        }
        match (&ta, &tb) {
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
            (Type::Sequence { .. }, Type::Sequence { .. }) => {
                self.mismatch(sides, verb, preposition, &ta, &tb, ITEM_BY_ITEM)
            }
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
}

/// An operator's expression with its operands, for messages.
#[derive(Clone, Copy)]
pub(super) struct Sides<'a> {
    pub(super) e: &'a Expr,
    pub(super) left: &'a Expr,
    pub(super) right: &'a Expr,
}

/// What to do where only the number of items of a sequence stands against the number of elements of a mesh.
fn items_of_elements(a: &Type, b: &Type) -> Option<String> {
    let (mut letter, mut counts) = (None, false);
    for ty in [a, b] {
        ty.atoms(&mut |atom| match atom {
            Atom::Length(name) => letter = Some(name.clone()),
            Atom::Count(_) => counts = true,
            _ => {}
        });
    }
    let letter = letter.filter(|_| counts)?;
    Some(format!(
        "`|{letter}|` is the number of items of what has the subscript `{letter}`; a sequence with an item for each vertex is \
         declared `x : V → ℝ³`"
    ))
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
pub(super) fn differ(a: &Shape, b: &Shape) -> bool {
    match (a, b) {
        (Shape::Scalar, Shape::Scalar) => false,
        (Shape::Vector(n), Shape::Vector(m)) => n.differs(m),
        (Shape::Matrix(n, m), Shape::Matrix(p, q)) => n.differs(p) || m.differs(q),
        _ => true,
    }
}
