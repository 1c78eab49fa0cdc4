//! Terms of a sum that share their elements are computed together and scattered.
//!
//! The rows of a plan often come in groups: the three corners of a triangle `(v; j, k)`, `(j; k, v)`, `(k; v, j)`, the
//! two ends of an edge with its faces `(i; j, f, g)`, `(j; i, g, f)`. The term of one row is that of another with
//! its elements exchanged, and in the common form of expressions ([`super::share`]) the terms of a group share most of
//! their work: edge lengths, or everything.
//!
//! ```text
//! for all v: ∑ over rows of v: g(v, j, k)  ⟶  for all groups: g(a, b, c), g(b, c, a), g(c, a, b) added to a, b, c
//! ```
//!
//! Fires for a sum over the rows of a function of one element whose terms depend only on the elements of the row, when
//! an exchange is found that saves enough. Which rows form groups is found when the plan is made; rows that belong
//! to no group are evaluated on their own.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::{Orbit, StagedProgram, Whole, rewrite, share, triangles};
use crate::ir::{Arena, ExprId, Fold, FunctionId, Kind, Range, Unary, VariableId};
use crate::types::Type;

/// The cost of a group must be below this part of the cost of its terms.
const LARGEST_PART: f64 = 0.85;
/// A term with less work than this is not worth it.
const LEAST_COST: u32 = 8;
/// Rows with more elements than this are not looked at.
const MOST_ELEMENTS: usize = 6;

/// Finds an orbit for every function of one element.
pub fn run(staged: &mut StagedProgram) {
    let ids: Vec<FunctionId> = staged.functions.keys().copied().collect();
    for id in ids {
        if staged.program.function(id).parameters.len() != 1 {
            continue;
        }
        let (body, fields) = match &staged.functions[&id].whole {
            Some(whole) => (whole.body, whole.fields.clone()),
            None => (staged.functions[&id].body, Vec::new()),
        };
        let Some(orbit) = find(staged, id, body) else {
            continue;
        };
        if let Some(function) = staged.functions.get_mut(&id) {
            function.whole = Some(Whole {
                body,
                fields,
                orbit: Some(orbit),
            });
        }
    }
}

fn find(staged: &mut StagedProgram, id: FunctionId, body: ExprId) -> Option<Orbit> {
    let key = staged.program.function(id).parameters[0].variable;
    let mut sums = Vec::new();
    unconditional(&staged.program.arena, body, &mut BTreeSet::new(), &mut sums);
    let mut best: Option<(u32, Orbit)> = None;
    for sum in sums {
        if let Some((saved, orbit)) = orbit(staged, id, key, body, sum)
            && best.as_ref().is_none_or(|(s, _)| *s < saved)
        {
            best = Some((saved, orbit));
        }
    }
    best.map(|(_, orbit)| orbit)
}

/// Sums over rows that are always evaluated, outside of other loops.
fn unconditional(arena: &Arena, e: ExprId, seen: &mut BTreeSet<ExprId>, sums: &mut Vec<ExprId>) {
    if !seen.insert(e) {
        return;
    }
    match arena.kind(e) {
        Kind::Fold {
            op: Fold::Sum,
            range: Range::Rows { .. },
            condition: None,
            ..
        } => sums.push(e),
        Kind::Fold { .. }
        | Kind::Tabulate { .. }
        | Kind::Optimum { .. }
        | Kind::Integral { .. } => {}
        Kind::If(condition, ..) => unconditional(arena, *condition, seen, sums),
        Kind::And(a, _) | Kind::Or(a, _) => unconditional(arena, *a, seen, sums),
        kind => kind.operands(|operand| unconditional(arena, operand, seen, sums)),
    }
}

