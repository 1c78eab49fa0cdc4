//! What names mean inside a module: innermost scope first, then the module's symbols.

use std::collections::BTreeMap;

use super::Checker;
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, VariableId};
use crate::resolve::{Meaning, ModuleId};
use crate::span::Span;
use crate::syntax::ast::{self, Name};
use crate::types::Type;

/// What a name of a scope is bound to.
#[derive(Clone, Debug)]
pub(super) enum Binding<'a> {
    /// A value.
    Value(ExprId),
    /// A local definition, checked when it is first used.
    Local(&'a ast::Definition, usize),
    /// A local definition that is being checked.
    Open,
}

/// The names of a function, a sum, a set builder.
#[derive(Clone, Debug, Default)]
pub(super) struct Scope<'a> {
    pub(super) names: BTreeMap<String, Binding<'a>>,
    /// Where they are declared.
    pub(super) spans: BTreeMap<String, Span>,
}

/// What a name stands for.
pub(super) enum Found {
    /// A value.
    Value(ExprId),
    /// Functions, by the module that the meanings belong to.
    Functions(Vec<(ModuleId, Meaning)>),
    /// A size that a type declares.
    Dimension,
    /// Nothing that is known; it has been reported.
    Error,
}

impl<'a> Checker<'a> {
    /// Evaluates `check` with a further scope.
    pub(super) fn with_scope<T>(
        &mut self,
        scope: Scope<'a>,
        check: impl FnOnce(&mut Self) -> T,
    ) -> T {
        self.scopes.push(scope);
        let value = check(self);
        self.scopes.pop();
        value
    }

    /// Evaluates `check` in another module, outside of all scopes.
    pub(super) fn in_module<T>(
        &mut self,
        module: ModuleId,
        check: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let scopes = std::mem::take(&mut self.scopes);
        let plus_minus = self.plus_minus.take();
        let before = std::mem::replace(&mut self.module, module);
        let value = check(self);
        self.module = before;
        self.scopes = scopes;
        self.plus_minus = plus_minus;
        value
    }

    /// A bound variable with its expression, entered in a scope under its name.
    pub(super) fn bind(&mut self, scope: &mut Scope<'a>, name: &Name, ty: Type) -> VariableId {
        let variable = self.program.arena.new_variable(&name.text, ty);
        let value = self.program.arena.variable(variable);
        scope.names.insert(name.text.clone(), Binding::Value(value));
        scope.spans.insert(name.text.clone(), name.span);
        variable
    }

    /// Enters local definitions in a scope.
    pub(super) fn bind_locals(&mut self, scope: &mut Scope<'a>, locals: &'a [ast::Definition]) {
        for definition in locals {
            for (target, left) in definition.targets.iter().enumerate() {
                let binding = Binding::Local(definition, target);
                let text = &left.name.text;
                if scope.names.insert(text.clone(), binding).is_some() {
                    let before = scope.spans.get(text).copied();
                    let message = format!("`{text}` is defined twice");
                    self.report(
                        Diagnostic::error(left.name.span, message)
                            .here("defined again here")
                            .label(before.unwrap_or(left.name.span), "declared here")
                            .help("rename one of the two: the names of one definition must differ"),
                    );
                }
                scope.spans.insert(text.clone(), left.name.span);
            }
        }
    }

    /// What a name stands for.
    pub(super) fn find(&mut self, name: &Name) -> Found {
        for depth in (0..self.scopes.len()).rev() {
            match self.scopes[depth].names.get(&name.text) {
                None => {}
                Some(Binding::Value(value)) => return Found::Value(*value),
                Some(Binding::Open) => {
                    let place = self.scopes[depth].spans.get(&name.text).copied();
                    let message = format!("the value of `{}` depends on itself", name.text);
                    self.report(
                        Diagnostic::error(place.unwrap_or(name.span), message)
                            .label(name.span, format!("`{}` is needed here again", name.text))
                            .help("local definitions may stand in any order, but not in a circle"),
                    );
                    return Found::Error;
                }
                Some(Binding::Local(definition, target)) => {
                    let (definition, target) = (*definition, *target);
                    return Found::Value(self.local(depth, definition, target));
                }
            }
        }
        self.find_in_module(self.module, &name.text)
    }

    /// Checks a local definition in the scope that it belongs to, and enters its values there.
    fn local(&mut self, depth: usize, definition: &'a ast::Definition, target: usize) -> ExprId {
        let inner = self.scopes.split_off(depth + 1);
        for left in &definition.targets {
            self.scopes[depth]
                .names
                .insert(left.name.text.clone(), Binding::Open);
        }
        let plus_minus = self.plus_minus.take();
        let values = self.definition_values(definition);
        self.plus_minus = plus_minus;
        for (left, value) in definition.targets.iter().zip(&values) {
            self.scopes[depth]
                .names
                .insert(left.name.text.clone(), Binding::Value(*value));
        }
        self.scopes.extend(inner);
        values[target]
    }

    /// What a name of a module stands for.
    pub(super) fn find_in_module(&mut self, module: ModuleId, name: &str) -> Found {
        let Some(symbol) = self.resolved.module(module).symbols.get(name) else {
            return if crate::syntax::builtin::ALWAYS.contains(&name) {
                Found::Functions(vec![(module, Meaning::Builtin(name.to_owned()))])
            } else {
                Found::Error
            };
        };
        let meanings = symbol.meanings.clone();
        let mut functions = Vec::new();
        for meaning in meanings {
            match &meaning {
                Meaning::Parameter {
                    item,
                    declaration,
                    target,
                } => {
                    return match self.input((*item, *declaration, *target)) {
                        Some(value) => Found::Value(value),
                        None => Found::Error,
                    };
                }
                Meaning::Definition { item, target } => {
                    let values = self.definition(module, *item);
                    return match values.get(*target) {
                        Some(value) => Found::Value(*value),
                        None => Found::Error,
                    };
                }
                Meaning::Argument(..) if self.misfits.contains(&(module, name.to_owned())) => {
                    return Found::Error;
                }
                Meaning::Argument(other, name) | Meaning::Import(other, name) => {
                    match self.find_in_module(*other, name) {
                        Found::Functions(more) => functions.extend(more),
                        found => return found,
                    }
                }
                Meaning::Dimension => return Found::Dimension,
                Meaning::Functions(_) | Meaning::Builtin(_) => functions.push((module, meaning)),
            }
        }
        if functions.is_empty() {
            Found::Error
        } else {
            Found::Functions(functions)
        }
    }
}
