//! Builds the symbol tables of a module and of all that it imports.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use super::names::{FreeNames, dimension_names, left_indices};
use super::{Meaning, Module, ModuleId, Resolved, Symbol, order};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::span::Span;
use crate::syntax::ast::{self, Definition, Function, ItemKind, Name};

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

pub(super) struct Resolver<'a> {
    pub(super) libraries: &'a BTreeMap<String, Rc<ast::Module>>,
    pub(super) resolved: Resolved,
    pub(super) instances: BTreeMap<(String, Vec<(ModuleId, String)>), ModuleId>,
    pub(super) open: Vec<String>,
    pub(super) diagnostics: &'a mut Diagnostics,
}

impl Resolver<'_> {
    /// Adds an instance. With arguments it is imported, and they are what its parameters stand for.
    pub(super) fn instantiate(
        &mut self,
        name: &str,
        syntax: Rc<ast::Module>,
        arguments: Option<&[(ModuleId, String)]>,
    ) -> ModuleId {
        let id = ModuleId(self.resolved.modules.len() as u32);
        let mut module = Module {
            name: name.to_owned(),
            syntax: Rc::clone(&syntax),
            symbols: BTreeMap::new(),
            order: Vec::new(),
            further: BTreeMap::new(),
            declared: BTreeMap::new(),
        };
        self.own_symbols(&mut module, arguments);
        self.resolved.modules.push(module);
        for item in &syntax.items {
            if let ItemKind::Import(import) = &item.kind {
                self.import(id, import);
            }
        }
        for name in &syntax.lost {
            let symbols = &mut self.resolved.modules[id.0 as usize].symbols;
            symbols.entry(name.clone()).or_insert_with(|| Symbol {
                meanings: Vec::new(),
                span: Span::default(),
            });
        }
        super::unknown::check_names(self.resolved.module(id), self.diagnostics);
        let order = order::order(self.resolved.module(id), self.diagnostics);
        self.resolved.modules[id.0 as usize].order = order;
        id
    }

    fn own_symbols(&mut self, module: &mut Module, arguments: Option<&[(ModuleId, String)]>) {
        let syntax = Rc::clone(&module.syntax);
        let entrywise = defined_by_entries(&syntax);
        let mut symbols: BTreeMap<String, Symbol> = BTreeMap::new();
        let mut n_parameters = 0;
        for (index, item) in syntax.items.iter().enumerate() {
            match &item.kind {
                ItemKind::Parameters(block) => {
                    for (declaration, d) in block.iter().enumerate() {
                        for (target, t) in d.targets.iter().enumerate() {
                            if entrywise.contains(&t.name.text) {
                                let place = (index, declaration, target);
                                let before = module.declared.insert(t.name.text.clone(), place);
                                if let Some(before) = before {
                                    self.declared_twice(&syntax, &t.name, before);
                                }
                                continue;
                            }
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
                        let defined = symbols.get(&t.name.text).is_some_and(|s| {
                            matches!(s.meanings.as_slice(), [Meaning::Definition { .. }])
                        });
                        if defined && (d.add || !t.subscripts.is_empty()) {
                            let further = module.further.entry(t.name.text.clone());
                            further.or_default().push(index);
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
        module.symbols = symbols;
    }

    /// Two declarations of a name that is defined entry by entry.
    fn declared_twice(&mut self, syntax: &ast::Module, name: &Name, before: (usize, usize, usize)) {
        let ItemKind::Parameters(block) = &syntax.items[before.0].kind else {
            return;
        };
        let parameter = Meaning::Parameter {
            item: before.0,
            declaration: before.1,
            target: before.2,
        };
        let first = block[before.1].targets[before.2].name.span;
        self.twice(name, (parameter.clone(), first), (parameter, name.span));
    }

    /// Gives a name a meaning; only functions may have several.
    pub(super) fn define(
        &mut self,
        symbols: &mut BTreeMap<String, Symbol>,
        name: &Name,
        meaning: Meaning,
    ) {
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
        // what is in error has been reported
        if before.meanings.is_empty() || before.meanings.contains(&meaning) {
            return;
        }
        let functions = before.meanings.iter().all(|m| self.is_function(m));
        if functions && self.is_function(&meaning) {
            if let (Some(Meaning::Functions(list)), Meaning::Functions(more)) =
                (before.meanings.last_mut(), &meaning)
            {
                list.extend(more);
            } else {
                before.meanings.push(meaning);
            }
            return;
        }
        let first = (before.meanings[0].clone(), before.span);
        // how it is used fits at most one of the two
        before.meanings.clear();
        self.twice(name, first, (meaning, name.span));
    }

    fn is_function(&self, meaning: &Meaning) -> bool {
        match meaning {
            Meaning::Functions(_) => true,
            Meaning::Builtin(name) => name != "e",
            // what an argument is, the importing module knows
            Meaning::Argument(..) => true,
            Meaning::Import(module, name) => {
                let module = &self.resolved.module(*module);
                let symbol = module.symbols.get(name);
                symbol.is_none_or(|s| s.meanings.iter().all(|m| self.is_function(m)))
            }
            _ => false,
        }
    }

    /// A name has two meanings that exclude each other.
    fn twice(&mut self, name: &Name, first: (Meaning, Span), second: (Meaning, Span)) {
        let is_import = |m: &Meaning| matches!(m, Meaning::Import(..) | Meaning::Builtin(_));
        let is_parameter = |m: &Meaning| matches!(m, Meaning::Parameter { .. });
        let said = |m: &Meaning| match m {
            Meaning::Import(..) | Meaning::Builtin(_) => "imported here",
            Meaning::Parameter { .. } | Meaning::Argument(..) => "declared here",
            Meaning::Functions(_) => "defined here as a function",
            _ => "defined here",
        };
        let (first, second) = match first.1 <= second.1 {
            true => (first, second),
            false => (second, first),
        };
        let text = &name.text;
        let one = |is: &dyn Fn(&Meaning) -> bool| is(&first.0) != is(&second.0);
        let (message, help) = if one(&is_import) {
            (
                format!("`{text}` is imported and has another meaning here"),
                format!("import it under another name, as in `{text} as …`"),
            )
        } else if is_import(&first.0) {
            (
                format!("`{text}` is imported twice"),
                format!("import one of the two under another name, as in `{text} as …`"),
            )
        } else if one(&is_parameter) {
            (
                format!("`{text}` is declared as a parameter and defined as well"),
                "the value of a parameter is handed to `new`; remove the declaration or the definition"
                    .to_owned(),
            )
        } else {
            let how = match is_parameter(&first.0) {
                true => "declared",
                false => "defined",
            };
            (
                format!("`{text}` is {how} twice"),
                "rename one of the two".to_owned(),
            )
        };
        self.diagnostics.push(
            Diagnostic::error(second.1, message)
                .here(said(&second.0))
                .label(first.1, said(&first.0))
                .help(help),
        );
    }
}

/// The names that have definitions of entries only, as `K_ij = …`: a declaration of such a name gives the type of what
/// is defined, and is no parameter.
pub fn defined_by_entries(syntax: &ast::Module) -> BTreeSet<String> {
    let definitions = || {
        syntax.items.iter().filter_map(|item| match &item.kind {
            ItemKind::Definition(d) => Some(d),
            _ => None,
        })
    };
    let targets = definitions().flat_map(|d| &d.targets);
    let mut names: BTreeSet<String> = targets
        .filter(|t| !t.subscripts.is_empty())
        .map(|t| t.name.text.clone())
        .collect();
    for definition in definitions().filter(|d| !d.add) {
        for target in definition
            .targets
            .iter()
            .filter(|t| t.subscripts.is_empty())
        {
            names.remove(&target.name.text);
        }
    }
    names
}

/// What a walk over an item finds besides the names that it uses.
#[derive(Default)]
pub struct Walked {
    /// The names that are bound inside.
    pub binders: Vec<Name>,
    /// The names that stand alone as subscripts without being bound there.
    pub indices: Vec<Name>,
}

impl From<FreeNames<'_>> for Walked {
    fn from(walk: FreeNames<'_>) -> Self {
        Self {
            binders: walk.binders,
            indices: walk.indices,
        }
    }
}

/// Walks the names that a function uses from outside.
pub fn walk_function(f: &Function, found: &mut dyn FnMut(&Name)) -> Walked {
    let mut bound: Vec<String> = f.subscripts.iter().map(|n| n.text.clone()).collect();
    bound.extend(f.parameters.iter().flatten().map(|n| n.text.clone()));
    for d in &f.declarations {
        dimension_names(&d.ty, &mut |name| bound.push(name.text.clone()));
        // what is declared without being a parameter is reported as that
        bound.extend(d.targets.iter().map(|t| t.name.text.clone()));
    }
    let mut walk = FreeNames::new(bound, found);
    f.declarations.iter().for_each(|d| walk.declaration(d));
    walk.locals(&f.locals, |walk| walk.expr(&f.body));
    walk.into()
}

/// Walks the names that a definition uses from outside.
pub fn walk_definition(d: &Definition, found: &mut dyn FnMut(&Name)) -> Walked {
    let bound = left_indices(d)
        .into_iter()
        .map(|n| n.text.clone())
        .collect();
    let mut walk = FreeNames::new(bound, found);
    walk.left_entries(d);
    walk.expr(&d.value);
    walk.into()
}

/// `1 argument`, `2 arguments`.
pub fn count(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}

/// How a message says how many were given.
pub fn given(n: usize) -> String {
    match n {
        0 => "none".to_owned(),
        n => n.to_string(),
    }
}

/// Where messages about an item point to: the names that it defines.
pub fn item_span(module: &ast::Module, item: usize) -> Span {
    match module.items.get(item).map(|item| (&item.kind, item.span)) {
        Some((ItemKind::Function(f), _)) => f.name.span,
        Some((ItemKind::Definition(d), span)) => match (d.targets.first(), d.targets.last()) {
            (Some(first), Some(last)) => first.name.span.to(last.name.span),
            _ => span,
        },
        Some((_, span)) => span,
        None => Span::default(),
    }
}
