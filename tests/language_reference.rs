//! Every program that the documentation shows compiles, or fails with the message that stands below it.
//!
//! | fence | what is tested |
//! | --- | --- |
//! | `hlang` | the program compiles without any message |
//! | `hlang,mesh` | the same, with the lines of the page's `hlang,prelude` added below it |
//! | `hlang,fail`, `hlang,mesh,fail` | the messages are those of the `text` fence that follows |
//!
//! In a table with the columns what, example and today, each row is compiled with the prelude: it must compile where it
//! says `yes`, and must not where it says `not yet`.
//!
//! `UPDATE_EXPECT=1 cargo test --test language_reference` writes the messages into the pages.

use std::fs;
use std::path::{Path, PathBuf};

use iheartmesh_compiler::optimize::Optimizations;
use iheartmesh_compiler::source::Source;
use iheartmesh_compiler::syntax::print::Spelling;
use iheartmesh_compiler::{Library, Request, compile, format, imported_modules, render};
use proc_macro2::{Ident, Span};

#[test]
fn readme() {
    check("README.md");
}

#[test]
fn language() {
    check("docs/language.md");
}

#[test]
fn formatting() {
    let page = "docs/formatting.md";
    check(page);
    // the second program is the first one, formatted
    let text = fs::read_to_string(root().join(page)).unwrap();
    let programs = blocks(page, &text);
    let programs: Vec<_> = programs
        .iter()
        .filter(|block| block.tag == "hlang")
        .collect();
    let [before, after] = programs[..] else {
        panic!("{page} has two programs");
    };
    let source = Source::file("before.hlang", before.lines.join("\n"));
    let formatted = format(source, &[], Spelling::Unicode).unwrap();
    assert_eq!(formatted.trim_end(), after.lines.join("\n"));
}

#[test]
fn neighborhoods() {
    check("docs/neighborhoods.md");
    let page = fs::read_to_string(root().join("docs/neighborhoods.md")).unwrap();
    let modules = [
        "Neighborhoods",
        "TetrahedronNeighborhoods",
        "PointCloudNeighborhoods",
    ];
    let sections = [
        "\n## Cell meshes",
        "\n## Edge meshes",
        "\n## Neighbourhoods of",
    ];
    let [cells, edges, end] = sections.map(|title| page.find(title).unwrap());
    let parts = [&page[..cells], &page[cells..edges], &page[edges..end]];
    for (module, part) in modules.iter().zip(parts) {
        let library = root().join(format!("neighborhoods/src/{module}.hlang"));
        for line in fs::read_to_string(library).unwrap().lines() {
            let name = line.split(|c: char| !c.is_alphanumeric()).next().unwrap();
            // one-letter names are meshes, element sets and matrices
            let defined = name.len() > 1
                && line[name.len()..].starts_with(['(', ' '])
                && line.contains(" = ");
            assert!(
                !defined || part.contains(&format!("`{name}")),
                "`{name}` of {module} is not on the page"
            );
        }
    }
}

/// A fenced block of a page.
struct Block {
    /// What stands behind the opening fence.
    tag: String,
    /// Number of the line after the opening fence, from 1.
    line: usize,
    /// The lines between the fences.
    lines: Vec<String>,
}

