//! Derivatives of random numbers against differences of their values.
//!
//! Differences of fourth order with two lengths of steps say themselves how exact they are. Where they are not, since
//! there is a kink nearby or a value that rounding blurs, nothing is compared. `tests/passes.rs` and `tests/values` carry the
//! values of these derivatives on, to optimised programs and to generated Rust.

#[allow(dead_code, unused_imports, reason = "a part of the tests")]
#[path = "../generate/mod.rs"]
mod generate;

use generate::{Energy, Form, Generated, compile, deep, energy, evaluate, seeds};
use iheartmesh_compiler::Stages;
use iheartmesh_compiler::interpret::Value;
use iheartmesh_compiler::optimize::Optimizations;

/// The longer step of the differences.
const STEP: f64 = 1e-3;

/// The real numbers of a value, in the order of `vec`.
fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Real(x) => vec![*x],
        Value::Reals(a) => a.as_slice().to_vec(),
        Value::Sequence(items) => items.iter().flat_map(numbers).collect(),
        _ => panic!("no real numbers: {value:?}"),
    }
}

/// Adds to one of them.
fn shift(value: &mut Value, k: usize, by: f64) {
    match value {
        Value::Real(x) => *x += by,
        Value::Reals(a) => a.as_mut_slice()[k] += by,
        Value::Sequence(items) => {
            let each = items.first().map_or(1, |item| numbers(item).len());
            shift(&mut items[k / each], k % each, by);
        }
        _ => panic!("no real numbers: {value:?}"),
    }
}

/// How much was compared.
#[derive(Debug, Default)]
struct Tally {
    compared: usize,
    /// Of these, not 0.
    substantial: usize,
    left_out: usize,
    without_value: usize,
}

/// The values of some definitions as numbers; nothing where one of them has none.
fn values(generated: &Generated, stages: &Stages, names: &[&str]) -> Option<Vec<Vec<f64>>> {
    let values = evaluate(generated, stages, Form::Checked, names).into_iter();
    values
        .map(|value| value.ok().map(|value| numbers(&value)))
        .collect()
}

/// Compares the derivatives of a program, and says what differs.
fn disagreement(energy: &Energy, tally: &mut Tally) -> Option<String> {
    let generated = &energy.generated;
    let stages = match compile(generated, Optimizations::NONE) {
        Ok(stages) => stages,
        Err(messages) => return Some(format!("it is rejected:\n{messages}")),
    };
    for (number, x) in energy.variables.iter().enumerate() {
        let (gradient, hessian) = (format!("g{number}"), format!("H{number}"));
        // what is differentiated, and its derivatives: for each entry of x a row of these
        let mut pairs = vec![("e", gradient.as_str()), (&gradient, &hessian)];
        if energy.is_mixed && number == 1 {
            pairs.push(("g0", "B"));
        }
        let functions: Vec<&str> = pairs.iter().map(|(function, _)| *function).collect();
        let all: Vec<&str> = pairs.iter().flat_map(|(f, d)| [*f, *d]).collect();
        let Some(here) = values(generated, &stages, &all) else {
            tally.without_value += 1;
            continue;
        };
        let place = generated.inputs.iter().position(|(name, _)| name == x)?;
        let n = numbers(&generated.inputs[place].1.value).len();
        // of many entries every third
        for k in (0..n).filter(|k| n < 9 || k % 3 == number % 3) {
            let mut moved = generated.clone();
            let at = |by: f64| {
                shift(&mut moved.inputs[place].1.value, k, by);
                let found = values(&moved, &stages, &functions);
                moved.inputs[place] = generated.inputs[place].clone();
                found
            };
            let steps = [2.0, -2.0, 1.0, -1.0, 0.5, -0.5].map(|s| s * STEP);
            let Some(around) = steps.map(at).into_iter().collect::<Option<Vec<_>>>() else {
                tally.without_value += 1;
                continue;
            };
            for (f, (function, derivative)) in pairs.iter().enumerate() {
                let (value, expected) = (&here[2 * f], &here[2 * f + 1]);
                if expected.len() != n * value.len() {
                    return Some(format!(
                        "{derivative} has {} entries, not {n}⋅{}",
                        expected.len(),
                        value.len()
                    ));
                }
                for (row, value) in value.iter().enumerate() {
                    let near = |s: usize| around[s][f][row];
                    let difference = |s: usize, step: f64| {
                        (8.0 * (near(s + 2) - near(s + 3)) - (near(s) - near(s + 1)))
                            / (12.0 * step)
                    };
                    let (coarse, fine) = (difference(0, STEP), difference(2, 0.5 * STEP));
                    // entry of the row of the function, in the column of the variable
                    let entry = expected[row + k * here[2 * f].len()];
                    let error = 4.0 * (coarse - fine).abs() + 1e-9 * (1.0 + value.abs());
                    let is_exact = error <= 1e-4 * (1.0 + fine.abs());
                    if !is_exact || !entry.is_finite() {
                        tally.left_out += 1;
                        continue;
                    }
                    tally.compared += 1;
                    tally.substantial += usize::from(fine.abs() > 1e-3);
                    if (entry - fine).abs() > error + 1e-7 * fine.abs() {
                        return Some(format!(
                            "{derivative}, of {function} number {row} by {x} number {k}, is {entry}, but differences give {fine} ± {error:.0e}"
                        ));
                    }
                }
            }
        }
    }
    None
}

#[test]
fn derivatives_are_limits_of_differences() {
    deep(compare);
}

fn compare() {
    let mut wrong = Vec::new();
    let mut tally = Tally::default();
    let seeds = seeds(150);
    for seed in seeds.clone() {
        let energy = energy(seed);
        let found = std::panic::catch_unwind(|| {
            let mut tally = Tally::default();
            (disagreement(&energy, &mut tally), tally)
        });
        match found {
            Ok((found, of_this)) => {
                tally.compared += of_this.compared;
                tally.substantial += of_this.substantial;
                tally.left_out += of_this.left_out;
                tally.without_value += of_this.without_value;
                if let Some(found) = found {
                    let source = &energy.generated.source;
                    wrong.push(format!("seed {seed}: {found}\n{source}"));
                }
            }
            Err(_) => wrong.push(format!(
                "seed {seed}: it panics\n{}",
                energy.generated.source
            )),
        }
    }
    println!("{tally:?}");
    assert!(
        wrong.is_empty(),
        "{} programs\n{}",
        wrong.len(),
        wrong.join("\n\n")
    );
    // the test does not pass by leaving everything out
    let programs = (seeds.end - seeds.start) as usize;
    assert!(tally.compared > 30 * programs, "{tally:?}");
    assert!(tally.substantial > 5 * programs, "{tally:?}");
    assert!(20 * tally.left_out < tally.compared, "{tally:?}");
    assert!(tally.without_value < programs, "{tally:?}");
}
