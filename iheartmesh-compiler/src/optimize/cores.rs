//! The cores of blocks are dropped where nothing asks for them: they are there to see that a block is positive
//! semi-definite, and only replacing its eigenvalues asks for that.

use std::collections::HashMap;

use crate::ir::{Arena, Binary, ExprId, Fold, Kind, Program, Unary};

/// Drops what is not needed in all of a program.
pub fn run(program: &mut Program) {
    let mut memo = HashMap::new();
    for k in 0..program.globals.len() {
        let value = program.globals[k].value;
        program.globals[k].value = kept(&mut program.arena, value, false, &mut memo);
    }
    for k in 0..program.functions.len() {
        let body = program.functions[k].body;
        program.functions[k].body = kept(&mut program.arena, body, false, &mut memo);
    }
}

/// An expression without the cores that nothing asks for; `asked` says that its eigenvalues are replaced.
fn kept(
    arena: &mut Arena,
    e: ExprId,
    asked: bool,
    memo: &mut HashMap<(ExprId, bool), ExprId>,
) -> ExprId {
    if let Some(&done) = memo.get(&(e, asked)) {
        return done;
    }
    let mut kind = arena.kind(e).clone();
    if let (Kind::Assemble { blocks, .. }, false) = (&mut kind, asked) {
        for block in blocks {
            block.core = None;
        }
    }
    let mapped = match kind {
        Kind::Unary(op @ (Unary::PositivePart | Unary::AbsolutePart), a) => {
            Kind::Unary(op, kept(arena, a, true, memo))
        }
        Kind::Binary(op @ (Binary::Add | Binary::Multiply), a, b) => {
            let (a, b) = (kept(arena, a, asked, memo), kept(arena, b, asked, memo));
            Kind::Binary(op, a, b)
        }
        Kind::If(condition, a, b) => {
            let condition = kept(arena, condition, false, memo);
            let (a, b) = (kept(arena, a, asked, memo), kept(arena, b, asked, memo));
            Kind::If(condition, a, b)
        }
        Kind::Fold { op, body, .. } if asked && op == Fold::Sum => {
            let mut of = |operand| kept(arena, operand, operand == body, memo);
            kind.map_operands(&mut of)
        }
        kind => kind.map_operands(|operand| kept(arena, operand, false, memo)),
    };
    let done = match mapped == *arena.kind(e) {
        true => e,
        false => {
            let ty = arena.ty(e).clone();
            let done = arena.add(mapped, ty);
            if let Some(span) = arena.origin(e) {
                arena.note_origin(done, span);
            }
            done
        }
    };
    memo.insert((e, asked), done);
    done
}
