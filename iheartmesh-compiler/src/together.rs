//! Definitions that are asked for at once: their names, and a definition of all their values.

use crate::derive;
use crate::emit::rust::{Clash, ascii_alias, rust_name};
use crate::ir::{Binary, Export, ExprId, Global, GlobalId, Kind, Pass, Program, Together, Unary};
use crate::optimize::{Optimizations, rewrite};
use crate::types::Type;

use std::collections::HashMap;

/// What is wrong with names that are asked for together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Misfit {
    /// Which of the lists.
    pub list: usize,
    /// Which of its names; `None` for the list itself.
    pub name: Option<usize>,
    /// What is wrong.
    pub message: String,
    /// What to do.
    pub help: String,
}

impl From<Clash> for Misfit {
    fn from(clash: Clash) -> Self {
        let Clash {
            list,
            method,
            other,
        } = clash;
        Self {
            list,
            name: None,
            message: format!(
                "what is asked for together and {other} have the same name in Rust, `{method}`"
            ),
            help: "name the definitions in another order, or rename one".to_owned(),
        }
    }
}

/// Finds the definitions of lists of names, as methods are named.
pub(crate) fn resolve(program: &mut Program, lists: &[Vec<String>]) -> Vec<Misfit> {
    let mut misfits = Vec::new();
    for (list, names) in lists.iter().enumerate() {
        let before = misfits.len();
        let mut misfit = |name: Option<usize>, message: String, help: String| {
            misfits.push(Misfit {
                list,
                name,
                message,
                help,
            });
        };
        let mut members: Vec<GlobalId> = Vec::new();
        for (k, name) in names.iter().enumerate() {
            match definition(program, name) {
                Ok(id) if members.contains(&id) => misfit(
                    Some(k),
                    format!("`{name}` is asked for twice"),
                    "name each definition once".to_owned(),
                ),
                Ok(id) => members.push(id),
                Err(message) => misfit(Some(k), message, definitions(program)),
            }
        }
        if let [name] = names.as_slice()
            && !members.is_empty()
        {
            misfit(
                Some(0),
                format!("`{name}` is asked for together with nothing"),
                format!("name two definitions or more; `{name}` alone has a method already"),
            );
        }
        if names.is_empty() {
            misfit(
                None,
                "nothing is asked for together".to_owned(),
                definitions(program),
            );
        }
        if misfits.len() == before {
            program.together.push(Together {
                members,
                pass: None,
            });
        }
    }
    misfits
}

/// Whether a method is called so.
fn is_named(name: &str, method: &str) -> bool {
    let rust = rust_name(name);
    rust == method || ascii_alias(&rust).is_some_and(|alias| alias == method)
}

fn definition(program: &Program, name: &str) -> Result<GlobalId, String> {
    for export in &program.exports {
        match export {
            Export::Global(id) if is_named(&program.global(*id).name, name) => return Ok(*id),
            Export::Function(id) if is_named(&program.function(*id).name, name) => {
                return Err(format!("`{name}` has parameters and is no definition"));
            }
            _ => {}
        }
    }
    let mut inputs = program.inputs.iter().map(|input| &input.name);
    let mut meshes = program.meshes.iter().map(|mesh| &mesh.name);
    Err(
        match inputs.any(|input| is_named(input, name)) || meshes.any(|mesh| is_named(mesh, name)) {
            true => format!("`{name}` is a parameter and no definition"),
            false => format!("there is no definition `{name}`"),
        },
    )
}

fn definitions(program: &Program) -> String {
    let named = program.exports.iter().filter_map(|export| match export {
        Export::Global(id) => Some(format!("`{}`", rust_name(&program.global(*id).name))),
        Export::Function(_) => None,
    });
    let named: Vec<String> = named.collect();
    match named.as_slice() {
        [] => "there are no definitions".to_owned(),
        named => format!("the definitions are {}", named.join(", ")),
    }
}

