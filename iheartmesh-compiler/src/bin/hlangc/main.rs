//! `hlangc`: what a program becomes at each stage, and its canonical text.

mod fmt;

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use iheartmesh_compiler::diagnostic::Diagnostics;
use iheartmesh_compiler::optimize::{Optimizations, show};
use iheartmesh_compiler::render::render;
use iheartmesh_compiler::source::{Source, Sources};
use iheartmesh_compiler::{
    Library, Misfit, Request, compile, imported_modules, ir, resolve, stages_together, syntax,
};

const USAGE: &str = "\
usage: hlangc [--emit STAGE] [--without PASS]... [--together NAMES]... [--library FOLDER]... FILE.hlang
       hlangc fmt [--ascii] [--check] [--library FOLDER]... FILE.hlang...

Compiles a program and prints what it is at a stage:
  ast     the syntax tree
  names   what each name stands for
  types   the types of definitions and functions
  ir      the typed program
  plan    the optimised program: what is computed once per mesh, and what each time
  rust    the generated Rust (the default)

  --without PASS     leaves out an optimisation: traverse, inline, products, nonzeros, steps, share, plan, corners, fields, orbits, slots, or all
  --together NAMES   definitions that are asked for at once, as in `--together e,g,H`
  --library FOLDER   looks for imported modules in FOLDER as well; the standard ones are built in; the folder of the file and any
                     `neighborhoods/src` above it or above the current folder are always looked at

`hlangc fmt` writes the files in the canonical spelling and layout; `hlangc fmt --help` says more";

/// The standard modules, for programs outside of this workspace.
const STANDARD: &[(&str, &str)] = &[
    ("Neighborhoods", FACES),
    ("PolygonNeighborhoods", FACES),
    ("TetrahedronNeighborhoods", CELLS),
    ("TetrahderonNeighborhoods", CELLS),
    ("PointCloudNeighborhoods", EDGES),
];
const FACES: &str = include_str!("../../../../neighborhoods/src/Neighborhoods.hlang");
const CELLS: &str = include_str!("../../../../neighborhoods/src/TetrahedronNeighborhoods.hlang");
const EDGES: &str = include_str!("../../../../neighborhoods/src/PointCloudNeighborhoods.hlang");

struct Arguments {
    emit: String,
    optimizations: Optimizations,
    together: Vec<Vec<String>>,
    folders: Vec<PathBuf>,
    file: PathBuf,
}

fn main() -> ExitCode {
    let mut words = std::env::args_os().skip(1);
    if words.next().is_some_and(|word| word == "fmt") {
        return fmt::main(words);
    }
    let arguments = match or_usage(arguments(), USAGE) {
        Ok(arguments) => arguments,
        Err(end) => return end,
    };
    match run(&arguments) {
        Ok(text) => {
            // a reader that has seen enough may have closed the pipe
            let _ = writeln!(std::io::stdout(), "{}", text.trim_end());
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("{}", message.trim_end());
            ExitCode::FAILURE
        }
    }
}

/// The arguments that were read; or what ends the command, after it has said how it is used: asked for, or because of a mistake.
fn or_usage<T>(arguments: Result<Option<T>, String>, usage: &str) -> Result<T, ExitCode> {
    match arguments {
        Ok(Some(arguments)) => Ok(arguments),
        Ok(None) => {
            println!("{usage}");
            Err(ExitCode::SUCCESS)
        }
        Err(message) => {
            eprintln!("error: {message}\n\n{usage}");
            Err(ExitCode::FAILURE)
        }
    }
}

fn arguments() -> Result<Option<Arguments>, String> {
    use lexopt::prelude::*;
    let mut parser = lexopt::Parser::from_env();
    let mut emit = "rust".to_owned();
    let mut optimizations = Optimizations::ALL;
    let mut together = Vec::new();
    let mut folders = Vec::new();
    let mut file = None;
    let text = |value: std::ffi::OsString| value.string().map_err(|e| e.to_string());
    while let Some(argument) = parser.next().map_err(|e| e.to_string())? {
        match argument {
            Long("help") | Short('h') => return Ok(None),
            Long("emit") => {
                emit = text(parser.value().map_err(|e| e.to_string())?)?;
                if !["ast", "names", "types", "ir", "plan", "rust"].contains(&emit.as_str()) {
                    return Err(format!("there is no stage `{emit}`"));
                }
            }
            Long("without") => {
                let pass = text(parser.value().map_err(|e| e.to_string())?)?;
                if pass == "all" {
                    optimizations = Optimizations::NONE;
                } else if !optimizations.set(&pass, false) {
                    return Err(format!("there is no optimisation `{pass}`"));
                }
            }
            Long("together") => {
                let names = text(parser.value().map_err(|e| e.to_string())?)?;
                let names = names
                    .split(',')
                    .map(str::trim)
                    .filter(|name| !name.is_empty());
                together.push(names.map(str::to_owned).collect());
            }
            Long("library") => folders.push(parser.value().map_err(|e| e.to_string())?.into()),
            Value(value) if file.is_none() => file = Some(PathBuf::from(value)),
            other => return Err(other.unexpected().to_string()),
        }
    }
    match file {
        Some(file) => Ok(Some(Arguments {
            emit,
            optimizations,
            together,
            folders,
            file,
        })),
        None => Err("no file is given".to_owned()),
    }
}