fn check(page: &str) {
    let path = root().join(page);
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{page}: {error}"));
    let blocks = blocks(page, &text);
    let prelude = blocks.iter().find(|block| block.tag == "hlang,prelude");
    let prelude = prelude.map_or(String::new(), |block| block.lines.join("\n"));

    let update = std::env::var_os("UPDATE_EXPECT").is_some();
    let mut problems = Vec::new();
    let mut replacements = Vec::new();
    let mut programs = 0;
    for (index, block) in blocks.iter().enumerate() {
        let mut tags = block.tag.split(',');
        if tags.next() != Some("hlang") {
            continue;
        }
        programs += 1;
        let (mut mesh, mut fail) = (false, false);
        for tag in tags {
            match tag {
                "mesh" => mesh = true,
                "fail" => fail = true,
                "prelude" => {}
                _ => problems.push(format!("{page}:{}: there is no tag `{tag}`", block.line)),
            }
        }
        let mut program = block.lines.join("\n") + "\n";
        if mesh {
            program.push_str(&prelude);
        }
        let messages = messages(&program);
        if !fail {
            if !messages.is_empty() {
                problems.push(format!("{page}:{}:\n{messages}", block.line));
            }
            continue;
        }
        let expected = blocks.get(index + 1).filter(|next| next.tag == "text");
        let Some(expected) = expected else {
            problems.push(format!("{page}:{}: no `text` follows", block.line));
            continue;
        };
        let messages: Vec<String> = messages
            .lines()
            .map(|line| line.trim_end().to_owned())
            .collect();
        if messages.is_empty() {
            problems.push(format!("{page}:{}: this compiles", block.line));
        } else if messages != expected.lines {
            if update {
                replacements.push((expected, messages));
            } else {
                let messages = messages.join("\n");
                problems.push(format!(
                    "{page}:{}: the messages are\n{messages}",
                    block.line
                ));
            }
        }
    }
    assert!(programs > 0, "{page} shows no program");
    for (line, row) in (1..).zip(text.lines()) {
        let row = row.replace("\\|", "\0");
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        let &["", _, example, today @ ("yes" | "not yet"), ""] = &cells[..] else {
            continue;
        };
        let example = example.trim_matches('`').replace('\0', "|");
        if example.is_empty() {
            continue;
        }
        let messages = messages(&format!("{example}\n{prelude}"));
        if messages.is_empty() != (today == "yes") {
            problems.push(format!(
                "{page}:{line}: `{example}` does not do what the row says\n{messages}"
            ));
        }
    }

    if !replacements.is_empty() {
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        for (block, messages) in replacements.into_iter().rev() {
            let start = block.line - 1;
            lines.splice(start..start + block.lines.len(), messages);
        }
        fs::write(&path, lines.join("\n") + "\n").unwrap();
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

/// All messages for a program; empty when it compiles.
fn messages(program: &str) -> String {
    let source = Source::file("example.hlang", program);
    let mut libraries: Vec<Library> = Vec::new();
    let mut open = imported_modules(&source);
    while let Some(name) = open.pop() {
        let file = root().join(format!("neighborhoods/src/{name}.hlang"));
        if let (Ok(text), false) = (
            fs::read_to_string(file),
            libraries.iter().any(|l| l.name == name),
        ) {
            let source = Source::file(format!("{name}.hlang"), text);
            open.extend(imported_modules(&source));
            libraries.push(Library { name, source });
        }
    }
    let outcome = compile(Request {
        name: Ident::new("Example", Span::call_site()),
        visibility: Default::default(),
        attributes: Default::default(),
        krate: "::iheartmesh".parse().unwrap(),
        source,
        libraries,
        optimizations: Optimizations::ALL,
        together: Vec::new(),
    });
    let messages = render::render_all(&outcome.sources, &outcome.diagnostics);
    assert!(
        outcome.code.is_some() || !messages.is_empty(),
        "no code and no message for\n{program}"
    );
    messages
}

fn blocks(page: &str, text: &str) -> Vec<Block> {
    let mut blocks: Vec<Block> = Vec::new();
    let mut open = false;
    for (index, line) in text.lines().enumerate() {
        match (line.strip_prefix("```"), open) {
            (Some(tag), false) => {
                blocks.push(Block {
                    tag: tag.to_owned(),
                    line: index + 2,
                    lines: Vec::new(),
                });
                open = true;
            }
            (Some(_), true) => open = false,
            (None, true) => blocks.last_mut().unwrap().lines.push(line.to_owned()),
            (None, false) => {}
        }
    }
    assert!(!open, "{page}: a fence stays open");
    blocks
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_owned()
}
