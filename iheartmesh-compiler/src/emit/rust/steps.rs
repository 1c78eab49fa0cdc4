//! Steps between elements for which the runtime has something faster than sets, with the same values.
//!
//! Lists two steps away are in tables of the mesh: the vertices of a face, the faces around a vertex, a vertex with its
//! neighbours. The first member of an intersection is found without the intersection. What `optimize::steps` found is a call.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::block::Body;
use crate::ir::{Boundary, ExprId, Kind, Neighbor, SetOp, VariableId};
use crate::types::Type;

impl Body<'_> {
    /// What two boundary matrices, one after the other, connect to an element, where the mesh has a list of it.
    pub(super) fn two_steps(&mut self, e: ExprId) -> Option<TokenStream> {
        if !self.takes_steps() {
            return None;
        }
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

    /// The mesh, where a set is that of the faces around a vertex.
    pub(super) fn faces_around(&self, set: ExprId, vertex: VariableId) -> Option<TokenStream> {
        let (set, vertex) = match self.kind(set) {
            // of a function that is nothing else
            Kind::Call(id, arguments) => {
                let function = self.context.program().function(*id);
                let is_of_vertex = arguments.as_slice() == [self.variable_expr(vertex)];
                match function.parameters.as_slice() {
                    [parameter] if is_of_vertex => (function.body, parameter.variable),
                    _ => return None,
                }
            }
            _ => (set, vertex),
        };
        let Kind::Traverse(outer, edges) = *self.kind(set) else {
            return None;
        };
        let (inner, of) = self.single_column(edges)?;
        let shape = |b: Boundary| (b.dimension, b.transposed);
        let is_around = self.takes_steps()
            && (shape(inner), shape(outer)) == ((1, true), (2, true))
            && *self.kind(of) == Kind::Variable(vertex);
        is_around.then(|| {
            let mesh = self.context.mesh_field(outer.mesh);
            quote!(#mesh)
        })
    }

    /// The vertices of the edges at a vertex.
    pub(super) fn closed_ring(&mut self, outer: Boundary, set: ExprId) -> Option<TokenStream> {
        if !self.takes_steps() {
            return None;
        }
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

    /// The first member of an intersection, which is found without the set.
    pub(super) fn step_to_item(
        &mut self,
        e: ExprId,
        set: ExprId,
        index: ExprId,
    ) -> Option<TokenStream> {
        let is_first = *self.kind(index) == Kind::Integer(1);
        if !self.takes_steps() || !is_first || self.names.contains_key(&set) {
            return None;
        }
        match *self.kind(set) {
            Kind::SetOp(SetOp::Intersection, a, b) if self.ty(set).element_of_set().is_some() => {
                let site = self.context.site(e);
                let (a, b) = (self.ids(a), self.ids(b));
                Some(quote!(rt::first_common(#a, #b, #site)?))
            }
            _ => None,
        }
    }

    /// An element beside two others.
    pub(super) fn neighbor(
        &mut self,
        e: ExprId,
        neighbor: Neighbor,
        a: ExprId,
        b: ExprId,
    ) -> TokenStream {
        let site = self.context.site(e);
        let (a, b) = (self.owned(a), self.owned(b));
        let sign = Literal::i8_unsuffixed;
        match neighbor {
            Neighbor::EdgeBetween(mesh) => {
                let mesh = self.context.mesh_field(mesh);
                quote!(rt::edge_between(t.#mesh.complex(), #a, #b, #site)?)
            }
            Neighbor::VertexInFace(mesh, s) => {
                let (mesh, sign) = (self.context.mesh_field(mesh), sign(s));
                quote!(rt::beside_in_face(t.#mesh, #a, #b, #sign, #site)?)
            }
            Neighbor::FaceWith(mesh, s) => {
                let (mesh, sign) = (self.context.mesh_field(mesh), sign(s));
                quote!(rt::face_beside(t.#mesh.complex(), #a, #b, #sign, false, #site)?)
            }
            Neighbor::FaceWithout(mesh, s) => {
                let (mesh, sign) = (self.context.mesh_field(mesh), sign(s));
                quote!(rt::face_beside(t.#mesh.complex(), #a, #b, #sign, true, #site)?)
            }
        }
    }

    /// Whether the pass of this name is on.
    fn takes_steps(&self) -> bool {
        self.context.staged.optimizations.steps
    }

    /// The head of a loop over a column of a boundary matrix in which its entries are used: they stand beside it.
    pub(super) fn column_with_signs(
        &mut self,
        variable: VariableId,
        set: ExprId,
    ) -> Option<TokenStream> {
        if !self.takes_steps() {
            return None;
        }
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
