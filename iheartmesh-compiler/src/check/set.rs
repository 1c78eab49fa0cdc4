//! Set literals, set builders, and operations on sets.

use super::Checker;
use super::operator::Sides;
use super::scope::Scope;
use super::wording::{KINDS, ONE_MESH};
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, Fold, Kind, Range, SetOp, VariableId};
use crate::resolve::symbols::count;
use crate::syntax::ast::{Condition, Expr, ExprKind, Name};
use crate::types::{Atom, Type};

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
                let (a, b) = self.described_both(&ty, &other);
                let help = match ty.is_element() && other.is_element() {
                    true => {
                        "a set has elements of one kind and one mesh; `tuple(a, b)` holds any two"
                    }
                    false => "all members of a set have the same type; `tuple(a, b)` holds any two",
                };
                let diagnostic =
                    Diagnostic::error(syntax.span, format!("a set cannot hold both {a} and {b}"))
                        .here(format!("this is {b}"))
                        .label(items[0].span, format!("this is {a}"))
                        .help(help);
                let diagnostic = self.with_origins(diagnostic, &[syntax, &items[0]]);
                return self.report(diagnostic);
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
        let ty = self.ty(body).clone();
        let ty = Type::set_of(self.type_of_all(&ty, variable, false));
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

    /// A set of integers as one of real numbers.
    pub(super) fn set_of_reals(&mut self, set: ExprId) -> ExprId {
        let variable = self.program.arena.new_variable("member", Type::INTEGER);
        let member = self.program.arena.variable(variable);
        let body = self.real(member);
        self.add(
            Kind::Fold {
                op: Fold::Collect,
                variable,
                range: Range::Set(set),
                condition: None,
                body,
            },
            Type::set_of(Type::REAL),
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
            let found = ty.described();
            let help = match ty {
                Type::Scalar(_) => {
                    "an index runs over a set; from 1 to `n` it runs in `∑_(i = 1)^n`"
                }
                _ => "an index runs over a set, as in `∑_(f ∈ Faces(v))`",
            };
            let message = format!("`∈` needs a set on its right, not {found}");
            let diagnostic = Diagnostic::error(range.span, message)
                .here(format!("this is {found}"))
                .help(help);
            let diagnostic = self.with_origins(diagnostic, &[range]);
            self.report(diagnostic);
            return None;
        };
        let mut scope = Scope::default();
        if let [name] = names {
            let member = self.member_type(member);
            let variable = self.bind(&mut scope, name, member);
            return Some((variable, set, scope));
        }
        let member = self.member_type(member);
        let items = match &member {
            Type::Tuple(items) if items.len() == names.len() => items,
            other => {
                let last = names.last().unwrap_or(&names[0]);
                let message = format!(
                    "cannot take {} apart into {}",
                    other.described(),
                    count(names.len(), "name")
                );
                let help = match other {
                    Type::Tuple(items) => format!("give {}", count(items.len(), "name")),
                    _ => "each name for all members has a sum or set of its own, as in `∑_(i ∈ S) ∑_(j ∈ S)`".to_owned(),
                };
                let diagnostic = Diagnostic::error(names[0].span.to(last.span), message)
                    .label(range.span, format!("this is {}", ty.described()))
                    .help(help);
                let diagnostic = self.with_origins(diagnostic, &[range]);
                self.report(diagnostic);
                return None;
            }
        };
        let whole = self.program.arena.new_variable("pair", member.clone());
        let value = self.program.arena.variable(whole);
        for (k, (name, ty)) in names.iter().zip(items).enumerate() {
            let item = self.project(value, k, ty.clone());
            scope
                .names
                .insert(name.text.clone(), super::scope::Binding::Value(item));
            scope.spans.insert(name.text.clone(), name.span);
        }
        Some((whole, set, scope))
    }

    /// The type of a member at hand: a size that differs from member to member is its own.
    fn member_type(&mut self, member: &Type) -> Type {
        let count = std::cell::Cell::new(self.n_dynamic);
        let ty = member.with_atoms(&|atom| match atom {
            Atom::Item(_, None) => {
                count.set(count.get() + 1);
                Some(Atom::Dynamic(count.get()))
            }
            _ => None,
        });
        self.n_dynamic = count.get();
        ty
    }

    /// A union, an intersection, a difference.
    pub(super) fn set_operation(
        &mut self,
        sides: Sides<'a>,
        op: SetOp,
        a: ExprId,
        b: ExprId,
    ) -> ExprId {
        // an empty literal takes the type of the other side, integers are real numbers
        let (a, b) = self.common(a, b);
        let (ta, tb) = (self.ty(a).clone(), self.ty(b).clone());
        let (verb, preposition, sign) = match op {
            SetOp::Union => ("unite", "and", "∪"),
            SetOp::Intersection => ("intersect", "and", "∩"),
            SetOp::Difference => ("subtract", "from", "-"),
        };
        match (&ta, &tb) {
            (Type::Set(x), Type::Set(y)) if x == y => self.add(Kind::SetOp(op, a, b), ta),
            (Type::Set(x), Type::Set(y)) => match (&**x, &**y) {
                (Type::Element(x), Type::Element(y)) if x.mesh != y.mesh => {
                    self.mismatch(sides, verb, preposition, &ta, &tb, ONE_MESH)
                }
                (Type::Element(_), Type::Element(_)) => {
                    self.mismatch(sides, verb, preposition, &ta, &tb, KINDS)
                }
                _ => self.mismatch(
                    sides,
                    verb,
                    preposition,
                    &ta,
                    &tb,
                    "the members of both sets must have the same type",
                ),
            },
            (Type::Set(item), other) if **item == *other => {
                let member = match &sides.right.kind {
                    ExprKind::Name(name) => name.text.as_str(),
                    ExprKind::Integer(_) => "1",
                    _ => "…",
                };
                let help = format!(
                    "`{{{member}}}` is the set with this one member: `… {sign} {{{member}}}`"
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
}
