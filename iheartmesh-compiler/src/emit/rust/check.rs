//! Checks of what the host hands in: parameters of the struct, and arguments of its methods.

use std::collections::BTreeSet;

use proc_macro2::TokenStream;
use quote::quote;

use super::member::{Checked, at_hand};
use super::{Context, names};
use crate::ir::{ExprId, Function, Input, InputId, Kind};
use crate::types::{Atom, Element, Type};

impl Context<'_> {
    /// Checks an input against the meshes and against other inputs; all are at hand under the names of their fields.
    /// Without `all` those inputs count that come before it, so that one mistake is one error.
    pub(super) fn input_checks(&self, id: InputId, input: &Input, all: bool) -> TokenStream {
        let field = self.input_field(id);
        let name = &input.name;
        let mut checks = TokenStream::new();
        let checked = Checked {
            function: "",
            parameter: name,
            set: &input
                .ty
                .owner()
                .or_else(|| self.items_owner(&input.ty))
                .map_or(String::new(), |mesh| self.program().mesh(mesh).name.clone()),
        };
        let value = at_hand(&input.ty, quote!(#field));
        checks.extend(self.element_checks(checked, &input.ty, &value));
        for pairs in &input.pairs {
            let [rows, columns] = pairs.sizes.each_ref().map(|size| self.size(size));
            let (first, matrix) = (pairs.first, &pairs.matrix);
            checks.extend(
                quote!(rt::check_pairs(#name, #field.as_ref(), #first, (#rows, #columns), #matrix)?;),
            );
        }
        checks.extend(self.fixed_member_check(id, input));
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
        checks.extend(self.tie_checks(id, all));
        checks
    }

    /// The mesh of the elements in a sequence.
    fn items_owner(&self, ty: &Type) -> Option<crate::types::MeshId> {
        match ty {
            Type::Sequence { item, .. } => item.owner(),
            _ => None,
        }
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
        let sizes = self.argument_size_checks(function);
        let members: TokenStream = function
            .parameters
            .iter()
            .map(|p| {
                let name = names::argument(&p.name);
                let value = at_hand(&p.ty, quote!(#name));
                let mut checked = Checked {
                    function: &function.name,
                    parameter: &p.name,
                    set: &p.within_name,
                };
                if let Some(check) = self.member_check(checked, &p.ty, &value, p.within) {
                    return check;
                }
                let mesh;
                if let Type::CellularSet(Some(owner)) = p.ty {
                    mesh = self.program().mesh(owner).name.clone();
                    checked.set = &mesh;
                }
                let mut checks = self.element_checks(checked, &p.ty, &value);
                if let Type::Sequence {
                    index: Some(element),
                    ..
                } = &p.ty
                {
                    checks.extend(self.length_check(&p.name, &quote!(#name), *element, true));
                }
                checks
            })
            .collect();
        match sizes.is_empty() {
            true => members,
            false => quote!(#members let sizes = &s.sizes; #sizes),
        }
    }

    /// The numbers of the members of the set that something is declared to be in, as a slice, where that is not all
    /// elements of a kind.
    pub(super) fn members(&self, within: Option<ExprId>) -> Option<TokenStream> {
        match self.program().arena.kind(within?) {
            Kind::Global(id) => {
                let set = self.set_of_global(*id);
                Some(quote!(&(#set)[..]))
            }
            Kind::Input(id) => {
                let field = self.input_field(*id);
                Some(quote!(&rt::ids_of_set(s.#field.as_ref())[..]))
            }
            _ => None,
        }
    }
}
