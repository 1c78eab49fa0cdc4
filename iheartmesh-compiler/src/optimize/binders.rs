//! Expressions that differ only in the names of their bound variables become one.
//!
//! ```text
//! ∑_(f ∈ F) a(f)  +  ∑_(g ∈ F) a(g)   ⟶   s + s   where s = ∑_(f ∈ F) a(f)
//! ```
//!
//! Derivatives and replaced calls write a sum again with variables of its own wherever its value is needed. Two binders are
//! compared by a form in which a variable is named by how many binders stand below its own: the form knows no other
//! names, and a binder never stands inside of one of the same name.

use std::collections::HashMap;

use super::rewrite::{self, bound_variables};
use crate::ir::{Arena, ExprId, Program, VariableId};
use crate::types::Type;

/// Unites the binders of each definition and function. Those of different ones stay apart: a variable of a loop is also the
/// name of the rows that its definition reads.
pub fn run(program: &mut Program) {
    let Program {
        arena,
        globals,
        functions,
        ..
    } = program;
    let values = globals.iter_mut().map(|global| &mut global.value);
    let bodies = functions.iter_mut().map(|function| &mut function.body);
    for e in values.chain(bodies) {
        *e = expression(arena, *e);
    }
}

/// Unites the binders of an expression.
pub fn expression(arena: &mut Arena, e: ExprId) -> ExprId {
    let (mut binders, mut first) = (Binders::default(), HashMap::new());
    rewrite::upward(arena, e, &mut HashMap::new(), &mut |arena, e| {
        if bound_variables(&mut arena.kind(e).clone()).is_empty() {
            return e;
        }
        let form = binders.form(arena, e);
        *first.entry(form).or_insert(e)
    })
}

/// Forms of expressions that are equal where only the names of bound variables differ.
#[derive(Default)]
pub struct Binders {
    /// The form of each expression, and the number of binders below each other in it.
    forms: HashMap<ExprId, (ExprId, usize)>,
    /// The variables of the forms: by the number of binders below, the place among the variables of one binder, the type.
    names: HashMap<(usize, usize, Type), VariableId>,
}

impl Binders {
    /// The form of an expression.
    pub fn form(&mut self, arena: &mut Arena, e: ExprId) -> ExprId {
        self.form_and_depth(arena, e).0
    }

    fn form_and_depth(&mut self, arena: &mut Arena, e: ExprId) -> (ExprId, usize) {
        if let Some(&done) = self.forms.get(&e) {
            return done;
        }
        let mut depth = 0;
        let mut kind = arena.kind(e).clone().map_operands(|operand| {
            let (form, below) = self.form_and_depth(arena, operand);
            depth = depth.max(below);
            form
        });
        let mut named = HashMap::new();
        for (place, variable) in bound_variables(&mut kind).iter_mut().enumerate() {
            let key = (depth, place, arena.variable_type(*variable).clone());
            let ty = key.2.clone();
            let new = *self
                .names
                .entry(key)
                .or_insert_with(|| arena.new_variable("bound", ty));
            named.insert(*variable, arena.variable(new));
            *variable = new;
        }
        if !named.is_empty() {
            depth += 1;
            let mut memo = HashMap::new();
            kind = kind.map_operands(|operand| rewrite::put(arena, operand, &named, &mut memo));
        }
        let ty = arena.ty(e).clone();
        let done = (arena.add(kind, ty), depth);
        self.forms.insert(e, done);
        done
    }
}
