//! The struct, its private module, and `new`.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::block::{Body, Mode, variable_ident};
use super::taken::RustNames;
use super::{Clash, Context, Header, docs, names};
use crate::diagnostic::Diagnostics;
use crate::ir::{Export, ExprId, FunctionId, GlobalId, Kind};
use crate::optimize::Plan;
use crate::types::Type;

/// All items of a program.
pub(super) fn items(
    context: &Context<'_>,
    header: &Header,
    diagnostics: &mut Diagnostics,
    clashes: &mut Vec<Clash>,
) -> TokenStream {
    let Header {
        name,
        visibility,
        attributes,
        source,
        ..
    } = header;
    let krate = context.krate;
    let module = &context.module;
    let mut rust_names = RustNames::new(diagnostics);
    let methods = context.methods(&mut rust_names);
    let setters = context.setters(&mut rust_names);
    let together = context.methods_together(&mut rust_names, clashes);
    let arguments = &methods.module;
    let inner = context.module_items();
    let parameters: Vec<(Ident, TokenStream)> = context.new_parameters();
    let (names, types): (Vec<_>, Vec<_>) = parameters.iter().cloned().unzip();
    let conversions = context.values().map(|(id, input)| {
        let name = names::argument(&input.name);
        let field = context.input_field(id);
        let value = context.held_value(&input.ty, quote!(#name));
        quote!(let #field = #value;)
    });
    let meshes: Vec<_> = context
        .program()
        .meshes
        .iter()
        .map(|mesh| names::argument(&mesh.name))
        .collect();
    let fields: Vec<_> = context
        .values()
        .map(|(id, _)| context.input_field(id))
        .collect();
    let methods = &methods.methods;
    let new_docs = docs::new(context);
    let struct_docs = docs::structure(source);
    quote! {
        #attributes
        #struct_docs
        #visibility struct #name<'a> {
            state: #module::State<'a>,
        }

        #[doc(hidden)]
        #[allow(dead_code, missing_docs, non_snake_case, non_camel_case_types, uncommon_codepoints,
            unused_variables, unused_parens, unreachable_code, unreachable_pub, clippy::all, clippy::pedantic)]
        mod #module {
            use #krate::__private as rt;
            #inner
            #arguments
        }

        impl ::std::fmt::Debug for #name<'_> {
            fn fmt(&self, formatter: &mut ::std::fmt::Formatter<'_>) -> ::std::fmt::Result {
                formatter.debug_struct(::std::stringify!(#name)).finish_non_exhaustive()
            }
        }

        #[allow(non_snake_case, uncommon_codepoints, unused_variables, clippy::all, clippy::pedantic)]
        impl<'a> #name<'a> {
            /// The text of the program.
            pub const SOURCE: &'static str = #source;

            #new_docs
            pub fn new(#(#names: #types),*) -> ::std::result::Result<Self, #krate::Error> {
                #(#conversions)*
                ::std::result::Result::Ok(Self { state: #module::State::new(#(#meshes,)* #(#fields),*)? })
            }

            #methods
            #setters
            #together
        }
    }
}

/// Whether an argument is several functions.
pub(super) fn is_functions(ty: &Type) -> bool {
    matches!(ty, Type::Sequence { item, .. } if matches!(**item, Type::Function { .. }))
}

/// Whether an argument is owned or borrowed, as the caller likes.
pub(super) fn is_converted(ty: &Type) -> bool {
    !matches!(ty, Type::Mesh(..) | Type::Function { .. }) && !super::block::is_copy(ty)
}

/// The local name of a field of values.
pub(super) fn field_name(id: FunctionId) -> Ident {
    format_ident!("field{}", id.0)
}

impl Context<'_> {
    fn new_parameters(&self) -> Vec<(Ident, TokenStream)> {
        let program = self.program();
        program
            .input_order
            .iter()
            .map(|id| {
                let input = program.input(*id);
                let name = names::argument(&input.name);
                (name, self.parameter_type(&input.ty, &quote!('a)))
            })
            .collect()
    }

    /// What is in the private module.
    fn module_items(&self) -> TokenStream {
        let krate = self.krate;
        let program = self.program();
        let meshes: Vec<(Ident, Ident)> = (0..program.meshes.len() as u32)
            .map(crate::types::MeshId)
            .map(|id| {
                (
                    self.mesh_field(id),
                    names::ident(&program.mesh(id).kind.to_string()),
                )
            })
            .collect();
        let (mesh_names, mesh_types): (Vec<_>, Vec<_>) = meshes.into_iter().unzip();
        let (values, value_types): (Vec<_>, Vec<_>) = self
            .values()
            .map(|(id, input)| (self.input_field(id), self.held_type(&input.ty)))
            .unzip();
        let plans = self.plans();
        let (plan_fields, plan_statements, plan_names, plan_functions) = (
            &plans.fields,
            &plans.statements,
            &plans.names,
            &plans.functions,
        );
        let globals: Vec<GlobalId> = (0..program.globals.len() as u32).map(GlobalId).collect();
        let (passes, globals): (Vec<GlobalId>, Vec<GlobalId>) = globals
            .into_iter()
            .partition(|id| program.pass(*id).is_some());
        let (fixed, changing): (Vec<GlobalId>, Vec<GlobalId>) = globals
            .into_iter()
            .partition(|id| self.is_static_global(*id));
        let fixed_fields = fixed.iter().map(|id| self.cache_field(*id));
        let fixed_starts = fixed.iter().map(|id| self.cache_start(*id));
        let changing_fields = changing.iter().map(|id| self.cache_field(*id));
        let changing_starts = changing.iter().map(|id| self.cache_start(*id));
        let fixed_methods = fixed.iter().map(|id| self.cache_method(*id));
        let changing_methods = changing.iter().map(|id| self.cache_method(*id));
        let slots = changing.iter().chain(&passes);
        let slots = slots.filter_map(|id| self.slots_field(*id));
        let (slot_names, slot_types): (Vec<_>, Vec<_>) = slots.unzip();
        let functions: TokenStream = program.function_ids().map(|id| self.function(id)).collect();
        let compute: TokenStream = fixed
            .iter()
            .chain(&changing)
            .map(|id| {
                let (compute, slots) = (self.compute(*id), self.slot_functions(*id));
                quote!(#compute #slots)
            })
            .chain(passes.iter().map(|id| self.slot_functions(*id)))
            .collect();
        let checks = self
            .values()
            .map(|(id, input)| self.input_checks(id, input, false));
        let state = quote!(Self { topology, sizes, plans, #(#values,)* #(#changing_starts)* #(#slot_names: ::std::default::Default::default(),)* });
        let (state, sets) = self.with_set_checks(&state);
        let (size_names, size_values): (Vec<_>, Vec<_>) = self.size_sources().into_iter().unzip();
        quote! {
            pub struct Topology<'a> {
                #(pub #mesh_names: &'a #krate::#mesh_types,)*
                #(#fixed_fields)*
                pub lifetime: ::std::marker::PhantomData<&'a ()>,
            }

            pub struct Plans { #plan_fields }

            pub struct Sizes { #(pub #size_names: i64,)* }

            pub struct State<'a> {
                pub topology: Topology<'a>,
                pub sizes: Sizes,
                pub plans: Plans,
                #(pub #values: #value_types,)*
                #(#changing_fields)*
                #(pub #slot_names: #slot_types,)*
            }

            impl<'a> Topology<'a> { #(#fixed_methods)* }

            impl<'a> State<'a> {
                pub fn new(#(#mesh_names: &'a #krate::#mesh_types,)* #(#values: #value_types),*)
                    -> ::std::result::Result<Self, #krate::Error>
                {
                    let topology = Topology {
                        #(#mesh_names,)*
                        #(#fixed_starts)*
                        lifetime: ::std::marker::PhantomData,
                    };
                    let t = &topology;
                    #(let #size_names = #size_values;)*
                    let sizes = Sizes { #(#size_names,)* };
                    #(#checks)*
                    #plan_statements
                    let plans = Plans { #plan_names };
                    #state
                }
                #sets

                #(#changing_methods)*
            }

            #plan_functions
            #compute
            #functions
        }
    }

    /// An argument as the struct holds it.
    pub(super) fn held_value(&self, ty: &Type, argument: TokenStream) -> TokenStream {
        match ty {
            Type::Function { .. } => quote!(::std::boxed::Box::new(#argument)),
            Type::Sequence { item, .. } if is_functions(ty) => {
                let function = self.function_type(item, &quote!('_));
                let held = quote!(::std::boxed::Box<#function>);
                quote! {
                    #argument.into_iter()
                        .map(|function| -> #held { ::std::boxed::Box::new(function) })
                        .collect::<::std::boxed::Box<[_]>>()
                }
            }
            ty if is_converted(ty) => quote!(#argument.into()),
            _ => argument,
        }
    }

    /// The type in which the struct holds a value.
    pub(super) fn held_type(&self, ty: &Type) -> TokenStream {
        let krate = self.krate;
        match ty {
            Type::Sequence { item, .. } if is_functions(ty) => {
                let item = self.held_type(item);
                quote!(::std::boxed::Box<[#item]>)
            }
            Type::Sequence { item, .. } => {
                let item = self.outer_type(item);
                quote!(#krate::Values<'a, #item>)
            }
            Type::Function { .. } => {
                let function = self.function_type(ty, &quote!('a));
                quote!(::std::boxed::Box<#function>)
            }
            ty if is_converted(ty) => {
                let value = self.outer_type(ty);
                quote!(#krate::OwnedOrBorrowed<'a, #value>)
            }
            _ => self.outer_type(ty),
        }
    }

    pub(super) fn cache_name(&self, id: GlobalId) -> Ident {
        format_ident!("cache{}", id.0)
    }

    fn cache_field(&self, id: GlobalId) -> TokenStream {
        let name = self.cache_name(id);
        let ty = self.inner_type_of_global(id);
        quote!(pub #name: ::std::sync::OnceLock<rt::Fallible<#ty>>,)
    }

    fn cache_start(&self, id: GlobalId) -> TokenStream {
        let name = self.cache_name(id);
        quote!(#name: ::std::sync::OnceLock::new(),)
    }

    fn inner_type_of_global(&self, id: GlobalId) -> TokenStream {
        let krate = self.krate;
        match self.program().arena.ty(self.program().global(id).value) {
            // a boundary matrix is only ever given to the host
            Type::Matrix {
                spaces: Some(_), ..
            } => quote!(#krate::sprs::CsMat<f64>),
            ty => self.inner_type(ty),
        }
    }

    fn cache_method(&self, id: GlobalId) -> TokenStream {
        let (name, cache, ty) = (
            self.global_name(id),
            self.cache_name(id),
            self.inner_type_of_global(id),
        );
        let compute = format_ident!("compute_{}", name);
        quote! {
            pub fn #name(&self) -> rt::Fallible<&#ty> {
                self.#cache.get_or_init(|| #compute(self)).as_ref().map_err(|fault| *fault)
            }
        }
    }

    /// The function that computes a definition.
    fn compute(&self, id: GlobalId) -> TokenStream {
        let name = format_ident!("compute_{}", self.global_name(id));
        let ty = self.inner_type_of_global(id);
        let value = self.program().global(id).value;
        match self.staged.globals.get(&id) {
            None => {
                let body = Body::single(self, Mode::Static, &Plan::default(), value);
                quote!(fn #name(t: &Topology<'_>) -> rt::Fallible<#ty> { #body })
            }
            Some(staged) if self.slot_sums.contains_key(&id) => {
                let filled = self.filled(staged.body, 0, &quote!(data));
                let (slots, fill) = (
                    format_ident!("slots_{}", self.global_name(id)),
                    format_ident!("fill_{}", self.global_name(id)),
                );
                quote! {
                    fn #name(s: &State<'_>) -> rt::Fallible<#ty> {
                        let slots = #slots(s)?;
                        let mut data = ::std::vec![0.0f64; slots.pattern(0).entries()];
                        #fill(s, &slots, &mut [&mut data], &mut [])?;
                        ::std::result::Result::Ok(#filled)
                    }
                }
            }
            Some(staged) => {
                let prelude = self.prelude(&[staged.body]);
                let body = Body::single(self, Mode::Dynamic, &staged.plan, staged.body);
                quote!(fn #name(s: &State<'_>) -> rt::Fallible<#ty> { #prelude #body })
            }
        }
    }

    /// The Rust function of a function of the program, with those that evaluate it for all elements.
    fn function(&self, id: FunctionId) -> TokenStream {
        let function = self.program().function(id);
        let name = self.function_name(id);
        let ty = self.inner_type(&function.ty);
        let parameters: Vec<TokenStream> = function
            .parameters
            .iter()
            .map(|p| {
                let name = variable_ident(self, p.variable);
                let ty = self.argument_type(&p.ty);
                quote!(#name: #ty)
            })
            .collect();
        let guard = match function.recursive {
            true => {
                let reason = format!("`{}` calls itself more than 500 times", function.name);
                quote!(let _recursion = rt::Recursion::enter(rt::Fault::new(#reason))?;)
            }
            false => TokenStream::new(),
        };
        match self.staged.functions.get(&id) {
            None => {
                let body = Body::of_function(
                    self,
                    Mode::Static,
                    &Plan::default(),
                    &function.parameters,
                    function.body,
                );
                quote!(pub fn #name(t: &Topology<'_> #(, #parameters)*) -> rt::Fallible<#ty> { #guard #body })
            }
            Some(staged) => {
                let prelude = self.prelude(&[staged.body]);
                let row = self.key_row(&staged.plan);
                let key = function
                    .parameters
                    .first()
                    .map(|p| variable_ident(self, p.variable));
                let body = Body::of_function(
                    self,
                    Mode::Dynamic,
                    &staged.plan,
                    &function.parameters,
                    staged.body,
                );
                let whole = self.whole(id, staged).map(|(_, code)| code);
                if let Some((table, row, n)) = self.row_of_function(id) {
                    let of_row = self.row_function_name(id);
                    return quote! {
                        #[inline]
                        pub fn #of_row(s: &State<'_>, #row: &[u32; #n]) -> rt::Fallible<#ty> { #prelude #body }
                        pub fn #name(s: &State<'_> #(, #parameters)*) -> rt::Fallible<#ty> {
                            #of_row(s, s.plans.#table.row(#key as usize))
                        }
                        #whole
                    };
                }
                quote! {
                    pub fn #name(s: &State<'_> #(, #parameters)*) -> rt::Fallible<#ty> { #guard #prelude #row #body }
                    #whole
                }
            }
        }
    }

    /// What a function over the state starts with: the topology, and a local name for each sequence that it uses.
    pub(super) fn prelude(&self, bodies: &[ExprId]) -> TokenStream {
        let mut used = BTreeSet::new();
        for body in bodies {
            crate::optimize::reachable(&self.program().arena, *body, &mut |kind| {
                if let Kind::Input(id) = kind
                    && matches!(self.program().input(*id).ty, Type::Sequence { .. })
                {
                    used.insert(*id);
                }
            });
        }
        let fields: Vec<_> = used.into_iter().map(|id| self.input_field(id)).collect();
        quote! {
            let t = &s.topology;
            let sizes = &s.sizes;
            #(let #fields = s.#fields.as_ref();)*
        }
    }

    /// What the host may call: definitions, and functions by name.
    pub(super) fn exports(&self) -> (Vec<GlobalId>, Vec<(String, Vec<FunctionId>)>) {
        let mut globals = Vec::new();
        let mut functions: Vec<(String, Vec<FunctionId>)> = Vec::new();
        for export in &self.program().exports {
            match export {
                Export::Global(id) => globals.push(*id),
                Export::Function(id) => {
                    let name = &self.program().function(*id).name;
                    match functions.iter_mut().find(|(n, _)| n == name) {
                        Some((_, list)) => list.push(*id),
                        None => functions.push((name.clone(), vec![*id])),
                    }
                }
            }
        }
        (globals, functions)
    }
}
