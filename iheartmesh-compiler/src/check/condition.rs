//! Conditions.

use super::Checker;
use super::wording::{KINDS, ONE_MESH};
use crate::diagnostic::Diagnostic;
use crate::ir::{Binary, ExprId, Kind, Unary};
use crate::syntax::ast::{CompareOp, Condition, ConditionKind, Expr, ExprKind};
use crate::types::display::plural;
use crate::types::{Number, Type};

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

    /// A comparison; with `±` it holds where it does with `+` or with `-`.
    fn compare(
        &mut self,
        condition: &'a Condition,
        op: CompareOp,
        left: &'a Expr,
        right: &'a Expr,
    ) -> ExprId {
        let outer = self.plus_minus.replace((Binary::Add, 0));
        let plus = self.compare_once(condition, op, left, right);
        let uses = self
            .plus_minus
            .replace((Binary::Subtract, 0))
            .map_or(0, |(_, uses)| uses);
        let value = match uses {
            0 => plus,
            1 => {
                let minus = self.compare_once(condition, op, left, right);
                self.add(Kind::Or(plus, minus), Type::Boolean)
            }
            _ => {
                self.report(
                    Diagnostic::error(condition.span, "`±` stands here more than once")
                        .help("one comparison has one `±`; write the others out with `or`"),
                );
                self.no_condition()
            }
        };
        self.plus_minus = outer;
        value
    }

    fn compare_once(
        &mut self,
        condition: &'a Condition,
        op: CompareOp,
        left: &'a Expr,
        right: &'a Expr,
    ) -> ExprId {
        let a = self.expr(left);
        let b = self.expr(right);
        if self.is_wrong(a) || self.is_wrong(b) {
            return self.no_condition();
        }
        let (a, b) = self.common(a, b);
        let (ta, tb) = (self.ty(a).clone(), self.ty(b).clone());
        let equality = matches!(op, CompareOp::Equal | CompareOp::NotEqual);
        let help = match (&ta, &tb) {
            (Type::Scalar(_), Type::Scalar(_)) => None,
            (Type::Element(x), Type::Element(y)) if x == y => None,
            (Type::Element(x), Type::Element(y)) if x.kind == y.kind => {
                Some("elements of different meshes are never the same")
            }
            (Type::Element(_), Type::Element(_)) => Some(KINDS),
            (Type::Set(x), Type::Set(y)) if x == y && equality => None,
            (Type::Vector { .. } | Type::Tuple(_), _) if ta == tb && equality => None,
            (Type::Element(_), Type::Scalar(_)) | (Type::Scalar(_), Type::Element(_)) => {
                Some("elements of a mesh are not numbers")
            }
            _ if ta == tb && equality => {
                Some("only numbers, elements, vectors, sets and tuples can be compared")
            }
            _ if ta == tb => Some(
                "only numbers and elements have an order; the others can be compared by `=` and `≠`",
            ),
            _ => Some("both sides must have the same type"),
        };
        if let Some(help) = help {
            let (a, b) = self.described_both(&ta, &tb);
            let diagnostic =
                Diagnostic::error(condition.span, format!("cannot compare {a} with {b}"))
                    .label(left.span, format!("this is {a}"))
                    .label(right.span, format!("this is {b}"))
                    .help(help);
            let diagnostic = self.with_origins(diagnostic, &[left, right]);
            self.report(diagnostic);
            return self.no_condition();
        }
        self.add(Kind::Compare(op, a, b), Type::Boolean)
    }

    /// A tuple of values; that of all items of a tuple is the tuple.
    fn tuple_of(&mut self, items: Vec<ExprId>, ty: Type) -> ExprId {
        if let Some(Kind::Project(whole, 0)) = items.first().map(|i| self.program.arena.kind(*i)) {
            let whole = *whole;
            let is_item = |(k, item): (usize, &ExprId)| {
                *self.program.arena.kind(*item) == Kind::Project(whole, k as u32)
            };
            if *self.ty(whole) == ty && items.iter().enumerate().all(is_item) {
                return whole;
            }
        }
        self.add(Kind::Tuple(items), ty)
    }

    fn member(&mut self, condition: &'a Condition, item: &'a Expr, set: &'a Expr) -> ExprId {
        let value = match &item.kind {
            ExprKind::Vector(items) => {
                let items: Vec<ExprId> = items.iter().map(|i| self.expr(i)).collect();
                let types = items.iter().map(|i| self.ty(*i).clone()).collect();
                self.tuple_of(items, Type::Tuple(types))
            }
            _ => self.expr(item),
        };
        let set_value = self.expr(set);
        if self.is_error(value) || self.is_error(set_value) {
            return self.no_condition();
        }
        let (ty, set_ty) = (self.ty(value).clone(), self.ty(set_value).clone());
        let Type::Set(member) = &set_ty else {
            let found = set_ty.described();
            let message = format!("`∈` needs a set on its right, not {found}");
            let diagnostic = Diagnostic::error(set.span, message)
                .here(format!("this is {found}"))
                .help("values are compared with `=`, `<`, `≤`, …");
            let diagnostic = self.with_origins(diagnostic, &[set]);
            self.report(diagnostic);
            return self.no_condition();
        };
        let value = match (&ty, &**member) {
            // an element is its number, counted from 1
            (Type::Element(_), Type::Scalar(Number::Integer)) => {
                self.add(Kind::Unary(Unary::ToInteger, value), Type::INTEGER)
            }
            _ => self.convert(value, member),
        };
        if self.ty(value) == &**member {
            return self.add(Kind::Member(value, set_value), Type::Boolean);
        }
        let help = match (&ty, &**member) {
            (Type::Element(x), Type::Element(y)) if x.kind == y.kind => ONE_MESH.to_owned(),
            (_, Type::Element(element)) => self
                .counted_help(item)
                .unwrap_or_else(|| format!("the members of this set are {}", plural(element.kind))),
            _ => format!("the members of this set have the type {member}"),
        };
        let (a, b) = self.described_both(&ty, &set_ty);
        let message = format!("{a} cannot be a member of {b}");
        let diagnostic = Diagnostic::error(condition.span, message)
            .label(item.span, format!("this is {a}"))
            .label(set.span, format!("this is {b}"))
            .help(help);
        let diagnostic = self.with_origins(diagnostic, &[item, set]);
        self.report(diagnostic);
        self.no_condition()
    }
}
