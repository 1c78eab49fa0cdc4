//! Expressions.

use super::Checker;
use super::scope::Found;
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, Kind};
use crate::syntax::ast::{Condition, Expr, ExprKind, Name};
use crate::types::{Number, Type};

impl<'a> Checker<'a> {
    /// Checks an expression.
    pub(super) fn expr(&mut self, e: &'a Expr) -> ExprId {
        match &e.kind {
            ExprKind::Integer(value) => self.program.arena.integer(*value),
            ExprKind::Real(value) => self.program.arena.real(*value),
            ExprKind::Pi => self.program.arena.real(std::f64::consts::PI),
            ExprKind::Infinity => self.program.arena.real(f64::INFINITY),
            ExprKind::Name(name) => self.name(name),
            ExprKind::Subscript { base, subscripts } => self.subscript(e, base, subscripts),
            ExprKind::Call {
                function,
                subscripts,
                arguments,
            } => self.call(e.span, function, subscripts, arguments),
            ExprKind::Unary { op, operand } => self.unary(e, *op, operand),
            ExprKind::Binary {
                op, left, right, ..
            } => self.binary(e, *op, left, right),
            ExprKind::Norm {
                double,
                operand,
                subscript,
            } => self.norm(e, *double, operand, subscript.as_ref()),
            ExprKind::Inner {
                left,
                right,
                weight,
            } => self.inner(e, left, right, weight.as_deref()),
            ExprKind::Vector(items) => self.vector(e, items),
            ExprKind::Set(items) => self.set_literal(e, items),
            ExprKind::Builder {
                element,
                variables,
                range,
                condition,
            } => self.builder(e, element, variables, range, condition.as_deref()),
            ExprKind::Big {
                op,
                head,
                body,
                locals,
            } => self.big(e, *op, head, body, locals),
            ExprKind::Piecewise {
                branches,
                otherwise,
            } => self.piecewise(e, branches, otherwise.as_deref()),
            ExprKind::Matrix(_) => self.unsupported(e.span, "matrices are"),
            ExprKind::NumberMatrix { .. } => {
                self.unsupported(e.span, "matrices of zeros and ones are")
            }
            ExprKind::Optimise { .. } => self.unsupported(e.span, "optimisation is"),
            ExprKind::Integral { .. } => self.unsupported(e.span, "integrals are"),
            ExprKind::Derivative { .. }
            | ExprKind::Gradient { .. }
            | ExprKind::Laplacian(_)
            | ExprKind::Divergence(_) => self.unsupported(e.span, "derivatives are"),
            ExprKind::Error => self.error(),
        }
    }

    fn name(&mut self, name: &Name) -> ExprId {
        match self.find(name) {
            Found::Value(value) => value,
            Found::Error => self.error(),
            Found::Dimension => self.unsupported(name.span, "sizes as values are"),
            Found::Functions(functions) => {
                if let [(_, crate::resolve::Meaning::Builtin(builtin))] = functions.as_slice()
                    && builtin == "e"
                {
                    return self.program.arena.real(std::f64::consts::E);
                }
                let message = format!("`{}` is a function, not a value", name.text);
                let expr = Expr {
                    kind: ExprKind::Name(name.clone()),
                    span: name.span,
                };
                let diagnostic = Diagnostic::error(name.span, message)
                    .help(format!("call it, as in `{}(…)`", name.text));
                let diagnostic = self.with_origins(diagnostic, &[&expr]);
                self.report(diagnostic)
            }
        }
    }

    /// A number as a real number.
    pub(super) fn real(&mut self, e: ExprId) -> ExprId {
        match (self.ty(e), self.program.arena.kind(e)) {
            (Type::Scalar(Number::Integer), Kind::Integer(value)) => {
                let value = *value as f64;
                self.program.arena.real(value)
            }
            (Type::Scalar(Number::Integer), _) => {
                self.add(Kind::Unary(crate::ir::Unary::ToReal, e), Type::REAL)
            }
            _ => e,
        }
    }

