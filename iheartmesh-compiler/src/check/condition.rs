//! Conditions.

use super::Checker;
use super::subscript::with_article;
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, Kind};
use crate::syntax::ast::{CompareOp, Condition, ConditionKind, Expr, ExprKind};
use crate::types::Type;

impl<'a> Checker<'a> {
    /// Checks a condition.
    pub(super) fn condition(&mut self, condition: &'a Condition) -> ExprId {
        match &condition.kind {
            ConditionKind::And(a, b) => {
                let (a, b) = (self.condition(a), self.condition(b));
                self.add(Kind::And(a, b), Type::Boolean)
            }
            ConditionKind::Or(a, b) => {
                let (a, b) = (self.condition(a), self.condition(b));
                self.add(Kind::Or(a, b), Type::Boolean)
            }
            ConditionKind::Compare { op, left, right } => self.compare(condition, *op, left, right),
            ConditionKind::Member { item, negated, set } => {
                let member = self.member(condition, item, set);
                match negated {
                    true => self.add(Kind::Not(member), Type::Boolean),
                    false => member,
                }
            }
            ConditionKind::Error => self.no_condition(),
        }
    }

    /// A condition in error: it has the type of a condition, so that what it guards is still checked.
    fn no_condition(&mut self) -> ExprId {
        self.add(Kind::Fail, Type::Boolean)
    }

    fn compare(
        &mut self,
        condition: &'a Condition,
        op: CompareOp,
        left: &'a Expr,
        right: &'a Expr,
    ) -> ExprId {
        let a = self.expr(left);
        let b = self.expr(right);
        if self.is_error(a) || self.is_error(b) {
            return self.no_condition();
        }
        let (a, b) = self.common(a, b);
        let (ta, tb) = (self.ty(a).clone(), self.ty(b).clone());
        let equality = matches!(op, CompareOp::Equal | CompareOp::NotEqual);
        let help = match (&ta, &tb) {
            (Type::Scalar(_), Type::Scalar(_)) => None,
            (Type::Element(x), Type::Element(y)) if x == y => None,
            (Type::Element(x), Type::Element(y)) if x.kind == y.kind => {
                let (here, there) = (self.mesh_name(x.mesh), self.mesh_name(y.mesh));
                Some(format!(
                    "one is of `{here}`, the other of `{there}`; they are never the same"
                ))
            }
            (Type::Element(_), Type::Element(_)) => {
                Some("vertices, edges, faces and cells are different kinds of elements".to_owned())
            }
            (Type::Set(x), Type::Set(y)) if x == y && equality => None,
            (Type::Vector { .. } | Type::Tuple(_), _) if ta == tb && equality => None,
            (Type::Element(_), Type::Scalar(_)) | (Type::Scalar(_), Type::Element(_)) => {
                Some("elements of a mesh are not numbers".to_owned())
            }
            _ if ta == tb => Some("only `=` and `≠` are defined here".to_owned()),
            _ => Some("both sides must have one type".to_owned()),
        };
        if let Some(help) = help {
            self.report(
                Diagnostic::error(
                    condition.span,
                    format!(
                        "cannot compare {} and {}",
                        with_article(&ta),
                        with_article(&tb)
                    ),
                )
                .label(left.span, format!("this is {}", with_article(&ta)))
                .label(right.span, format!("this is {}", with_article(&tb)))
                .help(help),
            );
            return self.no_condition();
        }
        self.add(Kind::Compare(op, a, b), Type::Boolean)
    }

    fn member(&mut self, condition: &'a Condition, item: &'a Expr, set: &'a Expr) -> ExprId {
        let value = match &item.kind {
            ExprKind::Vector(items) => {
                let items: Vec<ExprId> = items.iter().map(|i| self.expr(i)).collect();
                let types = items.iter().map(|i| self.ty(*i).clone()).collect();
                self.add(Kind::Tuple(items), Type::Tuple(types))
            }
            _ => self.expr(item),
        };
        let set_value = self.expr(set);
        if self.is_error(value) || self.is_error(set_value) {
            return self.no_condition();
        }
        let (ty, set_ty) = (self.ty(value).clone(), self.ty(set_value).clone());
        let Type::Set(member) = &set_ty else {
            self.report(
                Diagnostic::error(
                    set.span,
                    format!(
                        "`∈` needs a set on its right, not {}",
                        with_article(&set_ty)
                    ),
                )
                .here(format!("this is {}", with_article(&set_ty)))
                .help("compare numbers with `=`, `<`, `≤`, …"),
            );
            return self.no_condition();
        };
        let value = self.convert(value, member);
        if self.ty(value) == &**member {
            return self.add(Kind::Member(value, set_value), Type::Boolean);
        }
        let help = match (&ty, &**member) {
            (Type::Element(x), Type::Element(y)) if x.kind == y.kind => {
                let (here, there) = (self.mesh_name(x.mesh), self.mesh_name(y.mesh));
                format!("one is of `{here}`, the other of `{there}`")
            }
            _ => format!("the members of this set are of type {member}"),
        };
        self.report(
            Diagnostic::error(
                condition.span,
                format!("{} cannot be a member of a {set_ty}", with_article(&ty)),
            )
            .label(item.span, format!("this is {}", with_article(&ty)))
            .label(set.span, format!("this is a {set_ty}"))
            .help(help),
        );
        self.no_condition()
    }
}
