//! Calls of functions that mix topology and values are replaced by their bodies.
//!
//! ```text
//! f(a)  ⟶  body of f with a for its parameter
//! ```
//!
//! Fires for functions that depend on values, do not recurse and are small enough. A *field*, a function of one element
//! with some work in it, is left as a call: it has a plan of its own, and its values may be computed once for all
//! elements. After this pass what is static in a body can be seen together with the loop that it stands in.

use std::collections::{BTreeSet, HashMap};

use super::binding::Binding;
use super::rewrite;
use crate::ir::{Arena, ExprId, Function, FunctionId, Kind, Program};
use crate::types::{Atom, Type};

/// A body with more expressions than this is not copied.
const LARGEST_BODY: usize = 600;
/// A function of one element with at least this many operations is a field.
const LEAST_FIELD: usize = 6;

/// Inlines all calls that qualify.
pub fn run(program: &mut Program) {
    let binding = Binding::of(program);
    let mut done = BTreeSet::new();
    for id in program.function_ids() {
        function(program, &binding, &mut done, id);
    }
    for k in 0..program.globals.len() {
        let value = program.globals[k].value;
        program.globals[k].value = body(program, &binding, &mut done, value);
    }
}

fn function(
    program: &mut Program,
    binding: &Binding,
    done: &mut BTreeSet<FunctionId>,
    id: FunctionId,
) {
    if !done.insert(id) {
        return;
    }
    let old = program.function(id).body;
    let new = body(program, binding, done, old);
    program.functions[id.0 as usize].body = new;
}

fn body(
    program: &mut Program,
    binding: &Binding,
    done: &mut BTreeSet<FunctionId>,
    e: ExprId,
) -> ExprId {
    // what is called comes first, so that its body is final when it is copied
    let mut callees = BTreeSet::new();
    reachable(&program.arena, e, &mut |kind| {
        if let Kind::Call(id, _) = kind {
            callees.insert(*id);
        }
    });
    for &callee in &callees {
        if !program.function(callee).recursive {
            function(program, binding, done, callee);
        }
    }
    let inlined: BTreeSet<FunctionId> = callees
        .into_iter()
        .filter(|id| is_inlined(program, binding, *id))
        .collect();
    let bodies: HashMap<FunctionId, (Vec<_>, ExprId)> = inlined
        .iter()
        .map(|id| {
            let f = program.function(*id);
            (
                *id,
                (f.parameters.iter().map(|p| p.variable).collect(), f.body),
            )
        })
        .collect();
    rewrite::upward(
        &mut program.arena,
        e,
        &mut HashMap::new(),
        &mut |arena, e| match arena.kind(e).clone() {
            Kind::Call(id, arguments) => match bodies.get(&id) {
                Some((parameters, body)) => {
                    let variables = parameters.iter().copied().zip(arguments).collect();
                    rewrite::substitute(arena, *body, &variables)
                }
                None => e,
            },
            _ => e,
        },
    )
}

fn is_inlined(program: &Program, binding: &Binding, id: FunctionId) -> bool {
    let function = program.function(id);
    if binding.functions[id.0 as usize] || function.recursive || has_own_sizes(program, function) {
        return false;
    }
    let mut size = 0;
    reachable(&program.arena, function.body, &mut |_| size += 1);
    size <= LARGEST_BODY && !is_field(program, id)
}

/// Whether parameters of a function have sizes that no parameter of the program has: types in its body name them, and
/// mean nothing elsewhere.
fn has_own_sizes(program: &Program, function: &Function) -> bool {
    let mut known = BTreeSet::new();
    let mut note = |atom: &Atom| {
        known.insert(atom.clone());
    };
    for input in &program.inputs {
        note(&Atom::Symbol(input.name.clone()));
        input.ty.atoms(&mut note);
    }
    let mut own = false;
    for parameter in &function.parameters {
        parameter
            .ty
            .atoms(&mut |atom| own |= matches!(atom, Atom::Symbol(_)) && !known.contains(atom));
    }
    own
}

/// Whether a function is of one element and has enough work in it to be worth storing its values.
pub fn is_field(program: &Program, id: FunctionId) -> bool {
    let function = program.function(id);
    let [parameter] = function.parameters.as_slice() else {
        return false;
    };
    let mut operations = 0;
    reachable(&program.arena, function.body, &mut |kind| {
        operations += usize::from(matches!(
            kind,
            Kind::Unary(..) | Kind::Binary(..) | Kind::Fold { .. } | Kind::Call(..)
        ));
        if matches!(kind, Kind::Optimum { .. } | Kind::Integral { .. }) {
            operations += LEAST_FIELD;
        }
    });
    matches!(parameter.ty, Type::Element(_)) && operations >= LEAST_FIELD && stored(&function.ty)
}

/// Whether values of a type can stand in a field: numbers and vectors.
fn stored(ty: &Type) -> bool {
    matches!(ty, Type::Scalar(_)) || ty.fixed_vector().is_some()
}

/// Calls `f` with each different expression inside of one.
pub fn reachable(arena: &Arena, e: ExprId, f: &mut impl FnMut(&Kind)) {
    let mut seen = BTreeSet::new();
    let mut open = vec![e];
    while let Some(e) = open.pop() {
        if seen.insert(e) {
            f(arena.kind(e));
            arena.kind(e).operands(|operand| open.push(operand));
        }
    }
}
