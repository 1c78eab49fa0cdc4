//! From a staged program to Rust.
//!
//! The generated code is one struct and one private module beside it. In that module a `Topology` holds the meshes,
//! `Plans` what is computed once per mesh, and `State` both with the values; every function of the program is
//! one small Rust function over them. Only paths under the crate's own path are named.

mod array;
mod assemble;
mod block;
mod check;
mod docs;
mod expr;
mod heads;
mod into;
mod item;
mod item_size;
mod local;
mod member;
mod method;
pub mod names;
mod optimum;
mod orbit;
pub mod place;
mod plan;
mod set;
mod setter;
mod size;
mod slot_blocks;
mod slot_finder;
mod slot_locals;
mod slot_sums;
mod slot_terms;
mod slot_units;
mod slots;
mod steps;
mod tabulate;
mod taken;
mod tie;
mod together;
mod types;

pub use names::{ascii_alias, rust_name};

use std::collections::BTreeMap;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::diagnostic::Diagnostics;
use crate::ir::{ExprId, FunctionId, GlobalId, Input, InputId, Program};
use crate::optimize::StagedProgram;
use crate::source::Sources;
use crate::types::MeshId;

/// What the Rust side of the macro says about the struct.
#[derive(Clone, Debug)]
pub struct Header {
    /// Name of the struct.
    pub name: Ident,
    /// Its visibility.
    pub visibility: TokenStream,
    /// Its attributes: the user's documentation.
    pub attributes: TokenStream,
    /// Path of the crate that generated code names.
    pub krate: TokenStream,
    /// The text of the program.
    pub source: String,
}

/// A method of definitions that are asked for together, whose name is taken.
#[derive(Clone, Debug)]
pub struct Clash {
    /// Which of [`Program::together`].
    pub list: usize,
    /// The name.
    pub method: String,
    /// What has it.
    pub other: String,
}

/// The items that a program becomes. Clashes of Rust names are reported.
pub fn emit(
    staged: &StagedProgram,
    sources: &Sources,
    header: &Header,
    diagnostics: &mut Diagnostics,
    clashes: &mut Vec<Clash>,
) -> TokenStream {
    let mut context = Context {
        staged,
        sources,
        krate: &header.krate,
        module: format_ident!("__ihm_{}", header.name),
        may_fail: crate::optimize::MayFail::of(&staged.program),
        slot_sums: BTreeMap::new(),
    };
    context.slot_sums = context.find_slot_sums();
    item::items(&context, header, diagnostics, clashes)
}

/// What every part of the emitter needs.
struct Context<'a> {
    staged: &'a StagedProgram,
    sources: &'a Sources,
    krate: &'a TokenStream,
    /// The private module.
    module: Ident,
    may_fail: crate::optimize::MayFail,
    /// Sums of blocks with planned places.
    slot_sums: BTreeMap<GlobalId, slots::SlotSum>,
}

impl Context<'_> {
    fn program(&self) -> &Program {
        &self.staged.program
    }

    fn is_static_function(&self, id: FunctionId) -> bool {
        self.staged.static_functions[id.0 as usize]
    }

    fn is_static_global(&self, id: GlobalId) -> bool {
        self.staged.static_globals[id.0 as usize]
    }

    /// The Rust function of a function of the program.
    fn function_name(&self, id: FunctionId) -> Ident {
        let name = names::rust_name(&self.program().function(id).name);
        format_ident!("f{}_{}", id.0, name)
    }

    /// The Rust function that computes a definition.
    fn global_name(&self, id: GlobalId) -> Ident {
        let name = names::rust_name(&self.program().global(id).name);
        format_ident!("g{}_{}", id.0, name)
    }

    fn mesh_field(&self, mesh: MeshId) -> Ident {
        let name = names::rust_name(&self.program().mesh(mesh).name);
        format_ident!("mesh{}_{}", mesh.0, name)
    }

    fn input_field(&self, id: InputId) -> Ident {
        let name = names::rust_name(&self.program().input(id).name);
        format_ident!("input{}_{}", id.0, name)
    }

    /// Inputs other than meshes, in order of declaration.
    fn values(&self) -> impl Iterator<Item = (InputId, &Input)> {
        let program = self.program();
        program
            .input_order
            .iter()
            .map(|id| (*id, program.input(*id)))
            .filter(|(_, input)| !matches!(input.ty, crate::types::Type::Mesh(..)))
    }

    /// What is said when an expression fails: its text and place.
    fn site(&self, e: ExprId) -> TokenStream {
        let what = crate::ir::failure(self.program(), self.outermost(e));
        self.site_because(e, what)
    }

    /// The tuple that an expression is an item of, or itself: an item fails where the tuple does.
    fn outermost(&self, e: ExprId) -> ExprId {
        let mut e = e;
        while let crate::ir::Kind::Project(tuple, _) = self.program().arena.kind(e) {
            e = *tuple;
        }
        e
    }

    /// A call of an imported function says itself why it has no value: what is missing further in stands in another text.
    fn because_of_call(&self, call: ExprId) -> Option<TokenStream> {
        let arena = &self.program().arena;
        let crate::ir::Kind::Call(id, _) = arena.kind(call) else {
            return None;
        };
        let function = self.program().function(*id);
        let source = arena.origin(call)?.source;
        if source == function.span.source || !self.may_fail.function(*id) {
            return None;
        }
        let site = self.site(call);
        Some(quote!(.map_err(|_| #site)))
    }

    /// What is said when an expression fails for this reason.
    fn site_because(&self, e: ExprId, what: String) -> TokenStream {
        let e = self.outermost(e);
        let text = match self.program().arena.origin(e) {
            Some(span) => {
                let source = self.sources.get(span.source);
                let (line, column) = source.line_column(span.start);
                let written = self
                    .sources
                    .text(span)
                    .split_whitespace()
                    .collect::<Vec<_>>()
                    .join(" ");
                let written: String = match written.chars().count() {
                    0..=60 => written,
                    _ => written.chars().take(59).chain(['…']).collect(),
                };
                format!("{what} in `{written}` ({}:{line}:{column})", source.file)
            }
            None => what.trim_end_matches([',', ':']).to_owned(),
        };
        quote!(rt::Fault::new(#text))
    }
}
