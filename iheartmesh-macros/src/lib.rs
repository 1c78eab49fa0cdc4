//! The procedural macros behind `iheartmesh!`: the Rust side of a call, the places of its source text, the modules
//! that it imports, and the errors as rustc shows them. The language itself is compiled by `iheartmesh-compiler`.
//!
//! Users call `iheartmesh::iheartmesh!`, where everything is documented. What arrives here is that call with three
//! paths in front: what generated code runs on, where these macros are, and where the standard modules are. The
//! facade gives them with `$crate`, so that it may be renamed.
//!
//! | file | does |
//! | --- | --- |
//! | `invocation` | reads `use` lines and `struct Name = …;` items, with every error at its token |
//! | `literal`, `body` | what the source text of a module is, and where each character of it stands in the file |
//! | `module`, `exports` | a source on its way from one macro call to another |
//! | `collection` | what a call has in hand and still has to ask for |
//! | `libraries` | the modules that one module imports; circles, clashes, unknown names |
//! | `report` | errors, warnings, and a stand-in for an item with errors |
//! | `expansion` | the steps in order |

mod body;
mod collection;
mod error;
mod expansion;
mod exports;
mod invocation;
mod libraries;
mod literal;
mod module;
mod report;
mod switches;

use proc_macro::TokenStream;

/// Compiles modules, or asks first for the modules that they import: `[krate] [macros] [standard] call…`.
#[doc(hidden)]
#[proc_macro]
pub fn expand(tokens: TokenStream) -> TokenStream {
    expansion::expand(tokens.into()).into()
}

/// Takes the answer of an imported module and goes on: `{answer} [krate] [macros] [standard] [state]… call…`.
#[doc(hidden)]
#[proc_macro]
pub fn resume(tokens: TokenStream) -> TokenStream {
    expansion::resume(tokens.into()).into()
}
