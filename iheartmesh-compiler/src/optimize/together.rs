//! Sums over one range that are asked for at once become one sum of tuples.
//!
//! ```text
//! (∑_(f ∈ F) a(f), ∑_(g ∈ F) b(g))   ⟶   ∑_(f ∈ F) (a(f), b(f))
//! ```
//!
//! So a gradient and a Hessian share the rows that they read and what their terms have in common, with one another and with
//! their energy. Cases with one condition become one case of tuples:
//!
//! ```text
//! ((a if c, b otherwise), (a' if c, b' otherwise))   ⟶   (a, a') if c, (b, b') otherwise
//! ```
//!
//! The terms of each are added up in the order in which its own definition adds them, those of different loops loop by
//! loop. What has no loop in common with another one is left out, and evaluated by itself.

use std::collections::HashMap;

use super::{binders, rewrite};
use crate::ir::{Arena, Binary, ExprId, Fold, Global, GlobalId, Kind, Pass, Program, Unary};
use crate::types::Type;

/// Unites the loops of what is asked together; where there is nothing to unite, there is no pass.
pub fn run(program: &mut Program) {
    let passes: Vec<Option<Pass>> = program.together.iter_mut().map(|t| t.pass.take()).collect();
    let first = passes.iter().flatten().map(|pass| pass.global.0).min();
    // they are the last ones
    let old: Vec<Global> = match first {
        Some(first) => program.globals.split_off(first as usize),
        None => return,
    };
    let mut old = old.into_iter();
    for (k, pass) in passes.into_iter().enumerate() {
        let Some((pass, global)) = pass.and_then(|pass| Some((pass, old.next()?))) else {
            continue;
        };
        let Kind::Tuple(items) = program.arena.kind(global.value).clone() else {
            continue;
        };
        let Some((kept, value)) = united(&mut program.arena, &items) else {
            continue;
        };
        program.together[k].pass = Some(Pass {
            global: GlobalId(program.globals.len() as u32),
            members: kept.into_iter().map(|k| pass.members[k]).collect(),
        });
        program.globals.push(Global { value, ..global });
    }
}

/// A part of a sum: the body of a loop, or a term by itself.
struct Term {
    /// The loop that it stands in.
    fold: Option<ExprId>,
    value: ExprId,
}

/// What is the same for terms of one loop: the form of the loop without its body. Terms by themselves have none.
type Form = Option<ExprId>;

/// Parts of sums, each with the number of the sum.
type Parts = Vec<(usize, ExprId)>;

/// Which of the values are computed in one pass, and a tuple of its sums.
fn united(arena: &mut Arena, values: &[ExprId]) -> Option<(Vec<usize>, ExprId)> {
    let mut forms = binders::Binders::default();
    let mut all: Vec<(usize, Form, Term)> = Vec::new();
    for (k, value) in values.iter().enumerate() {
        let Some(terms) = terms(arena, *value) else {
            continue;
        };
        for term in terms {
            let range = term.fold.map(|fold| {
                let range = without_body(arena, fold);
                forms.form(arena, range)
            });
            all.push((k, range, term));
        }
    }
    let shares = |k: usize| {
        let mut own = all
            .iter()
            .filter(|(of, range, _)| *of == k && range.is_some());
        own.any(|(_, range, _)| all.iter().any(|(of, other, _)| *of != k && other == range))
    };
    let kept: Vec<usize> = (0..values.len()).filter(|k| shares(*k)).collect();
    // numbers alone are not worth a pass
    let is_array = |k: &usize| !arena.ty(values[*k]).is_scalar();
    if kept.len() < 2 || !kept.iter().any(is_array) {
        return None;
    }
    all.retain(|(k, ..)| kept.contains(k));
    let nothing: Vec<ExprId> = kept.iter().map(|k| zero(arena, values[*k])).collect();
    let mut ranges: Vec<Form> = Vec::new();
    for (_, range, _) in &all {
        if !ranges.contains(range) {
            ranges.push(*range);
        }
    }
    let place = |k: usize| kept.iter().position(|kept| *kept == k).unwrap_or(0);
    let sums: Vec<ExprId> = ranges
        .into_iter()
        .map(|range| {
            let own = all.iter().filter(|(_, of, _)| *of == range);
            let parts = own.map(|(k, _, term)| (place(*k), term));
            one(arena, &parts.collect::<Vec<_>>(), &nothing)
        })
        .collect();
    let ty = Type::Tuple(sums.iter().map(|sum| arena.ty(*sum).clone()).collect());
    Some((kept, arena.add(Kind::Tuple(sums), ty)))
}

