//! Integrals.

use super::Checker;
use super::scope::Scope;
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, Kind};
use crate::syntax::ast::{Expr, ExprKind};
use crate::types::Type;

impl<'a> Checker<'a> {
    /// `∫_[a, b] f 𝕕t`.
    pub(super) fn integral(&mut self, e: &'a Expr) -> ExprId {
        let ExprKind::Integral {
            variable,
            from,
            to,
            body,
        } = &e.kind
        else {
            return self.error();
        };
        let bounds = [self.expr(from), self.expr(to)];
        let mut scope = Scope::default();
        let bound = self.bind(&mut scope, variable, Type::REAL);
        let value = self.with_scope(scope, |checker| checker.expr(body));
        let what = [
            "the bounds of an integral are",
            "the bounds of an integral are",
            "the integrand is",
        ];
        let mut numbers = Vec::new();
        for ((value, syntax), what) in bounds
            .into_iter()
            .chain([value])
            .zip([from, to, body])
            .zip(what)
        {
            let ty = self.ty(value).clone();
            if ty.is_error() {
                return value;
            }
            if !ty.is_scalar() {
                let found = ty.described();
                let article = if what.ends_with("are") {
                    "numbers"
                } else {
                    "a number"
                };
                let diagnostic =
                    Diagnostic::error(syntax.span, format!("{what} {article}, not {found}"))
                        .here(format!("this is {found}"))
                        .help("integrate entry by entry, as in `y_i = ∫_[a, b] … 𝕕t`");
                let diagnostic = self.with_origins(diagnostic, &[syntax]);
                return self.report(diagnostic);
            }
            numbers.push(self.real(value));
        }
        let kind = Kind::Integral {
            variable: bound,
            from: numbers[0],
            to: numbers[1],
            body: numbers[2],
        };
        self.add_at(e.span, kind, Type::REAL)
    }
}
