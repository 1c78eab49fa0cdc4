//! Sums, products and big unions.

use super::Checker;
use super::scope::Scope;
use super::wording::NOT_NUMBERS;
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, Fold, Kind, Range};
use crate::syntax::ast::{BigOp, Condition, Definition, Expr, Head};
use crate::types::Type;
use crate::types::display::plural;

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
                        let found = ty.described();
                        let message = format!("the bounds of an index are integers, not {found}");
                        let diagnostic = Diagnostic::error(syntax.span, message)
                            .here(format!("this is {found}"))
                            .help("an index runs over all integers from one bound to the other");
                        let diagnostic = self.with_origins(diagnostic, &[syntax]);
                        return self.report(diagnostic);
                    }
                }
                let mut scope = Scope::default();
                let variable = self.bind(&mut scope, name, Type::INTEGER);
                (variable, Range::Integers(a, b), scope)
            }
            Head::Index(name) | Head::Filtered(name, _) => {
                let mut scope = Scope::default();
                let conditions: Vec<&'a Condition> = match head {
                    Head::Filtered(_, condition) => vec![condition],
                    _ => Vec::new(),
                };
                let locals = locals.iter().map(|local| &local.value);
                let parts: Vec<&'a Expr> = [body].into_iter().chain(locals).collect();
                match self.element_index(name, &parts, &conditions, None) {
                    Some(element) => {
                        let variable = self.bind_element(&mut scope, name, element);
                        let ty = Type::set_of(Type::Element(element));
                        let set = self.add(Kind::AllElements(element), ty);
                        (variable, Range::Set(set), scope)
                    }
                    None => {
                        let variable = self.bind_index(&mut scope, name);
                        (variable, Range::Rows { of: None }, scope)
                    }
                }
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
            Head::Index(_) | Head::Filtered(..) if range != (Range::Rows { of: None }) => range,
            Head::Index(_) | Head::Filtered(..) if ty.is_error() => {
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
                    BigOp::Sum => ("add up", "`∑` adds numbers, vectors and matrices"),
                    BigOp::Product => ("multiply", "`∏` multiplies numbers"),
                    BigOp::Union => ("unite", "`∪` unites sets; `∑` adds numbers"),
                };
                let help = match (op, &ty) {
                    (BigOp::Sum, Type::Set(_)) => "`∪` in place of `∑` unites sets",
                    (_, Type::Element(_)) => NOT_NUMBERS,
                    _ => takes,
                };
                let found = ty.described();
                let diagnostic = Diagnostic::error(
                    body.span,
                    format!("cannot {what} terms that are {}", terms(&ty)),
                )
                .here(format!("this is {found}"))
                .help(help);
                let diagnostic = self.with_origins(diagnostic, &[body]);
                return self.report(diagnostic);
            }
        };
        let (value, ty) = match ty.is_scalar() || ty.shape().is_none() {
            true => (value, ty),
            false => {
                let value = self.real(value);
                (value, self.ty(value).clone())
            }
        };
        // sizes of single terms are not known outside
        let ty = match &ty {
            Type::Set(_) => self.type_of_all(&ty, variable, false),
            _ => self.with_new_sizes(&ty, &|arena, e| arena.depends_on(e, variable), false),
        };
        self.add_at(
            e.span,
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

/// What the terms of a sum are, in the plural.
fn terms(ty: &Type) -> String {
    match (ty, ty.element_of_set()) {
        (Type::Element(element), _) => plural(element.kind).to_owned(),
        (_, Some(element)) => format!("sets of {}", plural(element.kind)),
        _ => ty.to_string(),
    }
}
