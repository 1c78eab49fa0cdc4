//! What programs become at each stage.
//!
//! `UPDATE_EXPECT=1 cargo test --test stages` writes the expected texts in `tests/stages` anew.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use iheartmesh_compiler::optimize::{Optimizations, show};
use iheartmesh_compiler::source::Source;
use iheartmesh_compiler::{
    Library, Request, compile, imported_modules, ir, resolve, stages, stages_together, syntax,
};

/// A program of the tests of the whole workspace.
fn program(name: &str) -> PathBuf {
    root().join(format!("../tests/programs/{name}.hlang"))
}

/// A program beside its expected text.
fn small(name: &str) -> PathBuf {
    root().join(format!("tests/stages/{name}.hlang"))
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(file: &Path) -> Source {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    match std::fs::read_to_string(file) {
        Ok(text) => Source::file(name, text),
        Err(error) => panic!("{}: {error}", file.display()),
    }
}

/// The standard modules that a program imports.
fn libraries(source: &Source) -> Vec<Library> {
    let read = |name: String| Library {
        source: read(&root().join(format!("../neighborhoods/src/{name}.hlang"))),
        name,
    };
    imported_modules(source).into_iter().map(read).collect()
}

/// Compares a text with the expected one in `tests/stages`.
fn expect(name: &str, found: &str) {
    let file = root().join("tests/stages").join(name);
    if std::env::var_os("UPDATE_EXPECT").is_some() {
        std::fs::write(&file, found).expect("the folder of expected texts is writable");
        return;
    }
    let expected = std::fs::read_to_string(&file).unwrap_or_default();
    if expected == found {
        return;
    }
    let mut same = expected.lines().zip(found.lines());
    let line = same.position(|(a, b)| a != b);
    let line = line.unwrap_or_else(|| expected.lines().count().min(found.lines().count()));
    let around = |text: &str| {
        let lines: Vec<&str> = text.lines().skip(line.saturating_sub(3)).take(12).collect();
        lines.join("\n")
    };
    panic!(
        "{}, line {}: expected\n{}\n\nfound\n{}\n\nUPDATE_EXPECT=1 writes it anew",
        file.display(),
        line + 1,
        around(&expected),
        around(found)
    );
}

/// All stages of a program, one after the other.
fn check(file: &Path) {
    check_together(file, &[]);
}

/// The same of a program of which some definitions are asked for at once.
fn check_together(file: &Path, together: &[Vec<String>]) {
    let source = read(file);
    let libraries = libraries(&source);
    let name = file.file_stem().unwrap_or_default().to_string_lossy();
    let stages = stages_together(
        "Program",
        source.clone(),
        &libraries,
        Optimizations::ALL,
        together,
    );
    assert!(stages.diagnostics.is_empty(), "{:?}", stages.diagnostics);
    let program = stages.program.as_ref().expect("a program without errors");
    let staged = stages.staged.as_ref().expect("a program without errors");
    let code = compile(Request {
        name: quote::format_ident!("Program"),
        visibility: quote::quote!(pub),
        attributes: quote::quote!(),
        krate: quote::quote!(::iheartmesh),
        source,
        libraries,
        optimizations: Optimizations::ALL,
        together: together.to_vec(),
    });
    let code = code.code.expect("a program without errors");
    let items = syn::parse2(code).expect("generated Rust is Rust");
    let mut text = String::new();
    for (stage, shown) in [
        ("ast", syntax::dump(&stages.syntax)),
        ("names", resolve::dump(&stages.resolved)),
        ("types", ir::types(program)),
        ("ir", ir::program(program)),
        ("plan", show::staged(staged)),
        ("rust", prettyplease::unparse(&items)),
    ] {
        let _ = writeln!(text, "──── {stage} ────\n\n{}\n", shown.trim_end());
    }
    expect(&format!("{name}.txt"), &text);
}

#[test]
fn gaussian_curvature() {
    check(&program("gaussian_curvature"));
}

#[test]
fn mean_curvature() {
    check(&program("mean_curvature"));
}

#[test]
fn vertex_normals() {
    check(&program("vertex_normals"));
}

#[test]
fn piecewise() {
    check(&small("piecewise"));
}

#[test]
fn chains() {
    check(&small("chains"));
}

#[test]
fn sets() {
    check(&small("sets"));
}

#[test]
fn sequences() {
    check(&small("sequences"));
}

#[test]
fn vectors() {
    check(&small("vectors"));
}

#[test]
fn entries() {
    check(&small("entries"));
}

#[test]
fn overloads() {
    check(&small("overloads"));
}

#[test]
fn derivatives() {
    check(&small("derivatives"));
    check(&small("sparse_derivatives"));
}

#[test]
fn projection() {
    check(&small("projection"));
}

#[test]
fn products() {
    check(&small("products"));
}

#[test]
fn optima() {
    check(&small("optima"));
}

#[test]
fn together() {
    let list = ["e", "g", "H"].map(str::to_owned).to_vec();
    check_together(&small("together"), &[list]);
}

/// The plan of one program without each of the optimisations, and without all.
#[test]
fn switches() {
    let source = read(&program("gaussian_curvature"));
    let libraries = libraries(&source);
    let mut text = String::new();
    for switch in Optimizations::NAMES.into_iter().chain(["all"]) {
        let mut optimizations = Optimizations::ALL;
        if switch == "all" {
            optimizations = Optimizations::NONE;
        } else {
            assert!(optimizations.set(switch, false), "`{switch}` is a switch");
        }
        let stages = stages("Program", source.clone(), &libraries, optimizations);
        let staged = stages.staged.as_ref().expect("a program without errors");
        let shown = show::staged(staged);
        let _ = writeln!(text, "──── without {switch} ────\n\n{}\n", shown.trim_end());
    }
    expect("gaussian_curvature.without.txt", &text);
}

/// The same text gives the same code, to the letter.
#[test]
fn compiling_is_deterministic() {
    let source = read(&program("mean_curvature"));
    let libraries = libraries(&source);
    let shown = || {
        let stages = stages("Program", source.clone(), &libraries, Optimizations::ALL);
        show::staged(stages.staged.as_ref().expect("a program without errors"))
    };
    assert_eq!(shown(), shown());
}
