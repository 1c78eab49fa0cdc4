//! The compiler of I♥MESH: one plain library function for each stage.
//!
//! ```text
//! source ──syntax──▶ tree ──resolve──▶ symbols ──check──▶ typed IR ──optimize──▶ staged IR ──emit──▶ Rust
//! ```
//!
//! [`compile`] calls every stage in this order and does nothing else. It knows no mesh and no value: what runs is in the
//! runtime crate, whose paths the generated code names.

pub mod check;
pub mod derive;
pub mod diagnostic;
pub mod emit;
#[cfg(feature = "interpret")]
pub mod interpret;
pub mod ir;
mod library;
pub mod optimize;
pub mod render;
pub mod resolve;
pub mod source;
pub mod span;
pub mod syntax;
mod together;
pub mod types;

use std::rc::Rc;

use proc_macro2::{Ident, TokenStream};

pub use library::{Library, format, imported_modules};
pub use together::Misfit;

use diagnostic::Diagnostics;
use optimize::{Optimizations, StagedProgram};
use source::{Source, Sources};

/// What is compiled, and how.
#[derive(Clone, Debug)]
pub struct Request {
    /// Name of the struct.
    pub name: Ident,
    /// Its visibility.
    pub visibility: TokenStream,
    /// Its attributes, the user's documentation among them.
    pub attributes: TokenStream,
    /// Path of the crate that generated code names.
    pub krate: TokenStream,
    /// The program.
    pub source: Source,
    /// Modules that it imports, and those that these import.
    pub libraries: Vec<Library>,
    /// Which optimisations are made.
    pub optimizations: Optimizations,
    /// Definitions that are asked for at once, by the names of their methods.
    pub together: Vec<Vec<String>>,
}

/// What came of it.
#[derive(Debug, Default)]
pub struct Outcome {
    /// The generated items; `None` when there are errors.
    pub code: Option<TokenStream>,
    /// All messages, warnings and notes among them.
    pub diagnostics: Diagnostics,
    /// What is wrong with [`Request::together`].
    pub misfits: Vec<Misfit>,
    /// The texts that the messages point into.
    pub sources: Sources,
}

/// The program as every stage sees it.
#[derive(Debug)]
pub struct Stages {
    /// The syntax tree.
    pub syntax: Rc<syntax::ast::Module>,
    /// What names stand for.
    pub resolved: resolve::Resolved,
    /// The typed program; `None` when there are errors before.
    pub program: Option<ir::Program>,
    /// The optimised program; `None` when there are errors before.
    pub staged: Option<StagedProgram>,
    /// All messages so far.
    pub diagnostics: Diagnostics,
    /// What is wrong with names that are asked for together.
    pub misfits: Vec<Misfit>,
    /// The texts that the messages point into.
    pub sources: Sources,
}

/// Runs all stages up to the optimised program.
pub fn stages(
    name: &str,
    source: Source,
    libraries: &[Library],
    optimizations: Optimizations,
) -> Stages {
    stages_together(name, source, libraries, optimizations, &[])
}

/// Runs all stages up to the optimised program, in which some definitions are asked for at once, by the names of their methods.
pub fn stages_together(
    name: &str,
    source: Source,
    libraries: &[Library],
    optimizations: Optimizations,
    together: &[Vec<String>],
) -> Stages {
    let mut sources = Sources::default();
    let mut diagnostics = Diagnostics::default();
    let parsed = library::parse_all(source, libraries, &mut sources, &mut diagnostics);
    let resolved = resolve::resolve(
        name,
        Rc::clone(&parsed.main),
        &parsed.libraries,
        &mut diagnostics,
    );
    let mut program = check::check(&resolved, &mut diagnostics);
    let misfits = match diagnostics.has_errors() {
        true => Vec::new(),
        false => together::resolve(&mut program, together),
    };
    let correct = !diagnostics.has_errors() && misfits.is_empty();
    let staged = correct.then(|| {
        let mut program = program.clone();
        together::prepare(&mut program, optimizations);
        optimize::optimize(program, optimizations)
    });
    if let Some(staged) = &staged {
        for (name, span, n) in optimize::operations::many(staged) {
            let message = format!("`{name}` becomes {n} operations, which takes rustc long");
            diagnostics.push(diagnostic::Diagnostic::warning(span, message).help(
                "differentiate terms of fewer items, or by numbers that are linear in them, such as edges",
            ));
        }
    }
    Stages {
        syntax: parsed.main,
        resolved,
        program: correct.then_some(program),
        staged,
        diagnostics,
        misfits,
        sources,
    }
}

/// Compiles a program to Rust.
pub fn compile(request: Request) -> Outcome {
    let name = request.name.to_string();
    let text = request.source.text.clone();
    let mut stages = stages_together(
        &name,
        request.source,
        &request.libraries,
        request.optimizations,
        &request.together,
    );
    let mut clashes = Vec::new();
    let code = stages.staged.as_ref().map(|staged| {
        let header = emit::rust::Header {
            name: request.name,
            visibility: request.visibility,
            attributes: request.attributes,
            krate: request.krate,
            source: text,
        };
        emit::rust::emit(
            staged,
            &stages.sources,
            &header,
            &mut stages.diagnostics,
            &mut clashes,
        )
    });
    let mut misfits = stages.misfits;
    misfits.extend(clashes.into_iter().map(Misfit::from));
    Outcome {
        code: code.filter(|_| !stages.diagnostics.has_errors() && misfits.is_empty()),
        diagnostics: stages.diagnostics,
        misfits,
        sources: stages.sources,
    }
}