    /// Two values brought to one type: an integer beside a real number becomes one.
    pub(super) fn common(&mut self, a: ExprId, b: ExprId) -> (ExprId, ExprId) {
        match (self.ty(a), self.ty(b)) {
            (Type::Scalar(Number::Real), Type::Scalar(Number::Integer)) => {
                let b = self.real(b);
                (a, b)
            }
            (Type::Scalar(Number::Integer), Type::Scalar(Number::Real)) => {
                let a = self.real(a);
                (a, b)
            }
            (Type::Set(_), Type::Set(_)) => {
                let (ta, tb) = (self.ty(a).clone(), self.ty(b).clone());
                (self.convert(a, &tb), self.convert(b, &ta))
            }
            _ => (a, b),
        }
    }

    /// A value as the type wants it, where there is a conversion: ℤ to ℝ, and the empty set to a set of anything.
    pub(super) fn convert(&mut self, e: ExprId, to: &Type) -> ExprId {
        match to {
            Type::Scalar(Number::Real) => self.real(e),
            Type::Set(_) if self.is_empty_set(e) => self.add(Kind::Set(Vec::new()), to.clone()),
            _ => e,
        }
    }

    fn vector(&mut self, e: &'a Expr, items: &'a [Expr]) -> ExprId {
        let mut entries = Vec::new();
        for item in items {
            let value = self.expr(item);
            let ty = self.ty(value).clone();
            match (&ty, ty.fixed_vector()) {
                (Type::Error, _) => return value,
                (Type::Scalar(_), _) => entries.push(self.real(value)),
                (Type::Vector { number, .. }, Some(n)) => {
                    for k in 1..=n {
                        let index = self.program.arena.integer(k);
                        let entry = self.add(Kind::Component(value, index), Type::Scalar(*number));
                        entries.push(self.real(entry));
                    }
                }
                _ => {
                    let found = ty.described();
                    let message = format!("{found} cannot be an entry of a vector");
                    let diagnostic = Diagnostic::error(item.span, message)
                        .here(format!("this is {found}"))
                        .help("the entries of `(a, b, c)` are numbers and vectors; `tuple(a, b)` holds any values");
                    let diagnostic = self.with_origins(diagnostic, &[item]);
                    return self.report(diagnostic);
                }
            }
        }
        let n = entries.len() as i64;
        if !(2..=4).contains(&n) {
            return self.unsupported(e.span, "vectors other than those of length 2, 3 or 4 are");
        }
        self.add(Kind::Vector(entries), Type::vector(n))
    }

    fn piecewise(
        &mut self,
        e: &'a Expr,
        branches: &'a [(Expr, Condition)],
        otherwise: Option<&'a Expr>,
    ) -> ExprId {
        let mut cases = Vec::new();
        for (value, condition) in branches {
            let condition = self.condition(condition);
            cases.push((value, Some(condition), self.expr(value)));
        }
        if let Some(value) = otherwise {
            cases.push((value, None, self.expr(value)));
        }
        // what is in error here may be a recursive call whose type is not yet known
        let typed: Vec<_> = cases
            .iter()
            .filter(|(_, _, v)| !self.is_error(*v))
            .map(|(syntax, _, v)| (*syntax, self.ty(*v).clone()))
            .collect();
        let Some((first, mut ty)) = typed.first().cloned() else {
            return self.error();
        };
        for (syntax, other) in &typed {
            if ty.is_scalar() && other.is_scalar() {
                if *other == Type::REAL {
                    ty = Type::REAL;
                }
            } else if *other != ty {
                let (a, b) = self.described_both(&ty, other);
                let message = format!("the branches differ: {a} and {b}");
                let diagnostic = Diagnostic::error(syntax.span, message)
                    .here(format!("this is {b}"))
                    .label(first.span, format!("this is {a}"))
                    .help("all branches of a piecewise definition must have the same type");
                let diagnostic = self.with_origins(diagnostic, &[first, syntax]);
                return self.report(diagnostic);
            }
        }
        let mut value = self.add_at(e.span, Kind::Fail, ty.clone());
        for (_, condition, case) in cases.into_iter().rev() {
            let case = match self.is_wrong(case) {
                true => self.add(Kind::Fail, ty.clone()),
                false => self.convert(case, &ty),
            };
            value = match condition {
                None => case,
                Some(condition) => {
                    self.add_at(e.span, Kind::If(condition, case, value), ty.clone())
                }
            };
        }
        value
    }
}
