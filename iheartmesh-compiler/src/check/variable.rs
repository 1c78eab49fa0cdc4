//! The variables of an optimisation: which are tried one by one, and which are searched for.

use super::Checker;
use crate::diagnostic::Diagnostic;
use crate::resolve::names::FreeNames;
use crate::syntax::ast::{
    CompareOp, Condition, ConditionKind, Declaration, Definition, Expr, ExprKind, Name, Number,
    Relation, TypeKind,
};

/// What the variables may be.
const VARIABLES: &str = "a variable is a number, a vector, a matrix or a member of a set: `x ∈ ℝ`, `u ∈ ℝ^n`, `v ∈ V`, `x ∈ [a, b]`";

/// A variable whose values are tried one by one.
pub(super) struct Member<'a> {
    pub(super) name: &'a Name,
    pub(super) over: Over<'a>,
    /// What must hold of it and those before.
    pub(super) conditions: Vec<&'a Condition>,
    /// A real number that runs over integers is given as a real number.
    pub(super) is_real: bool,
}

/// What a variable runs over.
pub(super) enum Over<'a> {
    Set(&'a Expr),
    Declared(&'a Declaration, &'a Name),
    /// Bounds, with what is added to each.
    Integers(Vec<(&'a Expr, i64)>, Vec<(&'a Expr, i64)>),
}

/// A variable with real numbers.
pub(super) struct Real<'a> {
    pub(super) name: &'a Name,
    pub(super) declaration: &'a Declaration,
    pub(super) target: usize,
    /// An interval that it is declared in.
    pub(super) interval: Option<(&'a Expr, &'a Expr)>,
}

/// An optimisation with its variables sorted.
pub(super) struct Task<'a> {
    pub(super) e: &'a Expr,
    pub(super) greatest: bool,
    pub(super) members: Vec<Member<'a>>,
    pub(super) reals: Vec<Real<'a>>,
    pub(super) restrictions: Vec<&'a Condition>,
    pub(super) objective: &'a Expr,
    pub(super) initial: &'a [Definition],
}

impl<'a> Checker<'a> {
    /// Decides what a variable is.
    pub(super) fn sort_variable(
        &mut self,
        task: &mut Task<'a>,
        declaration: &'a Declaration,
        target: usize,
        names: &[&'a Name],
        conditions: &mut Vec<&'a Condition>,
    ) -> Option<()> {
        let name = &declaration.targets[target].name;
        let subscript = &declaration.targets[target].subscript;
        let wrong = |checker: &mut Self, what: &str| {
            let message = format!(
                "`{}` cannot be a variable of an optimisation: it is {what}",
                name.text
            );
            checker.report(Diagnostic::error(declaration.span, message).help(VARIABLES));
        };
        let mut is_real = false;
        let over = match &declaration.ty.kind {
            TypeKind::Members(set) if interval(set).is_some() && subscript.is_none() => None,
            _ if declaration.relation == Relation::Subset => {
                wrong(self, "a set");
                return None;
            }
            TypeKind::Named(_) | TypeKind::Members(_) if subscript.is_some() => {
                wrong(self, "a sequence of members of a set");
                return None;
            }
            TypeKind::Named(set) => Some(Over::Declared(declaration, set)),
            TypeKind::Members(set) => Some(Over::Set(set)),
            TypeKind::Scalar(number) if subscript.is_none() => match take_set(conditions, name) {
                Some(set) => {
                    is_real = *number == Number::Real;
                    Some(Over::Set(set))
                }
                None if *number == Number::Integer => {
                    Some(self.integers(name, task, names, conditions)?)
                }
                None => None,
            },
            TypeKind::Scalar(Number::Real) => None,
            TypeKind::Vector {
                number: Number::Real,
                sparse: false,
                ..
            }
            | TypeKind::Matrix {
                number: Number::Real,
                sparse: false,
                ..
            } => match subscript {
                None => take_set(conditions, name).map(Over::Set),
                Some(_) => None,
            },
            TypeKind::Vector { sparse: true, .. } | TypeKind::Matrix { sparse: true, .. } => {
                wrong(self, "sparse");
                return None;
            }
            TypeKind::Scalar(_) | TypeKind::Vector { .. } | TypeKind::Matrix { .. } => {
                wrong(self, "made of integers");
                return None;
            }
            _ => {
                let ty = self.written_type(&declaration.ty);
                if !ty.is_error() {
                    wrong(self, &ty.described());
                }
                return None;
            }
        };
        match over {
            Some(over) => task.members.push(Member {
                name,
                over,
                conditions: Vec::new(),
                is_real,
            }),
            None => task.reals.push(Real {
                name,
                declaration,
                target,
                interval: match &declaration.ty.kind {
                    TypeKind::Members(set) => interval(set),
                    _ => None,
                },
            }),
        }
        Some(())
    }

    /// The bounds of an integer variable, taken from the conditions.
    fn integers(
        &mut self,
        name: &'a Name,
        task: &Task<'a>,
        names: &[&'a Name],
        conditions: &mut Vec<&'a Condition>,
    ) -> Option<Over<'a>> {
        // bounds may depend on what is tried further out
        let unknown: Vec<&Name> = names
            .iter()
            .copied()
            .filter(|n| task.members.iter().all(|m| m.name.text != n.text))
            .collect();
        let (mut lower, mut upper) = (Vec::new(), Vec::new());
        conditions.retain(|condition| {
            let ConditionKind::Compare { op, left, right } = &condition.kind else {
                return true;
            };
            let (op, bound) = match (is_name(left, name), is_name(right, name)) {
                (true, false) if !mentions(right, &unknown) => (*op, &**right),
                (false, true) if !mentions(left, &unknown) => (reversed(*op), &**left),
                _ => return true,
            };
            match op {
                CompareOp::Less => upper.push((bound, -1)),
                CompareOp::LessOrEqual => upper.push((bound, 0)),
                CompareOp::Greater => lower.push((bound, 1)),
                CompareOp::GreaterOrEqual => lower.push((bound, 0)),
                CompareOp::Equal => {
                    upper.push((bound, 0));
                    lower.push((bound, 0));
                }
                CompareOp::NotEqual => return true,
            }
            false
        });
        if lower.is_empty() || upper.is_empty() {
            let missing = match (lower.is_empty(), upper.is_empty()) {
                (true, true) => "no bounds",
                (true, false) => "no lower bound",
                _ => "no upper bound",
            };
            let message = format!("the integer `{}` has {missing}", name.text);
            self.report(Diagnostic::error(name.span, message).help(format!(
                "integers are tried one by one: write `s.t. {0} ≥ a and {0} ≤ b`, or `{0} ∈ S` with a finite set",
                name.text
            )));
            return None;
        }
        Some(Over::Integers(lower, upper))
    }

    /// Gives each condition to the last variable that it is about.
    pub(super) fn sort_conditions(
        &mut self,
        task: &mut Task<'a>,
        conditions: Vec<&'a Condition>,
    ) -> Option<()> {
        let mut correct = true;
        for condition in conditions {
            if matches!(condition.kind, ConditionKind::Error) {
                return None;
            }
            if task
                .reals
                .iter()
                .any(|r| condition_mentions(condition, &[r.name]))
            {
                task.restrictions.push(condition);
                continue;
            }
            match task
                .members
                .iter()
                .rposition(|m| condition_mentions(condition, &[m.name]))
            {
                Some(last) => task.members[last].conditions.push(condition),
                None => {
                    correct = false;
                    let message = "this restriction says nothing about the variables";
                    self.report(
                        Diagnostic::error(condition.span, message)
                            .help("a restriction is a condition on the variables; a piecewise value chooses by others"),
                    );
                }
            }
        }
        correct.then_some(())
    }
}

/// The conditions that `and` joins.
pub(super) fn split<'a>(condition: &'a Condition, all: &mut Vec<&'a Condition>) {
    match &condition.kind {
        ConditionKind::And(a, b) => {
            split(a, all);
            split(b, all);
        }
        _ => all.push(condition),
    }
}

