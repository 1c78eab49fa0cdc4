//! What the tests of the syntax share.

#![allow(dead_code)]

use iheartmesh_compiler::render::render_all;
use iheartmesh_compiler::source::{Source, Sources};
use iheartmesh_compiler::span::SourceId;
use iheartmesh_compiler::syntax::{NoImports, dump, parse};

/// The tree of a text and what is wrong with it.
pub fn show(text: &str) -> String {
    let source = Source::file("test.hlang", text);
    let (module, diagnostics) = parse(&source, SourceId(0), &NoImports);
    let mut shown = dump(&module);
    if !diagnostics.is_empty() {
        let mut sources = Sources::default();
        sources.add(source);
        shown += &render_all(&sources, &diagnostics);
        shown.push('\n');
    }
    shown
}

/// The symbols that the probes of the language reference use.
const PROBES: &str = "a, b, c, n ∈ ℝ\n\
w_i ∈ ℝ\n\
x_i ∈ ℝ^3\n\
u, v ∈ ℝ^3\n\
A, B ∈ ℝ^(3×3)\n\
f ∈ ℝ→ℝ\n\
S, W, U ∈ {ℤ}\n\
P ∈ {ℤ×ℤ}\n\
r, s, y ∈ ℝ";

/// Compares the table of some probes.
pub fn check_probes(rows: &str, expected: expect_test::Expect) {
    expected.assert_eq(&table(PROBES, rows));
}

/// For each line of `rows` in the scope of `context`: its tree, or its first message.
pub fn table(context: &str, rows: &str) -> String {
    let mut shown = String::new();
    let (known, _) = parse(&Source::file("context", context), SourceId(0), &NoImports);
    let skipped = dump(&known).len();
    for row in rows.lines().map(str::trim).filter(|row| !row.is_empty()) {
        let row = row.replace(" NL ", "\n");
        let source = Source::file("test.hlang", format!("{context}\n{row}"));
        let (module, diagnostics) = parse(&source, SourceId(0), &NoImports);
        let tree = dump(&module);
        let tree = tree
            .get(skipped..)
            .unwrap_or("")
            .trim_end()
            .replace('\n', "\n      ");
        let row = row.replace('\n', " NL ");
        shown += &match diagnostics.sorted().first() {
            None => format!("{row}\n   => {tree}\n"),
            Some(found) => {
                let help = found.help.as_deref().unwrap_or("");
                format!(
                    "{row}\n   {:?}: {}\n   = {help}\n",
                    found.severity, found.message
                )
            }
        };
    }
    shown
}

/// All texts of the corpus with their names, in alphabetic order.
pub fn corpus() -> Vec<(String, String)> {
    let directory = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/corpus/syntax");
    let entries = std::fs::read_dir(directory).expect("the corpus is part of the crate");
    let mut texts: Vec<(String, String)> = entries
        .map(|entry| {
            let path = entry.expect("a readable directory").path();
            let name = path
                .file_stem()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned();
            (
                name,
                std::fs::read_to_string(path).expect("a readable file"),
            )
        })
        .collect();
    texts.sort();
    texts
}
