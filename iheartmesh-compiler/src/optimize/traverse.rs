//! Products of boundary matrices and indicators become traversals.
//!
//! ```text
//! nonzeros(indicator(S))        ⟶  S
//! nonzeros(B indicator-like x)  ⟶  traverse B nonzeros(x)
//! ```
//!
//! Sound where no entries of the product can cancel: the matrix is unsigned and the chain has no negative entries. A
//! signed product is left alone. Cost O(columns touched) instead of a sparse product with its accumulation.

use super::rewrite;
use crate::ir::{Arena, ExprId, Kind, Program};

/// Rewrites all products of a program.
pub fn run(program: &mut Program) {
    rewrite::program(program, |arena, e| match arena.kind(e).clone() {
        Kind::NonZeros(chain) => support(arena, chain).unwrap_or(e),
        _ => e,
    });
}

/// The elements where a chain without negative entries is not 0; `None` for other chains.
fn support(arena: &mut Arena, chain: ExprId) -> Option<ExprId> {
    match arena.kind(chain).clone() {
        Kind::Indicator(set) => Some(set),
        Kind::Apply(boundary, inner) if !boundary.signed => {
            let set = support(arena, inner)?;
            let space = match arena.ty(chain) {
                crate::types::Type::Vector { space, .. } => (*space)?,
                _ => return None,
            };
            let ty = crate::types::Type::set_of(crate::types::Type::Element(space));
            Some(arena.add(Kind::Traverse(boundary, set), ty))
        }
        _ => None,
    }
}
