//! Optima.
//!
//! Variables that are members of finite sets, and integers between bounds, are tried one by one, in order of the text and of
//! the sets: nested loops, of which the first best one stays. Inside of them stands the search over the real variables.

use super::Checker;
use super::scope::{Binding, Scope};
use super::variable::{Member, Over, Task, split};
use crate::diagnostic::Diagnostic;
use crate::ir::{Binary, ExprId, Fold, Kind, Range, VariableId};
use crate::syntax::ast::{CompareOp, Condition, Expr, ExprKind, Name, OptimiseKind};
use crate::types::Type;

impl<'a> Checker<'a> {
    /// `min_(x ∈ ℝ^n) f s.t. …` and its like.
    pub(super) fn optimise(&mut self, e: &'a Expr) -> ExprId {
        let ExprKind::Optimise {
            kind,
            variables,
            objective,
            constraints,
            initial,
        } = &e.kind
        else {
            return self.error();
        };
        let mut conditions = Vec::new();
        constraints.iter().for_each(|c| split(c, &mut conditions));
        let mut task = Task {
            e,
            greatest: matches!(kind, OptimiseKind::Max | OptimiseKind::ArgMax),
            members: Vec::new(),
            reals: Vec::new(),
            restrictions: Vec::new(),
            objective,
            initial,
        };
        let names: Vec<&'a Name> = variables
            .iter()
            .flat_map(|d| &d.targets)
            .map(|t| &t.name)
            .collect();
        for (k, name) in names.iter().enumerate() {
            if let Some(before) = names[..k].iter().find(|n| n.text == name.text) {
                let message = format!("`{}` is a variable twice", name.text);
                return self.report(
                    Diagnostic::error(name.span, message)
                        .label(before.span, "declared here")
                        .help("the variables of one optimisation have different names"),
                );
            }
        }
        for declaration in variables {
            for target in 0..declaration.targets.len() {
                if self
                    .sort_variable(&mut task, declaration, target, &names, &mut conditions)
                    .is_none()
                {
                    return self.error();
                }
            }
        }
        if self.sort_conditions(&mut task, conditions).is_none() {
            return self.error();
        }
        for definition in initial {
            for target in &definition.targets {
                if task.reals.iter().all(|r| r.name.text != target.name.text) {
                    let name = &target.name.text;
                    let (message, help) = match task.members.iter().any(|m| m.name.text == *name) {
                        true => (
                            format!("`{name}` has no start value: all of its values are tried"),
                            "leave it out",
                        ),
                        false => (
                            format!("`{name}` is no variable of this optimisation"),
                            "a start value is `x = …` for a variable `x`",
                        ),
                    };
                    return self.report(Diagnostic::error(target.name.span, message).help(help));
                }
            }
        }
        self.optimum_of(&task, *kind, &names)
    }