fn orbit(
    staged: &mut StagedProgram,
    id: FunctionId,
    key: VariableId,
    body: ExprId,
    sum: ExprId,
) -> Option<(u32, Orbit)> {
    let Kind::Fold {
        variable: space,
        body: term,
        ..
    } = *staged.program.arena.kind(sum)
    else {
        return None;
    };
    let plan = &staged.functions[&id].plan;
    let rows = plan.space(space)?;
    // few rows, if any, are left in a space whose rows are turned
    if plan.corners.iter().any(|c| c.of == space) {
        return None;
    }
    if rows.parent != Some(key) || !rows.rows.is_several() {
        return None;
    }
    let arena = &mut staged.program.arena;
    // sums of integers are checked as they are formed
    if *arena.ty(sum) == Type::INTEGER {
        return None;
    }
    let columns = element_columns(arena, term, key, space)?;
    if columns.is_empty() || columns.len() + 1 > MOST_ELEMENTS {
        return None;
    }
    // stand-ins for the elements of a row
    let types: Vec<Type> = [arena.variable_type(key).clone()]
        .into_iter()
        .chain(
            columns
                .iter()
                .map(|c| rows.columns[*c as usize].value)
                .map(|e| arena.ty(e).clone()),
        )
        .collect();
    let elements: Vec<VariableId> = types
        .iter()
        .map(|ty| arena.new_variable("element", ty.clone()))
        .collect();
    let values: Vec<ExprId> = elements.iter().map(|v| arena.variable(*v)).collect();
    let stand_in = |arena: &mut Arena| {
        rewrite::upward(
            arena,
            term,
            &mut HashMap::new(),
            &mut |arena, e| match arena.kind(e) {
                Kind::Variable(v) if *v == key => values[0],
                Kind::Column(_, k) => match columns.iter().position(|c| c == k) {
                    Some(position) => values[position + 1],
                    None => e,
                },
                _ => e,
            },
        )
    };
    let raw = stand_in(arena);
    let single = share::expression(arena, raw);
    let single_cost = cost(arena, &[single]);
    if single_cost < LEAST_COST {
        return None;
    }
    let mut best: Option<(u32, usize, Vec<usize>, Vec<ExprId>)> = None;
    let is_turned = staged.functions[&id]
        .plan
        .corners
        .iter()
        .any(|c| c.space == space);
    for (permutation, order) in permutations(&types) {
        // the corners of a triangle go around
        if is_turned && permutation[..3] != [1, 2, 0] {
            continue;
        }
        let mut terms = vec![single];
        let mut power = permutation.clone();
        for _ in 1..order {
            let exchange: HashMap<VariableId, ExprId> = elements
                .iter()
                .zip(&power)
                .map(|(v, p)| (*v, values[*p]))
                .collect();
            let exchanged = rewrite::substitute(arena, single, &exchange);
            terms.push(share::expression(arena, exchanged));
            power = power.iter().map(|p| permutation[*p]).collect();
        }
        // the areas of triangles are shared where that saves something
        let areas: Vec<ExprId> = terms
            .iter()
            .map(|term| triangles::expression(arena, *term))
            .collect();
        if cost(arena, &areas) < cost(arena, &terms) {
            terms = areas;
        }
        let together = cost(arena, &terms);
        let apart = single_cost * order as u32;
        if f64::from(together) < LARGEST_PART * f64::from(apart) {
            // compared by what a group of six would cost, so that pairs and triples are compared fairly
            let per_term = together * 6 / order as u32;
            // of two that save the same, the one that leaves fewer elements in place is the one that meshes have
            let fixed = permutation
                .iter()
                .enumerate()
                .filter(|(k, p)| k == *p)
                .count();
            if best
                .as_ref()
                .is_none_or(|(b, f, ..)| (per_term, fixed) < (*b, *f))
            {
                best = Some((per_term, fixed, permutation, terms));
            }
        }
    }
    let (per_term, _, permutation, terms) = best?;
    let sum_type = arena.ty(sum).clone();
    let sum_variable = arena.new_variable("sum", sum_type);
    let sum_value = arena.variable(sum_variable);
    let rest = rewrite::upward(arena, body, &mut HashMap::new(), &mut |_, e| {
        if e == sum { sum_value } else { e }
    });
    let orbit = Orbit {
        space,
        sum,
        elements,
        columns,
        permutation,
        terms,
        rest,
        sum_variable,
    };
    Some((single_cost * 6 - per_term.min(single_cost * 6), orbit))
}

