//! Rendered diagnostics: the places are those of the file, and marks stand under what they mark.

use expect_test::{Expect, expect};
use iheartmesh_compiler::diagnostic::{Diagnostic, Diagnostics};
use iheartmesh_compiler::render::{render, render_all};
use iheartmesh_compiler::source::{Place, Source, Sources};
use iheartmesh_compiler::span::{SourceId, Span};

fn check(source: Source, marks: &[(&str, &str)], expected: Expect) {
    let place = |text: &str| {
        let start = source
            .text
            .find(text)
            .expect("the text is part of the source");
        Span::new(SourceId(0), start, start + text.len())
    };
    let mut diagnostic =
        Diagnostic::error(place(marks[0].0), "cannot add `ℝ³` and `ℝ`").here(marks[0].1);
    for (text, label) in &marks[1..] {
        diagnostic = diagnostic.label(place(text), *label);
    }
    let diagnostic = diagnostic.help("multiply one of them");
    let mut sources = Sources::default();
    sources.add(source);
    expected.assert_eq(&(render(&sources, &diagnostic) + "\n"));
}

#[test]
fn several_labels() {
    let source = Source::file(
        "shape.hlang",
        "x_i ∈ ℝ³\nw ∈ ℝ\n\nA(v) = x_v + w where v ∈ V\n",
    );
    let marks = [
        ("x_v", "a vector"),
        ("w where", "a number"),
        ("w ∈ ℝ", "declared here"),
    ];
    check(
        source,
        &marks,
        expect![[r#"
        error: cannot add `ℝ³` and `ℝ`
         --> shape.hlang:4:8
          |
        2 | w ∈ ℝ
          | ----- declared here
        3 |
        4 | A(v) = x_v + w where v ∈ V
          |        ^^^   ------- a number
          |        |
          |        a vector
          |
          = help: multiply one of them
    "#]],
    );
}

#[test]
fn a_literal_in_a_rust_file() {
    let source = Source {
        file: "src/main.rs".to_owned(),
        text: "x ∈ ℝ³\n    y = x + 1\n".to_owned(),
        first_line: 12,
        indents: vec![24],
        places: Vec::new(),
    };
    check(
        source,
        &[("x + 1", ""), ("x ∈", "declared here")],
        expect![[r#"
        error: cannot add `ℝ³` and `ℝ`
          --> src/main.rs:13:9
           |
        12 |                         x ∈ ℝ³
           |                         --- declared here
        13 |     y = x + 1
           |         ^^^^^
           |
           = help: multiply one of them
    "#]],
    );
}

#[test]
fn documentation_lines() {
    let source = Source {
        file: "src/main.rs".to_owned(),
        text: "x ∈ ℝ³\ny = x + 1".to_owned(),
        first_line: 3,
        indents: vec![8, 8],
        places: Vec::new(),
    };
    check(
        source,
        &[("x + 1", "here")],
        expect![[r#"
        error: cannot add `ℝ³` and `ℝ`
         --> src/main.rs:4:13
          |
        4 |         y = x + 1
          |             ^^^^^ here
          |
          = help: multiply one of them
    "#]],
    );
}

#[test]
fn a_literal_with_escapes() {
    let place = |offset, line, column| Place {
        offset,
        line,
        column,
    };
    let source = Source {
        places: vec![place(0, 7, 20), place(3, 7, 24), place(6, 9, 5)],
        ..Source::file("src/main.rs", "A \\ b\ny = x + 1\n")
    };
    check(
        source,
        &[("x + 1", ""), ("b", "on a line before")],
        expect![[r#"
        error: cannot add `ℝ³` and `ℝ`
         --> src/main.rs:9:9
          |
        7 |                    A \  b
          |                         - on a line before
        8 |
        9 |     y = x + 1
          |         ^^^^^
          |
          = help: multiply one of them
    "#]],
    );
}

#[test]
fn several_lines_on_one_line_of_the_file() {
    let place = |offset, line, column| Place {
        offset,
        line,
        column,
    };
    let source = Source {
        places: vec![place(0, 7, 20), place(4, 7, 25), place(8, 8, 3)],
        ..Source::file("src/main.rs", "a=1\nb=2\ny = x + 1\n")
    };
    check(
        source,
        &[("b", ""), ("x + 1", "on the next line")],
        expect![[r#"
            error: cannot add `ℝ³` and `ℝ`
             --> src/main.rs:7:25
              |
            7 |                    a=1  b=2
              |                         ^
            8 |   y = x + 1
              |       ----- on the next line
              |
              = help: multiply one of them
        "#]],
    );
}

#[test]
fn combining_marks_and_wide_signs() {
    let source = Source::file("wide.hlang", "x̂ ỹ = n̄̂ + 𝟙_3 𝕕 `漢字` + z // ❤️ end");
    check(
        source,
        &[("z", "after wide and combined signs"), ("𝟙_3", "ones")],
        expect![[r#"
        error: cannot add `ℝ³` and `ℝ`
         --> wide.hlang:1:27
          |
        1 | x̂ ỹ = n̄̂ + 𝟙_3 𝕕 `漢字` + z // ❤️ end
          |           --- ones       ^ after wide and combined signs
          |
          = help: multiply one of them
    "#]],
    );
}

#[test]
fn places_outside_the_text() {
    let mut sources = Sources::default();
    let id = sources.add(Source::file("a.hlang", "θ"));
    let mut all = Diagnostics::default();
    all.push(Diagnostic::warning(
        Span::new(id, 1, 9),
        "in the middle of a character",
    ));
    all.push(Diagnostic::note(Span::new(id, 7, 3), "past the end"));
    let empty = sources.add(Source::file("b.hlang", ""));
    let other = Diagnostic::error(Span::new(empty, 0, 0), "nothing here");
    all.push(other.label(Span::new(id, 0, 2), "but here"));
    expect![[r#"
        warning: in the middle of a character
         --> a.hlang:1:1
          |
        1 | θ
          | ^

        note: past the end
         --> a.hlang:1:2
          |
        1 | θ
          |  ^

        error: nothing here
         --> b.hlang:1:1
          |
        1 |
          | ^
          |
         ::: a.hlang:1:1
          |
        1 | θ
          | - but here
    "#]]
    .assert_eq(&(render_all(&sources, &all) + "\n"));
}
