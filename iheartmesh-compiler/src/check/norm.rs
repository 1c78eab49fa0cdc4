//! Bars and inner products.

use super::Checker;
use super::operator::Sides;
use super::wording::NOT_NUMBERS;
use crate::diagnostic::Diagnostic;
use crate::ir::{Binary, ExprId, Kind, Unary};
use crate::syntax::ast::{Expr, ExprKind, NormSubscript};
use crate::types::{Shape, Type};

impl<'a> Checker<'a> {
    pub(super) fn norm(
        &mut self,
        e: &'a Expr,
        double: bool,
        operand: &'a Expr,
        subscript: Option<&'a NormSubscript>,
    ) -> ExprId {
        let value = self.expr(operand);
        let value = self.in_numbers(value);
        let ty = self.ty(value).clone();
        if ty.is_error() {
            return value;
        }
        match (&ty, double) {
            (Type::Scalar(number), false) if subscript.is_none() => self.add_at(
                e.span,
                Kind::Unary(Unary::Absolute, value),
                Type::Scalar(*number),
            ),
            (Type::Set(_), false) if subscript.is_none() => {
                self.add(Kind::Cardinality(value), Type::INTEGER)
            }
            (Type::Sequence { .. }, false) if subscript.is_none() => self.extent(value, 0),
            (Type::Vector { space: None, .. }, true) => {
                self.vector_norm(e, operand, value, subscript)
            }
            (Type::Matrix { spaces: None, .. }, true) => {
                self.matrix_norm(e, operand, value, subscript)
            }
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
                    return self.not_square(e.span, "take the determinant of", operand, &ty);
                }
                let value = self.squared(e.span, value);
                self.real_unary(Unary::Determinant, value, Shape::Scalar)
            }
            (Type::Vector { .. }, false) => {
                self.bars(e, &ty, operand, "write `‖u‖` for the length of a vector")
            }
            (Type::Scalar(_), true) => self.bars(
                e,
                &ty,
                operand,
                "write `|a|` for the absolute value of a number",
            ),
            (Type::Set(_), true) => self.bars(
                e,
                &ty,
                operand,
                "write `|S|` for the number of members of a set",
            ),
            (Type::Sequence { item, .. }, true) => {
                let help = match item.shape() {
                    Some(_) => {
                        "write `‖vec(x)‖` for the norm of all entries, `|x|` for the number of items"
                    }
                    None => "write `|x|` for the number of items",
                };
                self.bars(e, &ty, operand, help)
            }
            (Type::Element(_), _) => self.bars(e, &ty, operand, NOT_NUMBERS),
            _ => self.bars(
                e,
                &ty,
                operand,
                "bars are defined for numbers, vectors, matrices, sets and sequences",
            ),
        }
    }

    fn vector_norm(
        &mut self,
        e: &'a Expr,
        operand: &'a Expr,
        value: ExprId,
        subscript: Option<&'a NormSubscript>,
    ) -> ExprId {
        let exponent = match subscript {
            None => return self.real_unary(Unary::Norm, value, Shape::Scalar),
            Some(NormSubscript::Infinity) => {
                return self.real_unary(Unary::NormMax, value, Shape::Scalar);
            }
            Some(NormSubscript::Nuclear) => {
                return self.norm_subscript(e, operand, value, "a vector");
            }
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
                let size = self.extent(value, 0);
                let p = self.sized(e.span, p, 0, (&k, size));
                let p = self.sized(e.span, p, 1, (&k, size));
                let (value, p) = (self.real(value), self.real(p));
                self.add(Kind::Binary(Binary::NormWeighted, value, p), Type::REAL)
            }
            _ => self.norm_subscript(e, operand, value, "a vector"),
        }
    }

    fn matrix_norm(
        &mut self,
        e: &'a Expr,
        operand: &'a Expr,
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
            Some(_) => self.norm_subscript(e, operand, value, "a matrix"),
        }
    }

    fn norm_subscript(&mut self, e: &Expr, operand: &Expr, value: ExprId, of: &str) -> ExprId {
        let help = match of {
            "a vector" => {
                "the norms of a vector are `‖u‖`, `‖u‖_p` with a number `p`, `‖u‖_∞`, and `‖u‖_P` with a square matrix `P`"
            }
            _ => {
                "the norms of a matrix are `‖A‖` and `‖A‖_F`, the same, and `‖A‖_*`, the nuclear norm"
            }
        };
        let ty = self.ty(value).described();
        let diagnostic = Diagnostic::error(e.span, format!("this is no norm of {of}"))
            .label(operand.span, format!("this is {ty}"))
            .help(help);
        let diagnostic = self.with_origins(diagnostic, &[operand]);
        self.report(diagnostic)
    }

    #[track_caller]
    fn bars(&mut self, e: &'a Expr, ty: &Type, operand: &'a Expr, help: &str) -> ExprId {
        let bars = match &e.kind {
            ExprKind::Norm { double: true, .. } => "‖…‖",
            _ => "|…|",
        };
        let message = format!("`{bars}` has no meaning for {}", ty.described());
        let diagnostic = Diagnostic::error(e.span, message)
            .label(operand.span, format!("this is {}", ty.described()))
            .help(help);
        let diagnostic = self.with_origins(diagnostic, &[operand]);
        self.report(diagnostic)
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
                    let size = self.extent(a, 0);
                    let w = self.sized(e.span, w, 0, (&n, size));
                    let w = self.sized(e.span, w, 1, (&n, size));
                    let w = self.real(w);
                    let weighted =
                        self.add(Kind::Binary(Binary::Product, w, a), Type::real_vector(n));
                    self.add(Kind::Binary(Binary::Dot, b, weighted), Type::REAL)
                }
                _ => {
                    let tw = tw.described();
                    let message = format!("the weight of an inner product in {ta} cannot be {tw}");
                    let diagnostic = Diagnostic::error(syntax.span, message)
                        .here(format!("this is {tw}"))
                        .help("the weight is a square matrix with as many rows as the vectors");
                    let diagnostic = self.with_origins(diagnostic, &[syntax]);
                    self.report(diagnostic)
                }
            };
        }
        let sides = Sides { e, left, right };
        self.mismatch(
            sides,
            "take the inner product of",
            "and",
            &ta,
            &tb,
            "both sides must be vectors of the same length",
        )
    }
}
