//! Rows that name the corners of a triangle are turned so that the key comes first.
//!
//! ```text
//! ∑ over rows of v: g(a, b, c)
//!     ⟶  ∑ over rows of v with v among a, b, c: g(v, j, k)  +  ∑ over the other rows: g(a, b, c)
//! ```
//!
//! `a(f) = ½ (x_j - x_i) × (x_k - x_i) where i, j, k = OrientedVertices(f)` is the same from whichever corner it is computed.
//! From the key it needs one value less, which the rows of a key then share, and the rows of a face become an orbit
//! ([`super::orbits`]). Fires for sums over rows whose terms stay the same, up to rounding, when three columns are exchanged
//! in a circle. Which rows hold their key is found when the plan is made; all others stay as they are.
//!
//! Further columns fall away where they are what stands in the circle: `NextVertexAroundFace(f, v)` beside
//! `OrientedVertices(f)`, which is the next vertex around `f` from another one. Rows in which they differ stay as they
//! are, too.

use std::collections::{BTreeSet, HashMap};

use super::{Column, Corners, Plan, Rows, Space, StagedProgram, rewrite, share, triangles};
use crate::ir::{Arena, Binary, ExprId, Fold, Kind, Program, Range, VariableId};
use crate::types::Type;

/// Rows with more columns of the kind of the key than this are not looked at.
const MOST_COLUMNS: usize = 8;

/// Turns the rows of all functions and definitions.
pub fn run(staged: &mut StagedProgram) {
    let share = staged.optimizations.share;
    let bodies = staged.functions.values_mut();
    for code in bodies.chain(staged.globals.values_mut()) {
        code.body = body(&mut staged.program, &mut code.plan, code.body, share);
    }
}

fn body(program: &mut Program, plan: &mut Plan, body: ExprId, share: bool) -> ExprId {
    let mut sums = BTreeSet::new();
    loops(&program.arena, body, &mut BTreeSet::new(), &mut sums);
    let mut turned = HashMap::new();
    for sum in sums {
        if let Some(split) = split(program, plan, sum, share) {
            turned.insert(sum, split);
        }
    }
    if turned.is_empty() {
        return body;
    }
    rewrite::upward(
        &mut program.arena,
        body,
        &mut HashMap::new(),
        &mut |_, e| turned.get(&e).copied().unwrap_or(e),
    )
}

/// Sums of real numbers and vectors over rows.
fn loops(arena: &Arena, e: ExprId, seen: &mut BTreeSet<ExprId>, sums: &mut BTreeSet<ExprId>) {
    if !seen.insert(e) {
        return;
    }
    let ty = arena.ty(e);
    if let Kind::Fold {
        op: Fold::Sum,
        range: Range::Rows { .. },
        condition: None,
        ..
    } = arena.kind(e)
        && (*ty == Type::REAL || ty.fixed_vector().is_some())
    {
        sums.insert(e);
    }
    arena
        .kind(e)
        .operands(|operand| loops(arena, operand, seen, sums));
}

/// The sum in two parts.
fn split(program: &mut Program, plan: &mut Plan, sum: ExprId, share: bool) -> Option<ExprId> {
    let Kind::Fold {
        variable,
        body: term,
        ..
    } = *program.arena.kind(sum)
    else {
        return None;
    };
    let space = plan.space(variable)?.clone();
    let key = space.parent?;
    let is_below_key = plan
        .space(key)
        .is_some_and(|s| matches!(s.rows, Rows::Key(_) | Rows::Universe(_)));
    let is_innermost = plan.below(Some(variable)).next().is_none();
    if !is_below_key || !is_innermost || !matches!(space.rows, Rows::Members(_)) {
        return None;
    }
    let used = columns(&program.arena, term, variable)?;
    let kind = program.arena.variable_type(key).clone();
    let corners: Vec<u32> = used
        .iter()
        .copied()
        .filter(|k| *program.arena.ty(space.columns[*k as usize].value) == kind)
        .collect();
    if corners.len() > MOST_COLUMNS {
        return None;
    }
    let circle = circle(&mut program.arena, term, variable, &corners)?;
    let (circle, merged) = merged(program, &space, key, circle, &corners);
    let kept: Vec<u32> = used
        .into_iter()
        .filter(|k| !circle.contains(k) && merged.iter().all(|(column, _)| column != k))
        .collect();

    let arena = &mut program.arena;
    let corner_type = arena.variable_type(variable).clone();
    let corner = arena.new_variable("corner", corner_type);
    let first = arena.variable(key);
    let place = |column: u32| match circle.iter().position(|k| *k == column) {
        Some(position) => Some(position as u32),
        None => merged.iter().find(|m| m.0 == column).map(|m| m.1),
    };
    let turned = rewrite::upward(arena, term, &mut HashMap::new(), &mut |arena, e| {
        let Kind::Column(of, k) = *arena.kind(e) else {
            return e;
        };
        if of != variable {
            return e;
        }
        let column = match place(k) {
            Some(0) => return first,
            Some(position) => position - 1,
            None => 2 + kept.iter().position(|other| *other == k).unwrap_or(0) as u32,
        };
        let ty = arena.ty(e).clone();
        let done = arena.add(Kind::Column(corner, column), ty);
        if let Some(span) = arena.origin(e) {
            arena.note_origin(done, span);
        }
        done
    });
    let turned = match share {
        true => share::expression(arena, turned),
        false => turned,
    };
    let ty = arena.ty(sum).clone();
    let part = arena.add(
        Kind::Fold {
            op: Fold::Sum,
            variable: corner,
            range: Range::Rows { of: Some(key) },
            condition: None,
            body: turned,
        },
        ty.clone(),
    );
    let column = |k: u32, may_fail| Column {
        value: space.columns[k as usize].value,
        may_fail,
    };
    plan.spaces.push(Space {
        variable: corner,
        parent: Some(key),
        rows: Rows::Corners(variable),
        // rows in which an element is missing are not turned
        columns: [circle[1], circle[2]]
            .map(|k| column(k, false))
            .into_iter()
            .chain(
                kept.iter()
                    .map(|k| column(*k, space.columns[*k as usize].may_fail)),
            )
            .collect(),
    });
    plan.corners.push(Corners {
        space: corner,
        of: variable,
        circle,
        merged,
        kept,
    });
    Some(arena.add(Kind::Binary(Binary::Add, part, sum), ty))
}

