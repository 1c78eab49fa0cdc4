//! Programs are worth the same before and after the passes: many random ones, by the interpreter.

#[allow(dead_code, unused_imports, reason = "a part of the tests")]
#[path = "../generate/mod.rs"]
mod generate;

use generate::{Form, Generated, agree, compile, deep, energy, interpret, program, seeds};
use iheartmesh_compiler::optimize::Optimizations;

/// The first disagreement of a program.
fn disagreement(generated: &Generated) -> Option<String> {
    let inlined = Optimizations::ALL;
    let called = Optimizations {
        inline: false,
        ..inlined
    };
    let mut stages = Vec::new();
    for optimizations in [Optimizations::NONE, called, inlined] {
        match compile(generated, optimizations) {
            Ok(found) => stages.push(found),
            Err(messages) => return Some(format!("it is rejected:\n{messages}")),
        }
    }
    let expected = interpret(generated, &stages[0], Form::Checked);
    for (stages, optimizations) in stages[1..].iter().zip([called, inlined]) {
        for form in [Form::Rewritten, Form::Staged] {
            let found = interpret(generated, stages, form);
            for ((name, expected), (_, found)) in expected.iter().zip(&found) {
                // an inlined function leaves out arguments that it does not use, those without a value too
                let left_out = optimizations.inline && expected == "fault";
                if !agree(expected, found) && !left_out {
                    return Some(format!(
                        "{name} is {expected}\n{form:?}: {found}, inlined: {}",
                        optimizations.inline
                    ));
                }
            }
        }
    }
    None
}

#[test]
fn passes_keep_values() {
    deep(|| compare(150, program));
}

#[test]
fn passes_keep_derivatives() {
    deep(|| compare(60, |seed| energy(seed).generated));
}

fn compare(usual: u64, program: fn(u64) -> Generated) {
    let mut wrong = Vec::new();
    for seed in seeds(usual) {
        let generated = program(seed);
        let found = std::panic::catch_unwind(|| disagreement(&generated));
        let found = found.unwrap_or_else(|_| Some("it panics".to_owned()));
        if let Some(found) = found {
            wrong.push(format!("seed {seed}: {found}\n{}", generated.source));
        }
    }
    assert!(
        wrong.is_empty(),
        "{} programs\n{}",
        wrong.len(),
        wrong.join("\n\n")
    );
}
