//! Steps between elements for which the runtime has something faster than sets, with the same values.
//!
//! Lists two steps away are in tables of the mesh: the vertices of a face, the faces around a vertex, a vertex with its
//! neighbours. The neighbour of a vertex along the edges of a face of one sign is found in the face itself, the first
//! member of an intersection without the intersection.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::block::Body;
use crate::ir::{Binary, Boundary, ExprId, Fold, Kind, Range, SetOp, VariableId};
use crate::syntax::ast::CompareOp;
use crate::types::{MeshId, Type};

impl Body<'_> {
    /// What two boundary matrices, one after the other, connect to an element, where the mesh has a list of it.
    pub(super) fn two_steps(&mut self, e: ExprId) -> Option<TokenStream> {
        let Kind::Traverse(outer, set) = *self.kind(e) else {
            return None;
        };
        let (inner, item) = self.unnamed_column(set)?;
        let shape = |b: Boundary| (b.dimension, b.transposed);
        let list = match (shape(inner), shape(outer)) {
            ((2, false), (1, false)) => quote!(rt::vertices_of_face),
            ((1, true), (2, true)) => quote!(rt::faces_of_vertex),
            _ => return None,
        };
        let (mesh, ..) = self.boundary(outer);
        let item = self.owned(item);
        Some(quote!(#list(#mesh, #item as usize)))
    }

    /// The vertices of the edges at a vertex.
    pub(super) fn closed_ring(&mut self, outer: Boundary, set: ExprId) -> Option<TokenStream> {
        let (inner, vertex) = self.unnamed_column(set)?;
        let is_ring = (inner.dimension, inner.transposed) == (1, true)
            && (outer.dimension, outer.transposed) == (1, false);
        if !is_ring {
            return None;
        }
        let (mesh, ..) = self.boundary(outer);
        let vertex = self.owned(vertex);
        Some(quote!(rt::closed_ring(#mesh, #vertex as usize)))
    }

    /// The boundary matrix and the element of a set that is a column of it, and has not been computed already.
    fn unnamed_column(&self, set: ExprId) -> Option<(Boundary, ExprId)> {
        match self.names.contains_key(&set) {
            true => None,
            false => self.single_column(set),
        }
    }

    /// An item of a set that is found without the set.
    pub(super) fn step_to_item(
        &mut self,
        e: ExprId,
        set: ExprId,
        index: ExprId,
    ) -> Option<TokenStream> {
        let is_first = *self.kind(index) == Kind::Integer(1);
        if !is_first || self.names.contains_key(&set) {
            return None;
        }
        let site = self.context.site(e);
        match *self.kind(set) {
            Kind::SetOp(SetOp::Intersection, a, b) if self.ty(set).element_of_set().is_some() => {
                let (a, b) = (self.ids(a), self.ids(b));
                Some(quote!(rt::first_common(#a, #b, #site)?))
            }
            Kind::SetOp(SetOp::Difference, ends, single) => {
                let vertex = self.singleton(single)?;
                let (mesh, face, sign) = self.edges_of_sign(self.ends_of(ends)?, vertex)?;
                let mesh = self.context.mesh_field(mesh);
                let (face, vertex) = (self.owned(face), self.owned(vertex));
                let sign = Literal::i64_unsuffixed(sign);
                Some(quote!(rt::beside_in_face(t.#mesh, #face, #vertex, #sign, #site)?))
            }
            _ => None,
        }
    }

    /// The set of edges whose vertices a set is.
    fn ends_of(&self, set: ExprId) -> Option<ExprId> {
        let is_ends = |b: &Boundary| b.dimension == 1 && !b.transposed;
        match self.kind(set) {
            Kind::Traverse(boundary, edges) => is_ends(boundary).then_some(*edges),
            // of a function that is nothing else
            Kind::Call(id, arguments) => {
                let function = self.context.program().function(*id);
                let Kind::Traverse(boundary, edges) = self.kind(function.body) else {
                    return None;
                };
                let ([parameter], [argument]) =
                    (function.parameters.as_slice(), arguments.as_slice())
                else {
                    return None;
                };
                let is_parameter = *self.kind(*edges) == Kind::Variable(parameter.variable);
                (is_ends(boundary) && is_parameter).then_some(*argument)
            }
            _ => None,
        }
    }

    /// The face f and the sign s of `{ e for e ∈ Edges(f) if ∂²_e,f ∂¹_v,e = s }`.
    fn edges_of_sign(&self, edges: ExprId, vertex: ExprId) -> Option<(MeshId, ExprId, i64)> {
        let Kind::Fold {
            op: Fold::Collect,
            variable,
            range: Range::Set(range),
            condition: Some(condition),
            body,
        } = *self.kind(edges)
        else {
            return None;
        };
        let (boundary, face) = self.single_column(range)?;
        let is_boundary = boundary.dimension == 2 && !boundary.transposed;
        if !is_boundary || *self.kind(body) != Kind::Variable(variable) {
            return None;
        }
        let Kind::Compare(CompareOp::Equal, product, sign) = *self.kind(condition) else {
            return None;
        };
        let (Kind::Binary(Binary::Multiply, a, b), Kind::Integer(sign @ (-1 | 1))) =
            (self.kind(product), self.kind(sign))
        else {
            return None;
        };
        let edge = self.variable_expr(variable);
        let is_signs = |of_face, of_vertex| {
            self.signed_entry(of_face) == Some((2, edge, face))
                && self.signed_entry(of_vertex) == Some((1, vertex, edge))
        };
        (is_signs(*a, *b) || is_signs(*b, *a)).then_some((boundary.mesh, face, *sign))
    }
    /// The dimension, row and column of an entry of a boundary matrix with signs.
    fn signed_entry(&self, e: ExprId) -> Option<(u8, ExprId, ExprId)> {
        match *self.kind(e) {
            Kind::Entry(boundary, row, column) if boundary.signed => {
                Some(match boundary.transposed {
                    true => (boundary.dimension, column, row),
                    false => (boundary.dimension, row, column),
                })
            }
            _ => None,
        }
    }

    /// The head of a loop over a column of a boundary matrix in which its entries are used: they stand beside it.
    pub(super) fn column_with_signs(
        &mut self,
        variable: VariableId,
        set: ExprId,
    ) -> Option<TokenStream> {
        let (boundary, item) = self.single_column(set)?;
        // where the set has a name, the item must be at hand too
        let is_at_hand =
            self.names.contains_key(&item) || matches!(self.kind(item), Kind::Variable(_));
        if self.names.contains_key(&set) && !is_at_hand {
            return None;
        }
        let member = self.variable_expr(variable);
        let (row, column) = match boundary.transposed {
            true => (item, member),
            false => (member, item),
        };
        let matrix = Boundary {
            signed: true,
            transposed: false,
            ..boundary
        };
        let arena = &self.context.program().arena;
        let entry = arena.find(&Kind::Entry(matrix, row, column), &Type::INTEGER)?;
        let (mesh, k, ..) = self.boundary(boundary);
        let (name, sign) = (
            self.variable_name(variable),
            format_ident!("sign{}", variable.0),
        );
        let item = self.owned(item);
        self.calls.insert(entry, quote!((#sign as i64)));
        let column = match boundary.transposed {
            true => quote!(coboundary_column),
            false => quote!(boundary_column),
        };
        Some(quote!(for (#name, #sign) in rt::with_signs(#mesh.#column(#k, #item as usize))))
    }
}
