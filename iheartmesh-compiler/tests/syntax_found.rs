//! What the fuzz targets have found, each with the text that showed it.

mod syntax_support;

use iheartmesh_compiler::source::Source;
use iheartmesh_compiler::span::SourceId;
use iheartmesh_compiler::syntax::print::{self, Spelling};
use iheartmesh_compiler::syntax::{NoImports, format, parse, strip_spans};

/// What is printed or formatted is the same tree again, and formatting is done after once.
fn check(text: &str) {
    let read = |text: &str| {
        let source = Source::file("test.hlang", text);
        let (mut module, diagnostics) = parse(&source, SourceId(0), &NoImports);
        strip_spans(&mut module);
        let errors = diagnostics.has_errors();
        assert!(!errors, "{text}\n{:?}", diagnostics.sorted());
        module
    };
    let module = read(text);
    for spelling in [Spelling::Unicode, Spelling::Ascii] {
        let printed = print::module(&module, spelling);
        assert!(read(&printed) == module, "{text}\n---\n{printed}");
        let again = |text: &str| {
            let source = Source::file("test.hlang", text);
            format(&source, SourceId(0), &NoImports, spelling).expect("no mistakes")
        };
        let formatted = again(text);
        assert!(read(&formatted) == module, "{text}\n---\n{formatted}");
        assert_eq!(again(&formatted), formatted);
    }
}

#[test]
fn names_of_a_line_with_a_warning_are_not_lost() {
    check("b ∈ ℝ^n\nT = 3\nK = bᵀ");
    let source = Source::file("test.hlang", "b ∈ ℝ^n\nT = 3\nK = b^T");
    let (module, diagnostics) = parse(&source, SourceId(0), &NoImports);
    assert_eq!(diagnostics.sorted().len(), 1);
    assert!(module.lost.is_empty());
}

#[test]
fn warnings_hide_no_error() {
    let warnings = "y = f (a)\n".repeat(200);
    let text = format!("a ∈ ℝ\nf ∈ ℝ → ℝ\n{warnings}z = (a +");
    let source = Source::file("test.hlang", text);
    let (_, diagnostics) = parse(&source, SourceId(0), &NoImports);
    assert!(diagnostics.has_errors());
}
