//! From symbols to the typed intermediate language.
//!
//! Checking is driven by demand: the compiled module is checked in full, of an imported module only what is used.
//! An expression in error has the type [`Type::Error`], which agrees with everything, so that one cause gives one
//! message. **Invariant:** when no error was reported, later stages meet no mistake of the user any more.

mod arguments;
mod attribute;
mod builtin;
mod call;
mod cell;
mod chain;
mod condition;
mod declare;
mod define;
mod derivative;
mod dimension;
mod elementwise;
mod entries;
mod expr;
mod extent;
mod fold;
mod function;
mod host;
mod index;
mod integral;
mod linear;
mod matrix;
mod norm;
mod operator;
mod optimum;
mod product;
mod recursion;
mod restriction;
mod scope;
mod search;
mod set;
mod single;
mod sizes;
mod sparse;
mod subscript;
mod variable;
mod wording;

use std::collections::{BTreeMap, BTreeSet};

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::ir::{Export, ExprId, FunctionId, GlobalId, Kind, Program, VariableId};
use crate::resolve::{ModuleId, Resolved};
use crate::span::Span;
use crate::syntax::ast::ItemKind;
use crate::types::Type;

use function::Signature;
use scope::Scope;

/// Checks the compiled module of `resolved` and what it uses of the others.
pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) -> Program {
    let mut checker = Checker {
        resolved,
        diagnostics,
        program: Program::default(),
        module: ModuleId(0),
        scopes: Vec::new(),
        inputs: BTreeMap::new(),
        declaring: BTreeSet::new(),
        definitions: BTreeMap::new(),
        functions: BTreeMap::new(),
        signatures: BTreeMap::new(),
        results: BTreeMap::new(),
        recursion: recursion::Recursion::default(),
        templates: BTreeMap::new(),
        ragged: BTreeMap::new(),
        item_sizes: BTreeMap::new(),
        results_of_calls: BTreeMap::new(),
        letter: None,
        index_uses: BTreeMap::new(),
        index_items: BTreeMap::new(),
        all_elements: BTreeSet::new(),
        guarded: false,
        given: BTreeSet::new(),
        n_dynamic: 0,
        plus_minus: None,
        circular: false,
        misfits: BTreeSet::new(),
    };
    checker.find_ragged();
    checker.declare_inputs();
    checker.check_sizes();
    checker.check_arguments();
    checker.module_items();
    checker.untyped();
    checker.program
}

/// What is known of a definition without parameters.
#[derive(Clone, Debug)]
enum Definition {
    /// It is being checked.
    Open,
    /// The value of each target.
    Done(Vec<ExprId>),
}

struct Checker<'a> {
    resolved: &'a Resolved,
    diagnostics: &'a mut Diagnostics,
    program: Program,
    /// The module instance that the current expression belongs to.
    module: ModuleId,
    scopes: Vec<Scope<'a>>,
    /// Values of the inputs, by item, declaration and target.
    inputs: BTreeMap<(usize, usize, usize), ExprId>,
    /// Inputs whose declaration has been looked at.
    declaring: BTreeSet<(usize, usize, usize)>,
    definitions: BTreeMap<(ModuleId, usize), Definition>,
    functions: BTreeMap<(ModuleId, usize), FunctionId>,
    signatures: BTreeMap<(ModuleId, usize), Signature>,
    /// Types of the results of the functions that are known so far.
    results: BTreeMap<FunctionId, Type>,
    /// Functions whose types are not settled.
    recursion: recursion::Recursion<'a>,
    /// Whether a definition needs its own value, which has been reported.
    circular: bool,
    /// Arguments of imported modules that do not fit, which has been reported.
    misfits: BTreeSet<(ModuleId, String)>,
    /// Sizes that the arguments of the function being checked bring along.
    templates: BTreeMap<String, ExprId>,
    /// Sizes that differ from item to item of a parameter of the module: the parameter and which of its sizes.
    ragged: BTreeMap<String, ((usize, usize, usize), u8)>,
    /// Sequences of the sizes of items: of which sequence, and which size.
    item_sizes: BTreeMap<ExprId, (ExprId, u8)>,
    /// Types of the results of calls with sizes that are known only at run time.
    results_of_calls: BTreeMap<(FunctionId, Vec<ExprId>, Type), Type>,
    /// The subscript of the declaration at hand.
    letter: Option<String>,
    /// For indices whose range follows from their use: where they index, with the size there.
    index_uses: BTreeMap<VariableId, Vec<IndexUse>>,
    /// Indices that are items of a pair, with the variables under which their uses are noted.
    index_items: BTreeMap<ExprId, VariableId>,
    /// Indices that run over all elements of a kind.
    all_elements: BTreeSet<VariableId>,
    /// Whether what is checked may have a value although another expression in the same definition has none: a case.
    guarded: bool,
    /// Symbols of sizes that parameters give.
    given: BTreeSet<String>,
    n_dynamic: u32,
    /// What `±` stands for in the comparison that is being checked, and how often it stands there.
    plus_minus: Option<(crate::ir::Binary, u32)>,
}