/// The columns that a term uses; `None` when there are loops in it.
fn columns(arena: &Arena, term: ExprId, space: VariableId) -> Option<Vec<u32>> {
    let mut columns = BTreeSet::new();
    let mut is_plain = true;
    super::reachable(arena, term, &mut |kind| match kind {
        Kind::Column(of, k) if *of == space => {
            columns.insert(*k);
        }
        // what binds a variable cannot stand in both parts
        Kind::Fold { .. }
        | Kind::Tabulate { .. }
        | Kind::Scatter { .. }
        | Kind::Optimum { .. }
        | Kind::Integral { .. } => is_plain = false,
        _ => {}
    });
    is_plain.then(|| columns.into_iter().collect())
}

/// Three columns whose exchange in a circle leaves a term as it is.
fn circle(arena: &mut Arena, term: ExprId, space: VariableId, columns: &[u32]) -> Option<[u32; 3]> {
    let mut common = None;
    for (k, &a) in columns.iter().enumerate() {
        for (l, &b) in columns.iter().enumerate().skip(k + 1) {
            for &c in &columns[l + 1..] {
                let common = *common.get_or_insert_with(|| triangles::expression(arena, term));
                let exchanged = rewrite::upward(
                    arena,
                    common,
                    &mut HashMap::new(),
                    &mut |arena, e| match *arena.kind(e) {
                        Kind::Column(of, k) if of == space => {
                            let next = match k {
                                _ if k == a => b,
                                _ if k == b => c,
                                _ if k == c => a,
                                _ => k,
                            };
                            let ty = arena.ty(e).clone();
                            arena.add(Kind::Column(of, next), ty)
                        }
                        _ => e,
                    },
                );
                if triangles::expression(arena, exchanged) == common {
                    return Some([a, b, c]);
                }
            }
        }
    }
    None
}

/// The circle, beginning and running so that the most other columns are what stands in it after the key, and these
/// columns with their places in the circle.
fn merged(
    program: &mut Program,
    space: &Space,
    key: VariableId,
    [a, b, c]: [u32; 3],
    columns: &[u32],
) -> ([u32; 3], Vec<(u32, u32)>) {
    let values: Vec<ExprId> = space
        .columns
        .iter()
        .map(|column| reduced(program, column.value))
        .collect();
    let key = program.arena.variable(key);
    let mut best = ([a, b, c], Vec::new());
    for circle in [
        [a, b, c],
        [b, c, a],
        [c, a, b],
        [a, c, b],
        [c, b, a],
        [b, a, c],
    ] {
        let first = values[circle[0] as usize];
        // what the others are when they are computed from the key
        let [second, third] = [circle[1], circle[2]].map(|k| {
            rewrite::upward(
                &mut program.arena,
                values[k as usize],
                &mut HashMap::new(),
                &mut |_, e| if e == first { key } else { e },
            )
        });
        let merged: Vec<(u32, u32)> = columns
            .iter()
            .filter(|k| !circle.contains(k))
            .filter_map(|k| match values[*k as usize] {
                value if value == second => Some((*k, 1)),
                value if value == third => Some((*k, 2)),
                _ => None,
            })
            .collect();
        if merged.len() > best.1.len() {
            best = (circle, merged);
        }
    }
    best
}

/// An expression in which items of the tuples that functions give are taken out of the functions' bodies.
fn reduced(program: &mut Program, e: ExprId) -> ExprId {
    let functions = program.functions.clone();
    let rule = &mut |arena: &mut Arena, e: ExprId| {
        let mut e = e;
        loop {
            let Kind::Project(tuple, k) = *arena.kind(e) else {
                return e;
            };
            e = match arena.kind(tuple).clone() {
                Kind::Tuple(items) => items[k as usize],
                Kind::Call(id, arguments) => {
                    let function = &functions[id.0 as usize];
                    let Kind::Tuple(items) = arena.kind(function.body).clone() else {
                        return e;
                    };
                    if function.recursive {
                        return e;
                    }
                    let parameters = function.parameters.iter().map(|p| p.variable);
                    let variables = parameters.zip(arguments).collect();
                    rewrite::substitute(arena, items[k as usize], &variables)
                }
                _ => return e,
            };
        }
    };
    rewrite::upward(&mut program.arena, e, &mut HashMap::new(), rule)
}
