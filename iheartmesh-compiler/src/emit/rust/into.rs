//! Methods that write a value into memory that is at hand.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::{Context, docs};
use crate::ir::GlobalId;

impl Context<'_> {
    /// Whether the value of a definition can be written into memory that is at hand: a sparse matrix, or a vector or matrix
    /// whose size the program does not fix.
    pub(super) fn has_into(&self, id: GlobalId) -> bool {
        let ty = self.program().arena.ty(self.program().global(id).value);
        ty.is_of_any_size()
    }

    /// `…_into` and `try_…_into`.
    pub(super) fn methods_into(&self, id: GlobalId, name: &str) -> TokenStream {
        let krate = self.krate;
        let global = self.program().global(id);
        let outer = self.outer_type(self.program().arena.ty(global.value));
        let (method, fallible) = (
            format_ident!("{}_into", name),
            format_ident!("try_{}_into", name),
        );
        let (inner, module) = (self.global_name(id), &self.module);
        let receiver = match self.is_static_global(id) {
            true => quote!(t),
            false => quote!(s),
        };
        let write = match self.slot_sums.contains_key(&id) {
            true => {
                let into = format_ident!("into_{}", inner);
                quote!(#module::#into(s, target))
            }
            false => quote!(#receiver.#inner().map(|value| rt::Reuse::assign(target, value))),
        };
        let (doc, try_doc) = (
            docs::global_into(self, global, false),
            docs::global_into(self, global, true),
        );
        let written = &global.name;
        quote! {
            #doc
            pub fn #method(&self, target: &mut #outer) {
                if let ::std::result::Result::Err(error) = self.#fallible(target) {
                    #krate::__private::fail(error)
                }
            }
            #try_doc
            pub fn #fallible(&self, target: &mut #outer) -> ::std::result::Result<(), #krate::Error> {
                use #krate::__private as rt;
                let s = &self.state;
                let t = &s.topology;
                #write.map_err(|fault| rt::undefined(#written, &[], fault))
            }
        }
    }

    /// The function that writes a sum with planned places into a value of its type.
    pub(super) fn function_into(&self, id: GlobalId) -> TokenStream {
        let inner = self.global_name(id);
        let [into, slots, fill] =
            ["into", "slots", "fill"].map(|start| format_ident!("{}_{}", start, inner));
        let (cache, ty) = (
            self.cache_name(id),
            self.inner_type(self.program().arena.ty(self.program().global(id).value)),
        );
        quote! {
            pub fn #into(s: &State<'_>, target: &mut #ty) -> rt::Fallible<()> {
                if let ::std::option::Option::Some(known) = s.#cache.get() {
                    rt::Reuse::assign(target, known.as_ref().map_err(|fault| *fault)?);
                    return ::std::result::Result::Ok(());
                }
                let slots = #slots(s)?;
                #fill(s, &slots, &mut [rt::Reuse::entries_of(target, slots.pattern(0))], &mut [])
            }
        }
    }
}