/// A place where an index stands alone as a subscript.
#[derive(Clone, Debug)]
struct IndexUse {
    size: ExprId,
    dimension: crate::types::Dimension,
    of_sequence: bool,
    span: Span,
    shown: String,
}

impl<'a> Checker<'a> {
    fn report(&mut self, diagnostic: Diagnostic) -> ExprId {
        self.diagnostics.push(diagnostic);
        self.error()
    }

    /// An expression in error.
    fn error(&mut self) -> ExprId {
        self.program.arena.add(Kind::Fail, Type::Error)
    }

    #[track_caller]
    fn unsupported(&mut self, span: Span, what: &str) -> ExprId {
        self.report(
            Diagnostic::error(span, format!("{what} not supported yet"))
                .help("the language reference says what this version compiles"),
        )
    }

    fn ty(&self, e: ExprId) -> &Type {
        self.program.arena.ty(e)
    }

    fn is_error(&self, e: ExprId) -> bool {
        self.ty(e).is_error()
    }

    fn is_function(&self, e: ExprId) -> bool {
        match self.ty(e) {
            Type::Function { .. } => true,
            Type::Sequence { item, .. } => matches!(**item, Type::Function { .. }),
            _ => false,
        }
    }

    /// Whether it is in error: an empty set, whose type follows from its place, is not.
    fn is_wrong(&self, e: ExprId) -> bool {
        self.is_error(e) && !self.is_empty_set(e)
    }

    fn add(&mut self, kind: Kind, ty: Type) -> ExprId {
        self.program.arena.add(kind, ty)
    }

    /// Adds an expression that may fail at run time, noting where it stands for the message.
    fn add_at(&mut self, span: Span, kind: Kind, ty: Type) -> ExprId {
        let e = self.program.arena.add(kind, ty);
        self.program.arena.note_origin(e, span);
        e
    }

    /// Checks all items of the compiled module, in order of the text.
    fn module_items(&mut self) {
        let module = self.resolved.module(ModuleId(0));
        let items = &module.syntax.items;
        let last = items
            .iter()
            .rposition(|item| matches!(item.kind, ItemKind::Expression(_)));
        for (index, item) in items.iter().enumerate() {
            match &item.kind {
                ItemKind::Import(_) | ItemKind::Parameters(_) => {}
                ItemKind::Function(_) => {
                    let function = self.function(ModuleId(0), index);
                    self.program.exports.push(Export::Function(function));
                }
                // its value has what the first one of this name adds up to
                ItemKind::Definition(definition)
                    if definition.targets.iter().any(|t| {
                        let further = module.further.get(&t.name.text);
                        further.is_some_and(|items| items.contains(&index))
                    }) => {}
                ItemKind::Definition(definition) => {
                    let values = self.definition(ModuleId(0), index);
                    for (target, value) in definition.targets.iter().zip(values) {
                        // another name of a function is no value of its own
                        if self.is_error(value) || self.is_function(value) {
                            continue;
                        }
                        self.export_global(&target.name.text, value, item.span);
                    }
                }
                ItemKind::Expression(expr) => {
                    let value = self.expr(expr);
                    if self.is_error(value) {
                        continue;
                    }
                    if Some(index) != last {
                        self.report(
                            Diagnostic::error(item.span, "the value of this expression is not used")
                                .help("give it a name, as in `y = …`; a module has one value without a name, `ret()`, the last such"),
                        );
                        continue;
                    }
                    self.export_global("ret", value, item.span);
                }
            }
        }
    }

    /// Reports definitions without a type, if nothing else was reported.
    fn untyped(&mut self) {
        if self.diagnostics.has_errors() {
            return;
        }
        let functions = self.program.functions.iter().map(|f| (&f.ty, f.span));
        let arena = &self.program.arena;
        let globals = self
            .program
            .globals
            .iter()
            .map(|g| (arena.ty(g.value), g.span));
        let mut untyped = functions.chain(globals).filter(|(ty, _)| ty.is_error());
        if let Some((_, span)) = untyped.next() {
            self.report(
                Diagnostic::error(span, "the type of `{}` is not known here").help(
                    "the type of `{}` follows from the set that it is put together with, as in `S ∪ {}`",
                ),
            );
        }
    }

    fn export_global(&mut self, name: &str, value: ExprId, span: Span) {
        let known = self
            .program
            .globals
            .iter()
            .position(|g| g.span == span && g.name == name);
        let id = known.unwrap_or_else(|| {
            self.program.globals.push(crate::ir::Global {
                name: name.to_owned(),
                value,
                span,
            });
            self.program.globals.len() - 1
        });
        self.program
            .exports
            .push(Export::Global(GlobalId(id as u32)));
    }
}