/// A loop over the range of another, which does nothing.
fn without_body(arena: &mut Arena, fold: ExprId) -> ExprId {
    let mut kind = arena.kind(fold).clone();
    if let Kind::Fold { body, .. } = &mut kind {
        *body = arena.real(0.0);
    }
    arena.add(kind, Type::REAL)
}

/// Nothing to add to a value.
fn zero(arena: &mut Arena, value: ExprId) -> ExprId {
    let ty = arena.ty(value).clone();
    match sizes(arena, value) {
        Some(sizes) if !ty.is_scalar() => {
            let kind = Kind::Assemble {
                sizes,
                blocks: Vec::new(),
            };
            arena.add(kind, ty)
        }
        _ => arena.real(0.0),
    }
}

fn sizes(arena: &Arena, e: ExprId) -> Option<Vec<ExprId>> {
    match arena.kind(e) {
        Kind::Assemble { sizes, .. } => Some(sizes.clone()),
        Kind::Binary(Binary::Add | Binary::Subtract, a, b) | Kind::If(_, a, b) => {
            sizes(arena, *a).or_else(|| sizes(arena, *b))
        }
        Kind::Fold { body: a, .. }
        | Kind::Unary(Unary::PositivePart | Unary::AbsolutePart | Unary::Negate, a)
        | Kind::Binary(Binary::Divide, a, _)
        | Kind::Binary(Binary::Multiply, _, a) => sizes(arena, *a),
        _ => None,
    }
}

/// The parts of a sum. Of an array all must be blocks; of a number one must be a loop.
fn terms(arena: &mut Arena, value: ExprId) -> Option<Vec<Term>> {
    let mut all = Vec::new();
    let array = !arena.ty(value).is_scalar();
    collect(arena, value, &mut |_, term| term, &mut all);
    let fits = match array {
        true => all.iter().all(|term| is_of_blocks(arena, term.value)),
        false => all.iter().any(|term| term.fold.is_some()),
    };
    fits.then_some(all)
}

/// Collects the parts of a sum, each with what `scale` makes of it.
fn collect(
    arena: &mut Arena,
    e: ExprId,
    scale: &mut dyn FnMut(&mut Arena, ExprId) -> ExprId,
    all: &mut Vec<Term>,
) {
    let ty = arena.ty(e).clone();
    match arena.kind(e).clone() {
        Kind::Binary(Binary::Add, a, b) => {
            collect(arena, a, scale, all);
            collect(arena, b, scale, all);
        }
        Kind::Binary(Binary::Subtract, a, b) => {
            collect(arena, a, scale, all);
            let minus = arena.real(-1.0);
            let mut negated = |arena: &mut Arena, e| {
                let part = scaled(arena, Binary::Multiply, minus, e);
                scale(arena, part)
            };
            collect(arena, b, &mut negated, all);
        }
        Kind::Unary(Unary::Negate, a) if has_loop(arena, a) => {
            let minus = arena.real(-1.0);
            let mut negated = |arena: &mut Arena, e| {
                let part = scaled(arena, Binary::Multiply, minus, e);
                scale(arena, part)
            };
            collect(arena, a, &mut negated, all);
        }
        Kind::Binary(Binary::Multiply, k, a) if has_loop(arena, a) => {
            let mut multiplied = |arena: &mut Arena, e| {
                let part = scaled(arena, Binary::Multiply, k, e);
                scale(arena, part)
            };
            collect(arena, a, &mut multiplied, all);
        }
        Kind::Binary(Binary::Multiply, a, k) if ty.is_scalar() && has_loop(arena, a) => {
            let mut multiplied = |arena: &mut Arena, e| {
                let part = scaled(arena, Binary::Multiply, k, e);
                scale(arena, part)
            };
            collect(arena, a, &mut multiplied, all);
        }
        Kind::Binary(Binary::Divide, a, k) if has_loop(arena, a) => {
            let mut divided = |arena: &mut Arena, e| {
                let part = scaled(arena, Binary::Divide, k, e);
                scale(arena, part)
            };
            collect(arena, a, &mut divided, all);
        }
        Kind::Fold {
            op: Fold::Sum,
            body,
            ..
        } => {
            let value = scale(arena, body);
            all.push(Term {
                fold: Some(e),
                value,
            });
        }
        _ => {
            let value = scale(arena, e);
            all.push(Term { fold: None, value });
        }
    }
}

