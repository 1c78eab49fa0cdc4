//! What a module offers to modules that import it.

use std::collections::BTreeMap;

use super::ast::{Import, ItemKind, Module, TypeKind};
use super::builtin;
use super::{Export, ImportedNames, NoImports};

/// The top-level names of a module, in alphabetic order: parameters, definitions, functions, imported names.
///
/// A name that it imports from a module that is not built in counts as a function, and `*` brings no names of such
/// a module; [`export_names_with`] knows better.
pub fn export_names(module: &Module) -> Vec<Export> {
    export_names_with(module, &NoImports)
}

/// As [`export_names`], with what the modules that it imports from export themselves.
pub fn export_names_with(module: &Module, imports: &dyn ImportedNames) -> Vec<Export> {
    let mut names = BTreeMap::new();
    let mut add = |name: &str, function: bool| {
        *names.entry(name.to_owned()).or_insert(false) |= function;
    };
    for item in &module.items {
        match &item.kind {
            ItemKind::Import(import) => imported(import, imports, &mut add),
            ItemKind::Parameters(declarations) => {
                for declaration in declarations {
                    let function = matches!(declaration.ty.kind, TypeKind::Function { .. });
                    for target in &declaration.targets {
                        add(&target.name.text, function);
                    }
                }
            }
            ItemKind::Function(function) => add(&function.name.text, true),
            ItemKind::Definition(definition) => {
                for target in &definition.targets {
                    add(&target.name.text, false);
                }
            }
            ItemKind::Expression(_) => {}
        }
    }
    let exports = names.into_iter();
    exports
        .map(|(name, function)| Export { name, function })
        .collect()
}

fn imported(import: &Import, imports: &dyn ImportedNames, add: &mut dyn FnMut(&str, bool)) {
    let module = &import.module.text;
    let exports = builtin::exports(module).or_else(|| imports.exports(module));
    match &import.names {
        None => {
            for export in exports.iter().flatten() {
                add(&export.name, export.function);
            }
        }
        Some(list) => {
            for import in list {
                let known = exports.iter().flatten();
                let mut known = known.filter(|export| export.name == import.name.text);
                let function = known.next().is_none_or(|export| export.function);
                let name = import.rename.as_ref().unwrap_or(&import.name);
                add(&name.text, function);
            }
        }
    }
}
