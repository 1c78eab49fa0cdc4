//! Builds the symbol tables of a module and of all that it imports.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::names::{FreeNames, dimension_names, left_indices};
use super::{Meaning, Module, ModuleId, Resolved, Symbol, order};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::span::Span;
use crate::syntax::ast::{self, Definition, Function, Import, ItemKind, Name};
use crate::syntax::builtin;

/// Resolves the module `main`, importing from `libraries` by name.
pub fn resolve(
    name: &str,
    main: Rc<ast::Module>,
    libraries: &BTreeMap<String, Rc<ast::Module>>,
    diagnostics: &mut Diagnostics,
) -> Resolved {
    let mut resolver = Resolver {
        libraries,
        resolved: Resolved::default(),
        instances: BTreeMap::new(),
        open: vec![name.to_owned()],
        diagnostics,
    };
    resolver.instantiate(name, main, None);
    resolver.resolved
}

struct Resolver<'a> {
    libraries: &'a BTreeMap<String, Rc<ast::Module>>,
    resolved: Resolved,
    instances: BTreeMap<(String, Vec<(ModuleId, String)>), ModuleId>,
    open: Vec<String>,
    diagnostics: &'a mut Diagnostics,
}

impl Resolver<'_> {
    /// Adds an instance. With arguments it is imported, and they are what its parameters stand for.
    fn instantiate(
        &mut self,
        name: &str,
        syntax: Rc<ast::Module>,
        arguments: Option<&[(ModuleId, String)]>,
    ) -> ModuleId {
        let id = ModuleId(self.resolved.modules.len() as u32);
        let symbols = self.own_symbols(&syntax, arguments);
        self.resolved.modules.push(Module {
            name: name.to_owned(),
            syntax: Rc::clone(&syntax),
            symbols,
            order: Vec::new(),
        });
        for item in &syntax.items {
            if let ItemKind::Import(import) = &item.kind {
                self.import(id, import);
            }
        }
        self.check_names(id);
        let order = order::order(self.resolved.module(id), self.diagnostics);
        self.resolved.modules[id.0 as usize].order = order;
        id
    }

    fn own_symbols(
        &mut self,
        syntax: &ast::Module,
        arguments: Option<&[(ModuleId, String)]>,
    ) -> BTreeMap<String, Symbol> {
        let mut symbols: BTreeMap<String, Symbol> = BTreeMap::new();
        let mut n_parameters = 0;
        for (index, item) in syntax.items.iter().enumerate() {
            match &item.kind {
                ItemKind::Parameters(block) => {
                    for (declaration, d) in block.iter().enumerate() {
                        for (target, t) in d.targets.iter().enumerate() {
                            let meaning = match arguments {
                                None => Meaning::Parameter {
                                    item: index,
                                    declaration,
                                    target,
                                },
                                Some(list) => match list.get(n_parameters) {
                                    Some((module, name)) => {
                                        Meaning::Argument(*module, name.clone())
                                    }
                                    // a wrong number of arguments has been reported
                                    None => continue,
                                },
                            };
                            n_parameters += 1;
                            self.define(&mut symbols, &t.name, meaning);
                        }
                    }
                }
                ItemKind::Function(f) => {
                    self.define(&mut symbols, &f.name, Meaning::Functions(vec![index]));
                }
                ItemKind::Definition(d) => {
                    for (target, t) in d.targets.iter().enumerate() {
                        let known = symbols.contains_key(&t.name.text);
                        if known && (d.add || !t.subscripts.is_empty()) {
                            continue;
                        }
                        self.define(
                            &mut symbols,
                            &t.name,
                            Meaning::Definition {
                                item: index,
                                target,
                            },
                        );
                    }
                }
                ItemKind::Import(_) | ItemKind::Expression(_) => {}
            }
        }
        for item in &syntax.items {
            if let ItemKind::Parameters(block) = &item.kind {
                for d in block {
                    dimension_names(&d.ty, &mut |name| {
                        symbols.entry(name.text.clone()).or_insert_with(|| Symbol {
                            meanings: vec![Meaning::Dimension],
                            span: name.span,
                        });
                    });
                }
            }
        }
        symbols
    }

    fn define(&mut self, symbols: &mut BTreeMap<String, Symbol>, name: &Name, meaning: Meaning) {
        let Some(before) = symbols.get_mut(&name.text) else {
            symbols.insert(
                name.text.clone(),
                Symbol {
                    meanings: vec![meaning],
                    span: name.span,
                },
            );
            return;
        };
        let is_function = |m: &Meaning| {
            matches!(
                m,
                Meaning::Functions(_)
                    | Meaning::Import(..)
                    | Meaning::Builtin(_)
                    | Meaning::Argument(..)
            )
        };
        if before.meanings.iter().all(is_function) && is_function(&meaning) {
            if let (Some(Meaning::Functions(list)), Meaning::Functions(more)) =
                (before.meanings.last_mut(), &meaning)
            {
                list.extend(more);
            } else if !before.meanings.contains(&meaning) {
                before.meanings.push(meaning);
            }
            return;
        }
        self.diagnostics.push(
            Diagnostic::error(name.span, format!("`{}` is defined twice", name.text))
                .here("defined again here")
                .label(before.span, "defined here")
                .help("rename one of the two"),
        );
    }

    fn import(&mut self, importer: ModuleId, import: &Import) {
        let module = &import.module;
        if let Some(known) = builtin::exports(&module.text) {
            if let Some(argument) = import.arguments.first() {
                self.diagnostics.push(
                    Diagnostic::error(
                        argument.span,
                        format!("`{}` takes no arguments", module.text),
                    )
                    .help("its functions take the mesh as their argument, as in `ElementSets(M)`"),
                );
            }
            let known: Vec<String> = known.into_iter().map(|export| export.name).collect();
            self.link(importer, import, &known, |name| {
                Meaning::Builtin(name.to_owned())
            });
            return;
        }
        let Some(syntax) = self.libraries.get(&module.text).cloned() else {
            self.diagnostics.push(
                Diagnostic::error(module.span, format!("no module `{}` is known", module.text)).help(format!(
                    "bring it in with `use path::to::{};` in the macro, or put `{}.hlang` beside this file",
                    module.text, module.text
                )),
            );
            self.link_errors(importer, import);
            return;
        };
        if self.open.contains(&module.text) {
            self.diagnostics.push(
                Diagnostic::error(module.span, format!("`{}` imports itself", module.text)).help(
                    format!("the cycle is {} → {}", self.open.join(" → "), module.text),
                ),
            );
            self.link_errors(importer, import);
            return;
        }
        let Some(arguments) = self.arguments(importer, import, &syntax) else {
            self.link_errors(importer, import);
            return;
        };
        let key = (module.text.clone(), arguments.clone());
        let id = match self.instances.get(&key) {
            Some(&id) => id,
            None => {
                self.open.push(module.text.clone());
                let id = self.instantiate(&module.text, syntax, Some(&arguments));
                self.open.pop();
                self.instances.insert(key, id);
                id
            }
        };
        let known: Vec<String> = self.resolved.module(id).symbols.keys().cloned().collect();
        self.link(importer, import, &known, |name| {
            Meaning::Import(id, name.to_owned())
        });
    }

    /// The symbols that the arguments of an import stand for; `None` after an error.
    fn arguments(
        &mut self,
        importer: ModuleId,
        import: &Import,
        syntax: &ast::Module,
    ) -> Option<Vec<(ModuleId, String)>> {
        let parameters: Vec<&Name> = syntax
            .items
            .iter()
            .filter_map(|item| match &item.kind {
                ItemKind::Parameters(block) => Some(block),
                _ => None,
            })
            .flatten()
            .flat_map(|d| &d.targets)
            .map(|t| &t.name)
            .collect();
        if parameters.len() != import.arguments.len() {
            let names: Vec<_> = parameters.iter().map(|p| p.text.as_str()).collect();
            self.diagnostics.push(
                Diagnostic::error(
                    import.module.span,
                    format!(
                        "`{}` takes {} but is given {}",
                        import.module.text,
                        count(parameters.len(), "argument"),
                        import.arguments.len()
                    ),
                )
                .help(format!(
                    "its parameters are `{}({})`",
                    import.module.text,
                    names.join(", ")
                )),
            );
            return None;
        }
        let mut arguments = Vec::new();
        for argument in &import.arguments {
            let Some(symbol) = self.resolved.module(importer).symbols.get(&argument.text) else {
                self.unknown(importer, argument);
                return None;
            };
            arguments.push(match symbol.meanings.first() {
                Some(Meaning::Argument(module, name)) => (*module, name.clone()),
                _ => (importer, argument.text.clone()),
            });
        }
        Some(arguments)
    }

    fn link(
        &mut self,
        importer: ModuleId,
        import: &Import,
        known: &[String],
        meaning: impl Fn(&str) -> Meaning,
    ) {
        let mut symbols = std::mem::take(&mut self.resolved.modules[importer.0 as usize].symbols);
        match &import.names {
            None => {
                for name in known
                    .iter()
                    .filter(|n| !symbols.contains_key(*n))
                    .collect::<Vec<_>>()
                {
                    let local = Name {
                        text: name.clone(),
                        span: import.module.span,
                    };
                    self.define(&mut symbols, &local, meaning(name));
                }
            }
            Some(names) => {
                for name in names {
                    let local = name.rename.as_ref().unwrap_or(&name.name);
                    if !known.contains(&name.name.text) {
                        let help = match closest(&name.name.text, known) {
                            Some(close) => format!("did you mean `{close}`?"),
                            None => format!("it has {}", list(known)),
                        };
                        self.diagnostics.push(
                            Diagnostic::error(
                                name.name.span,
                                format!("`{}` has no `{}`", import.module.text, name.name.text),
                            )
                            .help(help),
                        );
                        self.define_error(&mut symbols, local);
                        continue;
                    }
                    self.define(&mut symbols, local, meaning(&name.name.text));
                }
            }
        }
        self.resolved.modules[importer.0 as usize].symbols = symbols;
    }

    /// Makes the names of a failed import known, so that their use gives no further error.
    fn link_errors(&mut self, importer: ModuleId, import: &Import) {
        let mut symbols = std::mem::take(&mut self.resolved.modules[importer.0 as usize].symbols);
        for name in import.names.iter().flatten() {
            self.define_error(&mut symbols, name.rename.as_ref().unwrap_or(&name.name));
        }
        self.resolved.modules[importer.0 as usize].symbols = symbols;
    }

    fn define_error(&mut self, symbols: &mut BTreeMap<String, Symbol>, name: &Name) {
        symbols.entry(name.text.clone()).or_insert_with(|| Symbol {
            meanings: Vec::new(),
            span: name.span,
        });
    }

    /// Reports every name that is not bound.
    fn check_names(&mut self, id: ModuleId) {
        let module = self.resolved.module(id);
        let syntax = Rc::clone(&module.syntax);
        let mut unknown: Vec<Name> = Vec::new();
        {
            let mut found = |name: &Name| {
                if !module.symbols.contains_key(&name.text)
                    && !builtin::ALWAYS.contains(&name.text.as_str())
                    && name.text != "I"
                {
                    unknown.push(name.clone());
                }
            };
            for item in &syntax.items {
                match &item.kind {
                    ItemKind::Import(_) => {}
                    ItemKind::Parameters(block) => {
                        let mut walk = FreeNames::new(Vec::new(), &mut found);
                        block.iter().for_each(|d| walk.declaration(d));
                    }
                    ItemKind::Function(f) => walk_function(f, &mut found),
                    ItemKind::Definition(d) => walk_definition(d, &mut found),
                    ItemKind::Expression(e) => FreeNames::new(Vec::new(), &mut found).expr(e),
                }
            }
        }
        for name in unknown {
            self.unknown(id, &name);
        }
    }

    fn unknown(&mut self, module: ModuleId, name: &Name) {
        let known: Vec<String> = self
            .resolved
            .module(module)
            .symbols
            .keys()
            .cloned()
            .collect();
        let help = match (closest(&name.text, &known), module_of(&name.text)) {
            (_, Some(module)) => format!("`{} from {module}` imports it", name.text),
            (Some(close), None) => format!("did you mean `{close}`?"),
            (None, None) => format!("declare it, as in `{} ∈ ℝ`, or define it", name.text),
        };
        self.diagnostics.push(
            Diagnostic::error(name.span, format!("`{}` is not defined", name.text)).help(help),
        );
    }
}