/// Whether a sum has a loop among its parts.
fn has_loop(arena: &Arena, e: ExprId) -> bool {
    match arena.kind(e) {
        Kind::Fold { op: Fold::Sum, .. } => true,
        Kind::Binary(Binary::Add | Binary::Subtract | Binary::Multiply, a, b) => {
            has_loop(arena, *a) || has_loop(arena, *b)
        }
        Kind::Unary(Unary::Negate, a) | Kind::Binary(Binary::Divide, a, _) => has_loop(arena, *a),
        _ => false,
    }
}

/// `k e` or `e/k`, inside of the cases of `e`.
fn scaled(arena: &mut Arena, op: Binary, k: ExprId, e: ExprId) -> ExprId {
    let ty = arena.ty(e).clone();
    match *arena.kind(e) {
        Kind::If(condition, a, b) => {
            let [a, b] = [a, b].map(|case| scaled(arena, op, k, case));
            arena.add(Kind::If(condition, a, b), ty)
        }
        _ if is_nothing(arena, e) => e,
        _ if op == Binary::Divide => arena.add(Kind::Binary(op, e, k), ty),
        _ => arena.add(Kind::Binary(op, k, e), ty),
    }
}

/// Whether an array is put together from blocks alone.
fn is_of_blocks(arena: &Arena, e: ExprId) -> bool {
    match arena.kind(e) {
        Kind::Assemble { .. } => true,
        Kind::Binary(Binary::Add | Binary::Subtract, a, b) | Kind::If(_, a, b) => {
            is_of_blocks(arena, *a) && is_of_blocks(arena, *b)
        }
        Kind::Fold {
            op: Fold::Sum,
            body: a,
            ..
        }
        | Kind::Unary(Unary::PositivePart | Unary::AbsolutePart | Unary::Negate, a)
        | Kind::Binary(Binary::Divide, a, _)
        | Kind::Binary(Binary::Multiply, _, a) => is_of_blocks(arena, *a),
        _ => false,
    }
}

fn is_nothing(arena: &Arena, e: ExprId) -> bool {
    match arena.kind(e) {
        Kind::Assemble { blocks, .. } => blocks.is_empty(),
        Kind::Real(bits) => f64::from_bits(*bits) == 0.0,
        _ => false,
    }
}

/// One loop of all terms with its range, or terms without a loop.
fn one(arena: &mut Arena, terms: &[(usize, &Term)], nothing: &[ExprId]) -> ExprId {
    let mut fold = terms[0].1.fold;
    let mut variable = None;
    if let Some(old) = fold {
        // with variables of its own: those of the definitions name the rows that they read
        let own = rewrite::substitute(arena, old, &HashMap::new());
        if let Kind::Fold { variable: own, .. } = arena.kind(own) {
            variable = Some(*own);
        }
        fold = Some(own);
    }
    let parts = terms.iter().map(|(k, term)| {
        let mut named = HashMap::new();
        if let (Some(own), Some(old)) = (variable, term.fold)
            && let Kind::Fold { variable: old, .. } = *arena.kind(old)
        {
            named.insert(old, arena.variable(own));
        }
        (*k, rewrite::substitute(arena, term.value, &named))
    });
    let parts: Parts = parts.collect();
    // equal loops inside of the terms become one first, so that equal conditions are seen
    let ty = Type::Tuple(parts.iter().map(|(_, e)| arena.ty(*e).clone()).collect());
    let values = parts.iter().map(|(_, e)| *e).collect();
    let values = arena.add(Kind::Tuple(values), ty);
    let values = binders::expression(arena, values);
    let parts = match arena.kind(values) {
        Kind::Tuple(values) => parts.iter().map(|(k, _)| *k).zip(values.clone()).collect(),
        _ => parts,
    };
    let body = joined(arena, parts, nothing);
    let Some(mut kind) = fold.map(|fold| arena.kind(fold).clone()) else {
        return body;
    };
    if let Kind::Fold { body: inside, .. } = &mut kind {
        *inside = body;
    }
    let ty = arena.ty(body).clone();
    let sum = arena.add(kind, ty);
    if let Some(span) = fold.and_then(|fold| arena.origin(fold)) {
        arena.note_origin(sum, span);
    }
    sum
}

