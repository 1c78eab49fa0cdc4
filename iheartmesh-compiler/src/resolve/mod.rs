//! From syntax trees to symbols: which modules there are, what each name stands for, in which order definitions
//! depend on each other.
//!
//! A module that is imported is *instantiated*: its parameters are bound to symbols of the importing module, and the
//! same module with the same arguments is one instance. **Invariant:** after this stage every name of a
//! module is bound or has been reported.

mod dump;
mod imports;
pub mod names;
mod order;
pub mod symbols;
mod unknown;

use std::collections::BTreeMap;
use std::rc::Rc;

pub use dump::dump;
pub use symbols::resolve;

use crate::span::Span;
use crate::syntax::ast;

/// Index of a module instance; 0 is the module that is compiled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ModuleId(pub u32);

/// What a name of a module stands for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Meaning {
    /// A parameter handed in by the host: item, declaration and target in it.
    Parameter {
        /// Index of the item.
        item: usize,
        /// Index of the declaration in the block.
        declaration: usize,
        /// Index of the target in the declaration.
        target: usize,
    },
    /// A parameter of an imported module: the symbol of the importing module that stands for it.
    Argument(ModuleId, String),
    /// A size declared by its use in a type.
    Dimension,
    /// A definition without parameters: item, and which of its left-hand sides.
    Definition {
        /// Index of the item.
        item: usize,
        /// Index of the target.
        target: usize,
    },
    /// Functions with this name: items of this module.
    Functions(Vec<usize>),
    /// A symbol of another module.
    Import(ModuleId, String),
    /// A name of a built-in module.
    Builtin(String),
}

/// A name of a module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symbol {
    /// What it stands for; several only for functions that overload each other.
    pub meanings: Vec<Meaning>,
    /// Where it is declared first.
    pub span: Span,
}

/// An instance of a module.
#[derive(Clone, Debug)]
pub struct Module {
    /// Its name; the compiled module has the name of the struct.
    pub name: String,
    /// Its syntax tree.
    pub syntax: Rc<ast::Module>,
    /// Its names.
    pub symbols: BTreeMap<String, Symbol>,
    /// Its definitions and functions, by item, each after those that it depends on.
    pub order: Vec<usize>,
    /// For a name the items below its first definition that define entries of it or add to it, in order of the text.
    pub further: BTreeMap<String, Vec<usize>>,
    /// Names that are declared and then defined entry by entry: the item, declaration and target that declare them.
    pub declared: BTreeMap<String, (usize, usize, usize)>,
}

/// All module instances.
#[derive(Clone, Debug, Default)]
pub struct Resolved {
    /// By [`ModuleId`].
    pub modules: Vec<Module>,
}

impl Resolved {
    /// A module instance.
    pub fn module(&self, id: ModuleId) -> &Module {
        &self.modules[id.0 as usize]
    }
}
