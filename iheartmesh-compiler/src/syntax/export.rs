//! What a module offers to modules that import it.

use std::collections::BTreeMap;

use super::Export;
use super::ast::{ItemKind, Module, Name, TypeKind};
use super::builtin;

/// The top-level names of a module, in alphabetic order: parameters, definitions, functions, imported names.
pub fn export_names(module: &Module) -> Vec<Export> {
    let mut names = BTreeMap::new();
    let mut add = |name: &Name, function: bool| {
        *names.entry(name.text.clone()).or_insert(false) |= function;
    };
    for item in &module.items {
        match &item.kind {
            ItemKind::Import(import) => {
                let exports = builtin::exports(&import.module.text);
                for imported in import.names.iter().flatten() {
                    let known = exports.iter().flatten();
                    let mut known = known.filter(|export| export.name == imported.name.text);
                    let function = known.next().is_none_or(|export| export.function);
                    add(imported.rename.as_ref().unwrap_or(&imported.name), function);
                }
            }
            ItemKind::Parameters(declarations) => {
                for declaration in declarations {
                    let function = matches!(declaration.ty.kind, TypeKind::Function { .. });
                    for target in &declaration.targets {
                        add(&target.name, function);
                    }
                }
            }
            ItemKind::Function(function) => add(&function.name, true),
            ItemKind::Definition(definition) => {
                for target in &definition.targets {
                    add(&target.name, false);
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
