//! Methods that give several definitions at once, and what computes them in one pass.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::taken::RustNames;
use super::{Clash, Context, docs, names};
use crate::ir::{GlobalId, Pass, Together};

impl Context<'_> {
    /// The methods of what is asked for together.
    pub(super) fn methods_together(
        &self,
        rust_names: &mut RustNames<'_>,
        clashes: &mut Vec<Clash>,
    ) -> TokenStream {
        let mut code = TokenStream::new();
        for (list, together) in self.program().together.iter().enumerate() {
            let members = together.members.iter();
            let parts: Vec<String> = members
                .map(|id| names::rust_name(&self.program().global(*id).name))
                .collect();
            let name = parts.join("_");
            let mut ends = vec![""];
            if together.members.iter().any(|id| self.has_into(*id)) {
                ends.push("_into");
            }
            let forms = |name: &str| -> Vec<String> {
                let forms = ends.iter();
                let forms =
                    forms.flat_map(|end| [format!("{name}{end}"), format!("try_{name}{end}")]);
                forms.collect()
            };
            let what = "another such list";
            let span = self.program().global(together.members[0]).span;
            let taken = forms(&name).into_iter().find_map(|form| {
                let other = rust_names.known(&form)?.to_owned();
                Some(Clash {
                    list,
                    method: form,
                    other,
                })
            });
            if let Some(clash) = taken {
                clashes.push(clash);
                continue;
            }
            let mut list = vec![name.clone()];
            list.extend(names::ascii_alias(&name));
            for name in list {
                // an alias may be taken
                if !forms(&name)
                    .iter()
                    .all(|form| rust_names.alias(form, what, span))
                {
                    continue;
                }
                code.extend(self.method_together(together, &name));
                if ends.len() > 1 {
                    code.extend(self.method_together_into(together, &name));
                }
            }
        }
        code
    }

    fn method_together(&self, together: &Together, name: &str) -> TokenStream {
        let krate = self.krate;
        let (method, fallible) = (names::ident(name), format_ident!("try_{}", name));
        let types = together.members.iter().map(|id| self.outer_of(*id));
        let types: Vec<TokenStream> = types.collect();
        let values = together.members.iter().map(|id| self.try_name(*id, ""));
        let module = &self.module;
        let pass = self.united(together).map(|pass| {
            let keep = self.keep_name(pass);
            quote!(#module::#keep(&self.state);)
        });
        let (doc, try_doc) = (
            docs::together(self, together, false, false),
            docs::together(self, together, false, true),
        );
        quote! {
            #doc
            pub fn #method(&self) -> (#(#types),*) {
                match self.#fallible() {
                    ::std::result::Result::Ok(values) => values,
                    ::std::result::Result::Err(error) => #krate::__private::fail(error),
                }
            }
            #try_doc
            pub fn #fallible(&self) -> ::std::result::Result<(#(#types),*), #krate::Error> {
                #pass
                ::std::result::Result::Ok((#(self.#values()?),*))
            }
        }
    }

    fn method_together_into(&self, together: &Together, name: &str) -> TokenStream {
        let krate = self.krate;
        let (method, fallible) = (
            format_ident!("{}_into", name),
            format_ident!("try_{}_into", name),
        );
        let (targets, others): (Vec<GlobalId>, Vec<GlobalId>) =
            together.members.iter().partition(|id| self.has_into(**id));
        let arguments: Vec<Ident> = targets.iter().map(|id| self.target(*id)).collect();
        let types: Vec<TokenStream> = targets.iter().map(|id| self.outer_of(*id)).collect();
        let results = others.iter().map(|id| self.outer_of(*id));
        let result = tuple(results.collect());
        let values = others.iter().map(|id| {
            let name = self.try_name(*id, "");
            quote!(self.#name()?)
        });
        let value = tuple(values.collect());
        let module = &self.module;
        let pass = self.united(together);
        // in order, so that the first that has no value is named
        let each = |is_in: &dyn Fn(GlobalId) -> bool| -> TokenStream {
            let members = together.members.iter().filter(|id| is_in(**id));
            let code = members.map(|id| match self.has_into(*id) {
                true => {
                    let (name, target) = (self.try_name(*id, "_into"), self.target(*id));
                    quote!(self.#name(#target)?;)
                }
                false => {
                    let name = self.try_name(*id, "");
                    quote!(self.#name()?;)
                }
            });
            code.collect()
        };
        let write = match pass {
            None => each(&|_| true),
            Some(pass) => {
                let into = self.name_of_into(pass);
                let all = each(&|_| true);
                let rest = each(&|id| !pass.members.contains(&id) && self.has_into(id));
                let written = pass.members.iter().filter(|id| self.has_into(**id));
                let written = written.map(|id| self.target(*id));
                quote!(if #module::#into(&self.state, #(#written),*) { #rest } else { #all })
            }
        };
        let (doc, try_doc) = (
            docs::together(self, together, true, false),
            docs::together(self, together, true, true),
        );
        quote! {
            #doc
            pub fn #method(&self, #(#arguments: &mut #types),*) -> #result {
                match self.#fallible(#(#arguments),*) {
                    ::std::result::Result::Ok(values) => values,
                    ::std::result::Result::Err(error) => #krate::__private::fail(error),
                }
            }
            #try_doc
            pub fn #fallible(&self, #(#arguments: &mut #types),*) -> ::std::result::Result<#result, #krate::Error> {
                #write
                ::std::result::Result::Ok(#value)
            }
        }
    }

    /// What computes several of these definitions in one pass.
    pub(super) fn united<'a>(&self, together: &'a Together) -> Option<&'a Pass> {
        let pass = together.pass.as_ref()?;
        self.slot_sums.contains_key(&pass.global).then_some(pass)
    }

    fn outer_of(&self, id: GlobalId) -> TokenStream {
        self.outer_type(self.program().arena.ty(self.program().global(id).value))
    }

    fn try_name(&self, id: GlobalId, end: &str) -> Ident {
        let name = names::rust_name(&self.program().global(id).name);
        format_ident!("try_{}{}", name, end)
    }

    fn target(&self, id: GlobalId) -> Ident {
        names::argument(&self.program().global(id).name)
    }

    fn keep_name(&self, pass: &Pass) -> Ident {
        format_ident!("keep_{}", self.global_name(pass.global))
    }

    fn name_of_into(&self, pass: &Pass) -> Ident {
        format_ident!("into_{}", self.global_name(pass.global))
    }

    /// The functions that compute a pass: into what is kept of each definition, and into memory that is at hand. Where fewer
    /// than two are not known yet, or one has no value, they leave it to each by itself.
    pub(super) fn pass_functions(&self, pass: &Pass) -> TokenStream {
        let (keep, into) = (self.keep_name(pass), self.name_of_into(pass));
        let [slots, fill] = ["slots", "fill"]
            .map(|start| format_ident!("{}_{}", start, self.global_name(pass.global)));
        let caches: Vec<Ident> = pass.members.iter().map(|id| self.cache_name(*id)).collect();
        let (arrays, numbers): (Vec<GlobalId>, Vec<GlobalId>) =
            pass.members.iter().partition(|id| self.has_into(**id));
        let types = arrays.iter().map(|id| {
            let value = self.program().global(*id).value;
            self.inner_type(self.program().arena.ty(value))
        });
        let data: Vec<Ident> = (0..arrays.len())
            .map(|k| format_ident!("data{}", k))
            .collect();
        let places: Vec<Literal> = (0..arrays.len()).map(Literal::usize_unsuffixed).collect();
        let filled = arrays.iter().enumerate().map(|(k, id)| {
            let (cache, data) = (self.cache_name(*id), &data[k]);
            let value = self.filled(self.program().global(*id).value, k, &quote!(#data));
            quote!(let _ = s.#cache.set(::std::result::Result::Ok(#value));)
        });
        let totals = Literal::usize_unsuffixed(numbers.len());
        let known: Vec<TokenStream> = numbers
            .iter()
            .enumerate()
            .map(|(k, id)| {
                let (cache, k) = (self.cache_name(*id), Literal::usize_unsuffixed(k));
                quote!(let _ = s.#cache.set(::std::result::Result::Ok(totals[#k]));)
            })
            .collect();
        let unknown = quote! {
            if [#(s.#caches.get().is_none()),*].into_iter().filter(|unknown| *unknown).count() < 2
        };
        quote! {
            pub fn #keep(s: &State<'_>) {
                #unknown { return; }
                let ::std::result::Result::Ok(slots) = #slots(s) else { return };
                #(let mut #data = ::std::vec![0.0f64; slots.pattern(#places).entries()];)*
                let mut totals = [0.0f64; #totals];
                if #fill(s, &slots, &mut [#(&mut #data[..]),*], &mut totals).is_err() { return; }
                #(#filled)*
                #(#known)*
            }
            pub fn #into(s: &State<'_>, #(#data: &mut #types),*) -> bool {
                #unknown { return false; }
                let ::std::result::Result::Ok(slots) = #slots(s) else { return false };
                let mut totals = [0.0f64; #totals];
                let mut all = [#(rt::Reuse::entries_of(#data, slots.pattern(#places))),*];
                if #fill(s, &slots, &mut all, &mut totals).is_err() { return false; }
                #(#known)*
                true
            }
        }
    }
}

/// Several as a tuple, one by itself.
fn tuple(parts: Vec<TokenStream>) -> TokenStream {
    match parts.as_slice() {
        [single] => single.clone(),
        _ => quote!((#(#parts),*)),
    }
}
