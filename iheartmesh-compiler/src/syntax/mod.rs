//! From text to syntax tree.
//!
//! The language depends on declared names, blanks and bars, so lexer and parser are written by hand: [`parse`] lexes
//! the text, settles what each line break means, collects the declared names, splits runs of letters by them, and
//! reads the items by recursive descent. It is total: any text gives a tree and diagnostics, in time proportional to
//! its length, and no tree is higher than [`MOST_HEIGHT`].

pub mod ast;
pub mod builtin;
mod copies;
mod dump;
mod export;
mod format;
mod import_names;
mod layout;
mod letters;
mod lexer;
mod names;
mod parser;
pub mod print;
pub mod spelling;
mod split;
mod strip;
mod suggest;
mod token;

pub use dump::dump;
pub use export::{export_names, export_names_with};
pub use format::format;
pub use strip::strip_spans;
pub use suggest::closest;

use crate::diagnostic::Diagnostics;
use crate::source::Source;
use crate::span::SourceId;

/// How deep brackets, prefixes and the like may be nested. Later stages walk trees recursively; so does the parser.
pub const MOST_NESTING: usize = 100;

/// How high a tree may be: the most operators that may follow one another in a row.
pub const MOST_HEIGHT: usize = 200;

/// After this many errors no more are reported.
const MOST_ERRORS: usize = 100;

/// A name that a module offers to the modules that import it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Export {
    /// The name.
    pub name: String,
    /// Whether it is a function, so that `name(` is a call.
    pub function: bool,
}

/// What the parser has to know of the modules that a text imports from.
pub trait ImportedNames {
    /// Every name that a module (not built in) exports; `None` when the module is unknown, and then each name
    /// that is imported from it counts as a function.
    fn exports(&self, module: &str) -> Option<Vec<Export>>;
}

/// No module is known besides the built-in ones.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoImports;

impl ImportedNames for NoImports {
    fn exports(&self, _module: &str) -> Option<Vec<Export>> {
        None
    }
}

/// Reads a text.
pub fn parse(
    source: &Source,
    id: SourceId,
    imports: &dyn ImportedNames,
) -> (ast::Module, Diagnostics) {
    let (module, diagnostics, _) = parser::parse(&source.text, id, imports);
    (module, diagnostics)
}

/// The imports of a text, before the modules that they name are known; says nothing about mistakes.
pub fn imports(source: &Source, id: SourceId) -> Vec<ast::Import> {
    parser::imports(&source.text, id)
}

/// How many steps the parser takes for a text; for the test that it takes few.
#[doc(hidden)]
pub fn count_steps(source: &Source) -> usize {
    parser::parse(&source.text, SourceId(0), &NoImports).2
}
