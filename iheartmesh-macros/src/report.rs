//! What the user gets to see: errors, warnings, and a stand-in for an item that has errors.

use crate::body::Body;
use crate::error::Error;
use crate::invocation::Header;
use iheartmesh_compiler::diagnostic::{Diagnostic, Severity};
use proc_macro2::{Span, TokenStream};
use quote::{format_ident, quote, quote_spanned};

/// An error marked at `span`.
///
/// In braces: rustc adds an error of its own to the form with parentheses where items stand.
pub fn error(span: Span, message: &str) -> TokenStream {
    let message = message.strip_prefix("error: ").unwrap_or(message);
    quote_spanned!(span=> ::core::compile_error! { #message })
}

/// An error of the call as a whole.
pub fn call_error(found: &Error) -> TokenStream {
    error(found.span, &found.message)
}

/// A warning or note at `span`: on stable Rust, the use of a deprecated constant is the one warning that a macro
/// can word itself.
pub fn remark(span: Span, severity: Severity, message: &str) -> TokenStream {
    let (name, prefix) = match severity {
        Severity::Note => ("NOTE", "note: "),
        _ => ("WARNING", "warning: "),
    };
    let name = proc_macro2::Ident::new(name, span);
    let message = message.strip_prefix(prefix).unwrap_or(message);
    quote_spanned! {span=>
        const _: () = {
            #[deprecated(note = #message)]
            const #name: () = ();
            #name
        };
    }
}

/// One diagnostic of the compiler, marked at the token of `body` that it is about; `own` tells whether the place of
/// the diagnostic is in this body at all.
pub fn diagnostic(body: &Body, own: bool, found: &Diagnostic, rendered: &str) -> TokenStream {
    let (start, end) = match own {
        true => (found.span().start as usize, found.span().end as usize),
        false => (0, 0),
    };
    let span = body.span(start, end);
    match found.severity {
        Severity::Error => error(span, rendered),
        severity => remark(span, severity, rendered),
    }
}

/// Stands in for items that have errors, together with the errors.
///
/// rustc is silent about a name that it cannot find in a module which holds a `compile_error!`, and about
/// everything that is done with it afterwards. So the item becomes an alias of a type that is missing from such a
/// module: `use m::Name`, `Name::new(…)?`, fields of that type and calls of its methods all pass, and what is left
/// is exactly our own errors. A struct without methods would not do: calling `new` on it is one more error. A
/// re-export would not do either, since a macro of the same name stands beside the item (see `exports`).
///
/// All items of a call share one such module, since an item may have no error of its own: what is wrong with it was
/// said about another one.
pub fn failed(stand_ins: &[&Header], errors: &TokenStream) -> TokenStream {
    let Some(first) = stand_ins.first() else {
        return errors.clone();
    };
    let module = format_ident!("__ihm_errors_of_{}", first.name);
    let aliases = stand_ins.iter().map(|stand_in| {
        let Header {
            visibility, name, ..
        } = stand_in;
        quote! {
            #[doc(hidden)]
            #[allow(dead_code, missing_docs, non_camel_case_types, private_interfaces, unreachable_pub)]
            #visibility type #name<'a> = #module::#name<'a>;
        }
    });
    quote! {
        #[doc(hidden)]
        #[allow(non_snake_case)]
        mod #module {
            #errors
        }
        #(#aliases)*
    }
}
