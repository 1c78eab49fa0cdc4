//! Neighbours of an element are found without the sets in between.
//!
//! ```text
//! (B¹ᵀ{i} ∩ B¹ᵀ{j})₁                                       ⟶  the edge between i and j
//! (B¹ { e for e ∈ B²{f} if ∂²_e,f ∂¹_v,e = s } ∖ {v})₁     ⟶  the vertex after or before v in the face f
//! { f for f ∈ B²ᵀ{e} if ∂²_e,f ∂¹_v,e = s }₁               ⟶  the face on one side of e, seen from v
//! (B²ᵀ{e} ∖ { f for f ∈ B²ᵀ{e} if ∂²_e,f ∂¹_v,e = s })₁    ⟶  the face on the other side
//! ```
//!
//! Each side is the least element of the same set on every mesh; where the set is empty both fail, with the same reason. The runtime
//! has tables for them, made once per mesh. Signs and factors may stand in either order.

use std::collections::HashMap;

use super::rewrite;
use crate::ir::{
    Arena, Binary, Boundary, CompareOp, ExprId, Fold, FunctionId, Kind, Neighbor, Program, Range,
    SetOp,
};
use crate::types::MeshId;

pub fn run(program: &mut Program) {
    let traversals = program
        .function_ids()
        .filter_map(|id| Some((id, Traversal::of(program, id)?)))
        .collect();
    let pass = Pass { traversals };
    rewrite::program(program, |arena, e| {
        let Some((neighbor, a, b)) = pass.neighbor(arena, e) else {
            return e;
        };
        let ty = arena.ty(e).clone();
        let done = arena.add(Kind::Neighbor(neighbor, a, b), ty);
        if let Some(span) = arena.origin(e) {
            arena.note_origin(done, span);
        }
        done
    });
}

/// What a function of one parameter is, where it is a traversal and nothing else.
#[derive(Clone, Copy)]
enum Traversal {
    /// Of the set that consists of its parameter.
    OfElement(Boundary),
    /// Of the set that its parameter is.
    OfSet(Boundary),
}

impl Traversal {
    fn of(program: &Program, id: FunctionId) -> Option<Self> {
        let function = program.function(id);
        let [parameter] = function.parameters.as_slice() else {
            return None;
        };
        let arena = &program.arena;
        let Kind::Traverse(boundary, set) = *arena.kind(function.body) else {
            return None;
        };
        let is_parameter = |e| *arena.kind(e) == Kind::Variable(parameter.variable);
        match single(arena, set) {
            Some(item) if is_parameter(item) => Some(Self::OfElement(boundary)),
            None if is_parameter(set) => Some(Self::OfSet(boundary)),
            _ => None,
        }
    }
}

struct Pass {
    traversals: HashMap<FunctionId, Traversal>,
}

/// `{ f for f ∈ B²ᵀ{e} if ∂²_e,f ∂¹_v,e = s }`, or `{ e for e ∈ B²{f} if … }` with the same condition.
struct OfSign {
    range: Boundary,
    /// Whose column the range is.
    of: ExprId,
    vertex: ExprId,
    sign: i8,
}

impl Pass {
    /// What the first member of a set is.
    fn neighbor(&self, arena: &Arena, e: ExprId) -> Option<(Neighbor, ExprId, ExprId)> {
        let Kind::SetItem(set, index) = *arena.kind(e) else {
            return None;
        };
        if *arena.kind(index) != Kind::Integer(1) {
            return None;
        }
        match *arena.kind(set) {
            Kind::SetOp(SetOp::Intersection, a, b) => {
                let (mesh, a) = self.column(arena, a, (1, true))?;
                let (other, b) = self.column(arena, b, (1, true))?;
                (mesh == other).then_some((Neighbor::EdgeBetween(mesh), a, b))
            }
            Kind::SetOp(SetOp::Difference, all, left_out) => {
                if let Some(vertex) = single(arena, left_out) {
                    let (ends, edges) = self.traversal(arena, all)?;
                    let of_sign = self.of_sign(arena, edges)?;
                    let is_in_face = shape(ends) == (1, false)
                        && shape(of_sign.range) == (2, false)
                        && ends.mesh == of_sign.range.mesh
                        && of_sign.vertex == vertex;
                    let neighbor = Neighbor::VertexInFace(ends.mesh, of_sign.sign);
                    return is_in_face.then_some((neighbor, of_sign.of, vertex));
                }
                let (mesh, edge) = self.column(arena, all, (2, true))?;
                let of_sign = self.of_sign(arena, left_out)?;
                let is_same = shape(of_sign.range) == (2, true)
                    && of_sign.range.mesh == mesh
                    && of_sign.of == edge;
                let neighbor = Neighbor::FaceWithout(mesh, of_sign.sign);
                is_same.then_some((neighbor, edge, of_sign.vertex))
            }
            _ => {
                let of_sign = self.of_sign(arena, set)?;
                let neighbor = Neighbor::FaceWith(of_sign.range.mesh, of_sign.sign);
                (shape(of_sign.range) == (2, true)).then_some((
                    neighbor,
                    of_sign.of,
                    of_sign.vertex,
                ))
            }
        }
    }

