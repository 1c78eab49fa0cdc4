//! Names that stand for nothing: one message for each, however often it is used.

use std::collections::{BTreeMap, BTreeSet};

use super::Module;
use super::names::{FreeNames, left_indices};
use super::symbols::{Walked, walk_definition, walk_function};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::span::Span;
use crate::syntax::ast::{Declaration, ItemKind, Name, Type, TypeKind};
use crate::syntax::builtin;
use crate::syntax::closest;
use crate::syntax::spelling::{look_alike, look_alike_help};

/// A name that an item uses, and how often it is used in the module.
struct Unknown {
    name: Name,
    item: usize,
    uses: usize,
}

/// Reports every name that is not bound.
pub(super) fn check_names(module: &Module, diagnostics: &mut Diagnostics) {
    let mut unknown: Vec<Unknown> = Vec::new();
    let mut walks: Vec<Walked> = Vec::new();
    let mut types = BTreeSet::new();
    for (item, syntax) in module.syntax.items.iter().enumerate() {
        let mut found = |name: &Name| {
            if is_known(module, name) {
                return;
            }
            match unknown.iter_mut().find(|u| u.name.text == name.text) {
                Some(known) => known.uses += 1,
                None => unknown.push(Unknown {
                    name: name.clone(),
                    item,
                    uses: 1,
                }),
            }
        };
        walks.push(match &syntax.kind {
            ItemKind::Import(_) => Walked::default(),
            ItemKind::Parameters(block) => {
                type_names(block, &mut types);
                let mut walk = FreeNames::new(Vec::new(), &mut found);
                block.iter().for_each(|d| walk.declaration(d));
                walk.into()
            }
            ItemKind::Function(f) => {
                type_names(&f.declarations, &mut types);
                walk_function(f, &mut found)
            }
            ItemKind::Definition(d) => walk_definition(d, &mut found),
            ItemKind::Expression(e) => {
                let mut walk = FreeNames::new(Vec::new(), &mut found);
                walk.expr(e);
                walk.into()
            }
        });
    }
    // beside a letter that was meant as a sign, other names are unknown for its sake
    let misread: BTreeSet<usize> = unknown
        .iter()
        .filter(|unknown| look_alike(&unknown.name.text).is_some())
        .map(|unknown| unknown.item)
        .collect();
    unknown.retain(|unknown| {
        !misread.contains(&unknown.item) || look_alike(&unknown.name.text).is_some()
    });
    // indices of one item that nothing runs through have one cause
    let mut first_indices: BTreeMap<usize, Vec<Name>> = BTreeMap::new();
    unknown.retain(|unknown| {
        if !is_loose_index(module, &walks, unknown) {
            return true;
        }
        let indices = first_indices.entry(unknown.item).or_default();
        indices.push(unknown.name.clone());
        indices.len() == 1
    });
    for unknown in &unknown {
        if let Some(indices) = first_indices.get(&unknown.item)
            && indices[0].text == unknown.name.text
        {
            diagnostics.push(loose_indices(module, unknown.item, indices));
            continue;
        }
        let diagnostic = match types.contains(&unknown.name.span) {
            true => unknown_type(module, unknown),
            false => unknown_value(module, &walks, unknown),
        };
        diagnostics.push(match unknown.uses {
            1 => diagnostic,
            uses => diagnostic.here(format!("the first of {uses} uses")),
        });
    }
}

fn is_known(module: &Module, name: &Name) -> bool {
    module.symbols.contains_key(&name.text)
        || builtin::ALWAYS.contains(&name.text.as_str())
        || name.text == "I"
}

fn unknown_type(module: &Module, unknown: &Unknown) -> Diagnostic {
    let name = &unknown.name;
    let words = builtin::TYPE_WORDS.iter().copied();
    let words = words.filter(|word| word.starts_with(char::is_uppercase));
    let sets = module.symbols.keys().map(String::as_str);
    let help = match closest(&name.text, words.chain(sets)) {
        _ if is_element_set(&name.text) => ELEMENT_SETS.to_owned(),
        Some(word) => format!("did you mean `{word}`?"),
        None => "types are ℝ, ℤ, ℝ³, {ℤ}, FaceMesh and the like; after `∈` and `⊂` may also stand the name of a set"
            .to_owned(),
    };
    let message = format!("unknown type or set `{}`", name.text);
    Diagnostic::error(name.span, message).help(help)
}

