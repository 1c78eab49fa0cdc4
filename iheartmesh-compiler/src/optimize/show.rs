//! How staged programs are shown: `hlangc --emit plan`.

use std::fmt::Write;

use super::{Corners, Plan, Rows, Staged, StagedProgram};
use crate::ir::{FunctionId, GlobalId, expression};
use crate::types::display::plural;

/// The static part, then for every function and definition that depends on values its plan and its body.
pub fn staged(staged: &StagedProgram) -> String {
    let mut text = String::new();
    let program = &staged.program;
    for (k, global) in program.globals.iter().enumerate() {
        match staged.globals.get(&GlobalId(k as u32)) {
            None => {
                let _ = writeln!(
                    text,
                    "static {} = {}",
                    global.name,
                    expression(program, global.value)
                );
            }
            Some(code) => {
                let _ = writeln!(text, "dynamic {}", global.name);
                body(staged, code, &mut text);
            }
        }
    }
    for id in program.function_ids() {
        let function = program.function(id);
        let parameters: Vec<String> = function
            .parameters
            .iter()
            .map(|p| format!("{}.{}", p.name, p.variable.0))
            .collect();
        let head = format!("{}#{}({})", function.name, id.0, parameters.join(", "));
        match staged.functions.get(&id) {
            None => {
                let _ = writeln!(
                    text,
                    "static {head} = {}",
                    expression(program, function.body)
                );
            }
            Some(code) => {
                let _ = writeln!(text, "dynamic {head}");
                body(staged, code, &mut text);
                whole(staged, code, &mut text);
            }
        }
    }
    text
}

fn body(staged: &StagedProgram, code: &Staged, text: &mut String) {
    plan(staged, &code.plan, text);
    let _ = writeln!(text, "    value {}", expression(&staged.program, code.body));
}

fn plan(staged: &StagedProgram, plan: &Plan, text: &mut String) {
    let program = &staged.program;
    for space in &plan.spaces {
        let name = |v| format!("{}.{}", program.arena.variable_name(v), v.0);
        let rows = match space.rows {
            Rows::Key(element) => format!("one row for each of the {}", plural(element.kind)),
            Rows::Universe(element) => format!("all {}", plural(element.kind)),
            Rows::Members(set) => format!("members of {}", expression(program, set)),
            Rows::Corners(of) => {
                format!("rows {} with the key, turned so that it is first", name(of))
            }
        };
        let parent = space
            .parent
            .map_or(String::new(), |p| format!(" of {}", name(p)));
        let table = match staged.tables.of.get(&space.variable) {
            Some(table) if *table != space.variable => format!(", stored as {}", name(*table)),
            _ => String::new(),
        };
        let variable = name(space.variable);
        let _ = writeln!(text, "    rows {variable}{parent}: {rows}{table}");
        if let Some(corners) = plan.corners.iter().find(|c| c.space == space.variable) {
            turned(corners, text);
            continue;
        }
        for (k, column) in space.columns.iter().enumerate() {
            let mark = if column.may_fail {
                ", may be missing"
            } else {
                ""
            };
            let _ = writeln!(
                text,
                "        ⟨{k}⟩ {}{mark}",
                expression(program, column.value)
            );
        }
    }
    for local in &plan.locals {
        let space = format!(
            "{}.{}",
            program.arena.variable_name(local.space),
            local.space.0
        );
        let columns: Vec<String> = local.calls.iter().map(|(_, k)| format!("⟨{k}⟩")).collect();
        let name = &program.function(local.function).name;
        let _ = writeln!(
            text,
            "    {name}#{} once for each different element in {} of the rows {space} of a key",
            local.function.0,
            columns.join(", ")
        );
    }
}

/// Where the columns of turned rows come from.
fn turned(corners: &Corners, text: &mut String) {
    let circle = corners.circle.map(|k| format!("⟨{k}⟩")).join(" → ");
    for k in 0..2 {
        let merged = corners.merged.iter().filter(|m| m.1 == k + 1);
        let merged: String = merged.map(|m| format!(", the same as ⟨{}⟩", m.0)).collect();
        let _ = writeln!(
            text,
            "        ⟨{k}⟩ {} after the key in {circle}{merged}",
            k + 1
        );
    }
    for (k, column) in (2..).zip(&corners.kept) {
        let _ = writeln!(text, "        ⟨{k}⟩ ⟨{column}⟩");
    }
}

fn whole(staged: &StagedProgram, code: &Staged, text: &mut String) {
    let program = &staged.program;
    let Some(whole) = &code.whole else {
        return;
    };
    let field = |id: &FunctionId| format!("{}#{}", program.function(*id).name, id.0);
    let fields: Vec<String> = whole.fields.iter().map(field).collect();
    if !fields.is_empty() {
        let _ = writeln!(text, "    all: fields {} first", fields.join(", "));
        let _ = writeln!(text, "        value {}", expression(program, whole.body));
    }
    if let Some(orbit) = &whole.orbit {
        let elements: Vec<String> = orbit
            .elements
            .iter()
            .map(|v| format!("element.{}", v.0))
            .collect();
        let exchanged: Vec<&str> = orbit
            .permutation
            .iter()
            .map(|p| elements[*p].as_str())
            .collect();
        let _ = writeln!(
            text,
            "    all: rows in groups ({}) → ({})",
            elements.join(", "),
            exchanged.join(", ")
        );
        for term in &orbit.terms {
            let _ = writeln!(text, "        term {}", expression(program, *term));
        }
        let _ = writeln!(text, "        value {}", expression(program, orbit.rest));
    }
}
