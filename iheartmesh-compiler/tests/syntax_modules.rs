//! What passes between modules: imports, exports, and which names are functions.

use expect_test::{Expect, expect};
use iheartmesh_compiler::source::Source;
use iheartmesh_compiler::span::SourceId;
use iheartmesh_compiler::syntax::{
    Export, ImportedNames, NoImports, dump, export_names, export_names_with, imports, parse,
};

/// A module `Other` with a function `area` and a set `Big`.
struct Other;

impl ImportedNames for Other {
    fn exports(&self, module: &str) -> Option<Vec<Export>> {
        let export = |name: &str, function| Export {
            name: name.to_owned(),
            function,
        };
        (module == "Other").then(|| vec![export("area", true), export("Big", false)])
    }
}

const TEXT: &str = "area as size, Big from Other(M)
* from trigonometry
x from Unknown
M : FaceMesh
g ∈ ℝ → ℝ
n = 3
h(a) = size(2) + Big(2) + sin(a) + e(2) + x(a) + g(a) where a ∈ ℝ
s_i = 2";

fn check_exports(exports: Vec<Export>, expected: Expect) {
    let mut shown = String::new();
    for export in exports {
        if !iheartmesh_compiler::syntax::builtin::exports("trigonometry")
            .is_some_and(|known| known.contains(&export))
        {
            shown += &format!(
                "{}{} ",
                export.name,
                if export.function { "()" } else { "" }
            );
        }
    }
    expected.assert_eq(shown.trim_end());
}

#[test]
fn exports_decide_what_is_a_call() {
    let (module, diagnostics) = parse(&Source::file("t", TEXT), SourceId(0), &Other);
    assert!(diagnostics.is_empty(), "{:?}", diagnostics.sorted());
    expect![[r#"
        import area as size, Big from Other(M)
        import * from trigonometry()
        import x from Unknown()
        parameter M : FaceMesh
        parameter g ∈ (ℝ → ℝ)
        define n = 3
        function h(a)
          = (+ (+ (+ (+ (+ (call size 2) (* Big 2)) (call sin a)) (* e 2)) (call x a)) (call g a))
          where a ∈ ℝ
        define s[i] = 2
    "#]]
    .assert_eq(&dump(&module));
    check_exports(
        export_names_with(&module, &Other),
        expect!["Big M g() h() n s size() x()"],
    );
    check_exports(
        export_names(&module),
        expect!["Big() M g() h() n s size() x()"],
    );
}

#[test]
fn all_names_of_a_module() {
    let text = "* from Other\ny = area(2) Big";
    let (module, diagnostics) = parse(&Source::file("t", text), SourceId(0), &Other);
    assert!(diagnostics.is_empty(), "{:?}", diagnostics.sorted());
    expect![[r#"
        import * from Other()
        define y = (* (call area 2) Big)
    "#]]
    .assert_eq(&dump(&module));
}

#[test]
fn imports_are_found_before_the_modules_are_known() {
    let text = "y = ((\nfoo, bar as b from First(M, N)\n* from Second\nz = 'x\n from Third";
    let source = Source::file("t", text);
    let list = imports(&source, SourceId(0));
    let shown: Vec<String> = list
        .iter()
        .map(|import| {
            let arguments: Vec<&str> = import
                .arguments
                .iter()
                .map(|name| name.text.as_str())
                .collect();
            format!(
                "{} {:?} {}",
                import.module.text,
                arguments,
                import.names.as_ref().map_or(0, Vec::len)
            )
        })
        .collect();
    expect![[r#"
        First ["M", "N"] 2
        Second [] 0"#]]
    .assert_eq(&shown.join("\n"));
    let (_, diagnostics) = parse(&source, SourceId(0), &NoImports);
    assert!(diagnostics.has_errors());
}

#[test]
fn a_paper_example_is_read_in_few_milliseconds() {
    let text = include_str!("corpus/syntax/mean_curvature.hlang");
    let source = Source::file("t", text);
    let fastest = (0..20).map(|_| {
        let start = std::time::Instant::now();
        parse(&source, SourceId(0), &NoImports);
        start.elapsed()
    });
    let fastest = fastest.min().expect("at least one run");
    assert!(fastest.as_millis() < 5, "{fastest:?}");
}