    /// The boundary matrix and the set that it is applied to.
    fn traversal(&self, arena: &Arena, set: ExprId) -> Option<(Boundary, ExprId)> {
        match arena.kind(set) {
            Kind::Traverse(boundary, of) => Some((*boundary, *of)),
            Kind::Call(id, arguments) => match (self.traversals.get(id)?, arguments.as_slice()) {
                (Traversal::OfSet(boundary), [argument]) => Some((*boundary, *argument)),
                _ => None,
            },
            _ => None,
        }
    }

    /// The boundary matrix and the element whose column in it a set is.
    fn any_column(&self, arena: &Arena, set: ExprId) -> Option<(Boundary, ExprId)> {
        if let Kind::Call(id, arguments) = arena.kind(set)
            && let (Some(Traversal::OfElement(boundary)), [argument]) =
                (self.traversals.get(id), arguments.as_slice())
        {
            return Some((*boundary, *argument));
        }
        let (boundary, of) = self.traversal(arena, set)?;
        Some((boundary, single(arena, of)?))
    }

    /// The mesh and the element, for the boundary matrix of this dimension, transposed or not.
    fn column(&self, arena: &Arena, set: ExprId, wanted: (u8, bool)) -> Option<(MeshId, ExprId)> {
        let (boundary, item) = self.any_column(arena, set)?;
        (shape(boundary) == wanted).then_some((boundary.mesh, item))
    }

    fn of_sign(&self, arena: &Arena, set: ExprId) -> Option<OfSign> {
        let Kind::Fold {
            op: Fold::Collect,
            variable,
            range: Range::Set(range),
            condition: Some(condition),
            body,
        } = *arena.kind(set)
        else {
            return None;
        };
        if *arena.kind(body) != Kind::Variable(variable) {
            return None;
        }
        let (boundary, of) = self.any_column(arena, range)?;
        let Kind::Compare(CompareOp::Equal, a, b) = *arena.kind(condition) else {
            return None;
        };
        let (product, sign) = match (arena.kind(a), arena.kind(b)) {
            (_, Kind::Integer(sign)) => (a, *sign),
            (Kind::Integer(sign), _) => (b, *sign),
            _ => return None,
        };
        let Kind::Binary(Binary::Multiply, first, second) = *arena.kind(product) else {
            return None;
        };
        let entries = [first, second].map(|factor| entry(arena, factor));
        let [Some(first), Some(second)] = entries else {
            return None;
        };
        let (of_face, of_edge) = match (first.0.dimension, second.0.dimension) {
            (2, 1) => (first, second),
            (1, 2) => (second, first),
            _ => return None,
        };
        let ((of_face, edge, face), (of_edge, vertex, same_edge)) = (of_face, of_edge);
        let member = body;
        let is_condition = match boundary.transposed {
            true => face == member && edge == of,
            false => edge == member && face == of,
        };
        let is_of_sign = is_condition
            && boundary.dimension == 2
            && edge == same_edge
            && [of_face, of_edge].iter().all(|b| b.mesh == boundary.mesh)
            && !arena.depends_on(vertex, variable)
            && matches!(sign, -1 | 1);
        is_of_sign.then_some(OfSign {
            range: boundary,
            of,
            vertex,
            sign: sign as i8,
        })
    }
}

fn shape(boundary: Boundary) -> (u8, bool) {
    (boundary.dimension, boundary.transposed)
}

/// The member of a set that is written with one.
fn single(arena: &Arena, set: ExprId) -> Option<ExprId> {
    match arena.kind(set) {
        Kind::Set(items) => match items.as_slice() {
            [item] => Some(*item),
            _ => None,
        },
        _ => None,
    }
}

/// A boundary matrix with signs, and the row and column of an entry of it as if it were not transposed.
fn entry(arena: &Arena, e: ExprId) -> Option<(Boundary, ExprId, ExprId)> {
    match *arena.kind(e) {
        Kind::Entry(boundary, row, column) if boundary.signed => Some(match boundary.transposed {
            true => (boundary, column, row),
            false => (boundary, row, column),
        }),
        _ => None,
    }
}
