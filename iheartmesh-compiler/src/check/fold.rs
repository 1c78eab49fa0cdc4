//! Sums, products and big unions.

use super::Checker;
use super::scope::Scope;
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, Fold, Kind, Range};
use crate::syntax::ast::{BigOp, Definition, Expr, Head};
use crate::types::Type;

impl<'a> Checker<'a> {
    pub(super) fn big(
        &mut self,
        e: &'a Expr,
        op: BigOp,
        head: &'a Head,
        body: &'a Expr,
        locals: &'a [Definition],
    ) -> ExprId {
        let (variable, range, mut scope) = match head {
            Head::Members(names, range) => match self.bind_members(names, range) {
                Some((variable, set, scope)) => (variable, Range::Set(set), scope),
                None => return self.error(),
            },
            Head::Range(name, from, to) => {
                let (a, b) = (self.expr(from), self.expr(to));
                for (value, syntax) in [(a, from), (b, to)] {
                    let ty = self.ty(value).clone();
                    if ty.is_error() {
                        return value;
                    }
                    if ty != Type::INTEGER {
                        return self.report(
                            Diagnostic::error(
                                syntax.span,
                                format!("a bound of a sum cannot be {ty}"),
                            )
                            .here(format!("this is {ty}"))
                            .help("the bounds are integers"),
                        );
                    }
                }
                let mut scope = Scope::default();
                let variable = self.bind(&mut scope, name, Type::INTEGER);
                (variable, Range::Integers(a, b), scope)
            }
            Head::Index(name) | Head::Filtered(name, _) => {
                let mut scope = Scope::default();
                let variable = self.bind_index(&mut scope, name);
                (variable, Range::Rows, scope)
            }
        };
        self.bind_locals(&mut scope, locals);
        let (condition, value) = self.with_scope(scope, |checker| {
            let condition = match head {
                Head::Filtered(_, condition) => Some(checker.condition(condition)),
                _ => None,
            };
            (condition, checker.expr(body))
        });
        let ty = self.ty(value).clone();
        let range = match head {
            Head::Index(name) | Head::Filtered(name, _) if ty.is_error() => {
                let _ = name;
                self.index_uses.remove(&variable);
                range
            }
            Head::Index(name) | Head::Filtered(name, _) => match self.index_range(variable, name) {
                Some((_, size)) => Range::Integers(self.program.arena.integer(1), size),
                None => return self.error(),
            },
            _ => range,
        };
        let fold = match (op, &ty) {
            (_, Type::Error) => return value,
            (BigOp::Sum, ty) if ty.shape().is_some() => Fold::Sum,
            (BigOp::Product, Type::Scalar(_)) => Fold::Product,
            (BigOp::Union, Type::Set(_)) => Fold::Union,
            _ => {
                let (what, takes) = match op {
                    BigOp::Sum => ("add up", "numbers, vectors and matrices"),
                    BigOp::Product => ("multiply up", "numbers"),
                    BigOp::Union => ("unite", "sets"),
                };
                return self.report(
                    Diagnostic::error(body.span, format!("cannot {what} values of type {ty}"))
                        .here(format!("this is {ty}"))
                        .label(e.span, "in this expression")
                        .help(format!("it is defined for {takes}")),
                );
            }
        };
        let (value, ty) = match ty.is_scalar() || ty.shape().is_none() {
            true => (value, ty),
            false => {
                let value = self.real(value);
                (value, self.ty(value).clone())
            }
        };
        self.add(
            Kind::Fold {
                op: fold,
                variable,
                range,
                condition,
                body: value,
            },
            ty,
        )
    }
}
