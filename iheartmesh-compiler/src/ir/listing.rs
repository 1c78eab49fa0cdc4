//! How programs are shown: `hlangc --emit ir` and `--emit types`.

use std::fmt::Write;

use super::{FunctionId, Program, expression};

/// All of a program: inputs, definitions, functions.
pub fn program(program: &Program) -> String {
    let mut text = String::new();
    for id in &program.input_order {
        let input = program.input(*id);
        let _ = writeln!(text, "input {} : {}", input.name, input.ty);
    }
    for global in &program.globals {
        let ty = program.arena.ty(global.value);
        let _ = writeln!(
            text,
            "let {} : {ty} = {}",
            global.name,
            expression(program, global.value)
        );
    }
    for id in program.function_ids() {
        let _ = writeln!(text, "{}", function(program, id));
    }
    text
}

/// The types of inputs, definitions and functions: `hlangc --emit types`.
pub fn types(program: &Program) -> String {
    let mut text = String::new();
    for id in &program.input_order {
        let input = program.input(*id);
        let _ = writeln!(text, "parameter {} : {}", input.name, input.ty);
    }
    for global in &program.globals {
        let _ = writeln!(
            text,
            "definition {} : {}",
            global.name,
            program.arena.ty(global.value)
        );
    }
    for function in &program.functions {
        let parameters: Vec<String> = function
            .parameters
            .iter()
            .map(|p| match p.within_name.is_empty() {
                true => format!("{} : {}", p.name, p.ty),
                false => format!("{} : {} of {}", p.name, p.ty, p.within_name),
            })
            .collect();
        let _ = writeln!(
            text,
            "{} {}({}) : {}",
            if function.own {
                "function"
            } else {
                "imported function"
            },
            function.name,
            parameters.join(", "),
            function.ty
        );
    }
    text
}

/// A function on a line of its own.
fn function(program: &Program, id: FunctionId) -> String {
    let function = program.function(id);
    let parameters: Vec<String> = function
        .parameters
        .iter()
        .map(|p| format!("{} : {}", p.name, p.ty))
        .collect();
    format!(
        "fn {}#{}({}) : {}{} =\n    {}",
        function.name,
        id.0,
        parameters.join(", "),
        function.ty,
        if function.recursive {
            ", recursive"
        } else {
            ""
        },
        expression(program, function.body)
    )
}
