//! Values of functions of one element are computed once for all elements, where a whole field needs them often.
//!
//! ```text
//! H_all: … N(f₁) … for each neighbour  ⟶  N for all faces first, then … N[f₁] …
//! ```
//!
//! Fires for functions of one element whose loops over members of sets call other functions of one element. Whether
//! it pays is decided when the sizes are known: there must be more rows than elements.

use std::collections::{BTreeSet, HashMap};

use super::inline::is_field;
use super::{Rows, StagedProgram, Whole, rewrite};
use crate::ir::{ExprId, FunctionId, Kind};

/// Finds the fields of every function of one element.
pub fn run(staged: &mut StagedProgram) {
    let ids: Vec<FunctionId> = staged.functions.keys().copied().collect();
    for id in ids {
        if staged.program.function(id).parameters.len() != 1 {
            continue;
        }
        let body = staged.functions[&id].body;
        let has_rows = staged.functions[&id]
            .plan
            .spaces
            .iter()
            .any(|s| matches!(s.rows, Rows::Members(_)));
        if !has_rows {
            continue;
        }
        let mut fields = BTreeSet::new();
        super::reachable(&staged.program.arena, body, &mut |kind| {
            if let Kind::Call(callee, _) = kind {
                fields.insert(*callee);
            }
        });
        fields.retain(|callee| *callee != id && is_candidate(staged, *callee));
        if fields.is_empty() {
            continue;
        }
        let body = read(staged, body, &fields);
        let fields = fields.into_iter().collect();
        if let Some(function) = staged.functions.get_mut(&id) {
            function.whole = Some(Whole {
                body,
                fields,
                orbit: None,
            });
        }
    }
}

fn is_candidate(staged: &StagedProgram, id: FunctionId) -> bool {
    let function = staged.program.function(id);
    !staged.static_functions[id.0 as usize] && !function.recursive && is_field(&staged.program, id)
}

/// Calls of these functions become reads of their fields.
fn read(staged: &mut StagedProgram, body: ExprId, fields: &BTreeSet<FunctionId>) -> ExprId {
    let mut memo = HashMap::new();
    rewrite::upward(
        &mut staged.program.arena,
        body,
        &mut memo,
        &mut |arena, e| match arena.kind(e).clone() {
            Kind::Call(id, arguments) if fields.contains(&id) => {
                let ty = arena.ty(e).clone();
                arena.add(Kind::Field(id, arguments[0]), ty)
            }
            _ => e,
        },
    )
}
