//! Functions that call themselves, or each other in a circle.
//!
//! Bodies are checked when a function is first called. A call of a function whose body is still being checked has no type
//! yet; so the type of the result follows from the branches without such calls. With the types of all functions of the
//! circle their bodies are then checked again, until no type changes any more.

use super::Checker;
use super::scope::Scope;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::ir::{ExprId, FunctionId};
use crate::resolve::ModuleId;
use crate::syntax::ast;
use crate::types::{Atom, Type};

/// How often the bodies of a circle are checked at most. Types only go from ℤ to ℝ, or to a size known at run time, so
/// a few times suffice.
const MOST_ROUNDS: usize = 8;

/// What the body of a function is checked with.
#[derive(Clone, Debug)]
pub(super) struct Body<'a> {
    pub(super) id: FunctionId,
    pub(super) module: ModuleId,
    pub(super) syntax: &'a ast::Function,
    pub(super) scope: Scope<'a>,
    pub(super) templates: std::collections::BTreeMap<String, ExprId>,
}

/// The functions whose types are not settled.
#[derive(Debug, Default)]
pub(super) struct Recursion<'a> {
    /// Those that are being checked, each called by the one before.
    open: Vec<Open>,
    /// Those that have been checked and call one of the open ones, with its place among them.
    pending: Vec<(Body<'a>, usize)>,
}

#[derive(Debug)]
struct Open {
    id: FunctionId,
    /// The first of the open functions that it calls, itself or through others.
    calls: Option<usize>,
}

impl<'a> Checker<'a> {
    /// Checks a body, and again with those that it forms a circle with.
    pub(super) fn check_function(&mut self, body: Body<'a>) {
        let depth = self.recursion.open.len();
        let first = self.recursion.pending.len();
        let before = self.diagnostics.clone();
        self.recursion.open.push(Open {
            id: body.id,
            calls: None,
        });
        self.check_body(&body);
        match self.recursion.open[depth].calls {
            None => {}
            Some(calls) if calls < depth => {
                self.recursion.pending.push((body, calls));
                for (_, other) in &mut self.recursion.pending[first..] {
                    *other = calls.min(*other);
                }
                self.recursion.open.pop();
                self.note_call(calls);
                return;
            }
            Some(_) => {
                self.recursion.pending.insert(first, (body, depth));
                self.settle(first, before);
            }
        }
        self.recursion.pending.truncate(first);
        self.recursion.open.pop();
    }

    fn check_body(&mut self, body: &Body<'a>) {
        let templates = std::mem::replace(&mut self.templates, body.templates.clone());
        let value = self.with_scope(body.scope.clone(), |checker| {
            checker.function_value(body.syntax)
        });
        self.templates = templates;
        let ty = self.ty(value).clone();
        if !ty.is_error() {
            self.results.insert(body.id, ty.clone());
        }
        let function = &mut self.program.functions[body.id.0 as usize];
        function.body = value;
        function.ty = ty;
    }

    /// Checks the bodies of a circle until their types are settled.
    fn settle(&mut self, first: usize, before: Diagnostics) {
        let mut said_before = Diagnostics::default();
        for _ in 0..MOST_ROUNDS {
            let said = std::mem::replace(self.diagnostics, before.clone());
            said_before.extend(said);
            let mut is_settled = true;
            let mut k = first;
            while let Some((body, _)) = self.recursion.pending.get(k).cloned() {
                let known = self.results.get(&body.id).map(without_numbers);
                self.program.functions[body.id.0 as usize].recursive = true;
                self.in_module(body.module, |checker| checker.check_body(&body));
                is_settled &= self.results.get(&body.id).map(without_numbers) == known;
                k += 1;
            }
            if is_settled {
                break;
            }
        }
        // what else was checked on the way is not checked again
        for diagnostic in said_before.sorted() {
            let is_known = |d: &&Diagnostic| d.span() == diagnostic.span();
            if !self.diagnostics.sorted().iter().any(is_known) {
                self.diagnostics.push(diagnostic.clone());
            }
        }
        let mut endless: Vec<Body<'a>> = self.recursion.pending[first..]
            .iter()
            .map(|(body, _)| body.clone())
            .filter(|body| !self.results.contains_key(&body.id))
            .collect();
        endless.sort_by_key(|body| body.syntax.name.span);
        let is_said = *self.diagnostics.sorted() != *before.sorted() || self.circular;
        if let [one, others @ ..] = endless.as_slice()
            && !is_said
        {
            let name = &one.syntax.name;
            let others: Vec<String> = others
                .iter()
                .map(|other| format!("`{}`", other.syntax.name.text))
                .collect();
            let through = match others.is_empty() {
                true => String::new(),
                false => format!(", through {}", others.join(" and ")),
            };
            let message = format!(
                "`{}` never ends: it needs itself in every case{through}",
                name.text
            );
            self.report(Diagnostic::error(name.span, message).help(
                "a branch that gives a value without calling it ends the recursion, as in `{ 1 if k < 1`",
            ));
        }
    }

    /// The type of the result of a function that is called.
    pub(super) fn result(&mut self, id: FunctionId) -> Type {
        let recursion = &self.recursion;
        let is_open = recursion.open.iter().position(|open| open.id == id);
        let is_pending = || {
            let mut pending = recursion.pending.iter();
            pending
                .find(|(body, _)| body.id == id)
                .map(|(_, calls)| *calls)
        };
        if let Some(calls) = is_open.or_else(is_pending) {
            self.note_call(calls);
        }
        self.results.get(&id).cloned().unwrap_or(Type::Error)
    }

    /// The function being checked calls an open one, or one that calls it.
    fn note_call(&mut self, called: usize) {
        if let Some(open) = self.recursion.open.last_mut() {
            open.calls = Some(open.calls.map_or(called, |calls| calls.min(called)));
        }
    }
}

/// A type in which sizes that are known only at run time are not told apart.
fn without_numbers(ty: &Type) -> Type {
    ty.with_atoms(&|atom| matches!(atom, Atom::Dynamic(_)).then_some(Atom::Dynamic(0)))
}