/// Adds a definition of all values that may be computed in one pass, for each list.
pub(crate) fn prepare(program: &mut Program, optimizations: Optimizations) {
    if !optimizations.plan || !optimizations.slots {
        return;
    }
    for k in 0..program.together.len() {
        let members = program.together[k].members.clone();
        let order = |id: &GlobalId| {
            let ty = program.arena.ty(program.global(*id).value);
            match ty {
                ty if ty.is_of_any_size() => Some(u8::from(!ty.is_sparse())),
                Type::Scalar(_) if !ty.is_integer() => Some(2),
                _ => None,
            }
        };
        let mut found: Vec<(u8, GlobalId)> = members
            .iter()
            .filter_map(|id| Some((order(id)?, *id)))
            .collect();
        found.sort_by_key(|(order, _)| *order);
        let is_worth_it = |(order, _): &(u8, GlobalId)| *order < 2;
        if found.len() < 2 || !found.iter().any(is_worth_it) {
            continue;
        }
        let variable = found.iter().find_map(|(_, id)| variable(program, *id));
        let members: Vec<GlobalId> = found.iter().map(|(_, id)| *id).collect();
        let values: Vec<ExprId> = found
            .into_iter()
            .map(|(order, id)| {
                let value = program.global(id).value;
                let value = seen_through(program, value);
                let value = match (order, variable) {
                    (2, Some(x)) => derive::value(program, value, x),
                    _ => value,
                };
                // with variables of its own: those of the definitions name the rows that they read
                rewrite::substitute(&mut program.arena, value, &HashMap::new())
            })
            .collect();
        let names: Vec<&str> = members
            .iter()
            .map(|id| program.global(*id).name.as_str())
            .collect();
        let name = names.join(", ");
        let span = program.global(members[0]).span;
        let ty = Type::Tuple(
            values
                .iter()
                .map(|e| program.arena.ty(*e).clone())
                .collect(),
        );
        let value = program.arena.add(Kind::Tuple(values), ty);
        let global = GlobalId(program.globals.len() as u32);
        program.globals.push(Global { name, value, span });
        program.together[k].pass = Some(Pass { global, members });
    }
}

/// A sum in which arrays that have names are written out.
fn seen_through(program: &mut Program, e: ExprId) -> ExprId {
    let ty = program.arena.ty(e).clone();
    if !ty.is_of_any_size() {
        return e;
    }
    let kind = match *program.arena.kind(e) {
        Kind::Global(id) => return seen_through(program, program.global(id).value),
        Kind::Binary(op @ (Binary::Add | Binary::Subtract), a, b) => {
            let (a, b) = (seen_through(program, a), seen_through(program, b));
            Kind::Binary(op, a, b)
        }
        Kind::Binary(Binary::Multiply, k, a) => {
            let a = seen_through(program, a);
            Kind::Binary(Binary::Multiply, k, a)
        }
        Kind::Binary(Binary::Divide, a, k) => {
            let a = seen_through(program, a);
            Kind::Binary(Binary::Divide, a, k)
        }
        Kind::Unary(Unary::Negate, a) => {
            let a = seen_through(program, a);
            Kind::Unary(Unary::Negate, a)
        }
        _ => return e,
    };
    program.arena.add(kind, ty)
}

/// The parameter that the value of a definition is a derivative by: that with as many numbers.
fn variable(program: &mut Program, id: GlobalId) -> Option<ExprId> {
    let size = size(program, program.global(id).value)?;
    for id in program.input_order.clone() {
        let ty = program.input(id).ty.clone();
        if derive::count(&ty).is_none() {
            continue;
        }
        let input = program.arena.add(Kind::Input(id), ty);
        if derive::length(program, input) == size {
            return Some(input);
        }
    }
    None
}

/// The number of rows of a sum of blocks.
fn size(program: &Program, e: ExprId) -> Option<ExprId> {
    match program.arena.kind(e) {
        Kind::Assemble { sizes, .. } => sizes.first().copied(),
        Kind::Binary(Binary::Add | Binary::Subtract, a, b) | Kind::If(_, a, b) => {
            size(program, *a).or_else(|| size(program, *b))
        }
        Kind::Fold { body: a, .. }
        | Kind::Unary(Unary::PositivePart | Unary::AbsolutePart | Unary::Negate, a)
        | Kind::Binary(Binary::Divide, a, _)
        | Kind::Binary(Binary::Multiply, _, a) => size(program, *a),
        _ => None,
    }
}
