//! Checks that values are in the sets that they are declared to be in.

use proc_macro2::TokenStream;
use quote::quote;

use super::Context;
use crate::ir::{ExprId, GlobalId, Input, InputId, Kind};
use crate::types::Type;

/// What is checked: of which function, empty for the struct, which parameter, and the set as it is written.
#[derive(Clone, Copy)]
pub(super) struct Checked<'a> {
    pub(super) function: &'a str,
    pub(super) parameter: &'a str,
    pub(super) set: &'a str,
}

impl Context<'_> {
    /// Checks elements against the mesh: a value, a set, or a sequence of these. `value` is as [`at_hand`] gives
    /// it.
    pub(super) fn element_checks(
        &self,
        of: Checked<'_>,
        ty: &Type,
        value: &TokenStream,
    ) -> TokenStream {
        let Checked {
            function,
            parameter,
            set,
        } = of;
        match (ty, ty.element_of_set()) {
            (Type::Element(element), _) => {
                let n = self.count(*element);
                quote!(rt::check_argument(#function, #parameter, #value, #n, #set)?;)
            }
            (_, Some(element)) => {
                let n = self.count(element);
                quote!(rt::check_set_argument(#function, #parameter, #value, #n, #set)?;)
            }
            (Type::CellularSet(Some(mesh)), _) => {
                let (field, mesh) = (self.mesh_field(*mesh), &self.program().mesh(*mesh).name);
                quote!(rt::check_cellular_set(#function, #parameter, #value, t.#field.complex(), #mesh)?;)
            }
            (Type::Tuple(items), _) => {
                let items = items.iter().enumerate().map(|(k, item)| {
                    let k = proc_macro2::Literal::usize_unsuffixed(k);
                    let value = match item.is_element() {
                        true => quote!((#value).#k),
                        false => quote!(&(#value).#k),
                    };
                    self.element_checks(of, item, &value)
                });
                items.collect()
            }
            (Type::Sequence { item, .. } | Type::Set(item), _) => {
                let check = self.element_checks(of, item, &item_at_hand(item));
                match check.is_empty() {
                    true => check,
                    false => quote!(for item in (#value).iter() { #check }),
                }
            }
            _ => TokenStream::new(),
        }
    }

    /// The check that a value is in a set which is not all elements of a kind; `None` where it may be any. `value` is as
    /// [`at_hand`] gives it. Needs `t`, and `s` where the set depends on values.
    pub(super) fn member_check(
        &self,
        of: Checked<'_>,
        ty: &Type,
        value: &TokenStream,
        within: Option<ExprId>,
    ) -> Option<TokenStream> {
        let (set, is_input) = match self.program().arena.kind(within?) {
            Kind::Global(id) => (self.set_of_global(*id), false),
            Kind::Input(id) => {
                let field = self.input_field(*id);
                (quote!(s.#field.as_ref()), true)
            }
            _ => return None,
        };
        let Type::Set(member) = self.program().arena.ty(within?) else {
            return None;
        };
        let check = self.in_set(of, ty, member, value, is_input);
        Some(quote!({ let set = #set; #check }))
    }

    /// The check with the set at hand as `set`.
    fn in_set(
        &self,
        of: Checked<'_>,
        ty: &Type,
        member: &Type,
        value: &TokenStream,
        is_input: bool,
    ) -> TokenStream {
        let Checked {
            function,
            parameter,
            set: written,
        } = of;
        match ty {
            _ if ty == member => match (member, is_input) {
                (Type::Element(_), false) => {
                    quote!(rt::check_member(#function, #parameter, #value, &set[..], #written)?;)
                }
                (Type::Element(_), true) => {
                    quote!(rt::check_element_in(#function, #parameter, #value, set, #written)?;)
                }
                (_, false) if !self.is_same_outside(member) => {
                    let inner = self.to_inner(quote!((*#value)), member);
                    quote!(rt::check_in(#function, #parameter, &#inner, set, #written)?;)
                }
                _ => quote!(rt::check_in(#function, #parameter, #value, set, #written)?;),
            },
            Type::Set(item) | Type::Sequence { item, .. } => {
                let check = self.in_set(of, item, member, &item_at_hand(item), is_input);
                quote!(for item in (#value).iter() { #check })
            }
            _ => TokenStream::new(),
        }
    }

    /// The value of a definition that is a set.
    pub(super) fn set_of_global(&self, id: GlobalId) -> TokenStream {
        let krate = self.krate;
        let name = self.global_name(id);
        let receiver = match self.is_static_global(id) {
            true => quote!(t),
            false => quote!(s),
        };
        let written = &self.program().global(id).name;
        quote! {
            match #receiver.#name() {
                ::std::result::Result::Ok(set) => set,
                ::std::result::Result::Err(fault) => {
                    return ::std::result::Result::Err(#krate::__private::undefined(#written, &[], fault));
                }
            }
        }
    }

    /// Checks a parameter of the struct against a set that is known from the mesh.
    pub(super) fn fixed_member_check(&self, id: InputId, input: &Input) -> Option<TokenStream> {
        match self.program().arena.kind(input.within?) {
            Kind::Global(set) if self.is_static_global(*set) => {}
            _ => return None,
        }
        let field = self.input_field(id);
        self.member_check(
            self.checked(input),
            &input.ty,
            &at_hand(&input.ty, quote!(#field)),
            input.within,
        )
    }

    /// Checks the parameters of the struct against sets that depend on values, of a state `s` with the topology `t`.
    pub(super) fn changing_member_checks(&self) -> TokenStream {
        let mut checks = TokenStream::new();
        for (id, input) in self.values() {
            let Some(within) = input.within else {
                continue;
            };
            if matches!(self.program().arena.kind(within), Kind::Global(set) if self.is_static_global(*set))
            {
                continue;
            }
            let field = self.input_field(id);
            let value = at_hand(&input.ty, quote!(s.#field));
            checks.extend(self.member_check(self.checked(input), &input.ty, &value, input.within));
        }
        checks
    }

    /// The result of the constructor of the state, with the method that checks what depends on values.
    pub(super) fn with_set_checks(&self, state: &TokenStream) -> (TokenStream, TokenStream) {
        let (krate, sets) = (self.krate, self.changing_member_checks());
        if sets.is_empty() {
            return (quote!(::std::result::Result::Ok(#state)), sets);
        }
        let result = quote! {
            let state = #state;
            state.check_sets()?;
            ::std::result::Result::Ok(state)
        };
        let method = quote! {
            /// Checks parameters that must be in sets which depend on values.
            pub fn check_sets(&self) -> ::std::result::Result<(), #krate::Error> {
                let s = self;
                let t = &s.topology;
                #sets
                ::std::result::Result::Ok(())
            }
        };
        (result, method)
    }

    fn checked<'i>(&'i self, input: &'i Input) -> Checked<'i> {
        let set = match input.within.map(|set| self.program().arena.kind(set)) {
            Some(Kind::Global(id)) => &self.program().global(*id).name,
            Some(Kind::Input(id)) => &self.program().input(*id).name,
            _ => "",
        };
        Checked {
            function: "",
            parameter: &input.name,
            set,
        }
    }
}

/// A value, however it is held: an element itself, otherwise a reference.
pub(super) fn at_hand(ty: &Type, value: TokenStream) -> TokenStream {
    match super::item::is_converted(ty) {
        true => quote!(#value.as_ref()),
        false if ty.is_element() => value,
        false => quote!(&#value),
    }
}

/// The same of an item that is at hand as the reference `item`.
fn item_at_hand(ty: &Type) -> TokenStream {
    match ty.is_element() {
        true => quote!(*item),
        false => quote!(item),
    }
}
