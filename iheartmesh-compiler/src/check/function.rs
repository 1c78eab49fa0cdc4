//! Functions: their signatures, what their bodies are checked with.

use std::collections::BTreeSet;

use super::Checker;
use super::declare::Declared;
use super::recursion::Body;
use super::scope::{Binding, Scope};
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, Function, FunctionId, Kind, Parameter};
use crate::resolve::ModuleId;
use crate::resolve::symbols::walk_function;
use crate::syntax::ast::{self, ItemKind, Name};
use crate::types::{Atom, Dimension, Type};

/// What a call needs to know of a function before its body is checked.
#[derive(Clone, Debug)]
pub(super) struct Signature {
    /// Types of the parameters, those in subscripts first.
    pub(super) parameters: Vec<Type>,
    /// How it is written, for messages: `Faces(v ∈ V)`.
    pub(super) shown: String,
    /// Where its name stands.
    pub(super) span: crate::span::Span,
}

impl<'a> Checker<'a> {
    fn function_syntax(&self, module: ModuleId, item: usize) -> Option<&'a ast::Function> {
        match &self.resolved.module(module).syntax.items.get(item)?.kind {
            ItemKind::Function(function) => Some(function),
            _ => None,
        }
    }

    /// The signature of a function.
    pub(super) fn signature(&mut self, module: ModuleId, item: usize) -> Option<Signature> {
        if let Some(signature) = self.signatures.get(&(module, item)) {
            return Some(signature.clone());
        }
        let syntax = self.function_syntax(module, item)?;
        let declared = self.in_module(module, |checker| checker.parameters(syntax));
        let mut shown = Vec::new();
        for (name, declared) in &declared {
            let (name, ty) = match &declared.ty {
                Type::Sequence { item, length, .. } => match length.as_atom() {
                    Some(Atom::Length(letter)) => (format!("{}_{letter}", name.text), &**item),
                    _ => (name.text.clone(), &declared.ty),
                },
                ty => (name.text.clone(), ty),
            };
            shown.push(if declared.within_name.is_empty() {
                format!("{name} ∈ {ty}")
            } else if matches!(ty, Type::Set(_)) {
                format!("{name} ⊂ {}", declared.within_name)
            } else {
                format!("{name} ∈ {}", declared.within_name)
            });
        }
        let signature = Signature {
            parameters: declared.iter().map(|(_, d)| d.ty.clone()).collect(),
            shown: format!("{}({})", syntax.name.text, shown.join(", ")),
            span: syntax.name.span,
        };
        self.signatures.insert((module, item), signature.clone());
        Some(signature)
    }

    /// The parameters of a function with their declared types.
    fn parameters(&mut self, syntax: &'a ast::Function) -> Vec<(&'a Name, Declared)> {
        let names: Vec<&Name> = syntax
            .subscripts
            .iter()
            .chain(syntax.parameters.iter().flatten())
            .collect();
        let is_declared = |name: &Name| {
            let targets = syntax.declarations.iter().flat_map(|d| &d.targets);
            targets.into_iter().any(|t| t.name.text == name.text)
        };
        let missing: Vec<&Name> = names.iter().copied().filter(|n| !is_declared(n)).collect();
        let mut strange = false;
        for (k, name) in names.iter().enumerate() {
            if let Some(first) = names[..k].iter().find(|n| n.text == name.text) {
                let message = format!("`{}` has two parameters `{}`", syntax.name.text, name.text);
                self.report(
                    Diagnostic::error(name.span, message)
                        .label(first.span, "the first one")
                        .help("rename one of the two"),
                );
            }
        }
        for declaration in &syntax.declarations {
            for target in &declaration.targets {
                strange |= !names.iter().any(|n| n.text == target.name.text);
                if !names.iter().any(|n| n.text == target.name.text) {
                    let message = format!(
                        "`{}` is not a parameter of `{}`",
                        target.name.text, syntax.name.text
                    );
                    let help = match missing.as_slice() {
                        [name] => format!("did you mean `{}`?", name.text),
                        _ if is_bound(syntax, target.name.text.as_str()) => format!(
                            "a sum, a set or an optimum knows `{}`: remove its declaration here",
                            target.name.text
                        ),
                        _ => format!(
                            "declare it on a line of its own to make it a parameter of the module, or write `{}({}) = …`",
                            syntax.name.text,
                            names
                                .iter()
                                .map(|n| n.text.as_str())
                                .chain([target.name.text.as_str()])
                                .collect::<Vec<_>>()
                                .join(", ")
                        ),
                    };
                    self.report(
                        Diagnostic::error(target.name.span, message)
                            .label(syntax.name.span, "defined here")
                            .help(help),
                    );
                }
            }
        }
        names
            .into_iter()
            .map(|name| {
                let place = syntax.declarations.iter().find_map(|declaration| {
                    let target = declaration
                        .targets
                        .iter()
                        .position(|t| t.name.text == name.text)?;
                    Some((declaration, target))
                });
                let declared = match place {
                    Some((declaration, target)) => {
                        self.no_index(declaration);
                        self.declared(declaration, target)
                    }
                    None => {
                        // the name in the declaration may be misspelt; what could not be read may declare it
                        let misspelt = strange && missing.len() == 1;
                        let lost = self
                            .resolved
                            .module(self.module)
                            .syntax
                            .lost
                            .contains(&name.text);
                        if !misspelt && !lost {
                            let message = format!(
                                "parameter `{}` of `{}` has no type",
                                name.text, syntax.name.text
                            );
                            self.report(Diagnostic::error(name.span, message).help(format!(
                                "declare it after the definition, as in `where {} ∈ ℝ`",
                                name.text
                            )));
                        }
                        Declared {
                            ty: Type::Error,
                            within: None,
                            within_name: String::new(),
                        }
                    }
                };
                (name, declared)
            })
            .collect()
    }

    /// The function defined by an item; its body is checked when it is asked for the first time.
    pub(super) fn function(&mut self, module: ModuleId, item: usize) -> FunctionId {
        if let Some(&id) = self.functions.get(&(module, item)) {
            return id;
        }
        let Some(syntax) = self.function_syntax(module, item) else {
            panic!("bug in iheartmesh: item {item} is no function");
        };
        let span = self.resolved.module(module).syntax.items[item].span;
        let id = FunctionId(self.program.functions.len() as u32);
        self.functions.insert((module, item), id);
        let error = self.error();
        self.program.functions.push(Function {
            name: syntax.name.text.clone(),
            parameters: Vec::new(),
            body: error,
            ty: Type::Error,
            recursive: false,
            own: module == ModuleId(0),
            span,
        });
        self.check_overloads(module, item);
        self.in_module(module, |checker| checker.function_body(id, syntax));
        id
    }

    fn function_body(&mut self, id: FunctionId, syntax: &'a ast::Function) {
        let declared = {
            // signature() reports the errors of the declarations
            let before = self.diagnostics.clone();
            let declared = self.parameters(syntax);
            *self.diagnostics = before;
            declared
        };
        let mut scope = Scope::default();
        let mut parameters = Vec::new();
        for (name, declared) in declared {
            let variable = self.bind(&mut scope, name, declared.ty.clone());
            let targets = syntax.declarations.iter().flat_map(|d| &d.targets);
            if let Some(target) = targets.into_iter().find(|t| t.name.text == name.text) {
                scope.spans.insert(name.text.clone(), target.name.span);
            }
            parameters.push(Parameter {
                name: name.text.clone(),
                variable,
                ty: declared.ty,
                within: declared.within,
                within_name: declared.within_name,
            });
        }
        let templates = self.template_sizes(&parameters);
        let mut given: BTreeSet<String> = templates.keys().cloned().collect();
        given.extend(self.resolved.module(self.module).symbols.keys().cloned());
        for parameter in &parameters {
            let span = scope.spans.get(&parameter.name).copied();
            let span = span.unwrap_or(syntax.name.span);
            self.report_sizes(&parameter.ty, span, &mut given);
        }
        for (name, size) in &templates {
            scope
                .names
                .entry(name.clone())
                .or_insert(Binding::Value(*size));
        }
        self.program.functions[id.0 as usize].parameters = parameters;
        self.bind_locals(&mut scope, &syntax.locals);
        let module = self.module;
        self.check_function(Body {
            id,
            module,
            syntax,
            scope,
            templates,
        });
    }

    /// Sizes in the types of parameters that are not sizes of the module: they are those of the arguments.
    fn template_sizes(
        &mut self,
        parameters: &[Parameter],
    ) -> std::collections::BTreeMap<String, ExprId> {
        let mut found = std::collections::BTreeMap::new();
        // sequences and sets may be empty, and then their items say nothing
        let is_list = |p: &&Parameter| matches!(p.ty, Type::Sequence { .. } | Type::Set(_));
        let others = parameters.iter().filter(|p| !is_list(p));
        for parameter in others.chain(parameters.iter().filter(is_list)) {
            let value = self.program.arena.variable(parameter.variable);
            self.template_sizes_of(value, &mut found);
        }
        found
    }

    fn template_sizes_of(
        &mut self,
        value: ExprId,
        found: &mut std::collections::BTreeMap<String, ExprId>,
    ) {
        let sizes: Vec<(u8, Dimension)> = match self.ty(value).clone() {
            Type::Vector { length, .. } => vec![(0, length)],
            Type::Matrix { rows, columns, .. } => vec![(0, rows), (1, columns)],
            Type::Tuple(items) => {
                for (k, ty) in items.into_iter().enumerate() {
                    let item = self.project(value, k, ty);
                    self.template_sizes_of(item, found);
                }
                return;
            }
            Type::Sequence { item, .. } => match *item {
                Type::Vector { length, .. } => vec![(0, length)],
                Type::Matrix { rows, columns, .. } => vec![(0, rows), (1, columns)],
                _ => return,
            },
            Type::Set(item) => match *item {
                Type::Vector { length, .. } => vec![(0, length)],
                Type::Matrix { rows, columns, .. } => vec![(0, rows), (1, columns)],
                _ => return,
            },
            _ => return,
        };
        for (axis, size) in sizes {
            let (name, ragged) = match size.as_atom() {
                Some(Atom::Symbol(name)) => (name, false),
                Some(Atom::Item(of, None)) => match &**of {
                    Atom::Symbol(name) => (name, true),
                    _ => continue,
                },
                _ => continue,
            };
            let symbols = &self.resolved.module(self.module).symbols;
            if symbols.contains_key(name) || found.contains_key(name) {
                continue;
            }
            let name = name.clone();
            let size = match self.ty(value).clone() {
                Type::Sequence { .. } if ragged => self.sizes_of_items(value, axis),
                // all items have the size of the first one
                Type::Sequence { item, .. } => {
                    let n = self.extent(value, 0);
                    let one = self.program.arena.integer(1);
                    let first = self.add(Kind::Item(value, one), *item);
                    self.size_of_first(n, first, axis)
                }
                Type::Set(item) => {
                    let n = self.add(Kind::Cardinality(value), Type::INTEGER);
                    let one = self.program.arena.integer(1);
                    let first = self.add(Kind::SetItem(value, one), *item);
                    self.size_of_first(n, first, axis)
                }
                _ => self.add(Kind::Extent(value, axis), Type::INTEGER),
            };
            found.insert(name, size);
        }
    }

    /// A size of the first of `n` items; 0 where there is none.
    pub(super) fn size_of_first(&mut self, n: ExprId, first: ExprId, axis: u8) -> ExprId {
        let zero = self.program.arena.integer(0);
        let size = self.add(Kind::Extent(first, axis), Type::INTEGER);
        let none = self.add(Kind::Compare(ast::CompareOp::Equal, n, zero), Type::Boolean);
        self.add(Kind::If(none, zero, size), Type::INTEGER)
    }

    pub(super) fn function_value(&mut self, syntax: &'a ast::Function) -> ExprId {
        let body = self.expr(&syntax.body);
        // a local definition that is not used is checked as well
        for definition in &syntax.locals {
            for target in &definition.targets {
                let unused = self
                    .scopes
                    .last()
                    .and_then(|s| s.names.get(&target.name.text))
                    .is_some_and(|b| matches!(b, Binding::Local(..)));
                if unused {
                    self.find(&target.name);
                }
            }
        }
        body
    }

    /// Two definitions of one name must differ in the types of their parameters.
    fn check_overloads(&mut self, module: ModuleId, item: usize) {
        let Some(syntax) = self.function_syntax(module, item) else {
            return;
        };
        let Some(signature) = self.signature(module, item) else {
            return;
        };
        let others: Vec<usize> = self
            .resolved
            .module(module)
            .syntax
            .items
            .iter()
            .enumerate()
            .take(item)
            .filter(|(_, other)| {
                matches!(&other.kind, ItemKind::Function(f) if f.name.text == syntax.name.text)
            })
            .map(|(index, _)| index)
            .collect();
        for other in others {
            let Some(other) = self.signature(module, other) else {
                continue;
            };
            if other.parameters == signature.parameters
                && !other.parameters.iter().any(Type::is_error)
            {
                let message = format!(
                    "`{}` is defined twice with the same parameters",
                    syntax.name.text
                );
                self.report(
                    Diagnostic::error(signature.span, message)
                        .here(signature.shown.clone())
                        .label(other.span, other.shown)
                        .help(
                            "definitions of one name must differ in the types of their parameters",
                        ),
                );
            }
        }
    }
}

/// Whether a function binds a name inside of its body.
fn is_bound(function: &ast::Function, name: &str) -> bool {
    let bound = walk_function(function, &mut |_| {});
    let mut binders = bound.binders.iter();
    binders.any(|other| other.text == name)
}
