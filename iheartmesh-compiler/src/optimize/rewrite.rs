//! Rewriting of expressions from the operands upward.

use std::collections::HashMap;

use crate::ir::{Arena, ExprId, Kind, Program, VariableId};

/// Rewrites every definition and function of a program: `rule` sees each expression after its operands have been
/// rewritten, and gives what takes its place.
pub fn program(program: &mut Program, mut rule: impl FnMut(&mut Arena, ExprId) -> ExprId) {
    let mut memo = HashMap::new();
    for k in 0..program.globals.len() {
        let value = program.globals[k].value;
        program.globals[k].value = upward(&mut program.arena, value, &mut memo, &mut rule);
    }
    for k in 0..program.functions.len() {
        let body = program.functions[k].body;
        program.functions[k].body = upward(&mut program.arena, body, &mut memo, &mut rule);
    }
}

/// Rewrites one expression.
pub fn upward(
    arena: &mut Arena,
    e: ExprId,
    memo: &mut HashMap<ExprId, ExprId>,
    rule: &mut impl FnMut(&mut Arena, ExprId) -> ExprId,
) -> ExprId {
    if let Some(&done) = memo.get(&e) {
        return done;
    }
    let kind = arena.kind(e).clone();
    let mapped = kind.map_operands(|operand| upward(arena, operand, memo, rule));
    let rebuilt = if mapped == kind {
        e
    } else {
        let ty = arena.ty(e).clone();
        let rebuilt = arena.add(mapped, ty);
        if let Some(span) = arena.origin(e) {
            arena.note_origin(rebuilt, span);
        }
        rebuilt
    };
    let done = rule(arena, rebuilt);
    memo.insert(e, done);
    done
}

/// Replaces variables by expressions. Binders inside get new variables, so that each variable keeps one binder.
pub fn substitute(arena: &mut Arena, e: ExprId, variables: &HashMap<VariableId, ExprId>) -> ExprId {
    let mut substitution = Substitution {
        variables: variables.clone(),
        memo: HashMap::new(),
    };
    substitution.expr(arena, e)
}

struct Substitution {
    variables: HashMap<VariableId, ExprId>,
    memo: HashMap<ExprId, ExprId>,
}

impl Substitution {
    fn expr(&mut self, arena: &mut Arena, e: ExprId) -> ExprId {
        if let Some(&done) = self.memo.get(&e) {
            return done;
        }
        let kind = arena.kind(e).clone();
        let done = match &kind {
            Kind::Variable(v) => self.variables.get(v).copied().unwrap_or(e),
            _ => {
                let mapped = match kind.clone() {
                    Kind::Fold {
                        op,
                        variable,
                        range,
                        condition,
                        body,
                    } => {
                        let variable = self.fresh(arena, variable);
                        Kind::Fold {
                            op,
                            variable,
                            range,
                            condition,
                            body,
                        }
                    }
                    Kind::Tabulate {
                        layout,
                        variables,
                        sizes,
                        body,
                    } => {
                        let variables = variables
                            .into_iter()
                            .map(|v| self.fresh(arena, v))
                            .collect();
                        Kind::Tabulate {
                            layout,
                            variables,
                            sizes,
                            body,
                        }
                    }
                    Kind::Scatter {
                        variable,
                        set,
                        sizes,
                        place,
                        body,
                    } => Kind::Scatter {
                        variable: self.fresh(arena, variable),
                        set,
                        sizes,
                        place,
                        body,
                    },
                    Kind::Optimum {
                        greatest,
                        variables,
                        start,
                        restrictions,
                        objective,
                    } => {
                        let variables = variables
                            .into_iter()
                            .map(|v| self.fresh(arena, v))
                            .collect();
                        Kind::Optimum {
                            greatest,
                            variables,
                            start,
                            restrictions,
                            objective,
                        }
                    }
                    Kind::Integral {
                        variable,
                        from,
                        to,
                        body,
                    } => {
                        let variable = self.fresh(arena, variable);
                        Kind::Integral {
                            variable,
                            from,
                            to,
                            body,
                        }
                    }
                    other => other,
                };
                let mapped = mapped.map_operands(|operand| self.expr(arena, operand));
                let ty = arena.ty(e).clone();
                let done = arena.add(mapped, ty);
                if let Some(span) = arena.origin(e) {
                    arena.note_origin(done, span);
                }
                done
            }
        };
        self.memo.insert(e, done);
        done
    }

    /// A new variable in place of a bound one.
    fn fresh(&mut self, arena: &mut Arena, variable: VariableId) -> VariableId {
        let (name, ty) = (
            arena.variable_name(variable).to_owned(),
            arena.variable_type(variable).clone(),
        );
        let fresh = arena.new_variable(&name, ty);
        let value = arena.variable(fresh);
        self.variables.insert(variable, value);
        fresh
    }
}
