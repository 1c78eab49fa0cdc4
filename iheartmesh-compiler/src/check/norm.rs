//! Bars and inner products.

use super::Checker;
use super::operator::Sides;
use super::wording::NOT_NUMBERS;
use crate::diagnostic::Diagnostic;
use crate::ir::{Binary, ExprId, Kind, Unary};
use crate::syntax::ast::{Expr, ExprKind, NormSubscript};
use crate::types::Type;

impl<'a> Checker<'a> {
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
        let two = match subscript {
            None => true,
            Some(NormSubscript::Expr(p)) => {
                matches!(p.kind, crate::syntax::ast::ExprKind::Integer(2))
            }
            Some(_) => false,
        };
        match (&ty, double) {
            (Type::Scalar(number), false) if subscript.is_none() => {
                self.add(Kind::Unary(Unary::Absolute, value), Type::Scalar(*number))
            }
            (Type::Set(_), false) if subscript.is_none() => {
                self.add(Kind::Cardinality(value), Type::INTEGER)
            }
            (Type::Sequence { .. }, false) if subscript.is_none() => {
                self.add(Kind::Length(value), Type::INTEGER)
            }
            (Type::Vector { space: None, .. }, true) if two => {
                self.add(Kind::Unary(Unary::Norm, value), Type::REAL)
            }
            (Type::Vector { space: None, .. }, true) | (Type::Matrix { .. }, _) => {
                self.unsupported(e.span, "this norm is")
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
            (Type::Element(_), _) => self.bars(e, &ty, operand, NOT_NUMBERS),
            _ => self.bars(
                e,
                &ty,
                operand,
                "bars are defined for numbers, vectors, matrices, sets and sequences",
            ),
        }
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
        if weight.is_some() {
            return self.unsupported(e.span, "inner products with a weight are");
        }
        let a = self.expr(left);
        let b = self.expr(right);
        let (ta, tb) = (self.ty(a).clone(), self.ty(b).clone());
        if ta.is_error() || tb.is_error() {
            return self.error();
        }
        if ta == tb && matches!(ta, Type::Vector { space: None, .. }) {
            return self.add(Kind::Binary(Binary::Dot, a, b), Type::REAL);
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