/// `[a, b]`.
pub(super) fn interval(e: &Expr) -> Option<(&Expr, &Expr)> {
    match &e.kind {
        ExprKind::Matrix(rows) => match rows.as_slice() {
            [row] => match row.as_slice() {
                [a, b] => Some((a, b)),
                _ => None,
            },
            _ => None,
        },
        _ => None,
    }
}

pub(super) fn is_name(e: &Expr, name: &Name) -> bool {
    matches!(&e.kind, ExprKind::Name(n) if n.text == name.text)
}

/// Takes `name ∈ S` out of the conditions, where `S` is a set and no interval.
fn take_set<'a>(conditions: &mut Vec<&'a Condition>, name: &Name) -> Option<&'a Expr> {
    let found = conditions
        .iter()
        .position(|condition| match &condition.kind {
            ConditionKind::Member { item, negated, set } => {
                !negated && is_name(item, name) && interval(set).is_none()
            }
            _ => false,
        })?;
    match &conditions.remove(found).kind {
        ConditionKind::Member { set, .. } => Some(set),
        _ => None,
    }
}

pub(super) fn mentions(e: &Expr, names: &[&Name]) -> bool {
    let mut found = false;
    let mut see = |name: &Name| found |= names.iter().any(|n| n.text == name.text);
    FreeNames::new(Vec::new(), &mut see).expr(e);
    found
}

fn condition_mentions(condition: &Condition, names: &[&Name]) -> bool {
    let mut found = false;
    let mut see = |name: &Name| found |= names.iter().any(|n| n.text == name.text);
    FreeNames::new(Vec::new(), &mut see).condition(condition);
    found
}

/// The relation with its sides exchanged.
pub(super) fn reversed(op: CompareOp) -> CompareOp {
    match op {
        CompareOp::Less => CompareOp::Greater,
        CompareOp::LessOrEqual => CompareOp::GreaterOrEqual,
        CompareOp::Greater => CompareOp::Less,
        CompareOp::GreaterOrEqual => CompareOp::LessOrEqual,
        same => same,
    }
}
