//! What holds of any text, on random ones: soups of tokens, and programs with random changes.

mod syntax_support;

use std::sync::LazyLock;

use iheartmesh_compiler::source::Source;
use iheartmesh_compiler::span::SourceId;
use iheartmesh_compiler::syntax::print::{self, Spelling};
use iheartmesh_compiler::syntax::{self, NoImports, parse, strip_spans};
use proptest::prelude::*;
use proptest::sample::{Index, select};
use syntax_support::{PIECES, corpus};

static PROGRAMS: LazyLock<Vec<String>> =
    LazyLock::new(|| corpus().into_iter().map(|(_, text)| text).collect());

/// Pieces of programs in any order, mostly after a few declarations.
fn soup() -> impl Strategy<Value = String> {
    let pieces = prop::collection::vec(select(PIECES), 0..60);
    let known = "a, b, xy ∈ ℝ\nS ∈ {ℤ}\nf ∈ ℝ → ℝ\ny = ";
    (prop::bool::weighted(0.8), pieces).prop_map(move |(declared, pieces)| {
        let start = if declared { known } else { "" };
        start.to_owned() + &pieces.concat()
    })
}

/// A program in which some characters are replaced by pieces of programs, or by any character.
fn mutated() -> impl Strategy<Value = String> {
    let replacement = prop_oneof![
        4 => select(PIECES).prop_map(str::to_owned),
        1 => any::<char>().prop_map(String::from),
        2 => Just(String::new()),
    ];
    let change = (any::<Index>(), 0..4_usize, replacement);
    let changes = prop::collection::vec(change, 1..5);
    (select(&PROGRAMS[..]), changes).prop_map(|(program, changes)| {
        let mut text: Vec<char> = program.chars().collect();
        for (place, length, replacement) in changes {
            let start = place.index(text.len() + 1);
            let end = (start + length).min(text.len());
            text.splice(start..end, replacement.chars());
        }
        text.into_iter().collect()
    })
}

fn any_text() -> impl Strategy<Value = String> {
    prop_oneof![soup(), mutated(), any::<String>()]
}

/// All places that a tree or a message mentions: the numbers behind `start:` and `end:` in what `Debug` shows.
fn places(shown: &str) -> Vec<usize> {
    let mut found = Vec::new();
    for name in ["start: ", "end: "] {
        for rest in shown.split(name).skip(1) {
            let digits = rest.split(|c: char| !c.is_ascii_digit()).next();
            found.extend(digits.and_then(|digits| digits.parse::<usize>().ok()));
        }
    }
    found
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn places_are_inside_of_the_text(text in any_text()) {
        let source = Source::file("test.hlang", text.as_str());
        let (module, diagnostics) = parse(&source, SourceId(0), &NoImports);
        let messages = diagnostics.sorted().into_iter().map(|d| format!("{:?}", d.labels));
        let tree = format!("{:?}", module.items.iter().map(|item| &item.kind).collect::<Vec<_>>());
        // texts in the tree may look like places
        if !text.contains("start") && !text.contains("end") {
            for shown in messages.chain([tree]) {
                for place in places(&shown) {
                    prop_assert!(text.is_char_boundary(place), "{} in {:?}", place, text);
                }
            }
        }
        for item in &module.items {
            prop_assert!(item.span.start <= item.span.end);
        }
    }

    #[test]
    fn what_is_printed_is_read_back(text in any_text()) {
        let source = Source::file("test.hlang", text.as_str());
        let (mut module, diagnostics) = parse(&source, SourceId(0), &NoImports);
        strip_spans(&mut module);
        for spelling in [Spelling::Unicode, Spelling::Ascii] {
            let printed = print::module(&module, spelling);
            if diagnostics.has_errors() {
                continue;
            }
            let again = Source::file("test.hlang", printed.as_str());
            let (mut again, _) = parse(&again, SourceId(0), &NoImports);
            strip_spans(&mut again);
            prop_assert!(again == module, "{}\n---\n{}", text, printed);
            prop_assert_eq!(print::module(&again, spelling), printed);
        }
    }

    #[test]
    fn formatting_keeps_the_tree_and_is_done_after_once(text in any_text()) {
        let source = Source::file("test.hlang", text.as_str());
        let (mut module, diagnostics) = parse(&source, SourceId(0), &NoImports);
        strip_spans(&mut module);
        for spelling in [Spelling::Unicode, Spelling::Ascii] {
            let formatted = syntax::format(&source, SourceId(0), &NoImports, spelling);
            prop_assert_eq!(formatted.is_err(), diagnostics.has_errors());
            let Ok(formatted) = formatted else {
                continue;
            };
            let again = Source::file("test.hlang", formatted.as_str());
            let (mut tree, _) = parse(&again, SourceId(0), &NoImports);
            strip_spans(&mut tree);
            prop_assert!(tree == module, "{}\n---\n{}", text, formatted);
            let twice = syntax::format(&again, SourceId(0), &NoImports, spelling);
            prop_assert!(twice.is_ok_and(|twice| twice == formatted), "{}\n---\n{}", text, formatted);
        }
    }
}
