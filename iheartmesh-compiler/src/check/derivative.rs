//! Derivatives: what is differentiated by what, and the type of the result.

use super::Checker;
use crate::derive;
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, Kind};
use crate::span::Span;
use crate::syntax::ast::{Expr, ExprKind};
use crate::types::{Dimension, Shape, Type};

impl<'a> Checker<'a> {
    /// `∂y/∂x`, `∂²y/∂x²`, `∂²y/∂a∂b`.
    pub(super) fn derivative(
        &mut self,
        e: &'a Expr,
        order: u32,
        numerator: &'a Expr,
        denominators: &'a [(Expr, u32)],
    ) -> ExprId {
        let sum: u32 = denominators.iter().map(|(_, order)| order).sum();
        let value = self.expr(numerator);
        let mut variables = Vec::new();
        for (denominator, order) in denominators {
            let Some(variable) = self.differentiated_by(denominator) else {
                return self.error();
            };
            variables.extend(std::iter::repeat_n(
                (denominator, variable),
                *order as usize,
            ));
        }
        if self.is_error(value) {
            return self.error();
        }
        if sum != order {
            let message = format!("the orders differ: {order} above the line, {sum} below");
            return self.report(
                Diagnostic::error(e.span, message)
                    .help("write `∂y/∂x`, `∂²y/∂x²`, or `∂²y/∂a∂b` for mixed derivatives"),
            );
        }
        self.differentiate(e.span, numerator, value, &variables)
    }

    /// `∇_x y`.
    pub(super) fn gradient(
        &mut self,
        e: &'a Expr,
        variable: Option<&'a Expr>,
        operand: &'a Expr,
    ) -> ExprId {
        let value = self.expr(operand);
        let Some(variable) = variable else {
            return self.report(
                Diagnostic::error(e.span, "by what `∇` differentiates must stand in the text")
                    .help("write the variable as a subscript, as in `∇_x y`"),
            );
        };
        let Some(by) = self.differentiated_by(variable) else {
            return self.error();
        };
        match self.is_error(value) {
            true => self.error(),
            false => self.differentiate(e.span, operand, value, &[(variable, by)]),
        }
    }

    /// The parameter that a derivative is taken by.
    fn differentiated_by(&mut self, e: &'a Expr) -> Option<ExprId> {
        let value = self.expr(e);
        if self.is_error(value) {
            return None;
        }
        let ty = self.ty(value).clone();
        let is_parameter = matches!(
            self.program.arena.kind(value),
            Kind::Input(_) | Kind::Variable(_)
        ) && matches!(e.kind, ExprKind::Name(_));
        let found = ty.described();
        let diagnostic = match (is_parameter, derive::count(&ty)) {
            (true, Some(_)) => return Some(value),
            (true, None) => Diagnostic::error(e.span, format!("cannot differentiate by {found}"))
                .here(format!("this is {found}"))
                .help("derivatives are taken by real numbers, vectors, matrices, and sequences of them"),
            (false, _) => Diagnostic::error(
                e.span,
                "derivatives are taken by parameters of the module or of a function",
            )
            .here("this is not a parameter")
            .help(match e.kind {
                ExprKind::Subscript { .. } => {
                    "differentiate by all of it, as in `∂y/∂x`; the items stand one after the other"
                }
                _ => "write a function of it, as in `f(t) = …` with `∂f(t)/∂t` inside of another function",
            }),
        };
        let diagnostic = self.with_origins(diagnostic, &[e]);
        self.report(diagnostic);
        None
    }

