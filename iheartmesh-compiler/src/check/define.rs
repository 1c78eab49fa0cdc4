//! Definitions without parameters, of a module and local ones.

use super::{Checker, Definition};
use crate::diagnostic::Diagnostic;
use crate::ir::{ExprId, Global, GlobalId, Kind};
use crate::resolve::ModuleId;
use crate::resolve::symbols::count;
use crate::span::Span;
use crate::syntax::ast::{self, ItemKind};
use crate::types::Type;

impl<'a> Checker<'a> {
    /// The values of the targets of a module's definition.
    pub(super) fn definition(&mut self, module: ModuleId, item: usize) -> Vec<ExprId> {
        let syntax = &self.resolved.module(module).syntax.items[item];
        let ItemKind::Definition(definition) = &syntax.kind else {
            return Vec::new();
        };
        match self.definitions.get(&(module, item)) {
            Some(Definition::Done(values)) => return values.clone(),
            Some(Definition::Open) => {
                // the cycle has been reported when names were resolved
                self.circular = true;
                let error = self.error();
                return vec![error; definition.targets.len()];
            }
            None => {}
        }
        self.definitions.insert((module, item), Definition::Open);
        let parts = match definition.targets.as_slice() {
            [target] if !target.subscripts.is_empty() && self.has_no_meaning(module, target) => {
                // two meanings of one name have been reported
                let values = vec![self.error()];
                self.definitions
                    .insert((module, item), Definition::Done(values.clone()));
                return values;
            }
            [target] => self.parts(module, item, &target.name.text),
            _ => None,
        };
        let mut values = self.in_module(module, |checker| match &parts {
            Some(parts) => vec![checker.by_parts(module, parts)],
            None => checker.definition_values(definition),
        });
        for (value, target) in values.iter_mut().zip(&definition.targets) {
            *value = self.named(&target.name.text, *value, syntax.span);
        }
        self.definitions
            .insert((module, item), Definition::Done(values.clone()));
        values
    }

    fn has_no_meaning(&self, module: ModuleId, target: &ast::LeftSide) -> bool {
        let symbol = self.resolved.module(module).symbols.get(&target.name.text);
        symbol.is_some_and(|symbol| symbol.meanings.is_empty())
    }

    /// The value of a definition by its name, so that it is computed once; what costs nothing stays as it is.
    pub(super) fn named(&mut self, name: &str, value: ExprId, span: Span) -> ExprId {
        let costs_nothing = matches!(
            self.program.arena.kind(value),
            Kind::AllElements(_)
                | Kind::Boundary(_)
                | Kind::Integer(_)
                | Kind::Real(_)
                | Kind::Input(_)
                | Kind::Global(_)
                | Kind::Fail
        );
        if costs_nothing {
            return value;
        }
        let ty = self.ty(value).clone();
        self.program.globals.push(Global {
            name: name.to_owned(),
            value,
            span,
        });
        let id = GlobalId(self.program.globals.len() as u32 - 1);
        self.add(Kind::Global(id), ty)
    }

    /// The values of the left-hand sides of a definition.
    pub(super) fn definition_values(&mut self, definition: &'a ast::Definition) -> Vec<ExprId> {
        let n = definition.targets.len();
        if definition.add {
            // what it is added to has been reported
            let error = self.error();
            return vec![error; n];
        }
        if definition.targets.iter().any(|t| !t.subscripts.is_empty()) {
            if n > 1 {
                let error = self.several_at_once(definition);
                return vec![error; n];
            }
            return vec![self.entries(definition, None, None)];
        }
        let value = self.expr(&definition.value);
        if n == 1 {
            return vec![value];
        }
        self.destructure(definition, value)
    }

    /// `a, b += …`, `a_i, b_i = …`.
    pub(super) fn several_at_once(&mut self, definition: &ast::Definition) -> ExprId {
        let message = "several names cannot be defined by their entries at once";
        self.report(
            Diagnostic::error(definition_names(definition), message)
                .help("write a definition for each; `+=` and subscripts stand behind one name"),
        )
    }

