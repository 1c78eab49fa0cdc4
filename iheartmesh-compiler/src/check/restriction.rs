//! Restrictions of optimisations over real numbers: `A x ≤ b`, `‖x‖ = 1`, `x_i ≥ 0`, `x ∈ [a, b]`.
//!
//! Bounds of whole variables are kept apart, since the search never leaves them. A strict relation counts as the one
//! that allows equality: an optimum over an open set need not exist.

use super::Checker;
use super::scope::Scope;
use super::variable::{Real, interval, is_name, mentions, reversed};
use crate::diagnostic::Diagnostic;
use crate::ir::{Binary, ExprId, Kind, Layout, Restriction};
use crate::resolve::names::subscript_letters;
use crate::syntax::ast::{CompareOp, Condition, ConditionKind, Expr, Name};
use crate::types::{Shape, Type};

impl<'a> Checker<'a> {
    /// What the conditions ask of the real variables; `None` where one is wrong.
    pub(super) fn restrictions(
        &mut self,
        reals: &[Real<'a>],
        conditions: &[&'a Condition],
    ) -> Option<Vec<Restriction>> {
        let mut all = Some(Vec::new());
        let mut take = |found: Option<Vec<Restriction>>| match (found, &mut all) {
            (Some(found), Some(list)) => list.extend(found),
            (None, _) => all = None,
            _ => {}
        };
        for real in reals {
            if let Some((low, high)) = real.interval {
                let name = real.name;
                take(self.bounds(reals, name, low, CompareOp::GreaterOrEqual));
                take(self.bounds(reals, name, high, CompareOp::LessOrEqual));
            }
        }
        for condition in conditions {
            take(self.restriction(reals, condition));
        }
        all
    }

    /// A bound of a variable that is declared in an interval.
    fn bounds(
        &mut self,
        reals: &[Real<'a>],
        name: &Name,
        bound: &'a Expr,
        op: CompareOp,
    ) -> Option<Vec<Restriction>> {
        let value = self.expr(bound);
        if self.is_error(value) {
            return None;
        }
        let ty = self.ty(value).clone();
        let k = reals.iter().position(|r| r.name.text == name.text)?;
        let names: Vec<&Name> = reals.iter().map(|r| r.name).collect();
        if mentions(bound, &names[k..]) {
            // variables that stand further down are unknown here, which has been reported
            return None;
        }
        if !ty.is_scalar() || mentions(bound, &names) {
            let message = match ty.is_scalar() {
                true => "the bounds of an interval do not depend on the variables".to_owned(),
                false => format!(
                    "the bounds of an interval are numbers, not {}",
                    ty.described()
                ),
            };
            self.report(
                Diagnostic::error(bound.span, message)
                    .help("write the others behind `s.t.`, as in `x ≤ 2 y`"),
            );
            return None;
        }
        let value = self.real(value);
        let k = k as u32;
        Some(vec![match op {
            CompareOp::GreaterOrEqual => Restriction::Lower(k, value),
            _ => Restriction::Upper(k, value),
        }])
    }

    fn restriction(
        &mut self,
        reals: &[Real<'a>],
        condition: &'a Condition,
    ) -> Option<Vec<Restriction>> {
        let wrong = |checker: &mut Self, message: &str, help: &str| {
            checker.report(Diagnostic::error(condition.span, message.to_owned()).help(help));
            None
        };
        match &condition.kind {
            ConditionKind::Compare { op, left, right } => match op {
                CompareOp::NotEqual => wrong(
                    self,
                    "`≠` is no restriction of real variables",
                    "restrictions are `=`, `≤` and `≥`: where they hold must not have holes",
                ),
                _ => self.related(reals, condition, *op, left, right),
            },
            ConditionKind::Member {
                item,
                negated: false,
                set,
            } if interval(set).is_some() => {
                let (low, high) = interval(set)?;
                let mut all =
                    self.related(reals, condition, CompareOp::GreaterOrEqual, item, low)?;
                all.extend(self.related(reals, condition, CompareOp::LessOrEqual, item, high)?);
                Some(all)
            }
            ConditionKind::Member { negated: true, .. } => wrong(
                self,
                "`∉` is no restriction of real variables",
                "restrictions are `=`, `≤`, `≥`, and `∈` for a variable and a finite set or an interval `[a, b]`",
            ),
            ConditionKind::Member { .. } => wrong(
                self,
                "only a variable alone can be restricted to the members of a set",
                "declare a variable for it, as in `min_(k ∈ S, x ∈ ℝ^n)`, or write an interval `[a, b]`",
            ),
            ConditionKind::Or(..) => wrong(
                self,
                "`or` cannot join restrictions of real variables",
                "all restrictions hold together; write each on a line of its own",
            ),
            ConditionKind::And(..) | ConditionKind::Error => None,
        }
    }

    fn related(
        &mut self,
        reals: &[Real<'a>],
        condition: &'a Condition,
        op: CompareOp,
        left: &'a Expr,
        right: &'a Expr,
    ) -> Option<Vec<Restriction>> {
        let letters: Vec<&'a Name> = subscript_letters(condition)
            .into_iter()
            .filter(|name| !self.is_bound(&name.text))
            .collect();
        if !letters.is_empty() {
            return self.for_all(condition, op, left, right, &letters);
        }
        let (a, b) = (self.expr(left), self.expr(right));
        if self.is_error(a) || self.is_error(b) {
            return None;
        }
        let names: Vec<&Name> = reals.iter().map(|r| r.name).collect();
        for (variable, bound, value, op) in [(left, right, b, op), (right, left, a, reversed(op))] {
            let position = reals.iter().position(|r| is_name(variable, r.name));
            let Some(k) = position.filter(|_| !mentions(bound, &names)) else {
                continue;
            };
            let own = self
                .ty(if std::ptr::eq(variable, left) { a } else { b })
                .clone();
            let value = self.real(value);
            let given = self.ty(value).clone();
            let fits = given.is_scalar() && own.shape().is_some()
                || self.same_shape(&own, &given).is_some();
            if fits && !given.is_sparse() {
                let k = k as u32;
                return Some(match op {
                    CompareOp::Less | CompareOp::LessOrEqual => vec![Restriction::Upper(k, value)],
                    CompareOp::Equal => {
                        vec![Restriction::Lower(k, value), Restriction::Upper(k, value)]
                    }
                    _ => vec![Restriction::Lower(k, value)],
                });
            }
        }
        let difference = self.difference(condition, (left, a), (right, b), op)?;
        Some(vec![restricted(op, difference)])
    }

    /// What must be 0, or not above 0: the left side minus the right one, or the other way round.
    fn difference(
        &mut self,
        condition: &'a Condition,
        (left, a): (&'a Expr, ExprId),
        (right, b): (&'a Expr, ExprId),
        op: CompareOp,
    ) -> Option<ExprId> {
        let (a, b) = (self.real(a), self.real(b));
        let (ta, tb) = (self.ty(a).clone(), self.ty(b).clone());
        let (a, b) = match (ta.shape(), tb.shape()) {
            (Some(Shape::Scalar), Some(shape)) if self.same_shape(&ta, &tb).is_none() => {
                (self.spread(a, b, &shape), b)
            }
            (Some(shape), Some(Shape::Scalar)) if self.same_shape(&ta, &tb).is_none() => {
                (a, self.spread(b, a, &shape))
            }
            (Some(_), Some(_)) if self.same_shape(&ta, &tb).is_some() => (a, b),
            _ => {
                let (ta, tb) = self.described_both(&ta, &tb);
                let diagnostic = Diagnostic::error(condition.span, format!("cannot compare {ta} with {tb}"))
                    .label(left.span, format!("this is {ta}"))
                    .label(right.span, format!("this is {tb}"))
                    .help("a restriction compares numbers, or vectors or matrices of one size entry by entry; a number beside them holds for all entries");
                let diagnostic = self.with_origins(diagnostic, &[left, right]);
                self.report(diagnostic);
                return None;
            }
        };
        let (a, b) = match op {
            CompareOp::Greater | CompareOp::GreaterOrEqual => (b, a),
            _ => (a, b),
        };
        let difference = self.sum_of(condition.span, Binary::Subtract, a, b)?;
        let difference = self.real(difference);
        let dense = self.ty(difference).shape()?.real();
        Some(self.represented(difference, &dense))
    }

    /// A number as all entries of an array of the size of another.
    fn spread(&mut self, number: ExprId, like: ExprId, shape: &Shape) -> ExprId {
        let sizes = match shape {
            Shape::Scalar => return number,
            Shape::Vector(_) => vec![self.extent(like, 0)],
            Shape::Matrix(..) => vec![self.extent(like, 0), self.extent(like, 1)],
        };
        self.add(Kind::Filled(number, sizes), shape.clone().real())
    }

    /// A restriction for all values of its subscripts.
    fn for_all(
        &mut self,
        condition: &'a Condition,
        op: CompareOp,
        left: &'a Expr,
        right: &'a Expr,
        letters: &[&'a Name],
    ) -> Option<Vec<Restriction>> {
        let mut scope = Scope::default();
        let variables: Vec<_> = letters
            .iter()
            .map(|name| self.bind_index(&mut scope, name))
            .collect();
        let body = self.with_scope(scope, |checker| {
            let (a, b) = (checker.expr(left), checker.expr(right));
            if checker.is_error(a) || checker.is_error(b) {
                return None;
            }
            checker.difference(condition, (left, a), (right, b), op)
        });
        let mut ranges = Vec::new();
        for (variable, name) in variables.iter().zip(letters) {
            match body {
                Some(_) => ranges.push(self.index_range(*variable, name)),
                None => drop(self.index_uses.remove(variable)),
            }
        }
        let body = body?;
        let ranges: Vec<_> = ranges.into_iter().collect::<Option<_>>()?;
        let (dimensions, sizes): (Vec<_>, Vec<_>) = ranges.into_iter().unzip();
        let (layout, ty) = match (self.ty(body).is_scalar(), dimensions.as_slice()) {
            (true, [n]) => (Layout::Vector, Type::real_vector(n.clone())),
            (true, [n, m]) => (Layout::Matrix, Type::real_matrix(n.clone(), m.clone())),
            (false, [n]) => (
                Layout::Sequence,
                Type::Sequence {
                    item: Box::new(self.ty(body).clone()),
                    length: n.clone(),
                    index: None,
                },
            ),
            _ => {
                self.unsupported(condition.span, "restrictions with this many subscripts are");
                return None;
            }
        };
        let kind = Kind::Tabulate {
            layout,
            variables,
            sizes,
            body,
        };
        let value = self.add_at(condition.span, kind, ty);
        Some(vec![restricted(op, value)])
    }
}

fn restricted(op: CompareOp, value: ExprId) -> Restriction {
    match op {
        CompareOp::Equal => Restriction::Equal(value),
        _ => Restriction::AtMost(value),
    }
}
