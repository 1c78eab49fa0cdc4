//! Sums of numbers and small vectors over the same range become one sum of a vector.
//!
//! ```text
//! (∑_(f ∈ R) a(f)) / (∑_(g ∈ R) b(g))   ⟶   s₁/s₂   where s = ∑_(f ∈ R) (a(f), b(f))
//! ```
//!
//! Each entry adds up what it did before in the same order, so its value is the same bit for bit; the terms share their work
//! and the rows that they read. The derivatives of a term with sums in it, as of a one-ring, are made of dozens of
//! such sums. Fires in definitions for the whole mesh, among sums that are evaluated whenever any of them is, but not over all
//! elements of a kind, which are cut in pieces for several threads; a sum that another one's terms need comes before it.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::rewrite;
use crate::ir::{Arena, ExprId, Fold, Kind, Program, Range, VariableId};
use crate::types::Type;

/// The most sums that become one: a vector of this length still fits in the first level of a cache, many times.
const MOST: usize = 64;
/// The longest vector that becomes a part of a longer one.
const MOST_OF_ONE: usize = 4;

/// Unites the sums of each definition.
pub fn run(program: &mut Program) {
    for global in &mut program.globals {
        while let Some(value) = united(&mut program.arena, global.value) {
            global.value = value;
        }
    }
}

/// The definition with some sums made one; nothing when there are none left.
fn united(arena: &mut Arena, value: ExprId) -> Option<ExprId> {
    let mut places = vec![value];
    let mut seen = BTreeSet::new();
    while let Some(place) = places.pop() {
        if !seen.insert(place) {
            continue;
        }
        let mut sums = BTreeSet::new();
        together(arena, place, &mut BTreeSet::new(), &mut sums, &mut places);
        if let Some(group) = group(arena, sums) {
            let parts = one(arena, &group);
            return Some(rewrite::upward(
                arena,
                value,
                &mut HashMap::new(),
                &mut |_, e| parts.get(&e).copied().unwrap_or(e),
            ));
        }
    }
    None
}

/// The sums that are evaluated whenever an expression is, outside of other binders, and the expressions that may not be.
fn together(
    arena: &Arena,
    e: ExprId,
    seen: &mut BTreeSet<ExprId>,
    sums: &mut BTreeSet<ExprId>,
    others: &mut Vec<ExprId>,
) {
    if !seen.insert(e) {
        return;
    }
    let mut inside = |e| together(arena, e, seen, sums, others);
    match arena.kind(e) {
        Kind::If(condition, first, second) => {
            inside(*condition);
            others.extend([*first, *second]);
        }
        Kind::And(first, second) | Kind::Or(first, second) => {
            inside(*first);
            others.push(*second);
        }
        Kind::Fold {
            op,
            range,
            condition,
            ..
        } => {
            let outside: Vec<ExprId> = match *range {
                Range::Set(set) => vec![set],
                Range::Integers(from, to) => vec![from, to],
                Range::Rows { .. } => Vec::new(),
            };
            for e in &outside {
                inside(*e);
            }
            let is_sum = *op == Fold::Sum && matches!(range, Range::Set(_));
            if is_sum && condition.is_none() && length(arena, e).is_some() {
                sums.insert(e);
            }
            arena.kind(e).operands(|operand| {
                if !outside.contains(&operand) {
                    others.push(operand);
                }
            });
        }
        Kind::Tabulate { .. }
        | Kind::Scatter { .. }
        | Kind::Optimum { .. }
        | Kind::Integral { .. } => arena.kind(e).operands(|operand| others.push(operand)),
        kind => kind.operands(inside),
    }
}

/// The number of entries of what may become a part of a vector.
fn length(arena: &Arena, e: ExprId) -> Option<usize> {
    let ty = arena.ty(e);
    match *ty == Type::REAL {
        true => Some(1),
        false => Some(ty.fixed_vector()? as usize).filter(|n| *n <= MOST_OF_ONE),
    }
}

