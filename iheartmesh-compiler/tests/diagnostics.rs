//! What the compiler says of wrong programs: the message stands in the file of the program, below it.
//!
//! `UPDATE_EXPECT=1 cargo test --test diagnostics` writes the messages anew.

mod diagnostics_support;

use std::collections::BTreeSet;
use std::path::Path;

use diagnostics_support::{all_cases, files, folder, origins, outcome, parse, print, read, shown};
use expect_test::{Expect, expect};
use iheartmesh_compiler::source::Source;
use iheartmesh_compiler::span::SourceId;
use iheartmesh_compiler::syntax::{self, ast};

fn check_folder(name: &str) {
    let update = std::env::var_os("UPDATE_EXPECT").is_some();
    let mut wrong = Vec::new();
    for file in files(&folder(name)) {
        let mut cases = parse(&read(&file));
        for case in &mut cases {
            let found = case.messages();
            if found != case.expected && !update {
                wrong.push(format!(
                    "{}, {}: expected\n{}\n\nfound\n{found}",
                    file.display(),
                    case.title,
                    case.expected
                ));
            }
            case.expected = found;
        }
        if update {
            std::fs::write(&file, print(&cases)).expect("the folder of the cases is writable");
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

#[test]
fn texts_that_are_not_programs() {
    check_folder("parse");
}

#[test]
fn names() {
    check_folder("resolve");
}

#[test]
fn types() {
    check_folder("check");
}

/// Every place that makes a message is reached by a case: those that say what is not supported yet excepted.
#[test]
fn every_message_has_a_case() {
    let mut reached = BTreeSet::new();
    for (_, case) in all_cases() {
        reached.extend(origins(&case.outcome().diagnostics));
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut missing = Vec::new();
    for stage in ["resolve", "check"] {
        let entries = std::fs::read_dir(root.join("src").join(stage)).expect("the stage's folder");
        let mut files: Vec<_> = entries
            .map(|entry| entry.expect("a file").file_name())
            .collect();
        files.sort();
        for file in files {
            let name = format!("src/{stage}/{}", file.to_string_lossy());
            let text = read(&root.join(&name));
            let mut helper = false;
            for (number, line) in text.lines().enumerate() {
                // a helper that is told where it is called from counts there
                helper = match line {
                    _ if line.trim() == "#[track_caller]" => true,
                    "    }" | "}" => false,
                    _ => helper,
                };
                let makes = MAKERS.iter().any(|maker| line.contains(maker));
                let place = format!("{name}:{}", number + 1);
                let guard = GUARDS.contains(&line.trim());
                if makes && !helper && !guard && !reached.iter().any(|r| r.ends_with(&place)) {
                    missing.push(format!("{place}: {}", line.trim()));
                }
            }
        }
    }
    assert!(
        missing.is_empty(),
        "no program in tests/diagnostics reaches\n{}",
        missing.join("\n")
    );
}

/// What makes a message: the constructors, and helpers that are told where they are called from.
const MAKERS: [&str; 7] = [
    "Diagnostic::error(",
    "Diagnostic::warning(",
    "self.mismatch(",
    "self.bars(",
    "self.wrong(",
    "self.wrong_count(",
    "self.not_a_set(",
];

/// Messages that no program is known to cause, kept where a case of a `match` has to say something.
const GUARDS: [&str; 2] = [
    "return self.mismatch(sides, \"multiply\", \"and\", &ta, &tb, \"their sizes do not fit\");",
    "Diagnostic::error(rows[r][k].span, message)",
];

#[test]
fn line_breaks_of_other_systems() {
    let text = "a ∈ ℝ\r\nu ∈ ℝ³\r\n\r\ny = ½\ta +\tu\r\n";
    check(
        Source::file("program.hlang", text),
        expect![[r#"
            error: cannot add ℝ and ℝ³
             --> program.hlang:4:5
              |
            2 | u ∈ ℝ³
              | - `u` is declared here
            3 |
            4 | y = ½    a +    u
              |     ^^^^^^      - this is ℝ³
              |     |
              |     this is ℝ
              |
              = help: a number and a vector have no sum; `‖u‖` is the length of a vector `u`
        "#]],
    );
}

#[test]
fn a_literal_of_a_rust_file() {
    let source = Source {
        file: "src/main.rs".to_owned(),
        text: "a ∈ ℝ\n    u ∈ ℝ³\n    y = a + u".to_owned(),
        first_line: 12,
        indents: vec![24],
        places: Vec::new(),
    };
    check(
        source,
        expect![[r#"
            error: cannot add ℝ and ℝ³
              --> src/main.rs:14:9
               |
            12 |                         a ∈ ℝ
               |                         - `a` is declared here
            13 |     u ∈ ℝ³
               |     - `u` is declared here
            14 |     y = a + u
               |         ^   - this is ℝ³
               |         |
               |         this is ℝ
               |
               = help: a number and a vector have no sum; `‖u‖` is the length of a vector `u`
        "#]],
    );
}

fn check(source: Source, expected: Expect) {
    expected.assert_eq(&(shown(&outcome(source, Vec::new())) + "\n"));
}

/// What the compiler tells of the standard module is what it has.
#[test]
fn names_of_the_standard_module() {
    for library in diagnostics_support::neighborhoods() {
        let (module, _) = syntax::parse(&library.source, SourceId(0), &syntax::NoImports);
        for item in module.items {
            let names: Vec<_> = match item.kind {
                ast::ItemKind::Function(f) => vec![f.name.text],
                ast::ItemKind::Definition(d) => {
                    d.targets.into_iter().map(|t| t.name.text).collect()
                }
                _ => continue,
            };
            for name in names {
                // names of one letter or in back-ticks are its own, and two others are old spellings
                if name.chars().count() == 1
                    || !name.chars().all(|c| c.is_ascii_alphabetic())
                    || ["NextVertexInFace", "NextVerticeInFace"].contains(&name.as_str())
                {
                    continue;
                }
                let import = syntax::builtin::import_of(&name);
                let from = |module: &str| Some(format!("{name} from {module}(M)"));
                assert!(
                    import == from("Neighborhoods") || import == from(&library.name),
                    "{name}: {import:?}"
                );
            }
        }
    }
}
