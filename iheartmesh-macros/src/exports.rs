//! The macros that hand a module's source on.
//!
//! A procedural macro sees its own tokens and nothing else of the program, but it may call other macros. So beside
//! each struct stands a `macro_rules!` macro of the same name, which calls back with the source. Two are needed:
//!
//! - the *source macro*, emitted at once, before the modules that this one imports are known. Since it does not wait
//!   for anything, modules that import each other in a circle are found by us and do not leave rustc stuck. It names
//!   the needed modules by their paths, which hold in the same crate;
//! - the *bundle*, emitted at the end with the sources of all the needed modules. Other crates ask for this one: they
//!   may not know the crates that this crate knows, nor reach its private modules.

use crate::collection::{Collection, Context};
use crate::invocation::{Header, Item};
use crate::module::{Module, Need, Route};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote, quote_spanned};

/// Tells apart the crates of a program, as far as a macro can know it.
pub fn crate_identity() -> String {
    let parts = [
        "CARGO_PKG_NAME",
        "CARGO_PKG_VERSION",
        "CARGO_CRATE_NAME",
        "CARGO_BIN_NAME",
    ];
    let values: Vec<_> = parts.iter().filter_map(|p| std::env::var(p).ok()).collect();
    values.join(" ")
}

fn bundle_name(module: &Module) -> Ident {
    format_ident!("__ihm_bundle_{}_{}", module.name, module.id)
}

/// Whether a call in another crate has to ask for the bundle.
fn has_bundle(header: &Header, modules: &[&Module]) -> bool {
    let leads_away = |need: &Need| matches!(need.route, Route::Path(_) | Route::Closed(_));
    header.is_public() && modules.iter().any(|m| m.needs.iter().any(leads_away))
}

/// The source macro of an item, of the name and the visibility of the item.
pub fn source_macro(item: &Item, module: &Module, of_call: &[Module]) -> TokenStream {
    let modules = beside(module, of_call);
    let answers: Vec<_> = modules
        .iter()
        .map(|m| with_dollar_crate(m).write())
        .collect();
    let bundle = has_bundle(&item.header, &modules).then(|| {
        let bundle = bundle_name(module);
        let own_crate = dollar_crate(item.header.name.span());
        quote!(#own_crate::#bundle)
    });
    let Header {
        visibility, name, ..
    } = &item.header;
    let source = format_ident!("__ihm_source_{}_{}", module.name, module.id);
    let definition = answering(
        &source,
        item.header.is_public(),
        &quote!({#bundle} #(#answers)*),
    );
    quote! {
        #definition
        #[doc(hidden)]
        #[allow(unused_imports, unreachable_pub)]
        #visibility use #source as #name;
    }
}

/// The bundle of an item, if other crates have any use for it.
pub fn bundle(
    item: &Item,
    module: &Module,
    of_call: &[Module],
    collection: &Collection,
) -> TokenStream {
    if !has_bundle(&item.header, &beside(module, of_call)) {
        return TokenStream::new();
    }
    let mut found: Vec<Module> = Vec::new();
    let mut waiting = vec![module];
    while let Some(next) = waiting.pop() {
        if found.iter().any(|m| m.id == next.id) {
            continue;
        }
        let mut closed = next.clone();
        for need in &mut closed.needs {
            if matches!(need.route, Route::Standard) {
                continue;
            }
            if let Some(target) = collection.find(of_call, next, need) {
                need.route = Route::Known(target.id.clone());
                waiting.push(target);
            }
        }
        found.push(closed);
    }
    let answers = found.iter().map(Module::write);
    answering(&bundle_name(module), true, &quote!({} #(#answers)*))
}

/// A macro that gives an answer to the macro that is named in its call, along with the rest of the call.
fn answering(name: &Ident, exported: bool, answer: &TokenStream) -> TokenStream {
    let export = exported.then(|| quote!(#[macro_export]));
    let own_crate = crate_identity();
    quote! {
        #[doc(hidden)]
        #[allow(unused_macros, non_local_definitions)]
        #export
        macro_rules! #name {
            ([$($callback:tt)*] $($waiting:tt)*) => {
                $($callback)* ! { { #own_crate #answer } $($waiting)* }
            };
        }
    }
}

/// The call of another module's macro, which will call `resume` with its source.
pub fn question(path: &TokenStream, context: &Context, waiting: &TokenStream) -> TokenStream {
    let macros = &context.macros;
    quote!(#path ! { [#macros::resume] #waiting })
}

/// A module and all modules of its call that it needs.
fn beside<'a>(module: &'a Module, of_call: &'a [Module]) -> Vec<&'a Module> {
    let mut found = vec![module];
    let mut next = 0;
    while let Some(module) = found.get(next).copied() {
        for need in &module.needs {
            if let Route::Known(id) = &need.route
                && found.iter().all(|m| m.id != *id)
            {
                found.extend(of_call.iter().find(|m| m.id == *id));
            }
        }
        next += 1;
    }
    found
}

/// `$crate` for the macros of this crate.
///
/// It has to look like a token of the user: rustc resolves a `$crate` that comes from here, inside of the facade's
/// macro, to the facade.
fn dollar_crate(user: Span) -> TokenStream {
    quote_spanned!(user=> $crate)
}

/// The module with paths that hold in the macros of this crate wherever they are called.
fn with_dollar_crate(module: &Module) -> Module {
    let mut module = module.clone();
    for need in &mut module.needs {
        if let Route::Path(path) = &mut need.route {
            let mut tokens = path.clone().into_iter().peekable();
            let own = tokens.next_if(|t| t.to_string() == "crate");
            let own = own.map(|token| dollar_crate(token.span()));
            *path = own.into_iter().flatten().chain(tokens).collect();
        }
    }
    module
}