/// Walks the names that a function uses from outside.
pub fn walk_function(f: &Function, found: &mut dyn FnMut(&Name)) {
    let mut bound: Vec<String> = f.subscripts.iter().map(|n| n.text.clone()).collect();
    bound.extend(f.parameters.iter().flatten().map(|n| n.text.clone()));
    for d in &f.declarations {
        dimension_names(&d.ty, &mut |name| bound.push(name.text.clone()));
    }
    let mut walk = FreeNames::new(bound, found);
    f.declarations.iter().for_each(|d| walk.declaration(d));
    walk.locals(&f.locals, |walk| walk.expr(&f.body));
}

/// Walks the names that a definition uses from outside.
pub fn walk_definition(d: &Definition, found: &mut dyn FnMut(&Name)) {
    let bound = left_indices(d)
        .into_iter()
        .map(|n| n.text.clone())
        .collect();
    FreeNames::new(bound, found).expr(&d.value);
}

/// `1 argument`, `2 arguments`.
pub fn count(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}

fn list(names: &[String]) -> String {
    let names: Vec<_> = names.iter().take(12).map(|n| format!("`{n}`")).collect();
    names.join(", ")
}

/// The known name with the fewest edits, if they are few.
pub fn closest<'a>(name: &str, known: &'a [String]) -> Option<&'a String> {
    let length = name.chars().count();
    known
        .iter()
        .map(|k| (edits(name, k), k))
        .filter(|(d, k)| *d <= 1 + length.max(k.chars().count()) / 4 && length > 1)
        .min()
        .map(|(_, k)| k)
}

/// Levenshtein's distance.
fn edits(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let substituted = diagonal + usize::from(x != *y);
            diagonal = row[j + 1];
            row[j + 1] = substituted.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

/// Spans of the items of a module, for messages about definitions.
pub fn item_span(module: &ast::Module, item: usize) -> Span {
    module.items.get(item).map(|i| i.span).unwrap_or_default()
}

/// The built-in module that has a name.
fn module_of(name: &str) -> Option<&'static str> {
    ["trigonometry", "linearalgebra", "MeshConnectivity"]
        .into_iter()
        .find(|module| {
            builtin::exports(module)
                .iter()
                .flatten()
                .any(|export| export.name == name)
        })
}
