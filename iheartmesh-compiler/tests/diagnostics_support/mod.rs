//! Cases of wrong programs: how they are read from a file, compiled, and written back with what the compiler says.
//!
//! A file holds several cases, each a heading, a program, the modules that it imports and the messages:
//!
//! ```text
//! === what is wrong
//! y = a + 1
//! +++ Module
//! a = 2
//! ---
//! error: …
//! ```

use std::path::{Path, PathBuf};

use iheartmesh_compiler::diagnostic::Diagnostics;
use iheartmesh_compiler::optimize::Optimizations;
use iheartmesh_compiler::render::render_all;
use iheartmesh_compiler::source::Source;
use iheartmesh_compiler::{Library, Outcome, Request, compile};

/// A program with what is expected of it.
#[derive(Debug, PartialEq)]
pub struct Case {
    /// What is wrong with it.
    pub title: String,
    /// The program.
    pub program: String,
    /// Names and texts of the modules that stand below it.
    pub modules: Vec<(String, String)>,
    /// The messages.
    pub expected: String,
}

impl Case {
    /// Compiles the program as the module `Program` of the file `program.hlang`.
    pub fn outcome(&self) -> Outcome {
        let own = self.modules.iter().map(|(name, text)| Library {
            name: name.clone(),
            source: Source::file(format!("{name}.hlang"), text.as_str()),
        });
        outcome(
            Source::file("program.hlang", self.program.as_str()),
            own.chain(neighborhoods()).collect(),
        )
    }

    /// The messages as they are shown.
    pub fn messages(&self) -> String {
        std::panic::catch_unwind(|| shown(&self.outcome()))
            .unwrap_or_else(|_| "the compiler panics".to_owned())
    }
}

/// Compiles a source.
pub fn outcome(source: Source, libraries: Vec<Library>) -> Outcome {
    compile(Request {
        name: quote::format_ident!("Program"),
        visibility: quote::quote!(pub),
        attributes: quote::quote!(),
        krate: quote::quote!(::iheartmesh),
        source,
        libraries,
        optimizations: Optimizations::ALL,
        together: Vec::new(),
    })
}

/// The messages of an outcome.
pub fn shown(outcome: &Outcome) -> String {
    assert_eq!(outcome.code.is_none(), outcome.diagnostics.has_errors());
    match render_all(&outcome.sources, &outcome.diagnostics) {
        text if text.is_empty() => "nothing is wrong".to_owned(),
        text => text,
    }
}

/// The standard modules.
pub fn neighborhoods() -> Vec<Library> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../neighborhoods/src");
    files(Path::new(folder))
        .into_iter()
        .map(|file| {
            let name = file
                .file_stem()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned();
            let source = Source::file(format!("{name}.hlang"), read(&file));
            Library { name, source }
        })
        .collect()
}

/// The `.hlang` files of a folder in alphabetic order.
pub fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("a folder of the repository");
    let mut files: Vec<PathBuf> = entries
        .map(|entry| entry.expect("a readable folder").path())
        .filter(|file| file.extension().is_some_and(|e| e == "hlang"))
        .collect();
    files.sort();
    files
}

/// The text of a file.
pub fn read(file: &Path) -> String {
    std::fs::read_to_string(file).unwrap_or_else(|e| panic!("{}: {e}", file.display()))
}

/// The cases of a file.
pub fn parse(text: &str) -> Vec<Case> {
    enum Part {
        Program,
        Module,
        Expected,
    }
    let mut cases: Vec<Case> = Vec::new();
    let mut part = Part::Program;
    for line in text.lines() {
        if let Some(title) = line.strip_prefix("=== ") {
            cases.push(Case {
                title: title.to_owned(),
                program: String::new(),
                modules: Vec::new(),
                expected: String::new(),
            });
            part = Part::Program;
            continue;
        }
        let case = cases
            .last_mut()
            .expect("a file starts with the heading of a case");
        let text = match (line.strip_prefix("+++ "), &part) {
            (Some(name), Part::Program | Part::Module) => {
                case.modules.push((name.to_owned(), String::new()));
                part = Part::Module;
                continue;
            }
            _ if line == "---" => {
                part = Part::Expected;
                continue;
            }
            (_, Part::Program) => &mut case.program,
            (_, Part::Module) => &mut case.modules.last_mut().expect("a module").1,
            (_, Part::Expected) => &mut case.expected,
        };
        text.push_str(line);
        text.push('\n');
    }
    for case in &mut cases {
        case.expected = case.expected.trim_end().to_owned();
    }
    cases
}

/// The text of a file of these cases.
pub fn print(cases: &[Case]) -> String {
    let cases = cases.iter().map(|case| {
        let modules: String = case
            .modules
            .iter()
            .map(|(name, text)| format!("+++ {name}\n{text}"))
            .collect();
        format!(
            "=== {}\n{}{modules}---\n{}\n",
            case.title, case.program, case.expected
        )
    });
    cases.collect::<Vec<_>>().join("\n")
}

/// All cases of all folders, with the name of their file.
pub fn all_cases() -> Vec<(String, Case)> {
    ["parse", "resolve", "check"]
        .into_iter()
        .flat_map(|name| files(&folder(name)))
        .flat_map(|file| {
            let name = file.display().to_string();
            parse(&read(&file))
                .into_iter()
                .map(move |case| (name.clone(), case))
        })
        .collect()
}

/// A folder of cases.
pub fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/diagnostics")
        .join(name)
}
/// The places in the compiler where these messages were made.
pub fn origins(diagnostics: &Diagnostics) -> Vec<String> {
    diagnostics
        .sorted()
        .into_iter()
        .map(|d| format!("{}:{}", d.raised.file(), d.raised.line()))
        .collect()
}
