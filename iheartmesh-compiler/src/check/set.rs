//! Set literals and set builders.

use super::Checker;
use super::scope::Scope;
use super::subscript::with_article;
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, Fold, Kind, Range, VariableId};
use crate::resolve::symbols::count;
use crate::syntax::ast::{Condition, Expr, Name};
use crate::types::Type;

impl<'a> Checker<'a> {
    pub(super) fn set_literal(&mut self, e: &'a Expr, items: &'a [Expr]) -> ExprId {
        let values: Vec<ExprId> = items.iter().map(|i| self.expr(i)).collect();
        if values.iter().any(|v| self.is_error(*v)) {
            return self.error();
        }
        let Some(&first) = values.first() else {
            // its type is that of the set it is put together with
            return self.add_at(e.span, Kind::Set(Vec::new()), Type::set_of(Type::Error));
        };
        let mut ty = self.ty(first).clone();
        for (value, syntax) in values.iter().zip(items) {
            let other = self.ty(*value).clone();
            if ty.is_scalar() && other.is_scalar() {
                if other == Type::REAL {
                    ty = Type::REAL;
                }
            } else if other != ty {
                let (a, b) = (with_article(&ty), with_article(&other));
                return self.report(
                    Diagnostic::error(syntax.span, format!("a set cannot hold {a} and {b}"))
                        .here(format!("this is {b}"))
                        .label(items[0].span, format!("this is {a}"))
                        .help("all members of a set have one type"),
                );
            }
        }
        let values = values.into_iter().map(|v| self.convert(v, &ty)).collect();
        self.add(Kind::Set(values), Type::set_of(ty))
    }

    pub(super) fn is_empty_set(&self, e: ExprId) -> bool {
        matches!(self.program.arena.kind(e), Kind::Set(items) if items.is_empty())
            && self.ty(e) == &Type::set_of(Type::Error)
    }

    pub(super) fn builder(
        &mut self,
        _e: &'a Expr,
        element: &'a Expr,
        variables: &'a [Name],
        range: &'a Expr,
        condition: Option<&'a Condition>,
    ) -> ExprId {
        let Some((variable, range, scope)) = self.bind_members(variables, range) else {
            return self.error();
        };
        let (body, condition) = self.with_scope(scope, |checker| {
            let condition = condition.map(|c| checker.condition(c));
            (checker.expr(element), condition)
        });
        if self.is_error(body) {
            return self.error();
        }
        let ty = Type::set_of(self.ty(body).clone());
        self.add(
            Kind::Fold {
                op: Fold::Collect,
                variable,
                range: Range::Set(range),
                condition,
                body,
            },
            ty,
        )
    }

    /// Binds names to the members of a set: one name to the whole member, or several to the items of a tuple.
    pub(super) fn bind_members(
        &mut self,
        names: &'a [Name],
        range: &'a Expr,
    ) -> Option<(VariableId, ExprId, Scope<'a>)> {
        let set = self.expr(range);
        let ty = self.ty(set).clone();
        if ty.is_error() {
            return None;
        }
        let Type::Set(member) = &ty else {
            self.report(
                Diagnostic::error(
                    range.span,
                    format!("`∈` needs a set on its right, not {}", with_article(&ty)),
                )
                .here(format!("this is {}", with_article(&ty)))
                .help("an index runs over a set, as in `∑_(f ∈ Faces(v))`"),
            );
            return None;
        };
        let mut scope = Scope::default();
        if let [name] = names {
            let variable = self.bind(&mut scope, name, (**member).clone());
            return Some((variable, set, scope));
        }
        let items = match &**member {
            Type::Tuple(items) if items.len() == names.len() => items,
            other => {
                let last = names.last().unwrap_or(&names[0]);
                self.report(
                    Diagnostic::error(
                        names[0].span.to(last.span),
                        format!("{} for {}", count(names.len(), "name"), with_article(other)),
                    )
                    .label(range.span, format!("this is a {ty}"))
                    .help("a set of pairs takes two names; write one sum inside another for all pairs of a set"),
                );
                return None;
            }
        };
        let whole = self.program.arena.new_variable("pair", (**member).clone());
        let value = self.program.arena.variable(whole);
        for (k, (name, ty)) in names.iter().zip(items).enumerate() {
            let item = self.project(value, k, ty.clone());
            scope
                .names
                .insert(name.text.clone(), super::scope::Binding::Value(item));
        }
        Some((whole, set, scope))
    }
}
