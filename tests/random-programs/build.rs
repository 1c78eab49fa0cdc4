//! Compiles random programs to Rust, and writes down what the interpreter says that they are worth.

#[allow(
    missing_docs,
    dead_code,
    unused_imports,
    reason = "a part of the tests"
)]
mod generate;

use std::fmt::Write;
use std::path::PathBuf;

use generate::{Form, Generated, compile, deep, energy, interpret, program, seeds};
use iheartmesh_compiler::emit::rust::{Header, emit};
use iheartmesh_compiler::optimize::Optimizations;
use quote::quote;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-changed=generate");
    println!("cargo:rerun-if-env-changed=IHEARTMESH_SEEDS");
    let text = deep(|| {
        let mut text = String::new();
        let mut list = String::new();
        // programs by seeds, and some with derivatives
        let range = seeds(50);
        let energies = (range.start..range.end).step_by(3);
        let programs = range.map(|seed| (format!("p{seed}"), program(seed)));
        let energies = energies.map(|seed| (format!("e{seed}"), energy(seed).generated));
        for (name, generated) in programs.chain(energies) {
            text.push_str(&module(&name, &generated));
            let _ = writeln!(list, "    ({name}::run as fn(), {name:?}),");
        }
        let _ = writeln!(text, "pub const PROGRAMS: &[(fn(), &str)] = &[\n{list}];");
        text
    });
    let folder = PathBuf::from(std::env::var_os("OUT_DIR").expect("cargo sets it"));
    std::fs::write(folder.join("programs.rs"), text).expect("the folder is writable");
}

/// A program in both forms, and a function that compares them with what is expected.
fn module(name: &str, generated: &Generated) -> String {
    let source = &generated.source;
    let mut text = format!(
        "mod {name} {{\n    use super::*;\n    pub fn run() {{ compare({name:?}, SOURCE, &[(\"plain\", plain::run, PLAIN), (\"optimized\", optimized::run, OPTIMIZED)]); }}\n    const SOURCE: &str = {source:?};\n"
    );
    for (form_name, constant, form, optimizations) in [
        ("plain", "PLAIN", Form::Checked, Optimizations::NONE),
        (
            "optimized",
            "OPTIMIZED",
            Form::Rewritten,
            Optimizations::ALL,
        ),
    ] {
        let stages = match compile(generated, optimizations) {
            Ok(stages) => stages,
            Err(messages) => panic!("{name}:\n{messages}\n{source}"),
        };
        let expected = interpret(generated, &stages, form);
        let _ = writeln!(
            text,
            "    const {constant}: &[(&str, &str)] = &{expected:?};"
        );
        let Some(staged) = &stages.staged else {
            panic!("{name}: no program");
        };
        let header = Header {
            name: proc_macro2::Ident::new("Random", proc_macro2::Span::call_site()),
            visibility: quote!(pub),
            attributes: quote!(),
            krate: quote!(::iheartmesh),
            source: source.clone(),
        };
        let mut diagnostics = Default::default();
        let code = emit(
            staged,
            &stages.sources,
            &header,
            &mut diagnostics,
            &mut Vec::new(),
        );
        assert!(
            !diagnostics.has_errors(),
            "{name}: {diagnostics:?}\n{source}"
        );
        let _ = writeln!(
            text,
            "    mod {form_name} {{\n        use super::super::*;\n        {code}\n        {}\n    }}",
            run(generated)
        );
    }
    text.push_str("}\n");
    text
}

/// A function that makes the struct and asks for everything.
fn run(generated: &Generated) -> String {
    let mut text =
        String::from("pub fn run() -> Vec<String> {\n            let mut found = Vec::new();\n");
    let mut arguments = Vec::new();
    if let Some(mesh) = &generated.mesh {
        let _ = writeln!(
            text,
            "            let faces: Vec<Vec<u32>> = [{}].map(Vec::from).to_vec();",
            mesh.faces
                .iter()
                .map(|f| format!("&{f:?}[..]"))
                .collect::<Vec<_>>()
                .join(", ")
        );
        let _ = writeln!(
            text,
            "            let mesh = FaceMesh::from_polygons({}, &faces).expect(\"a mesh\");",
            mesh.vertices
        );
        arguments.push("&mesh".to_owned());
    }
    arguments.extend(generated.inputs.iter().map(|(_, datum)| datum.rust.clone()));
    let _ = writeln!(
        text,
        "            let random = match Random::new({}) {{ Ok(random) => random, Err(error) => return vec![error.to_string()] }};",
        arguments.join(", ")
    );
    for name in &generated.definitions {
        let _ = writeln!(
            text,
            "            found.push(outcome(random.try_{name}()));"
        );
    }
    for (name, arguments) in &generated.calls {
        let arguments: Vec<&str> = arguments.iter().map(|datum| datum.rust.as_str()).collect();
        let _ = writeln!(
            text,
            "            found.push(outcome(random.try_{name}({})));",
            arguments.join(", ")
        );
    }
    for (name, _) in &generated.fields {
        let _ = writeln!(
            text,
            "            found.push(outcome(random.try_{name}_all()));"
        );
    }
    text.push_str("            found\n        }");
    text
}
