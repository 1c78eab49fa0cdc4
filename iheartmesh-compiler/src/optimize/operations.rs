//! How many operations on real numbers stand in the code of a method.

use std::collections::BTreeSet;

use super::StagedProgram;
use crate::ir::{Arena, Binary, ExprId, Kind, Unary};
use crate::span::Span;
use crate::types::Shape;

/// With more operations than this a method takes rustc long.
const MANY: usize = 10_000;

/// The operations of an expression: each once, however often its value is used or a loop runs.
pub fn operations(arena: &Arena, e: ExprId) -> usize {
    let mut seen = BTreeSet::new();
    let mut open = vec![e];
    let mut sum = 0;
    while let Some(e) = open.pop() {
        if !seen.insert(e) {
            continue;
        }
        let kind = arena.kind(e);
        let counts = !arena.ty(e).is_integer()
            && match kind {
                Kind::Binary(op, ..) => *op != Binary::Append && *op != Binary::Unstack,
                Kind::Unary(op, _) => !matches!(op, Unary::Reshape | Unary::Stack | Unary::ToReal),
                _ => false,
            };
        if counts {
            sum += match arena.ty(e).shape() {
                Some(Shape::Vector(n)) => n.value().unwrap_or(1),
                Some(Shape::Matrix(n, m)) => n.value().unwrap_or(1) * m.value().unwrap_or(1),
                _ => 1,
            } as usize;
        }
        kind.operands(|operand| open.push(operand));
    }
    sum
}

/// The methods with very many operations: their names, where they are defined, and how many.
pub fn many(staged: &StagedProgram) -> Vec<(String, Span, usize)> {
    let program = &staged.program;
    // what is asked together is said once
    let named = staged
        .globals
        .iter()
        .filter(|(id, _)| program.pass(**id).is_none());
    let globals = named.map(|(id, code)| {
        let global = program.global(*id);
        (&global.name, global.span, code.body)
    });
    let functions = staged.functions.iter().map(|(id, code)| {
        let function = program.function(*id);
        (&function.name, function.span, code.body)
    });
    let all = globals.chain(functions).map(|(name, span, body)| {
        let n = operations(&program.arena, body);
        (name.clone(), span, n)
    });
    all.filter(|(_, _, n)| *n > MANY).collect()
}