fn run(arguments: &Arguments) -> Result<String, String> {
    let source = read(&arguments.file)?;
    let libraries = libraries(&source, &arguments.folders, arguments.file.parent())?;
    let stem = arguments
        .file
        .file_stem()
        .and_then(|s| s.to_str())
        .unwrap_or("Module");
    if arguments.emit == "rust" {
        let name = stem
            .split(|c: char| !c.is_alphanumeric())
            .map(capitalised)
            .collect::<String>();
        let name = match name.starts_with(|c: char| c.is_alphabetic()) {
            true => name,
            false => "Module".to_owned(),
        };
        let outcome = compile(Request {
            name: proc_macro2::Ident::new(&name, proc_macro2::Span::call_site()),
            visibility: quote::quote!(pub),
            attributes: quote::quote!(),
            krate: quote::quote!(::iheartmesh),
            source,
            libraries,
            optimizations: arguments.optimizations,
            together: arguments.together.clone(),
        });
        let messages = messages(&outcome.sources, &outcome.diagnostics, &outcome.misfits);
        let Some(code) = outcome.code else {
            return Err(messages);
        };
        eprint!("{messages}");
        let file = syn::parse2(code).map_err(|e| format!("bug in iheartmesh: {e}"))?;
        return Ok(prettyplease::unparse(&file));
    }
    let stages = stages_together(
        stem,
        source,
        &libraries,
        arguments.optimizations,
        &arguments.together,
    );
    let messages = messages(&stages.sources, &stages.diagnostics, &stages.misfits);
    let text = match arguments.emit.as_str() {
        "ast" => Some(syntax::dump(&stages.syntax)),
        "names" => Some(resolve::dump(&stages.resolved)),
        "types" => stages.program.as_ref().map(ir::types),
        "ir" => stages.program.as_ref().map(ir::program),
        _ => stages.staged.as_ref().map(show::staged),
    };
    match text {
        Some(text) => {
            eprint!("{messages}");
            Ok(text)
        }
        None => Err(messages),
    }
}

fn capitalised(word: &str) -> String {
    let mut letters = word.chars();
    match letters.next() {
        Some(first) => first.to_uppercase().chain(letters).collect(),
        None => String::new(),
    }
}

fn messages(sources: &Sources, diagnostics: &Diagnostics, misfits: &[Misfit]) -> String {
    let found = diagnostics.sorted().into_iter();
    let found = found.map(|d| format!("{}\n", render(sources, d).trim_end()));
    let misfits = misfits.iter();
    let misfits = misfits.map(|m| format!("error: {}\n  = help: {}\n", m.message, m.help));
    found.chain(misfits).collect()
}

fn read(file: &Path) -> Result<Source, String> {
    match std::fs::read_to_string(file) {
        Ok(text) => Ok(Source::file(file.display().to_string(), text)),
        Err(error) => Err(format!("error: cannot read {}: {error}", file.display())),
    }
}

/// All modules that a text imports, directly or through others.
fn libraries(
    source: &Source,
    folders: &[PathBuf],
    folder: Option<&Path>,
) -> Result<Vec<Library>, String> {
    let mut folders = folders.to_vec();
    let folder = folder.unwrap_or(Path::new(""));
    folders.push(folder.to_owned());
    for start in [folder, Path::new(".")] {
        let absolute = std::path::absolute(start).unwrap_or_default();
        folders.extend(absolute.ancestors().map(|a| a.join("neighborhoods/src")));
    }
    let mut found: Vec<Library> = Vec::new();
    let mut open = imported_modules(source);
    while let Some(name) = open.pop() {
        if found.iter().any(|l| l.name == name) {
            continue;
        }
        // what is not found is reported where it is imported
        let candidates = folders.iter().map(|f| f.join(format!("{name}.hlang")));
        let file = candidates.into_iter().find(|f| f.is_file());
        let standard = STANDARD.iter().find(|(standard, _)| *standard == name);
        let source = match (file, standard) {
            (Some(file), _) => Some(read(&file)?),
            (None, Some((name, text))) => Some(Source::file(format!("{name}.hlang"), *text)),
            (None, None) => None,
        };
        if let Some(source) = source {
            open.extend(imported_modules(&source));
            found.push(Library { name, source });
        }
    }
    Ok(found)
}
