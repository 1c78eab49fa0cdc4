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
    expected.assert_eq(&probes(rows));
}

/// The table of some probes, in the scope of the symbols that they use.
pub fn probes(rows: &str) -> String {
    table(PROBES, rows)
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

/// Everything in the repository that might be a program, with the file it stands in: files, programs in the
/// documentation, and string literals of tests, examples and benchmarks. Many are not programs, or have mistakes.
pub fn programs() -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut open = vec![std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("..")];
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(folder).expect("a readable folder") {
            let path = entry.expect("a readable folder").path();
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let name = name.into_owned();
            if path.is_dir() {
                let skipped =
                    name.starts_with('.') || matches!(name.as_str(), "target" | "fuzz" | "out");
                if !skipped {
                    open.push(path);
                }
                continue;
            }
            let Ok(text) = std::fs::read_to_string(&path) else {
                continue;
            };
            match path.extension().and_then(|e| e.to_str()) {
                Some("hlang") => {
                    found.extend(text.split("\n---\n").map(|t| (name.clone(), t.to_owned())))
                }
                Some("md") => found.extend(fenced(&text).map(|t| (name.clone(), t))),
                Some("rs") => found.extend(literals(&text).map(|t| (name.clone(), t))),
                _ => {}
            }
        }
    }
    found.sort_by(|(_, first), (_, second)| first.cmp(second));
    found.dedup_by(|(_, first), (_, second)| first == second);
    found
}

/// The fenced programs of a page.
fn fenced(text: &str) -> impl Iterator<Item = String> {
    let blocks = text.split("```hlang").skip(1);
    blocks.map(|block| {
        let block = block.split("```").next().unwrap_or_default();
        block
            .split_once('\n')
            .map_or("", |(_, program)| program)
            .to_owned()
    })
}

/// The string literals of Rust; those with escapes as they are written.
fn literals(text: &str) -> impl Iterator<Item = String> {
    let raw = text.split("r#\"").skip(1);
    let raw = raw.filter_map(|rest| rest.split("\"#").next());
    let plain = text.split('"').skip(1).step_by(2);
    let all: Vec<String> = raw.chain(plain).map(str::to_owned).collect();
    all.into_iter()
}

/// Pieces that programs are made of, for random texts.
#[rustfmt::skip]
pub const PIECES: &[&str] = &[
    "a", "f", "xy", "θ", "x̂", "1", "0", "2.5", "½", "²", "ᵀ", "⁻¹", "⁺", "₁", "ᵢ", "_", "^", "+", "-", "±",
    "*", "/", "⋅", "×", "∘", "⊗", "\\", ":", "∪", "∩", "∑", "∏", "∫", "∂", "𝕕", "∇", "Δ", "√", "|", "||", "‖",
    "⟨", "⟩", "<", ">", "=", "≠", "≤", "∈", "∉", "⊂", "→", "(", ")", "[", "]", "{", "}", ",", ";", "\n", " ",
    "  ", "where ", "with ", "if ", "for ", "otherwise", " and ", " or ", " from ", "min_(", "s.t.", "`",
    "`q r`", "#", "ℝ", "ℤ", "π", "∞", "∅", "'", "$", "//", "sum_(", "int_", "with initial ", "FaceMesh",
    "sparse", "\u{0}", "\r\n", "+=",
];
