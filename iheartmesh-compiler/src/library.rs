//! The texts of imported modules, parsed before the module that imports them.

use std::collections::BTreeMap;
use std::rc::Rc;

use crate::diagnostic::Diagnostics;
use crate::source::{Source, Sources};
use crate::span::SourceId;
use crate::syntax::{self, Export, ImportedNames, ast, builtin};

/// A module that can be imported.
#[derive(Clone, Debug)]
pub struct Library {
    /// Its name after `from`.
    pub name: String,
    /// Its text.
    pub source: Source,
}

/// The modules that a text imports and that are not built in, in order, each once.
pub fn imported_modules(source: &Source) -> Vec<String> {
    let mut names = Vec::new();
    for import in syntax::imports(source, SourceId(0)) {
        let name = import.module.text;
        if builtin::exports(&name).is_none() && !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

/// The trees of a program.
pub(crate) struct Parsed {
    pub(crate) main: Rc<ast::Module>,
    pub(crate) libraries: BTreeMap<String, Rc<ast::Module>>,
}

/// Parses a module and all that it imports. The module itself has the first id.
pub(crate) fn parse_all(
    source: Source,
    libraries: &[Library],
    sources: &mut Sources,
    diagnostics: &mut Diagnostics,
) -> Parsed {
    let main_id = sources.add(source.clone());
    let mut parser = Parser {
        available: libraries,
        sources,
        diagnostics,
        parsed: BTreeMap::new(),
        open: Vec::new(),
    };
    parser.needs(&source, main_id);
    let names = Names(&parser.parsed);
    let (main, found) = syntax::parse(&source, main_id, &names);
    let parsed = parser.parsed;
    diagnostics.extend(found);
    Parsed {
        main: Rc::new(main),
        libraries: parsed,
    }
}

/// The canonical text of a module in one of the spellings, as [`syntax::format()`] makes it; which imported names are
/// functions follows from the modules that it imports.
///
/// # Errors
/// The diagnostics of a text with mistakes, and the texts that they point into.
pub fn format(
    source: Source,
    libraries: &[Library],
    spelling: syntax::print::Spelling,
) -> Result<String, (Diagnostics, Sources)> {
    let mut sources = Sources::default();
    let id = sources.add(source.clone());
    // mistakes of imported modules are no reason to leave this one as it is
    let mut ignored = Diagnostics::default();
    let mut parser = Parser {
        available: libraries,
        sources: &mut sources,
        diagnostics: &mut ignored,
        parsed: BTreeMap::new(),
        open: Vec::new(),
    };
    parser.needs(&source, id);
    let parsed = parser.parsed;
    syntax::format(&source, id, &Names(&parsed), spelling)
        .map_err(|diagnostics| (diagnostics, sources))
}

struct Parser<'a> {
    available: &'a [Library],
    sources: &'a mut Sources,
    diagnostics: &'a mut Diagnostics,
    parsed: BTreeMap<String, Rc<ast::Module>>,
    open: Vec<String>,
}

impl Parser<'_> {
    /// Parses what a text imports.
    fn needs(&mut self, source: &Source, id: SourceId) {
        for import in syntax::imports(source, id) {
            let name = import.module.text;
            if self.parsed.contains_key(&name) || self.open.contains(&name) {
                continue;
            }
            let Some(library) = self.available.iter().find(|l| l.name == name) else {
                continue;
            };
            self.open.push(name.clone());
            let id = self.sources.add(library.source.clone());
            self.needs(&library.source, id);
            let (module, found) = syntax::parse(&library.source, id, &Names(&self.parsed));
            self.diagnostics.extend(found);
            self.parsed.insert(name, Rc::new(module));
            self.open.pop();
        }
    }
}

struct Names<'a>(&'a BTreeMap<String, Rc<ast::Module>>);

impl ImportedNames for Names<'_> {
    fn exports(&self, module: &str) -> Option<Vec<Export>> {
        self.0
            .get(module)
            .map(|module| syntax::export_names(module))
    }
}
