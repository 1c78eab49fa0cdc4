//! Imports: the module that is meant, its arguments, its names.

use std::collections::BTreeMap;

use super::symbols::{Resolver, count, given};
use super::{Meaning, ModuleId, Symbol};
use crate::diagnostic::Diagnostic;
use crate::syntax::ast::{self, Import, ItemKind, Name, Type, TypeKind};
use crate::syntax::{builtin, closest};

/// At most so many names are listed in a message.
const MOST_LISTED: usize = 24;

impl Resolver<'_> {
    /// Makes the names of an import known.
    pub(super) fn import(&mut self, importer: ModuleId, import: &Import) {
        let module = &import.module;
        if let Some(known) = builtin::exports(&module.text) {
            if let Some(argument) = import.arguments.first() {
                let message = format!("`{}` takes no arguments", module.text);
                self.diagnostics
                    .push(Diagnostic::error(argument.span, message).help(format!(
                    "write `from {}`; its functions take what they need, as in `ElementSets(M)`",
                    module.text
                )));
            }
            let known: Vec<String> = known.into_iter().map(|export| export.name).collect();
            self.link(importer, import, &known, &known, |name| {
                Meaning::Builtin(name.to_owned())
            });
            return;
        }
        let id = self.imported(importer, import);
        let Some(id) = id else {
            self.link_errors(importer, import);
            return;
        };
        let symbols = &self.resolved.module(id).symbols;
        let known: Vec<String> = symbols.keys().cloned().collect();
        let own = symbols.iter().filter(|(name, symbol)| {
            let defined = matches!(
                symbol.meanings.first(),
                Some(Meaning::Functions(_) | Meaning::Definition { .. })
            );
            defined
                && name.chars().count() > 1
                && name
                    .chars()
                    .all(|c| c.is_alphabetic() || c.is_ascii_digit())
        });
        let shown: Vec<String> = own.map(|(name, _)| name.clone()).collect();
        self.link(importer, import, &known, &shown, |name| {
            Meaning::Import(id, name.to_owned())
        });
    }

    /// The instance of a module that is not built in; `None` after an error.
    fn imported(&mut self, importer: ModuleId, import: &Import) -> Option<ModuleId> {
        let module = &import.module;
        if let Some(start) = self.open.iter().position(|open| *open == module.text) {
            let mut circle: Vec<_> = self.open[start..].iter().collect();
            circle.push(&module.text);
            let message = match circle.len() {
                2 => format!("`{}` imports itself", module.text),
                _ => {
                    let names: Vec<_> = circle.iter().map(|name| format!("`{name}`")).collect();
                    format!(
                        "modules import each other in a circle: {}",
                        names.join(" → ")
                    )
                }
            };
            self.diagnostics.push(
                Diagnostic::error(module.span, message)
                    .help("move what both sides need into a module of its own"),
            );
            return None;
        }
        let Some(syntax) = self.libraries.get(&module.text).cloned() else {
            let libraries = self.libraries.keys().map(String::as_str);
            let known = libraries.chain(builtin::MODULES.iter().copied());
            let help = match closest(&module.text, known).filter(|close| *close != module.text) {
                Some(close) => format!("did you mean `{close}`?"),
                None => format!(
                    "`use path::to::{0};` in front of the `struct` brings in a module of Rust; \
                     for a file, `{0}.hlang` stands beside this one",
                    module.text
                ),
            };
            self.diagnostics.push(
                Diagnostic::error(module.span, format!("no module `{}`", module.text)).help(help),
            );
            return None;
        };
        let arguments = self.arguments(importer, import, &syntax)?;
        let key = (module.text.clone(), arguments.clone());
        if let Some(&id) = self.instances.get(&key) {
            return Some(id);
        }
        self.open.push(module.text.clone());
        let id = self.instantiate(&module.text, syntax, Some(&arguments));
        self.open.pop();
        self.instances.insert(key, id);
        Some(id)
    }

    /// The symbols that the arguments of an import stand for; `None` after an error.
    fn arguments(
        &mut self,
        importer: ModuleId,
        import: &Import,
        syntax: &ast::Module,
    ) -> Option<Vec<(ModuleId, String)>> {
        let parameters = parameters(syntax);
        if parameters.len() != import.arguments.len() {
            let names: Vec<_> = parameters.iter().map(|(p, _)| p.text.as_str()).collect();
            let module = &import.module.text;
            let help = match names.is_empty() {
                true => format!("write `from {module}`"),
                false => format!(
                    "write `from {module}({0})`, with symbols of this module for `{0}`",
                    names.join(", ")
                ),
            };
            let message = format!(
                "module `{module}` takes {} but is given {}",
                count(parameters.len(), "argument"),
                given(import.arguments.len())
            );
            self.diagnostics
                .push(Diagnostic::error(import.module.span, message).help(help));
            return None;
        }
        let mut arguments = Vec::new();
        for (argument, (_, ty)) in import.arguments.iter().zip(parameters) {
            let importing = self.resolved.module(importer);
            let Some(symbol) = importing.symbols.get(&argument.text) else {
                // it may be declared in a line that could not be read
                if !importing.syntax.lost.contains(&argument.text) {
                    let known = importing.symbols.keys().map(String::as_str);
                    let help = match (closest(&argument.text, known), &ty.kind) {
                        (Some(close), _) => format!("did you mean `{close}`?"),
                        (None, TypeKind::Mesh(kind)) => {
                            format!("declare it, as in `{} : {kind}`", argument.text)
                        }
                        _ => "declare it on a line of its own".to_owned(),
                    };
                    let message = format!("unknown name `{}`", argument.text);
                    self.diagnostics
                        .push(Diagnostic::error(argument.span, message).help(help));
                }
                return None;
            };
            arguments.push(match symbol.meanings.first() {
                Some(Meaning::Argument(module, name)) => (*module, name.clone()),
                _ => (importer, argument.text.clone()),
            });
        }
        Some(arguments)
    }

    /// Makes names known: all of `known` may be imported, those of `shown` are proposed.
    fn link(
        &mut self,
        importer: ModuleId,
        import: &Import,
        known: &[String],
        shown: &[String],
        meaning: impl Fn(&str) -> Meaning,
    ) {
        let mut symbols = std::mem::take(&mut self.resolved.modules[importer.0 as usize].symbols);
        match &import.names {
            None => {
                let new = known.iter().filter(|name| !symbols.contains_key(*name));
                for name in new.collect::<Vec<_>>() {
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
                        let help = match closest(&name.name.text, known.iter().map(String::as_str))
                        {
                            Some(close) => format!("did you mean `{close}`?"),
                            None => format!("it has {}", list(shown)),
                        };
                        let message = format!(
                            "module `{}` has no `{}`",
                            import.module.text, name.name.text
                        );
                        self.diagnostics
                            .push(Diagnostic::error(name.name.span, message).help(help));
                        define_error(&mut symbols, local);
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
        let symbols = &mut self.resolved.modules[importer.0 as usize].symbols;
        for name in import.names.iter().flatten() {
            define_error(symbols, name.rename.as_ref().unwrap_or(&name.name));
        }
    }
}

/// The parameters of a module with their types, in order.
fn parameters(syntax: &ast::Module) -> Vec<(&Name, &Type)> {
    let entrywise = super::symbols::defined_by_entries(syntax);
    let blocks = syntax.items.iter().filter_map(|item| match &item.kind {
        ItemKind::Parameters(block) => Some(block),
        _ => None,
    });
    blocks
        .flatten()
        .flat_map(|d| d.targets.iter().map(|t| (&t.name, &d.ty)))
        .filter(|(name, _)| !entrywise.contains(&name.text))
        .collect()
}

fn define_error(symbols: &mut BTreeMap<String, Symbol>, name: &Name) {
    symbols.entry(name.text.clone()).or_insert_with(|| Symbol {
        meanings: Vec::new(),
        span: name.span,
    });
}

fn list(names: &[String]) -> String {
    let listed: Vec<_> = names
        .iter()
        .take(MOST_LISTED)
        .map(|n| format!("`{n}`"))
        .collect();
    let more = names.len() - listed.len();
    match more {
        0 => listed.join(", "),
        more => format!("{} and {more} more", listed.join(", ")),
    }
}
