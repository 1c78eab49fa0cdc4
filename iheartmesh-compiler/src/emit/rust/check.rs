//! Checks of what the host hands in: parameters of the struct, and arguments of its methods.

use std::collections::BTreeSet;

use proc_macro2::TokenStream;
use quote::quote;

use super::{Context, names};
use crate::ir::{ExprId, Function, GlobalId, Input, InputId, Kind, Parameter};
use crate::types::{Atom, Element, Type};

impl Context<'_> {
    /// Checks an input against the meshes and against other inputs; all are at hand under the names of their fields.
    /// Without `all` those inputs count that come before it, so that one mistake is one error.
    pub(super) fn input_checks(&self, id: InputId, input: &Input, all: bool) -> TokenStream {
        let field = self.input_field(id);
        let name = &input.name;
        let mut checks = TokenStream::new();
        if let Type::Element(element) = input.ty {
            let n = self.count(element);
            let mesh = &self.program().mesh(element.mesh).name;
            checks.extend(quote!(rt::check_element(#name, #field, #n, #mesh)?;));
        }
        if let Some(element) = input.ty.element_of_set() {
            let n = self.count(element);
            let mesh = &self.program().mesh(element.mesh).name;
            checks.extend(quote!(rt::check_set(#name, #field.as_ref(), #n, #mesh)?;));
        }
        if let Type::CellularSet(Some(mesh)) = input.ty {
            let (field_of_mesh, mesh) = (self.mesh_field(mesh), &self.program().mesh(mesh).name);
            checks.extend(quote! {
                rt::check_cellular_set("", #name, #field.as_ref(), t.#field_of_mesh.complex(), #mesh)?;
            });
        }
        checks.extend(self.item_checks(input, &field));
        for pairs in &input.pairs {
            let [rows, columns] = pairs.sizes.each_ref().map(|size| self.size(size));
            let (first, matrix) = (pairs.first, &pairs.matrix);
            checks.extend(
                quote!(rt::check_pairs(#name, #field.as_ref(), #first, (#rows, #columns), #matrix)?;),
            );
        }
        checks.extend(self.smaller_set_check(input, &field));
        if let Type::Sequence { length, index, .. } = &input.ty {
            let indexed: Vec<Element> = index.iter().chain(&input.indexed_by).copied().collect();
            let indexed: BTreeSet<Element> = indexed.into_iter().collect();
            let exact = indexed.len() == 1;
            for element in indexed {
                checks.extend(self.length_check(name, &quote!(#field), element, exact));
            }
            if let Some(Atom::Length(_)) = length.as_atom() {
                let others = self.values().filter(|(other, other_input)| {
                    *other != id
                        && (all || *other < id)
                        && matches!(&other_input.ty, Type::Sequence { length: l, .. } if l == length)
                });
                for (other, other_input) in others {
                    let (other, other_name) = (self.input_field(other), &other_input.name);
                    let (one, two) = (
                        quote!(#name, #field.as_ref().len()),
                        quote!(#other_name, #other.as_ref().len()),
                    );
                    checks.extend(match all {
                        true => quote!(rt::check_same_length(#one, #two)?;),
                        false => quote!(rt::check_same_length(#two, #one)?;),
                    });
                }
            }
        }
        checks.extend(self.size_checks(id, input, all));
        checks
    }

    /// Checks the elements in the items of a sequence, or in the tuples of a set.
    fn item_checks(&self, input: &Input, field: &proc_macro2::Ident) -> Option<TokenStream> {
        let (Type::Sequence { item, .. } | Type::Set(item)) = &input.ty else {
            return None;
        };
        let name = &input.name;
        let check = |element: &Element, value: TokenStream| {
            let (n, mesh) = (
                self.count(*element),
                &self.program().mesh(element.mesh).name,
            );
            quote!(rt::check_element(#name, #value, #n, #mesh)?;)
        };
        let checks: Vec<TokenStream> = match (&**item, &input.ty) {
            (Type::Element(element), Type::Sequence { .. }) => vec![check(element, quote!(*item))],
            (Type::Tuple(items), _) => items
                .iter()
                .enumerate()
                .filter_map(|(k, item)| match item {
                    Type::Element(element) => {
                        let k = proc_macro2::Literal::usize_unsuffixed(k);
                        Some(check(element, quote!(item.#k)))
                    }
                    _ => None,
                })
                .collect(),
            _ => Vec::new(),
        };
        (!checks.is_empty()).then(|| quote!(for item in #field.as_ref().iter() { #(#checks)* }))
    }

    /// Checks an input that must be in a set which is not all elements of its kind, where that set is known from the
    /// mesh.
    fn smaller_set_check(&self, input: &Input, field: &proc_macro2::Ident) -> Option<TokenStream> {
        let Kind::Global(set) = self.program().arena.kind(input.within?) else {
            return None;
        };
        if !self.is_static_global(*set) {
            return None;
        }
        let members = self.members_of_global(*set);
        let (name, set) = (&input.name, &self.program().global(*set).name);
        Some(match input.ty.is_element() {
            true => quote!(rt::check_member("", #name, #field, #members, #set)?;),
            false => quote!(rt::check_members("", #name, #field.as_ref(), #members, #set)?;),
        })
    }

    fn length_check(
        &self,
        name: &str,
        sequence: &TokenStream,
        element: Element,
        exact: bool,
    ) -> TokenStream {
        let n = self.count(element);
        let mesh = &self.program().mesh(element.mesh).name;
        let kind = crate::types::display::plural(element.kind);
        quote!(rt::check_length(#name, #sequence.as_ref().len(), #n, #exact, #mesh, #kind)?;)
    }

    /// Checks the arguments of a method, which are at hand under their Rust names.
    pub(super) fn argument_checks(&self, function: &Function) -> TokenStream {
        function
            .parameters
            .iter()
            .map(|p| {
                let name = names::argument(&p.name);
                let (called, written, set) = (&function.name, &p.name, &p.within_name);
                if let Type::Sequence { item, .. } = &p.ty && p.within.is_some() {
                    return self.argument_item_checks(function, p, item);
                }
                if let Some(members) = self.members(p.within) {
                    return match p.ty.is_element() {
                        true => quote!(rt::check_member(#called, #written, #name, #members, #set)?;),
                        false => quote!(rt::check_members(#called, #written, #name.as_ref(), #members, #set)?;),
                    };
                }
                match (&p.ty, p.ty.element_of_set()) {
                    (Type::Element(element), _) => {
                        let n = self.count(*element);
                        quote!(rt::check_argument(#called, #written, #name, #n, #set)?;)
                    }
                    (_, Some(element)) => {
                        let n = self.count(element);
                        quote!(rt::check_set_argument(#called, #written, #name.as_ref(), #n, #set)?;)
                    }
                    (Type::CellularSet(Some(mesh)), _) => {
                        let (field, mesh) = (self.mesh_field(*mesh), &self.program().mesh(*mesh).name);
                        quote!(rt::check_cellular_set(#called, #written, #name.as_ref(), t.#field.complex(), #mesh)?;)
                    }
                    (
                        Type::Sequence {
                            index: Some(element),
                            ..
                        },
                        _,
                    ) => self.length_check(written, &quote!(#name), *element, true),
                    _ => TokenStream::new(),
                }
            })
            .collect()
    }

    /// Checks the items of a sequence of elements, or of sets of elements, that are declared to be in a set.
    fn argument_item_checks(&self, function: &Function, p: &Parameter, item: &Type) -> TokenStream {
        let name = names::argument(&p.name);
        let (called, written, set) = (&function.name, &p.name, &p.within_name);
        let check = match (self.members(p.within), item, item.element_of_set()) {
            (Some(members), Type::Element(_), _) => {
                quote!(rt::check_member(#called, #written, *item, #members, #set)?;)
            }
            (Some(members), ..) => {
                quote!(rt::check_members(#called, #written, item, #members, #set)?;)
            }
            (None, Type::Element(element), _) => {
                let n = self.count(*element);
                quote!(rt::check_argument(#called, #written, *item, #n, #set)?;)
            }
            (None, _, Some(element)) => {
                let n = self.count(element);
                quote!(rt::check_set_argument(#called, #written, item, #n, #set)?;)
            }
            _ => return TokenStream::new(),
        };
        quote!(for item in #name.as_ref() { #check })
    }

    /// The numbers of the members of the set that something is declared to be in, as a slice, where that is not all
    /// elements of a kind.
    pub(super) fn members(&self, within: Option<ExprId>) -> Option<TokenStream> {
        match self.program().arena.kind(within?) {
            Kind::Global(id) => Some(self.members_of_global(*id)),
            Kind::Input(id) => {
                let field = self.input_field(*id);
                Some(quote!(&rt::ids_of_set(s.#field.as_ref())[..]))
            }
            _ => None,
        }
    }

    fn members_of_global(&self, id: GlobalId) -> TokenStream {
        let krate = self.krate;
        let name = self.global_name(id);
        let receiver = match self.is_static_global(id) {
            true => quote!(t),
            false => quote!(s),
        };
        let written = &self.program().global(id).name;
        quote! {
            match #receiver.#name() {
                ::std::result::Result::Ok(set) => &set[..],
                ::std::result::Result::Err(fault) => {
                    return ::std::result::Result::Err(#krate::__private::undefined(#written, &[], fault));
                }
            }
        }
    }
}
