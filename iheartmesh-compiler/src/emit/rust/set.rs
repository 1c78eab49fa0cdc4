//! Sets, chains and boundary matrices.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::block::Body;
use crate::ir::{Boundary, ExprId, Kind, SetOp};
use crate::types::{Element, Type};

impl Body<'_> {
    /// A set of elements as a sorted slice of `u32`.
    pub(super) fn ids(&mut self, e: ExprId) -> TokenStream {
        if self.names.contains_key(&e) {
            let reference = self.reference(e);
            return quote!(&(#reference)[..]);
        }
        match self.kind(e) {
            // a parameter or an input is a slice already
            Kind::Variable(v) => self.variable_name(*v),
            Kind::Input(id) => {
                let field = self.context.input_field(*id);
                quote!(&rt::ids_of_set(s.#field.as_ref())[..])
            }
            Kind::Global(id) => {
                let name = self.context.global_name(*id);
                match self.context.is_static_global(*id) {
                    true => quote!(&t.#name()?[..]),
                    false => quote!(&s.#name()?[..]),
                }
            }
            _ => {
                if let Some((boundary, item)) = self.single_column(e) {
                    return self.matrix_column(boundary, item);
                }
                if let Some(list) = self.two_steps(e) {
                    return list;
                }
                let value = self.value(e);
                quote!(&#value[..])
            }
        }
    }

    /// The boundary matrix and the element, where a set is what the matrix connects to this element.
    pub(super) fn single_column(&self, e: ExprId) -> Option<(Boundary, ExprId)> {
        let single = |set| self.singleton(set);
        match self.kind(e) {
            Kind::Traverse(boundary, set) => Some((*boundary, single(*set)?)),
            // of a function that is nothing else
            Kind::Call(id, arguments) => {
                let function = self.context.program().function(*id);
                let Kind::Traverse(boundary, set) = self.kind(function.body) else {
                    return None;
                };
                let ([parameter], [argument]) =
                    (function.parameters.as_slice(), arguments.as_slice())
                else {
                    return None;
                };
                let is_parameter = *self.kind(single(*set)?) == Kind::Variable(parameter.variable);
                is_parameter.then_some((*boundary, *argument))
            }
            _ => None,
        }
    }

    /// The member of a set that is written with one, if it is at hand.
    pub(super) fn singleton(&self, set: ExprId) -> Option<ExprId> {
        let Kind::Set(items) = self.kind(set) else {
            return None;
        };
        let &[item] = items.as_slice() else {
            return None;
        };
        let is_variable = matches!(self.kind(item), Kind::Variable(_));
        (is_variable || !self.names.contains_key(&set)).then_some(item)
    }

    /// What a boundary matrix connects to an element, as it stands in the matrix.
    fn matrix_column(&mut self, boundary: Boundary, item: ExprId) -> TokenStream {
        let (mesh, k, _, transposed) = self.boundary(boundary);
        let item = self.owned(item);
        match transposed {
            false => quote!(#mesh.boundary_elements(#k, #item as usize)),
            true => quote!(#mesh.coboundary_elements(#k, #item as usize)),
        }
    }

    /// The value of a set, a chain, or of what is asked of one.
    pub(super) fn set_value(&mut self, e: ExprId) -> TokenStream {
        let elements = self.ty(e).element_of_set().is_some();
        match self.kind(e) {
            Kind::AllElements(element) => {
                let n = self.context.count(*element);
                quote!(rt::all(#n))
            }
            Kind::Set(items) => {
                let items: Vec<_> = items.iter().map(|i| self.owned(*i)).collect();
                match (elements, items.as_slice()) {
                    (true, [single]) => quote!(rt::singleton(#single)),
                    (true, items) => quote!(rt::sorted(rt::Ids::from_slice(&[#(#items),*]))),
                    (false, items) => {
                        let ty = self.context.inner_type(self.ty(e));
                        quote!(<#ty as ::std::convert::From<::std::vec::Vec<_>>>::from(::std::vec![#(#items),*]))
                    }
                }
            }
            Kind::SetOp(SetOp::Difference, a, b) if elements && self.singleton(*b).is_some() => {
                let item = self.singleton(*b).map(|item| self.owned(item));
                let a = self.ids(*a);
                quote!(rt::without(#a, #item))
            }
            Kind::SetOp(op, a, b) if elements => {
                let (a, b) = (self.ids(*a), self.ids(*b));
                match op {
                    SetOp::Union => quote!(rt::union(#a, #b)),
                    SetOp::Intersection => quote!(rt::intersection(#a, #b)),
                    SetOp::Difference => quote!(rt::difference(#a, #b)),
                }
            }
            Kind::SetOp(op, a, b) => {
                let (a, b) = (self.reference(*a), self.reference(*b));
                match op {
                    SetOp::Union => quote!((#a).union(#b)),
                    SetOp::Intersection => quote!((#a).intersection(#b)),
                    SetOp::Difference => quote!((#a).difference(#b)),
                }
            }
            Kind::Cardinality(set) => self.cardinality(*set),
            Kind::SetItem(set, index) => {
                if let Some(step) = self.step_to_item(e, *set, *index) {
                    return step;
                }
                let index = self.owned(*index);
                let site = self.context.site(e);
                let set = self.slice(*set);
                match super::block::is_copy(self.ty(e)) {
                    true => quote!(*rt::entry(#set, #index, #site)?),
                    false => quote!(rt::entry(#set, #index, #site)?.clone()),
                }
            }
            Kind::Neighbor(neighbor, a, b) => self.neighbor(e, *neighbor, *a, *b),
            Kind::Sized(set, n) => {
                let site = self.context.site(e);
                let n = Literal::u32_unsuffixed(*n);
                let value = self.owned(*set);
                quote!(rt::sized(#value, #n, #site)?)
            }
            Kind::Member(item, set) => self.member(*item, *set),
            Kind::Indicator(set) => {
                let set = self.ids(*set);
                quote!(rt::Chain::indicator(#set))
            }
            Kind::Apply(boundary, chain) => {
                let chain = self.reference(*chain);
                let (mesh, k, signed, transposed) = self.boundary(*boundary);
                quote!(rt::Chain::product(#mesh, #k, #signed, #transposed, #chain))
            }
            Kind::NonZeros(chain) => {
                let chain = self.reference(*chain);
                quote!((#chain).non_zeros())
            }
            Kind::ValueSet(chain, value) => {
                let n = self.context.count(self.space_of(*chain));
                let (chain, value) = (self.reference(*chain), self.owned(*value));
                quote!((#chain).where_equal(#value, #n))
            }
            Kind::Traverse(boundary, set) => self.traverse(e, *boundary, *set),
            Kind::Entry(boundary, row, column) => {
                let (row, column) = match boundary.transposed {
                    true => (*column, *row),
                    false => (*row, *column),
                };
                let (row, column) = (self.owned(row), self.owned(column));
                let (mesh, k, signed, _) = self.boundary(*boundary);
                let entry =
                    quote!((#mesh.boundary_entry(#k, #row as usize, #column as usize) as i64));
                match signed {
                    true => entry,
                    false => quote!(#entry.abs()),
                }
            }
            Kind::Boundary(boundary) => {
                let (mesh, k, signed, transposed) = self.boundary(*boundary);
                quote!(rt::boundary_as_matrix(#mesh, #k, #signed, #transposed))
            }
            other => panic!("bug in iheartmesh: no Rust for {other:?}"),
        }
    }

    /// Of which elements a value is a chain.
    pub(super) fn space_of(&self, chain: ExprId) -> Element {
        match self.ty(chain) {
            Type::Vector {
                space: Some(space), ..
            } => *space,
            other => panic!("bug in iheartmesh: {other} is no chain"),
        }
    }

    /// A set as a slice of its members.
    fn slice(&mut self, set: ExprId) -> TokenStream {
        if self.ty(set).element_of_set().is_some() {
            return self.ids(set);
        }
        let set = self.reference(set);
        quote!((#set).as_slice())
    }

    fn cardinality(&mut self, set: ExprId) -> TokenStream {
        if let Kind::AllElements(element) = self.kind(set) {
            let n = self.context.count(*element);
            return quote!((#n as i64));
        }
        let set = self.slice(set);
        quote!(((#set).len() as i64))
    }

    fn member(&mut self, item: ExprId, set: ExprId) -> TokenStream {
        if let Kind::AllElements(element) = self.kind(set) {
            let n = self.context.count(*element);
            let item = self.owned(item);
            return quote!(((#item as usize) < #n));
        }
        let elements = self.ty(set).element_of_set().is_some();
        let item = self.reference(item);
        match elements {
            true => {
                let set = self.ids(set);
                quote!((#set).binary_search(#item).is_ok())
            }
            false => {
                let set = self.reference(set);
                quote!((#set).contains(#item))
            }
        }
    }

    /// The mesh, the number of a boundary matrix, whether it has signs, whether it is transposed.
    pub(super) fn boundary(&self, boundary: Boundary) -> (TokenStream, TokenStream, bool, bool) {
        let mesh = self.context.mesh_field(boundary.mesh);
        let k = Literal::u8_unsuffixed(boundary.dimension);
        (
            quote!(t.#mesh.complex()),
            quote!(#k),
            boundary.signed,
            boundary.transposed,
        )
    }

    /// The elements that a boundary matrix connects to those of a set. Of a single element they stand in the matrix.
    fn traverse(&mut self, e: ExprId, boundary: Boundary, set: ExprId) -> TokenStream {
        if let Some((boundary, item)) = self.single_column(e) {
            let column = self.matrix_column(boundary, item);
            return quote!(rt::copied(#column));
        }
        if let Some(list) = self.two_steps(e) {
            return quote!(rt::copied(#list));
        }
        if let Some(ring) = self.closed_ring(boundary, set) {
            return ring;
        }
        let (mesh, k, _, transposed) = self.boundary(boundary);
        let set = self.ids(set);
        match transposed {
            false => quote!(rt::boundary_of(#mesh, #k, #set)),
            true => quote!(rt::coboundary_of(#mesh, #k, #set)),
        }
    }
}
