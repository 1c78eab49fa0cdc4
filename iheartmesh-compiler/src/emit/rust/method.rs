//! The methods of the struct.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::taken::RustNames;
use super::{Context, docs, names};
use crate::ir::{Function, FunctionId, GlobalId, Parameter};
use crate::types::Type;

/// The methods, and what they need in the private module.
#[derive(Default)]
pub(super) struct Methods {
    pub(super) methods: TokenStream,
    pub(super) module: TokenStream,
}

impl Context<'_> {
    /// The methods of all that the host may call.
    pub(super) fn methods(&self, rust_names: &mut RustNames<'_>) -> Methods {
        let mut code = Methods::default();
        let (globals, functions) = self.exports();
        for id in globals {
            let global = self.program().global(id);
            let into = self.has_into(id);
            let more: &[&str] = if into { &["into"] } else { &[] };
            for name in self.take_names(&global.name, global.span, more, rust_names) {
                code.methods.extend(self.global_methods(id, &name));
                if into {
                    code.methods.extend(self.methods_into(id, &name));
                }
            }
        }
        for (name, list) in functions {
            let span = self.program().function(list[0]).span;
            let all = list.len() == 1 && self.has_all(list[0]);
            let more: &[&str] = if all { &["all"] } else { &[] };
            for rust in self.take_names(&name, span, more, rust_names) {
                match list.as_slice() {
                    [single] => code.methods.extend(self.function_methods(*single, &rust)),
                    several => code.methods.extend(self.overload_methods(several, &rust)),
                }
            }
            if list.len() > 1 {
                code.module.extend(self.overload_trait(&list));
            }
        }
        code
    }

    /// The Rust names of a symbol: its own, and the ASCII one of Greek letters; `more` are the ends of names of further
    /// methods.
    fn take_names(
        &self,
        name: &str,
        span: crate::span::Span,
        more: &[&str],
        rust_names: &mut RustNames<'_>,
    ) -> Vec<String> {
        let rust = names::rust_name(name);
        let forms = |rust: &str| {
            let mut forms = vec![rust.to_owned(), format!("try_{rust}")];
            for end in more {
                forms.extend([format!("{rust}_{end}"), format!("try_{rust}_{end}")]);
            }
            forms
        };
        let what = format!("`{name}`");
        for form in forms(&rust) {
            // one clash is one error
            if !rust_names.take(&form, &what, span) {
                break;
            }
        }
        let mut list = vec![rust.clone()];
        if let Some(alias) = names::ascii_alias(&rust) {
            let free = forms(&alias)
                .iter()
                .all(|form| rust_names.alias(form, &what, span));
            if free {
                list.push(alias);
            }
        }
        list
    }

    fn module_name(&self) -> &Ident {
        &self.module
    }

    fn global_methods(&self, id: GlobalId, name: &str) -> TokenStream {
        let krate = self.krate;
        let global = self.program().global(id);
        let ty = self.program().arena.ty(global.value);
        let outer = self.outer_type(ty);
        let (method, fallible) = (names::ident(name), format_ident!("try_{}", name));
        let inner = self.global_name(id);
        let receiver = match self.is_static_global(id) {
            true => quote!(t),
            false => quote!(s),
        };
        let value = match super::block::is_copy(ty) {
            true => quote!(*value),
            false => quote!(value.clone()),
        };
        let value = self.to_outer(value, ty);
        let (doc, try_doc) = (
            docs::global(self, global, false),
            docs::global(self, global, true),
        );
        let written = &global.name;
        quote! {
            #doc
            pub fn #method(&self) -> #outer {
                match self.#fallible() {
                    ::std::result::Result::Ok(value) => value,
                    ::std::result::Result::Err(error) => #krate::__private::fail(error),
                }
            }
            #try_doc
            pub fn #fallible(&self) -> ::std::result::Result<#outer, #krate::Error> {
                use #krate::__private as rt;
                let s = &self.state;
                let t = &s.topology;
                match #receiver.#inner() {
                    ::std::result::Result::Ok(value) => ::std::result::Result::Ok(#value),
                    ::std::result::Result::Err(fault) => {
                        ::std::result::Result::Err(rt::undefined(#written, &[], fault))
                    }
                }
            }
        }
    }

    /// Whether a function can be evaluated over its whole element set.
    fn has_all(&self, id: FunctionId) -> bool {
        matches!(self.program().function(id).parameters.as_slice(), [p] if p.ty.is_element())
    }

    /// The call of the Rust function of a function; arguments are at hand under their Rust names.
    fn inner_call(&self, id: FunctionId, inside: bool) -> TokenStream {
        let function = self.program().function(id);
        let inner = self.function_name(id);
        let receiver = match self.is_static_function(id) {
            true => quote!(t),
            false => quote!(s),
        };
        let module = self.module_name();
        let path = match inside {
            true => quote!(#inner),
            false => quote!(#module::#inner),
        };
        let arguments = function.parameters.iter().map(|p| {
            let name = names::argument(&p.name);
            match &p.ty {
                ty if !super::item::is_converted(ty) => self.to_inner(quote!(#name), ty),
                ty if super::item::is_functions(ty) => quote!(&#name),
                ty if self.is_same_outside(ty) => quote!(#name.as_ref()),
                ty => {
                    let inner = self.to_inner(quote!(#name.as_ref()), ty);
                    match ty.element_of_set().is_some() {
                        true => quote!(&#inner[..]),
                        false => quote!(&#inner),
                    }
                }
            }
        });
        quote!(#path(#receiver #(, #arguments)*))
    }

    fn conversions(&self, function: &Function) -> TokenStream {
        function
            .parameters
            .iter()
            .filter(|p| super::item::is_converted(&p.ty))
            .map(|p| {
                let name = names::argument(&p.name);
                let krate = self.krate;
                let outer = self.outer_type(&p.ty);
                match &p.ty {
                    ty if super::item::is_functions(ty) => {
                        let held = self.held_value(ty, quote!(#name));
                        quote!(let #name = #held;)
                    }
                    Type::Sequence { item, .. } => {
                        let item = self.outer_type(item);
                        quote!(let #name: #krate::Values<'_, #item> = #name.into();)
                    }
                    _ => quote!(let #name: #krate::OwnedOrBorrowed<'_, #outer> = #name.into();),
                }
            })
            .collect()
    }

    fn shown_arguments(&self, parameters: &[Parameter]) -> TokenStream {
        let shown = parameters.iter().map(|p| {
            let name = names::argument(&p.name);
            match &p.ty {
                Type::Element(_) | Type::Scalar(_) => quote!(&#name),
                ty if ty.fixed_vector().is_some() => quote!(&rt::Shown(&#name)),
                _ => quote!(&"…"),
            }
        });
        quote!(&[#(#shown),*])
    }

    /// The value of a function as a `Result`, with its arguments at hand under their Rust names; `inside` the private
    /// module or outside.
    fn fallible_body(&self, id: FunctionId, inside: bool) -> TokenStream {
        let function = self.program().function(id);
        let conversions = self.conversions(function);
        let checks = self.argument_checks(function);
        let call = self.inner_call(id, inside);
        let value = self.to_outer(quote!(value), &function.ty);
        let shown = self.shown_arguments(&function.parameters);
        let written = &function.name;
        quote! {
            #conversions
            #checks
            match #call {
                ::std::result::Result::Ok(value) => ::std::result::Result::Ok(#value),
                ::std::result::Result::Err(fault) => {
                    ::std::result::Result::Err(rt::undefined(#written, #shown, fault))
                }
            }
        }
    }

    fn function_methods(&self, id: FunctionId, name: &str) -> TokenStream {
        let krate = self.krate;
        let function = self.program().function(id);
        let (method, fallible) = (names::ident(name), format_ident!("try_{}", name));
        let outer = self.outer_type(&function.ty);
        let (parameters, arguments): (Vec<Ident>, Vec<TokenStream>) = function
            .parameters
            .iter()
            .map(|p| {
                let name = names::argument(&p.name);
                (name, self.parameter_type(&p.ty, &quote!('b)))
            })
            .unzip();
        // a lifetime inside of `impl Into<…>` must have a name
        let named = |p: &Parameter| {
            super::item::is_converted(&p.ty) || matches!(p.ty, Type::Function { .. })
        };
        let lifetime = match function.parameters.iter().any(named) {
            true => quote!(<'b>),
            false => TokenStream::new(),
        };
        let body = self.fallible_body(id, false);
        let (doc, try_doc) = (
            docs::function(self, function, false, false),
            docs::function(self, function, true, false),
        );
        let all = match self.has_all(id) {
            true => self.all_methods(id, name),
            false => TokenStream::new(),
        };
        quote! {
            #doc
            #[inline]
            #[track_caller]
            pub fn #method #lifetime (&self #(, #parameters: #arguments)*) -> #outer {
                match self.#fallible(#(#parameters),*) {
                    ::std::result::Result::Ok(value) => value,
                    ::std::result::Result::Err(error) => #krate::__private::fail(error),
                }
            }
            #try_doc
            #[inline]
            pub fn #fallible #lifetime (&self #(, #parameters: #arguments)*) -> ::std::result::Result<#outer, #krate::Error> {
                use #krate::__private as rt;
                let s = &self.state;
                let t = &s.topology;
                #body
            }
            #all
        }
    }

    fn all_methods(&self, id: FunctionId, name: &str) -> TokenStream {
        let krate = self.krate;
        let function = self.program().function(id);
        let (method, fallible) = (
            format_ident!("{}_all", name),
            format_ident!("try_{}_all", name),
        );
        let outer = self.outer_type(&function.ty);
        let Type::Element(element) = function.parameters[0].ty else {
            return TokenStream::new();
        };
        let n = self.count(element);
        let module = self.module_name();
        let inner = self.function_name(id);
        let receiver = match self.is_static_function(id) {
            true => quote!(t),
            false => quote!(s),
        };
        let values = match self.members(function.parameters[0].within) {
            Some(set) => quote!(rt::for_each_of(#set, |v| #module::#inner(#receiver, v))),
            None => match self
                .staged
                .functions
                .get(&id)
                .and_then(|staged| self.whole(id, staged))
            {
                Some((whole, _)) => quote!(#module::#whole(s)),
                None => quote!(rt::for_each_element(#n, |v| #module::#inner(#receiver, v))),
            },
        };
        let converted = match self.is_same(&function.ty) {
            true => quote!(values),
            false => {
                let value = self.to_outer(quote!(value), &function.ty);
                quote!(values.into_iter().map(|value| #value).collect())
            }
        };
        let handle = self.handle(element.kind);
        let written = &function.name;
        let (doc, try_doc) = (
            docs::function(self, function, false, true),
            docs::function(self, function, true, true),
        );
        quote! {
            #doc
            #[track_caller]
            pub fn #method(&self) -> ::std::vec::Vec<#outer> {
                match self.#fallible() {
                    ::std::result::Result::Ok(values) => values,
                    ::std::result::Result::Err(error) => #krate::__private::fail(error),
                }
            }
            #try_doc
            pub fn #fallible(&self) -> ::std::result::Result<::std::vec::Vec<#outer>, #krate::Error> {
                use #krate::__private as rt;
                let s = &self.state;
                let t = &s.topology;
                match #values {
                    ::std::result::Result::Ok(values) => ::std::result::Result::Ok(#converted),
                    ::std::result::Result::Err((element, fault)) => ::std::result::Result::Err(
                        rt::undefined(#written, &[&#handle::new(element)], fault)
                    ),
                }
            }
        }
    }

    fn is_same(&self, ty: &Type) -> bool {
        self.is_same_outside(ty)
    }

    /// The trait that dispatches overloads by the types of their arguments.
    fn overload_trait(&self, functions: &[FunctionId]) -> TokenStream {
        let krate = self.krate;
        let name = &self.program().function(functions[0]).name;
        let trait_name = self.trait_name(name);
        let mut code = quote! {
            pub trait #trait_name {
                type Value;
                fn value(self, s: &State<'_>) -> ::std::result::Result<Self::Value, #krate::Error>;
            }
        };
        for id in functions {
            let function = self.program().function(*id);
            let outer = self.outer_type(&function.ty);
            let body = self.fallible_body(*id, true);
            let names: Vec<Ident> = function
                .parameters
                .iter()
                .map(|p| names::argument(&p.name))
                .collect();
            // sets and sequences go in owned or borrowed
            let by_reference = function
                .parameters
                .iter()
                .any(|p| super::item::is_converted(&p.ty));
            for reference in [false, true] {
                if reference && !by_reference {
                    continue;
                }
                let types: Vec<TokenStream> = function
                    .parameters
                    .iter()
                    .map(|p| {
                        let ty = self.outer_type(&p.ty);
                        match reference && super::item::is_converted(&p.ty) {
                            true => quote!(&#ty),
                            false => ty,
                        }
                    })
                    .collect();
                let (ty, pattern) = match (types.as_slice(), names.as_slice()) {
                    ([ty], [name]) => (quote!(#ty), quote!(#name)),
                    _ => (quote!((#(#types,)*)), quote!((#(#names,)*))),
                };
                code.extend(quote! {
                    impl #trait_name for #ty {
                        type Value = #outer;
                        fn value(self, s: &State<'_>) -> ::std::result::Result<#outer, #krate::Error> {
                            let #pattern = self;
                            let t = &s.topology;
                            #body
                        }
                    }
                });
            }
        }
        code
    }

    fn trait_name(&self, name: &str) -> Ident {
        format_ident!("Arguments_{}", names::rust_name(name))
    }

    fn overload_methods(&self, functions: &[FunctionId], name: &str) -> TokenStream {
        let krate = self.krate;
        let list: Vec<&Function> = functions
            .iter()
            .map(|id| self.program().function(*id))
            .collect();
        let trait_name = self.trait_name(&list[0].name);
        let module = self.module_name();
        let (method, fallible) = (names::ident(name), format_ident!("try_{}", name));
        let (doc, try_doc) = (
            docs::overloads(self, &list, false),
            docs::overloads(self, &list, true),
        );
        let n = list[0].parameters.len();
        let same = list.iter().all(|f| f.parameters.len() == n) && n > 1;
        let (generics, parameters, arguments, tuple) = match same {
            true => {
                let types: Vec<Ident> = (0..n).map(|k| format_ident!("A{}", k)).collect();
                let names: Vec<Ident> = (0..n).map(|k| format_ident!("a{}", k)).collect();
                (
                    quote!(#(#types),*),
                    quote!(#(#names: #types),*),
                    quote!(#(#names),*),
                    (quote!((#(#types,)*)), quote!((#(#names,)*))),
                )
            }
            // with different numbers of arguments, several go in as a tuple
            false => (quote!(A), quote!(a: A), quote!(a), (quote!(A), quote!(a))),
        };
        let (tuple_type, tuple_value) = tuple;
        quote! {
            #doc
            #[track_caller]
            pub fn #method<#generics>(&self, #parameters) -> <#tuple_type as #module::#trait_name>::Value
            where #tuple_type: #module::#trait_name {
                match self.#fallible(#arguments) {
                    ::std::result::Result::Ok(value) => value,
                    ::std::result::Result::Err(error) => #krate::__private::fail(error),
                }
            }
            #try_doc
            pub fn #fallible<#generics>(&self, #parameters)
                -> ::std::result::Result<<#tuple_type as #module::#trait_name>::Value, #krate::Error>
            where #tuple_type: #module::#trait_name {
                #module::#trait_name::value(#tuple_value, &self.state)
            }
        }
    }
}
