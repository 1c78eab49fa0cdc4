//! Sparse sums of blocks inside of other expressions become definitions of their own: `A + ∑ psd(…)` where the pattern of
//! `A` depends on values, or `(∂²e/∂x² + a I)⁻¹ g`. The places of a definition's entries are found once per mesh, see
//! `emit::rust::slots`; those of a matrix inside of an expression are sorted each time.
//!
//! Such an expression has no variables, and what a definition is does not depend on where it is named.

use std::collections::HashMap;

use super::binding::Binding;
use crate::ir::{Arena, Binary, ExprId, Fold, Global, GlobalId, Kind, Program, Unary};
use crate::span::Span;

/// Names all such sums in definitions.
pub fn run(program: &mut Program) {
    let count = program.globals.len();
    let mut pass = Pass {
        count,
        patterns: Binding::of(program).globals,
        parts: Vec::new(),
        known: HashMap::new(),
    };
    for k in 0..count {
        let value = program.globals[k].value;
        match pass.is_sum(&program.arena, value) {
            true => pass.patterns[k] = true,
            false => program.globals[k].value = pass.inside(&mut program.arena, value),
        }
    }
    for value in pass.parts {
        program.globals.push(Global {
            name: "part".to_owned(),
            value,
            span: Span::default(),
        });
    }
}

struct Pass {
    /// The number of definitions before.
    count: usize,
    /// By definition: its pattern does not depend on values. It depends on the mesh alone, or is such a sum.
    patterns: Vec<bool>,
    parts: Vec<ExprId>,
    known: HashMap<ExprId, ExprId>,
}

impl Pass {
    /// An expression with the sums inside of it by their names.
    fn inside(&mut self, arena: &mut Arena, e: ExprId) -> ExprId {
        if let Some(&known) = self.known.get(&e) {
            return known;
        }
        let kind = arena.kind(e).clone();
        let ty = arena.ty(e).clone();
        let named = self.is_sum(arena, e);
        let mapped = match named {
            true => {
                self.parts.push(e);
                Kind::Global(GlobalId((self.count + self.parts.len() - 1) as u32))
            }
            false => kind
                .clone()
                .map_operands(|operand| self.inside(arena, operand)),
        };
        let done = match mapped == kind {
            true => e,
            false => {
                let done = arena.add(mapped, ty);
                if let Some(span) = arena.origin(e) {
                    arena.note_origin(done, span);
                }
                done
            }
        };
        self.known.insert(e, done);
        done
    }

    /// Whether an expression is a sparse sum of blocks without variables, beside which only definitions of known patterns and
    /// the identity stand.
    fn is_sum(&self, arena: &Arena, e: ExprId) -> bool {
        arena.ty(e).is_sparse()
            && arena.node(e).free.is_empty()
            && self.is_made_of_blocks(arena, e, false)
            && has_loop(arena, e)
    }

    fn is_made_of_blocks(&self, arena: &Arena, e: ExprId, is_inside: bool) -> bool {
        let of = |e: ExprId, is_inside| self.is_made_of_blocks(arena, e, is_inside);
        match *arena.kind(e) {
            Kind::Assemble { .. } => true,
            Kind::Global(id) => {
                let is_known = self.patterns.get(id.0 as usize);
                !is_inside && is_known.is_some_and(|is_known| *is_known)
            }
            Kind::Identity(_) => !is_inside,
            Kind::Binary(Binary::Add | Binary::Subtract, a, b) => {
                of(a, is_inside) && of(b, is_inside)
            }
            Kind::If(_, a, b) => of(a, true) && of(b, true),
            Kind::Binary(Binary::Multiply, _, a)
            | Kind::Binary(Binary::Divide, a, _)
            | Kind::Unary(Unary::Negate, a) => of(a, is_inside),
            Kind::Unary(Unary::PositivePart | Unary::AbsolutePart, a) => is_inside && of(a, true),
            Kind::Fold {
                op: Fold::Sum,
                body,
                ..
            } => of(body, true),
            _ => false,
        }
    }
}

/// Whether a sum has many terms.
fn has_loop(arena: &Arena, e: ExprId) -> bool {
    match *arena.kind(e) {
        Kind::Fold { .. } => true,
        Kind::Binary(Binary::Add | Binary::Subtract, a, b) | Kind::If(_, a, b) => {
            has_loop(arena, a) || has_loop(arena, b)
        }
        Kind::Binary(Binary::Multiply, _, a)
        | Kind::Binary(Binary::Divide, a, _)
        | Kind::Unary(Unary::Negate, a) => has_loop(arena, a),
        _ => false,
    }
}
