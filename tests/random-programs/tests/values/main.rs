//! What the Rust of random programs computes, with and without optimisations, against the interpreter.
//!
//! `IHEARTMESH_SEEDS=500..600 cargo test -p random-programs --test values` compares other programs.

#[path = "../../generate/agree.rs"]
mod agree;
mod show;

use agree::agree;
use programs::PROGRAMS;

/// The programs, as `build.rs` wrote them.
#[allow(warnings, clippy::all, reason = "code that nobody reads")]
mod programs {
    use super::compare;
    use super::show::{outcome, sparse};
    use iheartmesh::{Edge, Face, FaceMesh, Set, Vertex, glam};
    use nalgebra::{DMatrix, DVector, SMatrix, SVector};

    include!(concat!(env!("OUT_DIR"), "/programs.rs"));
}

/// A form of a program: its name, what computes its values, and these as the interpreter has them, with their names.
type Form = (
    &'static str,
    fn() -> Vec<String>,
    &'static [(&'static str, &'static str)],
);

/// Compares both forms of a program with what is expected.
fn compare(program: &str, source: &str, forms: &[Form]) {
    for (form, run, expected) in forms {
        let found = run();
        assert_eq!(
            found.len(),
            expected.len(),
            "{program}, {form}: {found:?}\n{source}"
        );
        for ((name, expected), found) in expected.iter().zip(&found) {
            assert!(
                agree(expected, found),
                "{program}, {form}: {name} is\n{expected}\nbut the generated code says\n{found}\n{source}"
            );
        }
    }
}

#[test]
fn generated_rust_computes_what_the_interpreter_says() {
    let mut wrong = Vec::new();
    for (run, name) in PROGRAMS {
        if std::panic::catch_unwind(run).is_err() {
            wrong.push(name);
        }
    }
    assert!(wrong.is_empty(), "programs {wrong:?} of {}", PROGRAMS.len());
}