/// The sum of parts of the items of a tuple, as one expression of the type of the tuple.
fn joined(arena: &mut Arena, parts: Parts, nothing: &[ExprId]) -> ExprId {
    let parts = apart(arena, parts);
    let mut rest = Vec::new();
    let mut cases: Vec<(ExprId, [Parts; 2])> = Vec::new();
    for (k, e) in parts {
        match case(arena, e) {
            Some((condition, branches)) => {
                let known = cases.iter().position(|(c, _)| *c == condition);
                let known = known.unwrap_or_else(|| {
                    cases.push((condition, [Vec::new(), Vec::new()]));
                    cases.len() - 1
                });
                for (all, branch) in cases[known].1.iter_mut().zip(branches) {
                    all.push((k, branch));
                }
            }
            None => rest.push((k, e)),
        }
    }
    let items = nothing.iter().enumerate().map(|(k, zero)| {
        let own = rest.iter().filter(|(of, _)| *of == k).map(|(_, e)| *e);
        let own: Vec<ExprId> = own.filter(|e| !is_nothing(arena, *e)).collect();
        let ty = arena.ty(*zero).clone();
        let mut own = own.into_iter();
        let first = own.next().unwrap_or(*zero);
        own.fold(first, |sum, e| {
            arena.add(Kind::Binary(Binary::Add, sum, e), ty.clone())
        })
    });
    let items: Vec<ExprId> = items.collect();
    let ty = Type::Tuple(nothing.iter().map(|e| arena.ty(*e).clone()).collect());
    let mut sum = None;
    if items != nothing || cases.is_empty() {
        sum = Some(arena.add(Kind::Tuple(items), ty.clone()));
    }
    for (condition, [then, otherwise]) in cases {
        let then = joined(arena, then, nothing);
        let otherwise = joined(arena, otherwise, nothing);
        let choice = arena.add(Kind::If(condition, then, otherwise), ty.clone());
        sum = Some(match sum {
            None => choice,
            Some(sum) => arena.add(Kind::Binary(Binary::Add, sum, choice), ty.clone()),
        });
    }
    sum.unwrap_or(nothing[0])
}

/// Sums with cases among their terms, term by term.
fn apart(arena: &Arena, parts: Parts) -> Parts {
    let mut all = Vec::new();
    for (k, e) in parts {
        let mut terms = Vec::new();
        let mut open = vec![e];
        while let Some(e) = open.pop() {
            match arena.kind(e) {
                Kind::Binary(Binary::Add, a, b) => open.extend([*b, *a]),
                _ => terms.push(e),
            }
        }
        match terms.iter().any(|e| is_case(arena, *e)) {
            true => all.extend(terms.into_iter().map(|e| (k, e))),
            false => all.push((k, e)),
        }
    }
    all
}

/// The condition of a term that is a choice, and the term in either case.
fn case(arena: &mut Arena, e: ExprId) -> Option<(ExprId, [ExprId; 2])> {
    let ty = arena.ty(e).clone();
    match *arena.kind(e) {
        Kind::If(condition, a, b) => Some((condition, [a, b])),
        Kind::Unary(op @ (Unary::PositivePart | Unary::AbsolutePart), a) => {
            let (condition, cases) = case(arena, a)?;
            let cases = cases.map(|case| match is_nothing(arena, case) {
                true => case,
                false => arena.add(Kind::Unary(op, case), ty.clone()),
            });
            Some((condition, cases))
        }
        Kind::Binary(Binary::Multiply, k, a) if !ty.is_scalar() => {
            let (condition, cases) = case(arena, a)?;
            Some((
                condition,
                cases.map(|case| scaled(arena, Binary::Multiply, k, case)),
            ))
        }
        _ => None,
    }
}

/// Whether a term is a choice.
fn is_case(arena: &Arena, e: ExprId) -> bool {
    match *arena.kind(e) {
        Kind::If(..) => true,
        Kind::Unary(Unary::PositivePart | Unary::AbsolutePart, a) => is_case(arena, a),
        Kind::Binary(Binary::Multiply, _, a) => !arena.ty(e).is_scalar() && is_case(arena, a),
        _ => false,
    }
}