    fn optimum_of(&mut self, task: &Task<'a>, kind: OptimiseKind, names: &[&'a Name]) -> ExprId {
        let value_only = matches!(kind, OptimiseKind::Min | OptimiseKind::Max);
        if let ([member], []) = (task.members.as_slice(), task.reals.as_slice()) {
            return self
                .best_member(task, member, value_only)
                .unwrap_or_else(|| self.error());
        }
        let Some(best) = self.search(task, 0, &mut Vec::new()) else {
            return self.error();
        };
        let Type::Tuple(types) = self.ty(best).clone() else {
            return self.error();
        };
        if value_only {
            return self.project(best, 0, types[0].clone());
        }
        // members come first in the tuple; the values are given in the order of the text
        let all: Vec<&Name> = task
            .members
            .iter()
            .map(|m| m.name)
            .chain(task.reals.iter().map(|r| r.name))
            .collect();
        let values: Vec<ExprId> = names
            .iter()
            .filter_map(|name| all.iter().position(|n| n.text == name.text))
            .map(|k| self.project(best, k + 1, types[k + 1].clone()))
            .collect();
        match values.as_slice() {
            [value] => *value,
            _ => {
                let types = values.iter().map(|v| self.ty(*v).clone()).collect();
                self.add(Kind::Tuple(values), Type::Tuple(types))
            }
        }
    }

    /// The least or greatest value for the members of one set, or the member that it belongs to.
    fn best_member(
        &mut self,
        task: &Task<'a>,
        member: &Member<'a>,
        value_only: bool,
    ) -> Option<ExprId> {
        let (variable, range, scope) = self.bind_member(member)?;
        let (condition, body) = self.with_scope(scope, |checker| {
            let condition = checker.all_hold(&member.conditions);
            (condition, checker.objective(task.objective))
        });
        let mut body = body?;
        let mut ty = self.ty(body).clone();
        let op = match (value_only, task.greatest) {
            (true, false) => Fold::Min,
            (true, true) => Fold::Max,
            (false, false) => Fold::ArgMin,
            (false, true) => Fold::ArgMax,
        };
        if !value_only {
            let mut value = self.program.arena.variable(variable);
            if member.is_real {
                value = self.real(value);
            }
            let own = self.ty(value).clone();
            body = self.add(
                Kind::Tuple(vec![body, value]),
                Type::Tuple(vec![ty, own.clone()]),
            );
            ty = own;
        }
        Some(self.add_at(
            task.e.span,
            Kind::Fold {
                op,
                variable,
                range,
                condition,
                body,
            },
            ty,
        ))
    }

    /// The best of what can be tried from a level on: a tuple of the value of the objective and of the variables.
    fn search(
        &mut self,
        task: &Task<'a>,
        level: usize,
        values: &mut Vec<ExprId>,
    ) -> Option<ExprId> {
        let Some(member) = task.members.get(level) else {
            return self.innermost(task, values);
        };
        let (variable, range, scope) = self.bind_member(member)?;
        let value = self.program.arena.variable(variable);
        let value = if member.is_real {
            self.real(value)
        } else {
            value
        };
        values.push(value);
        let (condition, inner) = self.with_scope(scope, |checker| {
            let mut condition = checker.all_hold(&member.conditions);
            if level + 1 < task.members.len() {
                let exists = checker.exists(task, level + 1)?;
                condition = Some(checker.both(condition, exists));
            }
            Some((condition, checker.search(task, level + 1, values)?))
        })?;
        values.pop();
        let ty = self.ty(inner).clone();
        let Type::Tuple(types) = &ty else {
            return None;
        };
        let key = self.project(inner, 0, types[0].clone());
        let body = self.add(
            Kind::Tuple(vec![key, inner]),
            Type::Tuple(vec![types[0].clone(), ty.clone()]),
        );
        let op = if task.greatest {
            Fold::ArgMax
        } else {
            Fold::ArgMin
        };
        Some(self.add_at(
            task.e.span,
            Kind::Fold {
                op,
                variable,
                range,
                condition,
                body,
            },
            ty,
        ))
    }

    /// Whether there is anything to try from a level on.
    fn exists(&mut self, task: &Task<'a>, level: usize) -> Option<ExprId> {
        let member = &task.members[level];
        let (variable, range, scope) = self.bind_member(member)?;
        let condition = self.with_scope(scope, |checker| {
            let condition = checker.all_hold(&member.conditions);
            match level + 1 < task.members.len() {
                true => {
                    let exists = checker.exists(task, level + 1)?;
                    Some(Some(checker.both(condition, exists)))
                }
                false => Some(condition),
            }
        })?;
        let body = self.program.arena.integer(1);
        let fold = Kind::Fold {
            op: Fold::Sum,
            variable,
            range,
            condition,
            body,
        };
        let (count, zero) = (
            self.add_at(task.e.span, fold, Type::INTEGER),
            self.program.arena.integer(0),
        );
        Some(self.add(
            Kind::Compare(CompareOp::Greater, count, zero),
            Type::Boolean,
        ))
    }

    fn both(&mut self, a: Option<ExprId>, b: ExprId) -> ExprId {
        match a {
            Some(a) => self.add(Kind::And(a, b), Type::Boolean),
            None => b,
        }
    }

    fn all_hold(&mut self, conditions: &[&'a Condition]) -> Option<ExprId> {
        let mut all = None;
        for condition in conditions {
            let condition = self.condition(condition);
            all = Some(self.both(all, condition));
        }
        all
    }

    fn bind_member(&mut self, member: &Member<'a>) -> Option<(VariableId, Range, Scope<'a>)> {
        let mut scope = Scope::default();
        let (variable, range) = match &member.over {
            Over::Set(set) => {
                let (variable, set, bound) =
                    self.bind_members(std::slice::from_ref(member.name), set)?;
                scope = bound;
                (variable, Range::Set(set))
            }
            Over::Declared(declaration, set) => {
                let declared = self.declared_by_set(declaration, set);
                if declared.ty.is_error() {
                    return None;
                }
                (
                    self.bind(&mut scope, member.name, declared.ty),
                    Range::Set(declared.within?),
                )
            }
            Over::Integers(lower, upper) => {
                let from = self.bound(lower, Binary::Max)?;
                let to = self.bound(upper, Binary::Min)?;
                (
                    self.bind(&mut scope, member.name, Type::INTEGER),
                    Range::Integers(from, to),
                )
            }
        };
        if member.is_real && !self.program.arena.variable_type(variable).is_scalar() {
            let found = self.program.arena.variable_type(variable).described();
            let message = format!(
                "`{}` is a number, but a member of this set is {found}",
                member.name.text
            );
            self.report(
                Diagnostic::error(member.name.span, message)
                    .help("declare it with the type of the members"),
            );
            return None;
        }
        if member.is_real {
            let value = self.program.arena.variable(variable);
            let value = self.real(value);
            scope
                .names
                .insert(member.name.text.clone(), Binding::Value(value));
        }
        Some((variable, range, scope))
    }

    /// The tightest of several bounds of an integer.
    fn bound(&mut self, bounds: &[(&'a Expr, i64)], op: Binary) -> Option<ExprId> {
        let mut tightest = None;
        for (syntax, add) in bounds {
            let mut value = self.expr(syntax);
            let ty = self.ty(value).clone();
            if ty.is_error() {
                return None;
            }
            if ty != Type::INTEGER {
                let found = ty.described();
                let message = format!("the bounds of an integer are integers, not {found}");
                let diagnostic = Diagnostic::error(syntax.span, message)
                    .here(format!("this is {found}"))
                    .help("integers are tried one by one, from the lower bound to the upper one");
                let diagnostic = self.with_origins(diagnostic, &[syntax]);
                self.report(diagnostic);
                return None;
            }
            if *add != 0 {
                let add = self.program.arena.integer(*add);
                value = self.add_at(
                    syntax.span,
                    Kind::Binary(Binary::Add, value, add),
                    Type::INTEGER,
                );
            }
            tightest = Some(match tightest {
                Some(other) => self.add(Kind::Binary(op, other, value), Type::INTEGER),
                None => value,
            });
        }
        tightest
    }

    /// The objective for values of all members: over the real variables, if there are any.
    fn innermost(&mut self, task: &Task<'a>, values: &[ExprId]) -> Option<ExprId> {
        let best = match task.reals.is_empty() {
            true => vec![self.objective(task.objective)?],
            false => {
                let optimum = self.real_optimum(task)?;
                let Type::Tuple(types) = self.ty(optimum).clone() else {
                    return None;
                };
                if values.is_empty() {
                    return Some(optimum);
                }
                (0..types.len())
                    .map(|k| self.project(optimum, k, types[k].clone()))
                    .collect()
            }
        };
        let all: Vec<ExprId> = best[..1]
            .iter()
            .chain(values)
            .chain(&best[1..])
            .copied()
            .collect();
        let types = all.iter().map(|v| self.ty(*v).clone()).collect();
        Some(self.add(Kind::Tuple(all), Type::Tuple(types)))
    }

    /// The objective: a number.
    pub(super) fn objective(&mut self, syntax: &'a Expr) -> Option<ExprId> {
        let value = self.expr(syntax);
        let ty = self.ty(value).clone();
        match ty {
            Type::Error => None,
            Type::Scalar(_) => Some(value),
            _ => {
                let found = ty.described();
                let help = match ty.shape() {
                    Some(_) => "only numbers have an order; `‖u‖²` is a number",
                    None => "only numbers have an order",
                };
                let diagnostic = Diagnostic::error(
                    syntax.span,
                    format!("what is optimised is a number, not {found}"),
                )
                .here(format!("this is {found}"))
                .help(help);
                let diagnostic = self.with_origins(diagnostic, &[syntax]);
                self.report(diagnostic);
                None
            }
        }
    }
}