    fn differentiate(
        &mut self,
        span: Span,
        numerator: &'a Expr,
        value: ExprId,
        variables: &[(&'a Expr, ExprId)],
    ) -> ExprId {
        let ty = self.ty(value).clone();
        let value = self.real(value);
        let is_vector = matches!(ty.shape(), Some(Shape::Vector(_)));
        if !(ty.is_scalar() || is_vector && variables.len() == 1) {
            let found = ty.described();
            let (what, help) = match variables.len() {
                1 => (
                    "only numbers and vectors have derivatives",
                    "write `vec(A)` for the entries of a matrix or a sequence",
                ),
                _ => (
                    "only numbers have derivatives of an order above 1",
                    "differentiate the entries one by one",
                ),
            };
            let diagnostic = Diagnostic::error(numerator.span, what)
                .here(format!("this is {found}"))
                .help(help);
            let diagnostic = self.with_origins(diagnostic, &[numerator]);
            return self.report(diagnostic);
        }
        let numbers = |checker: &Self, list: &[(&'a Expr, ExprId)]| {
            list.iter().all(|(_, v)| checker.ty(*v).is_scalar())
        };
        let result = match variables {
            [(_, x)] => derive::first(&mut self.program, value, *x),
            [(_, a), (_, b)] => derive::second(&mut self.program, value, *a, *b),
            _ if numbers(self, variables) => {
                let mut result = Ok(value);
                for (_, x) in variables {
                    result = result.and_then(|y| derive::first(&mut self.program, y, *x));
                }
                result
            }
            _ => {
                return self.report(
                    Diagnostic::error(
                        span,
                        "derivatives of an order above 2 are taken by numbers only",
                    )
                    .help("differentiate a second derivative entry by entry"),
                );
            }
        };
        match result {
            Ok(derivative) => {
                match variables {
                    [(_, x)] if is_vector => self.note_dense_jacobian(span, derivative, *x),
                    [(_, a), (_, b)] => self.note_dense(span, derivative, value, (*a, *b)),
                    _ => {}
                }
                derivative
            }
            Err(trouble) => {
                let place = trouble.span.unwrap_or(numerator.span);
                let mut diagnostic = Diagnostic::error(place, trouble.message).help(trouble.help);
                if place != span && !(span.start <= place.start && place.end <= span.end) {
                    diagnostic = diagnostic.label(span, "it is differentiated here");
                }
                self.report(diagnostic)
            }
        }
    }

    /// Whether a matrix of derivatives by the items of a mesh is dense.
    fn is_large(&self, derivative: ExprId, by: &[ExprId]) -> bool {
        let ty = self.ty(derivative);
        let is_fixed = |n: &Dimension| n.value().is_some();
        let is_large = match ty.shape() {
            Some(Shape::Matrix(n, m)) => !ty.is_sparse() && !is_fixed(&n) && !is_fixed(&m),
            _ => false,
        };
        let of_mesh =
            |x: &ExprId| matches!(self.ty(*x), Type::Sequence { length, .. } if !is_fixed(length));
        is_large && !self.program.meshes.is_empty() && by.iter().all(of_mesh)
    }

    fn note_dense_jacobian(&mut self, span: Span, derivative: ExprId, by: ExprId) {
        if self.is_large(derivative, &[by]) {
            let message = "this matrix of derivatives is dense, since an entry of the vector takes many items at once";
            self.diagnostics.push(Diagnostic::note(span, message).help(
                "it is sparse where each entry of the vector takes a few items of the variable; products with it do not form it",
            ));
        }
    }

    /// Says that second derivatives by the items of a mesh are a dense matrix, and why.
    fn note_dense(&mut self, span: Span, derivative: ExprId, value: ExprId, by: (ExprId, ExprId)) {
        if !self.is_large(derivative, &[by.0, by.1]) {
            return;
        }
        let Some(term) = derive::dense_because(&mut self.program, value, by.0, by.1) else {
            return;
        };
        let mut note = Diagnostic::note(
            span,
            "these second derivatives are a dense matrix, since one term takes many items at once",
        );
        if let Some(term) = term.filter(|term| *term != span) {
            note = note.label(term, "this is the term");
        }
        let note = note.help(
            "they are sparse where what is differentiated is a sum whose terms take a few items each",
        );
        self.diagnostics.push(note);
    }
}