fn unknown_value(module: &Module, walks: &[Walked], unknown: &Unknown) -> Diagnostic {
    let name = &unknown.name;
    let text = &name.text;
    let diagnostic = Diagnostic::error(name.span, format!("unknown name `{text}`"));
    if let Some(help) = look_alike_help(text) {
        return diagnostic.help(help);
    }
    if let Some(binder) = walks[unknown.item].binders.iter().find(|b| b.text == *text) {
        return diagnostic
            .label(binder.span, format!("this `{text}` ends before"))
            .help(
                "an index is known only inside of its sum, product or set; parentheses extend a sum",
            );
    }
    let elsewhere = walks.iter().enumerate().find_map(|(item, walk)| {
        let binder = walk.binders.iter().find(|b| b.text == *text)?;
        match &module.syntax.items[item].kind {
            ItemKind::Function(f) => Some((binder, &f.name.text)),
            _ => None,
        }
    });
    let known = module.symbols.keys().map(String::as_str);
    let close = closest(text, known.chain(builtin::ALWAYS.iter().copied()));
    match (builtin::import_of(text), close, elsewhere) {
        (Some(import), ..) => diagnostic.help(format!("`{import}` imports it")),
        (None, Some(close), _) => diagnostic.help(format!("did you mean `{close}`?")),
        (None, None, Some((binder, function))) => diagnostic
            .label(
                binder.span,
                format!("this one is known only in `{function}`"),
            )
            .help("define it on a line of its own to use it in several definitions"),
        _ if is_element_set(text) => diagnostic.help(ELEMENT_SETS),
        _ if text.chars().all(char::is_alphanumeric) => {
            diagnostic.help(format!("declare it, as in `{text} ∈ ℝ`, or define it"))
        }
        _ => diagnostic.help("declare it or define it"),
    }
}

/// Whether a name is a letter that stands only as a subscript, and that nothing runs through anywhere near.
fn is_loose_index(module: &Module, walks: &[Walked], unknown: &Unknown) -> bool {
    let text = &unknown.name.text;
    let walk = &walks[unknown.item];
    let indexed = walk.indices.iter().filter(|name| name.text == *text);
    let in_definition = matches!(
        module.syntax.items[unknown.item].kind,
        ItemKind::Definition(_)
    );
    in_definition
        && text.chars().count() == 1
        && look_alike(text).is_none()
        && !is_element_set(text)
        && builtin::import_of(text).is_none()
        && indexed.count() == unknown.uses
        && walk.binders.iter().all(|binder| binder.text != *text)
}

/// One message for the indices of a definition that stand neither on its left side nor below a sum.
fn loose_indices(module: &Module, item: usize, indices: &[Name]) -> Diagnostic {
    let (left, bound) = match &module.syntax.items[item].kind {
        ItemKind::Definition(definition) => {
            let target = definition.targets.first();
            let left = target.map_or("y", |target| &target.name.text);
            (left, left_indices(definition))
        }
        _ => ("y", Vec::new()),
    };
    let letters: String = bound
        .into_iter()
        .chain(indices)
        .map(|name| name.text.as_str())
        .collect();
    let message = match indices {
        [index] => format!("unknown index `{}`", index.text),
        _ => {
            let names: Vec<String> = indices.iter().map(|n| format!("`{}`", n.text)).collect();
            format!("unknown indices {}", names.join(", "))
        }
    };
    let mut diagnostic = Diagnostic::error(indices[0].span, message);
    for index in &indices[1..] {
        diagnostic = diagnostic.label(index.span, "and this");
    }
    diagnostic.help(format!(
        "an index stands on the left side as well, as in `{left}_{letters} = …`, or below a sum, as in `∑_{}`; \
         a fixed one is declared, as in `{0} ∈ ℤ`",
        indices[0].text
    ))
}

const ELEMENT_SETS: &str =
    "`V, E, F = ElementSets(M)` names the vertices, edges and faces of a mesh `M`";

fn is_element_set(name: &str) -> bool {
    ["V", "E", "F", "C"].contains(&name)
}

/// The places of the names that stand for types or sets in declarations.
fn type_names(declarations: &[Declaration], places: &mut BTreeSet<Span>) {
    fn walk(ty: &Type, places: &mut BTreeSet<Span>) {
        match &ty.kind {
            TypeKind::Named(name) => {
                places.insert(name.span);
            }
            TypeKind::Mapping { from, to } => {
                places.insert(from.span);
                walk(to, places);
            }
            TypeKind::Set(items) | TypeKind::SetOfAlternatives(items) | TypeKind::Tuple(items) => {
                items.iter().for_each(|item| walk(item, places));
            }
            TypeKind::Function {
                parameters,
                results,
            } => {
                let items = parameters.iter().chain(results);
                items.for_each(|item| walk(item, places));
            }
            _ => {}
        }
    }
    declarations.iter().for_each(|d| walk(&d.ty, places));
}