/// The columns that a term depends on; `None` when it depends on anything else that changes with the row or the key.
fn element_columns(
    arena: &Arena,
    term: ExprId,
    key: VariableId,
    space: VariableId,
) -> Option<Vec<u32>> {
    let mut columns = BTreeSet::new();
    let mut ok = true;
    // loops inside of the term would need their rows
    super::reachable(arena, term, &mut |kind| match kind {
        Kind::Column(v, k) if *v == space => {
            columns.insert(*k);
        }
        Kind::Column(..) | Kind::Fold { .. } | Kind::Global(_) => ok = false,
        Kind::Variable(v) => ok &= *v == key,
        _ => {}
    });
    let mut open = vec![term];
    let mut seen = BTreeSet::new();
    while let Some(e) = open.pop() {
        if seen.insert(e) {
            if matches!(arena.kind(e), Kind::Column(..)) {
                ok &= arena.ty(e).is_element();
            }
            arena.kind(e).operands(|operand| open.push(operand));
        }
    }
    ok.then(|| columns.into_iter().collect())
}

/// Exchanges of the elements of a row that keep their kinds, move the key, and come back after two or three steps.
fn permutations(types: &[Type]) -> Vec<(Vec<usize>, usize)> {
    let n = types.len();
    let mut found = Vec::new();
    let mut current: Vec<usize> = Vec::new();
    fn extend(
        types: &[Type],
        n: usize,
        current: &mut Vec<usize>,
        found: &mut Vec<(Vec<usize>, usize)>,
    ) {
        if current.len() == n {
            if let Some(order) = order(current)
                && current[0] != 0
            {
                found.push((current.clone(), order));
            }
            return;
        }
        for k in 0..n {
            if !current.contains(&k) && types[k] == types[current.len()] {
                current.push(k);
                extend(types, n, current, found);
                current.pop();
            }
        }
    }
    extend(types, n, &mut current, &mut found);
    found
}

/// 2 or 3, when doing it so often changes nothing and the key is somewhere else before.
fn order(permutation: &[usize]) -> Option<usize> {
    let mut power: Vec<usize> = permutation.to_vec();
    for order in 2..=3 {
        power = power.iter().map(|p| permutation[*p]).collect();
        if power.iter().enumerate().all(|(k, p)| k == *p) {
            return Some(order);
        }
        if power[0] == 0 {
            return None;
        }
    }
    None
}

/// What computing expressions together costs, roughly in multiples of an addition.
fn cost(arena: &Arena, roots: &[ExprId]) -> u32 {
    let mut seen: BTreeMap<ExprId, ()> = BTreeMap::new();
    let mut open = roots.to_vec();
    let mut cost = 0;
    while let Some(e) = open.pop() {
        if seen.insert(e, ()).is_some() {
            continue;
        }
        let width = arena.ty(e).fixed_vector().unwrap_or(1) as u32;
        cost += match arena.kind(e) {
            Kind::Unary(Unary::Negate | Unary::ToReal, _) => 0,
            Kind::Unary(Unary::Norm, _) => 20,
            Kind::Unary(Unary::SquareRoot, _) => 15,
            Kind::Unary(Unary::Apply(_), _) => 40,
            Kind::Binary(crate::ir::Binary::Dot, ..) => 5,
            Kind::Binary(crate::ir::Binary::Cross, ..) => 9,
            Kind::Binary(crate::ir::Binary::Divide, ..) => 10 + width,
            Kind::Binary(crate::ir::Binary::Atan2 | crate::ir::Binary::Power, ..) => 50,
            Kind::Binary(..) | Kind::Unary(..) => width,
            Kind::Call(..) => 100,
            Kind::Item(..) | Kind::Field(..) => 1,
            _ => 0,
        };
        arena.kind(e).operands(|operand| open.push(operand));
    }
    cost
}