    /// Takes a tuple, set or vector apart.
    fn destructure(&mut self, definition: &ast::Definition, value: ExprId) -> Vec<ExprId> {
        let n = definition.targets.len();
        let names: Vec<String> = definition
            .targets
            .iter()
            .map(|t| format!("`{}`", t.name.text))
            .collect();
        let ty = self.ty(value).clone();
        let span = definition.value.span;
        let size = match &ty {
            Type::Tuple(items) => Some(items.len() as i64),
            Type::Vector { .. } => ty.fixed_vector(),
            Type::Set(_) | Type::Sequence { .. } => None,
            Type::Error => return vec![value; n],
            other => {
                let found = other.described();
                let message = format!("cannot take {found} apart into {}", names.join(", "));
                let diagnostic = Diagnostic::error(span, message)
                    .here(format!("this is {found}"))
                    .help("several names on the left need a tuple, a set or a vector on the right");
                let diagnostic = self.with_origins(diagnostic, &[&definition.value]);
                let error = self.report(diagnostic);
                return vec![error; n];
            }
        };
        // a built-in function that gives one result for each kind of element may be taken in part
        let may_be_part =
            matches!(&ty, Type::Tuple(_)) && self.is_connectivity_call(&definition.value);
        if let Some(size) = size
            && size != n as i64
            && !(may_be_part && n as i64 <= size)
        {
            let message = format!(
                "{} on the left but {} on the right",
                count(n, "name"),
                count(size as usize, "value")
            );
            let error = self.report(
                Diagnostic::error(definition_names(definition), message)
                    .label(span, format!("this is {}", ty.described()))
                    .help(format!("give {} on the left", count(size as usize, "name"))),
            );
            return vec![error; n];
        }
        // in a function equal values are computed once, those of a module are not known to each other
        let value = match (self.scopes.is_empty(), &ty, self.program.arena.kind(value)) {
            (_, _, Kind::Tuple(_)) => value,
            (true, Type::Tuple(_), _) => {
                self.named(&names.join(", ").replace('`', ""), value, definition.span)
            }
            _ => value,
        };
        let whole = match &ty {
            Type::Set(_) => self.add_at(span, Kind::Sized(value, n as u32), ty.clone()),
            _ => value,
        };
        (0..n)
            .map(|k| {
                let index = self.program.arena.integer(k as i64 + 1);
                match &ty {
                    Type::Tuple(items) => self.project(value, k, items[k].clone()),
                    Type::Set(item) => {
                        let item = self.item_type(item, index);
                        self.add_at(span, Kind::SetItem(whole, index), item)
                    }
                    Type::Sequence { item, .. } => {
                        let item = self.item_type(item, index);
                        self.add_at(span, Kind::Item(value, index), item)
                    }
                    Type::Vector { number, .. } => {
                        self.add(Kind::Component(value, index), Type::Scalar(*number))
                    }
                    _ => value,
                }
            })
            .collect()
    }

    /// An item of a tuple, from 0.
    pub(super) fn project(&mut self, tuple: ExprId, index: usize, ty: Type) -> ExprId {
        if let Kind::Tuple(items) = self.program.arena.kind(tuple) {
            return items[index];
        }
        self.add(Kind::Project(tuple, index as u32), ty)
    }

    fn is_connectivity_call(&self, value: &ast::Expr) -> bool {
        matches!(&value.kind, ast::ExprKind::Call { function, .. }
            if ["ElementSets", "BoundaryMatrices", "UnsignedBoundaryMatrices"].contains(&function.text.as_str()))
    }
}

/// Where the names on the left stand.
fn definition_names(definition: &ast::Definition) -> Span {
    match (definition.targets.first(), definition.targets.last()) {
        (Some(first), Some(last)) => first.name.span.to(last.name.span),
        _ => definition.span,
    }
}
