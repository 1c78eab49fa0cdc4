//! Values of functions of one element that a sum needs are computed once for each element around the key.
//!
//! ```text
//! H(i): for each neighbour: … N(f₁) … N(f₂) …  ⟶  N of each face around i first, then … N[slot 1] … N[slot 2] …
//! ```
//!
//! Two neighbours share a face, so that half of the calls fall away; and the rows of the function's own plan are copied
//! next to each other, so that they are read in one go. Fires for calls that every row of a sum makes, of functions
//! whose body reads nothing but a row of its plan.

use std::collections::BTreeSet;

use super::{Local, Plan, Rows, StagedProgram};
use crate::ir::{Arena, ExprId, FunctionId, Kind, Range, VariableId};
use crate::types::Type;

/// Finds the local values of every function of one element.
pub fn run(staged: &mut StagedProgram) {
    let ids: Vec<FunctionId> = staged.functions.keys().copied().collect();
    for id in ids {
        let found = find(staged, id);
        if let Some(function) = staged.functions.get_mut(&id) {
            function.plan.locals = found;
        }
    }
}

fn find(staged: &StagedProgram, id: FunctionId) -> Vec<Local> {
    let arena = &staged.program.arena;
    let function = &staged.functions[&id];
    let [key] = staged.program.function(id).parameters.as_slice() else {
        return Vec::new();
    };
    let mut sums = Vec::new();
    loops(arena, function.body, &mut sums);
    let mut locals: Vec<Local> = Vec::new();
    for (space, term) in sums {
        let plan = &function.plan;
        let is_innermost = plan.below(Some(space)).next().is_none();
        let is_below_key = plan
            .space(space)
            .is_some_and(|s| s.parent == Some(key.variable) && s.rows.is_several());
        if !is_innermost || !is_below_key {
            continue;
        }
        let mut calls = Vec::new();
        unconditional(arena, term, &mut BTreeSet::new(), &mut calls);
        calls.sort_unstable();
        for call in calls {
            let Kind::Call(callee, arguments) = arena.kind(call) else {
                continue;
            };
            let [argument] = arguments.as_slice() else {
                continue;
            };
            let Kind::Column(of, column) = *arena.kind(*argument) else {
                continue;
            };
            if of != space || *callee == id || !is_read_from_row(staged, *callee) {
                continue;
            }
            let known = locals
                .iter_mut()
                .find(|l| l.space == space && l.function == *callee);
            match known {
                Some(local) => local.calls.push((call, column)),
                None => locals.push(Local {
                    space,
                    function: *callee,
                    calls: vec![(call, column)],
                }),
            }
        }
    }
    locals
}

/// The loops over rows in a body with their terms; without a condition, which might keep a row from being used.
fn loops(arena: &Arena, body: ExprId, found: &mut Vec<(VariableId, ExprId)>) {
    super::reachable(arena, body, &mut |kind| {
        if let Kind::Fold {
            variable,
            range: Range::Rows { .. },
            condition: None,
            body,
            ..
        } = kind
        {
            found.push((*variable, *body));
        }
    });
}

/// Calls that are always made.
fn unconditional(arena: &Arena, e: ExprId, seen: &mut BTreeSet<ExprId>, calls: &mut Vec<ExprId>) {
    if !seen.insert(e) {
        return;
    }
    match arena.kind(e) {
        Kind::Call(..) => calls.push(e),
        Kind::Fold { .. }
        | Kind::Tabulate { .. }
        | Kind::Optimum { .. }
        | Kind::Integral { .. } => {}
        Kind::If(condition, ..) => unconditional(arena, *condition, seen, calls),
        Kind::And(a, _) | Kind::Or(a, _) => unconditional(arena, *a, seen, calls),
        kind => kind.operands(|operand| unconditional(arena, operand, seen, calls)),
    }
}

/// Whether a function reads nothing about its element but the row of its plan.
pub fn is_read_from_row(staged: &StagedProgram, id: FunctionId) -> bool {
    let function = staged.program.function(id);
    let [parameter] = function.parameters.as_slice() else {
        return false;
    };
    let Some(stages) = staged.functions.get(&id) else {
        return false;
    };
    let Plan { spaces, .. } = &stages.plan;
    let has_row = matches!(spaces.as_slice(), [space] if matches!(space.rows, Rows::Key(_)) && !space.columns.is_empty());
    let is_number = matches!(function.ty, Type::Scalar(_)) || function.ty.fixed_vector().is_some();
    let mut is_plain = true;
    super::reachable(&staged.program.arena, stages.body, &mut |kind| {
        is_plain &= match kind {
            Kind::Variable(v) => *v != parameter.variable,
            Kind::Fold { .. } | Kind::Optimum { .. } | Kind::Integral { .. } => false,
            _ => true,
        };
    });
    has_row && is_number && is_plain && !function.recursive
}
