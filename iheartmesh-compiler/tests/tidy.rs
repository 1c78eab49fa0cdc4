//! Keeps the layout as it is meant: which part may use which, how long files are, that each says what it is.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Which parts of the compiler a part may use besides itself; those of the root need no entry.
///
/// `syntax::ast` stands for the vocabulary of the tree alone, `syntax::ast::CompareOp` for this one type.
const MAY_USE: [(&str, &[&str]); 10] = [
    ("syntax", &["span", "source", "diagnostic"]),
    ("types", &["syntax::ast"]),
    ("resolve", &["span", "diagnostic", "syntax"]),
    (
        "check",
        &[
            "span",
            "diagnostic",
            "syntax",
            "resolve",
            "types",
            "ir",
            "derive",
        ],
    ),
    ("ir", &["span", "types", "syntax::ast::CompareOp"]),
    (
        "derive",
        &["span", "types", "ir", "optimize", "syntax::ast::CompareOp"],
    ),
    ("optimize", &["ir", "types", "span"]),
    (
        "emit",
        &[
            "span",
            "source",
            "diagnostic",
            "types",
            "ir",
            "optimize",
            "syntax::ast::CompareOp",
        ],
    ),
    (
        "interpret",
        &["types", "ir", "optimize", "syntax::ast::CompareOp"],
    ),
    ("render", &["span", "source", "diagnostic"]),
];

/// The most lines of a file.
const MOST_LINES: usize = 500;

/// Files that are longer, each with the reason.
const LONGER: [(&str, &str); 4] = [
    (
        "iheartmesh-compiler/src/check/operator.rs",
        "the table of what each operator takes",
    ),
    (
        "iheartmesh-compiler/src/syntax/ast.rs",
        "the vocabulary of one language, nearly all documentation",
    ),
    (
        "iheartmesh-compiler/src/emit/rust/item.rs",
        "the struct and its methods refer to each other's names",
    ),
    (
        "iheartmesh-compiler/src/emit/rust/method.rs",
        "all forms of one method",
    ),
];

/// Where the Rust of the workspace stands.
const FOLDERS: [&str; 13] = [
    "src",
    "iheartmesh-compiler/src",
    "iheartmesh-compiler/tests",
    "iheartmesh-macros/src",
    "iheartmesh-runtime/src",
    "iheartmesh-runtime/tests",
    "solve/src",
    "solve/tests",
    "neighborhoods/src",
    "tests/random-programs/generate",
    "tests/random-programs/tests",
    "examples",
    "benches",
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// All Rust files below a folder with their texts, by their path from the root of the workspace.
fn files(folder: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_owned()];
    while let Some(folder) = open.pop() {
        let Ok(entries) = std::fs::read_dir(root().join(&folder)) else {
            continue;
        };
        for entry in entries {
            let path = entry.expect("a readable folder").path();
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let name = format!("{folder}/{name}");
            if path.is_dir() {
                open.push(name);
            } else if name.ends_with(".rs") {
                let text = std::fs::read_to_string(&path).expect("a readable file");
                found.push((name, text));
            }
        }
    }
    found.sort();
    found
}

/// The paths of this crate that a text names, without comments and without its unit tests.
fn used(text: &str) -> BTreeSet<String> {
    let code = text.split("#[cfg(test)]").next().unwrap_or_default();
    let lines = code.lines().filter(|l| !l.trim_start().starts_with("//"));
    let code: String = lines.collect::<Vec<_>>().join("\n");
    let is_part = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    let mut found = BTreeSet::new();
    for (at, _) in code.match_indices("crate::") {
        if code[..at].ends_with(is_part) {
            continue;
        }
        let rest = &code[at + "crate::".len()..];
        let path: String = rest.chars().take_while(|c| is_part(*c)).collect();
        let group = rest[path.len()..].strip_prefix('{');
        let group = group.and_then(|g| g.split('}').next()).unwrap_or_default();
        match group.is_empty() {
            true => drop(found.insert(path)),
            false => {
                let names = group.split(',').map(str::trim).filter(|n| !n.is_empty());
                found.extend(names.map(|name| format!("{path}{name}")));
            }
        }
    }
    found
}

#[test]
fn parts_use_only_what_is_below_them() {
    let mut wrong = Vec::new();
    for (part, allowed) in MAY_USE {
        let mut sources = files(&format!("iheartmesh-compiler/src/{part}"));
        let file = format!("iheartmesh-compiler/src/{part}.rs");
        if let Ok(text) = std::fs::read_to_string(root().join(&file)) {
            sources.push((file, text));
        }
        assert!(!sources.is_empty(), "`{part}` is a part of the compiler");
        for (file, text) in sources {
            for path in used(&text) {
                let is_below =
                    |allowed: &&str| path == *allowed || path.starts_with(&format!("{allowed}::"));
                if !is_below(&part) && !allowed.iter().any(is_below) {
                    wrong.push(format!("{file} uses `crate::{path}`"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The compiler writes paths of the runtime and never runs it; what compiles and what runs need nothing of each other.
#[test]
fn crates_depend_one_way() {
    let forbidden = [
        (
            "iheartmesh-compiler/Cargo.toml",
            ["iheartmesh-runtime", "iheartmesh-macros", "sprs", "glam"],
        ),
        (
            "iheartmesh-runtime/Cargo.toml",
            [
                "iheartmesh-compiler",
                "iheartmesh-macros",
                "proc-macro2",
                "quote",
            ],
        ),
    ];
    for (file, crates) in forbidden {
        let text = std::fs::read_to_string(root().join(file)).expect("a manifest");
        for name in crates {
            let depends = text.lines().any(|line| {
                line.strip_prefix(name)
                    .is_some_and(|rest| rest.starts_with([' ', '.', '=']))
            });
            assert!(!depends, "{file} depends on {name}");
        }
    }
}

#[test]
fn files_are_short_and_say_what_they_are() {
    let mut wrong = Vec::new();
    for (file, text) in FOLDERS.iter().flat_map(|folder| files(folder)) {
        let lines = text.lines().count();
        let reason = LONGER.iter().find(|(longer, _)| *longer == file);
        if lines > MOST_LINES && reason.is_none() {
            wrong.push(format!("{file} has {lines} lines, more than {MOST_LINES}"));
        }
        if !text.starts_with("//!") && !text.starts_with("#![") {
            wrong.push(format!("{file} does not begin with `//!`"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn reasons_are_for_files_that_exist() {
    for (file, reason) in LONGER {
        assert!(root().join(file).is_file(), "{file} is gone");
        assert!(!reason.is_empty(), "{file} needs a reason");
    }
}

#[test]
fn paths_are_found_in_code_only() {
    let text = "use crate::a::{B, c::D};\n// crate::no\nlet x = crate::e::f(::crate::g);\n#[cfg(test)] crate::h";
    let found: Vec<String> = used(text).into_iter().collect();
    assert_eq!(found, ["a::B", "a::c::D", "e::f"]);
}
