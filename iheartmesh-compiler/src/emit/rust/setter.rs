//! The methods that hand in other values.

use proc_macro2::TokenStream;
use quote::quote;

use super::taken::RustNames;
use super::{Context, docs, names};
use crate::ir::{ExprId, GlobalId, InputId, Kind};

impl Context<'_> {
    /// The methods that set new values.
    pub(super) fn setters(&self, rust_names: &mut RustNames<'_>) -> TokenStream {
        let krate = self.krate;
        let mut setters = TokenStream::new();
        for (id, input) in self.values() {
            let base = names::rust_name(&input.name);
            let mut list = vec![base.clone()];
            let what = format!("the setter of `{}`", input.name);
            rust_names.take(&format!("set_{base}"), &what, input.span);
            if let Some(alias) = names::ascii_alias(&base)
                && rust_names.alias(&format!("set_{alias}"), &what, input.span)
            {
                list.push(alias);
            }
            let ty = self.parameter_type(&input.ty, &quote!('a));
            let field = self.input_field(id);
            let value = self.held_value(&input.ty, quote!(value));
            let check = self.input_checks(id, input, true);
            let updates = self.size_updates(id, input);
            // other inputs are at hand for the check
            let others = self
                .values()
                .filter(|(other, _)| *other != id)
                .map(|(other, _)| {
                    let other = self.input_field(other);
                    quote!(let #other = &self.state.#other;)
                });
            let caches = self
                .dependent_globals(id)
                .into_iter()
                .map(|global| self.cache_name(global));
            let caches: Vec<_> = caches.collect();
            let slots = self
                .slot_sums
                .iter()
                .filter(|(_, sum)| sum.inputs.contains(&id));
            let slots: Vec<_> = slots
                .filter_map(|(global, _)| self.slots_field(*global))
                .map(|(name, _)| name)
                .collect();
            let set = match self.changing_member_checks().is_empty() {
                true => {
                    quote!(self.state.#field = #field; #(self.state.#slots = ::std::default::Default::default();)* #(self.state.#caches = ::std::sync::OnceLock::new();)*)
                }
                false => quote! {
                    let before = ::std::mem::replace(&mut self.state.#field, #field);
                    #(self.state.#slots = ::std::default::Default::default();)*
                    #(self.state.#caches = ::std::sync::OnceLock::new();)*
                    if let ::std::result::Result::Err(error) = self.state.check_sets() {
                        let #field = before;
                        { use #krate::__private as rt; #updates }
                        self.state.#field = #field;
                        #(self.state.#slots = ::std::default::Default::default();)*
                        #(self.state.#caches = ::std::sync::OnceLock::new();)*
                        return ::std::result::Result::Err(error);
                    }
                },
            };
            let body = quote! {
                let #field = #value;
                {
                    use #krate::__private as rt;
                    let t = &self.state.topology;
                    let sizes = &self.state.sizes;
                    #(#others)*
                    #check
                }
                { use #krate::__private as rt; #updates }
                #set
                ::std::result::Result::Ok(())
            };
            let text = docs::setter(&input.name);
            for name in list {
                let setter = names::ident(&format!("set_{name}"));
                setters.extend(quote! {
                    #text
                    pub fn #setter(&mut self, value: #ty) -> ::std::result::Result<(), #krate::Error> { #body }
                });
            }
        }
        setters
    }

    /// The definitions whose values depend on an input.
    fn dependent_globals(&self, input: InputId) -> Vec<GlobalId> {
        let program = self.program();
        let sizes = self.own_sizes(input, program.input(input));
        let mut functions = vec![false; program.functions.len()];
        let mut globals = vec![false; program.globals.len()];
        loop {
            let mut changed = false;
            let uses = |e: ExprId, functions: &[bool], globals: &[bool]| {
                let mut found = false;
                crate::optimize::reachable(&program.arena, e, &mut |kind| {
                    found |= match kind {
                        Kind::Input(id) => *id == input,
                        Kind::Size(size) => size
                            .terms()
                            .flat_map(|(_, atoms)| atoms)
                            .any(|atom| sizes.contains(atom)),
                        Kind::Call(id, _) => functions[id.0 as usize],
                        Kind::Global(id) => globals[id.0 as usize],
                        _ => false,
                    }
                });
                found
            };
            for (k, f) in program.functions.iter().enumerate() {
                if !functions[k] && uses(f.body, &functions, &globals) {
                    functions[k] = true;
                    changed = true;
                }
            }
            for (k, g) in program.globals.iter().enumerate() {
                if !globals[k] && uses(g.value, &functions, &globals) {
                    globals[k] = true;
                    changed = true;
                }
            }
            if !changed {
                break;
            }
        }
        (0..program.globals.len())
            .filter(|k| globals[*k])
            .map(|k| GlobalId(k as u32))
            .filter(|id| program.pass(*id).is_none())
            .collect()
    }
}
