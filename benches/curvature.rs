//! Generated curvatures and normals against hand-written ones; prints Markdown tables.
//!
//! ```text
//! cargo bench --bench curvature                      # everything, up to a million vertices
//! cargo bench --bench curvature -- --max 100000      # smaller meshes only
//! cargo bench --bench curvature -- --table plan      # one table: whole, plan, one, mesh, without
//! ```
//!
//! Under `cargo test --benches` it runs on a tiny mesh, to see that it works.

// The values of the loops are what is measured; their names are those of the formulas.
#![allow(non_snake_case)]

mod baseline;
#[path = "../examples/common/generate.rs"]
#[allow(dead_code)]
mod generate;
#[path = "curvature/measure.rs"]
mod measure;
#[path = "curvature/programs.rs"]
mod programs;
#[path = "curvature/tables.rs"]
mod tables;

use std::time::Duration;

use measure::Effort;
use tables::Setting;

/// Prints a table.
type Table = fn(Setting);

fn main() {
    let mut setting = Setting {
        largest: 1_000_000,
        effort: Effort {
            least_rounds: 5,
            budget: Duration::from_secs(2),
        },
    };
    let mut table = None;
    let mut is_bench = false;
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        let mut value = || arguments.next().unwrap_or_else(|| usage(&argument));
        match argument.as_str() {
            "--bench" => is_bench = true,
            "--test" => is_bench = false,
            "--max" => {
                setting.largest = value().parse().unwrap_or_else(|_| usage(&argument));
            }
            "--seconds" => {
                let seconds: f64 = value().parse().unwrap_or_else(|_| usage(&argument));
                setting.effort.budget =
                    Duration::try_from_secs_f64(seconds).unwrap_or_else(|_| usage(&argument));
            }
            "--table" => table = Some(value()),
            _ => usage(&argument),
        }
    }
    if !is_bench {
        setting.largest = 0;
        setting.effort = Effort {
            least_rounds: 1,
            budget: Duration::ZERO,
        };
    }
    let all: [(&str, Table); 5] = [
        ("whole", tables::whole),
        ("plan", tables::plan),
        ("one", tables::one),
        ("mesh", tables::mesh_table),
        ("without", tables::without),
    ];
    if let Some(name) = &table
        && !all.iter().any(|(other, _)| other == name)
    {
        usage(name);
    }
    for (name, print) in all {
        if table.as_deref().is_none_or(|wanted| wanted == name) {
            print(setting);
        }
    }
}

fn usage(argument: &str) -> ! {
    eprintln!(
        "`{argument}`? options: --max VERTICES, --seconds PER_ROW, --table whole|plan|one|mesh|without"
    );
    std::process::exit(2)
}