/// Sums over one range that know the same variables, none of which needs another one.
fn group(arena: &Arena, sums: BTreeSet<ExprId>) -> Option<Vec<ExprId>> {
    let mut groups: BTreeMap<(ExprId, &[VariableId]), Vec<ExprId>> = BTreeMap::new();
    for sum in sums {
        if let Kind::Fold {
            range: Range::Set(set),
            ..
        } = arena.kind(sum)
            && !matches!(arena.kind(*set), Kind::AllElements(_))
        {
            let key = (*set, &*arena.node(sum).free);
            groups.entry(key).or_default().push(sum);
        }
    }
    groups.into_values().find_map(|group| {
        // an operand comes before what it is an operand of, so that the first sum needs no other one
        let members: BTreeSet<ExprId> = group.iter().copied().collect();
        let mut needs = HashMap::new();
        let is_free = |sum: &ExprId, needs: &mut HashMap<ExprId, bool>| {
            let mut free = true;
            arena
                .kind(*sum)
                .operands(|operand| free &= !needs_any(arena, operand, &members, needs));
            free
        };
        let mut entries = 0;
        let free: Vec<ExprId> = group
            .into_iter()
            .filter(|sum| is_free(sum, &mut needs))
            .take_while(|sum| {
                entries += length(arena, *sum).unwrap_or_default();
                entries <= MOST
            })
            .collect();
        (free.len() > 1).then_some(free)
    })
}

/// Whether one of several expressions is part of another.
fn needs_any(
    arena: &Arena,
    e: ExprId,
    members: &BTreeSet<ExprId>,
    memo: &mut HashMap<ExprId, bool>,
) -> bool {
    if let Some(&done) = memo.get(&e) {
        return done;
    }
    let mut needs = members.contains(&e);
    arena
        .kind(e)
        .operands(|operand| needs = needs || needs_any(arena, operand, members, memo));
    memo.insert(e, needs);
    needs
}

/// What takes the place of each sum: a part of the one sum.
fn one(arena: &mut Arena, sums: &[ExprId]) -> HashMap<ExprId, ExprId> {
    let mut kind = arena.kind(sums[0]).clone();
    let Kind::Fold { variable, body, .. } = &mut kind else {
        return HashMap::new();
    };
    let value = arena.variable(*variable);
    let terms = sums.iter().filter_map(|sum| match *arena.kind(*sum) {
        Kind::Fold { variable, body, .. } => Some((variable, body)),
        _ => None,
    });
    let terms: Vec<(VariableId, ExprId)> = terms.collect();
    let terms = terms.into_iter().map(|(variable, body)| {
        let named = HashMap::from([(variable, value)]);
        rewrite::put(arena, body, &named, &mut HashMap::new())
    });
    let terms: Vec<ExprId> = terms.collect();
    let mut all = Vec::new();
    for term in terms {
        match length(arena, term) {
            Some(n) if *arena.ty(term) != Type::REAL => {
                all.extend((1..=n).map(|k| entry(arena, term, k)));
            }
            _ => all.push(term),
        }
    }
    let ty = Type::vector(all.len() as i64);
    *body = arena.add(Kind::Vector(all), ty.clone());
    let all = arena.add(kind, ty);
    if let Some(span) = arena.origin(sums[0]) {
        arena.note_origin(all, span);
    }
    let mut parts = HashMap::new();
    let mut first = 1;
    for sum in sums {
        let n = length(arena, *sum).unwrap_or(1);
        let entries: Vec<ExprId> = (first..first + n).map(|k| entry(arena, all, k)).collect();
        first += n;
        let ty = arena.ty(*sum).clone();
        let part = match ty == Type::REAL {
            true => entries[0],
            false => arena.add(Kind::Vector(entries), ty),
        };
        parts.insert(*sum, part);
    }
    parts
}

fn entry(arena: &mut Arena, vector: ExprId, k: usize) -> ExprId {
    let k = arena.integer(k as i64);
    arena.add(Kind::Component(vector, k), Type::REAL)
}
