//! The text of this stage: `hlangc --emit names`.

use std::fmt::Write;

use super::{Meaning, Resolved};
use crate::syntax::ast::ItemKind;

/// One paragraph for each module instance: its names with what they stand for, and its order of definition.
pub fn dump(resolved: &Resolved) -> String {
    let mut text = String::new();
    for (id, module) in resolved.modules.iter().enumerate() {
        let _ = writeln!(text, "module {id} {}", module.name);
        for (name, symbol) in &module.symbols {
            let meanings: Vec<String> = symbol
                .meanings
                .iter()
                .map(|meaning| match meaning {
                    Meaning::Parameter { .. } => "parameter".to_owned(),
                    Meaning::Argument(module, name) => {
                        format!("argument: module {} `{name}`", module.0)
                    }
                    Meaning::Dimension => "size".to_owned(),
                    Meaning::Definition { item, .. } => format!("definition in item {item}"),
                    Meaning::Functions(items) => {
                        let items: Vec<_> = items.iter().map(usize::to_string).collect();
                        format!("function in item {}", items.join(", "))
                    }
                    Meaning::Import(module, name) => format!("module {} `{name}`", module.0),
                    Meaning::Builtin(name) => format!("built-in `{name}`"),
                })
                .collect();
            let _ = writeln!(text, "  `{name}`: {}", meanings.join("; "));
        }
        let order: Vec<String> = module
            .order
            .iter()
            .map(|item| match &module.syntax.items[*item].kind {
                ItemKind::Function(f) => format!("{item} `{}`", f.name.text),
                ItemKind::Definition(d) => {
                    let names: Vec<_> = d
                        .targets
                        .iter()
                        .map(|t| format!("`{}`", t.name.text))
                        .collect();
                    format!("{item} {}", names.join(" "))
                }
                _ => format!("{item} ret"),
            })
            .collect();
        let _ = writeln!(text, "  order: {}", order.join(", "));
    }
    text
}
