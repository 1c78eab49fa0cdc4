//! Bound variables: each has one binder, so what is used again has new ones.

use std::collections::HashMap;

use super::normal::Normal;
use crate::ir::{ExprId, Fold, Kind, Range, VariableId};
use crate::optimize::rewrite;

impl Normal<'_> {
    /// The same loop with variables of its own.
    pub(super) fn rebound(&mut self, mut kind: Kind) -> Kind {
        match &mut kind {
            Kind::Fold {
                variable,
                condition,
                body,
                ..
            } => {
                let fresh = self.fresh(&mut [variable]);
                for part in condition.iter_mut().chain([body]) {
                    *part = rewrite::substitute(&mut self.program.arena, *part, &fresh);
                }
            }
            Kind::Tabulate {
                variables, body, ..
            } => {
                let mut list: Vec<&mut VariableId> = variables.iter_mut().collect();
                let fresh = self.fresh(&mut list);
                *body = rewrite::substitute(&mut self.program.arena, *body, &fresh);
            }
            Kind::Scatter {
                variable,
                place,
                body,
                ..
            } => {
                let fresh = self.fresh(&mut [variable]);
                for part in place.iter_mut().chain([body]) {
                    *part = rewrite::substitute(&mut self.program.arena, *part, &fresh);
                }
            }
            _ => {}
        }
        kind
    }

    /// New variables in place of bound ones, with the substitution.
    pub(super) fn fresh(
        &mut self,
        variables: &mut [&mut VariableId],
    ) -> HashMap<VariableId, ExprId> {
        let arena = &mut self.program.arena;
        let mut all = HashMap::new();
        for variable in variables {
            let name = arena.variable_name(**variable).to_owned();
            let ty = arena.variable_type(**variable).clone();
            let fresh = arena.new_variable(&name, ty);
            all.insert(**variable, arena.variable(fresh));
            **variable = fresh;
        }
        all
    }

    /// The sum of a value over a loop, with a variable of its own.
    pub(super) fn summed(
        &mut self,
        mut variable: VariableId,
        range: Range,
        condition: Option<ExprId>,
        value: ExprId,
    ) -> ExprId {
        if self.algebra().is_zero(value) {
            return value;
        }
        let all = self.fresh(&mut [&mut variable]);
        let arena = &mut self.program.arena;
        let body = rewrite::substitute(arena, value, &all);
        let condition = condition.map(|c| rewrite::substitute(arena, c, &all));
        let ty = arena.ty(value).clone();
        let kind = Kind::Fold {
            op: Fold::Sum,
            variable,
            range,
            condition,
            body,
        };
        arena.add(kind, ty)
    }
}
