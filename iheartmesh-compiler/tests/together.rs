//! Definitions that are asked for at once: which of them share a pass, and what is said of names that are none.

use expect_test::{Expect, expect};
use iheartmesh_compiler::optimize::Optimizations;
use iheartmesh_compiler::source::Source;
use iheartmesh_compiler::{Library, Outcome, Request, compile};

fn outcome(program: &str, lists: &[&[&str]], optimizations: Optimizations) -> Outcome {
    let file = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../neighborhoods/src/Neighborhoods.hlang"
    );
    let text = std::fs::read_to_string(file).expect("a file of the repository");
    let names = |list: &&[&str]| list.iter().map(|name| (*name).to_owned()).collect();
    compile(Request {
        name: quote::format_ident!("Program"),
        visibility: quote::quote!(pub),
        attributes: quote::quote!(),
        krate: quote::quote!(::iheartmesh),
        source: Source::file("program.hlang", program),
        libraries: vec![Library {
            name: "Neighborhoods".to_owned(),
            source: Source::file("Neighborhoods.hlang", text),
        }],
        optimizations,
        together: lists.iter().map(names).collect(),
    })
}

const SPRINGS: &str = "
ElementSets from MeshConnectivity
OrientedVertices, Vertices from Neighborhoods(M)
psd from linearalgebra
M : FaceMesh
V, E, F = ElementSets(M)
x_i ∈ ℝ²
w ∈ ℝ
D(f) = |[x_b - x_a  x_c - x_a]| where f ∈ F, a, b, c = OrientedVertices(f)
s(k) = (‖x_i - x_j‖² - w)² where k ∈ E, i, j = Vertices(k)
e = ½ ∑_(k ∈ E) s(k) - w ∑_(f ∈ F) D(f)² + 1
g = ∂e/∂x
H = ∂²e/∂x²
θ = ∑_(f ∈ F) psd(∂²D(f)²/∂x²)
B = 3 H
C = H + ∑_(v ∈ V) psd(∂²‖x_v‖⁴/∂x²)
d = ‖g‖
n = |V|
m = (1, 2, w)
L = psd(H)
a = ∑_(k ∈ E) s(k)
b = ∑_(k ∈ E) 2 s(k)
";

/// What the documentation of the method says, by which list.
fn said(lists: &[&[&str]], optimizations: Optimizations) -> Vec<String> {
    let found = outcome(SPRINGS, lists, optimizations);
    assert!(found.diagnostics.is_empty() && found.misfits.is_empty());
    let code = found.code.expect("a program without errors").to_string();
    let methods = lists.iter().map(|list| {
        let method = format!("pub fn {} ", list.join("_"));
        let before = &code[..code.find(&method).expect("a method of these names")];
        let docs = before
            .rfind("The values of several definitions")
            .expect("documentation");
        let docs = &before[docs..];
        let start = docs
            .find("One pass")
            .or_else(|| docs.find("Each is"))
            .expect("how it is computed");
        docs[start..]
            .split('"')
            .next()
            .unwrap_or_default()
            .to_owned()
    });
    methods.collect()
}

#[test]
fn what_shares_a_pass() {
    let lists: [&[&str]; 12] = [
        &["e", "g", "H"],
        &["H", "g", "e"],
        &["e", "g"],
        &["theta", "e", "n", "g", "m"],
        &["H", "theta"],
        &["B", "g"],
        &["C", "e"],
        // a norm is no sum, and what is of the whole matrix no sum of blocks
        &["d", "g"],
        &["L", "H", "e"],
        // numbers alone
        &["a", "b"],
        &["n", "m"],
        &["θ", "a"],
    ];
    let text = said(&lists, Optimizations::ALL).join("\n");
    expect![[r#"
        One pass computes `e`, `g`, `H`, where two or more of them are not known already.
        One pass computes `H`, `g`, `e`, where two or more of them are not known already.
        One pass computes `e`, `g`, where two or more of them are not known already.
        One pass computes `θ`, `e`, `g`, where two or more of them are not known already.
        One pass computes `H`, `θ`, where two or more of them are not known already.
        One pass computes `B`, `g`, where two or more of them are not known already.
        One pass computes `C`, `e`, where two or more of them are not known already.
        Each is computed by itself.
        One pass computes `H`, `e`, where two or more of them are not known already.
        Each is computed by itself.
        Each is computed by itself.
        Each is computed by itself."#]]
    .assert_eq(&text);
    let mut without = Optimizations::ALL;
    without.slots = false;
    for optimizations in [Optimizations::NONE, without] {
        let all = said(&lists, optimizations);
        assert!(
            all.iter().all(|text| text == "Each is computed by itself."),
            "{all:?}"
        );
    }
}

fn check(program: &str, lists: &[&[&str]], expected: Expect) {
    let found = outcome(program, lists, Optimizations::ALL);
    assert!(found.code.is_none());
    let lines = found.misfits.iter().map(|misfit| {
        let name = misfit.name.map(|k| lists[misfit.list][k]);
        let name = name.unwrap_or("together");
        format!(
            "{}, `{name}`: {}\n  = help: {}\n",
            misfit.list, misfit.message, misfit.help
        )
    });
    expected.assert_eq(&lines.collect::<String>());
}

#[test]
fn names_that_are_no_definitions() {
    let program = "
f from trigonometry_of_ours
M : FaceMesh
x_i ∈ ℝ²
`θ` ∈ ℝ
e = θ
y = 2 θ
g(t) = t² where t ∈ ℝ
"
    .replace("f from trigonometry_of_ours\n", "");
    check(
        &program,
        &[
            &["e", "q", "y"],
            &["e", "x"],
            &["theta", "M", "e"],
            &["g", "e"],
            &["e", "y", "e"],
            &["e"],
            &[],
            &["q"],
        ],
        expect![[r#"
            0, `q`: there is no definition `q`
              = help: the definitions are `e`, `y`
            1, `x`: `x` is a parameter and no definition
              = help: the definitions are `e`, `y`
            2, `theta`: `theta` is a parameter and no definition
              = help: the definitions are `e`, `y`
            2, `M`: `M` is a parameter and no definition
              = help: the definitions are `e`, `y`
            3, `g`: `g` has parameters and is no definition
              = help: the definitions are `e`, `y`
            4, `e`: `e` is asked for twice
              = help: name each definition once
            5, `e`: `e` is asked for together with nothing
              = help: name two definitions or more; `e` alone has a method already
            6, `together`: nothing is asked for together
              = help: the definitions are `e`, `y`
            7, `q`: there is no definition `q`
              = help: the definitions are `e`, `y`
        "#]],
    );
    check(
        "s(t) = t² where t ∈ ℝ\n",
        &[&["s", "s"], &[]],
        expect![[r#"
            0, `s`: `s` has parameters and is no definition
              = help: there are no definitions
            0, `s`: `s` has parameters and is no definition
              = help: there are no definitions
            1, `together`: nothing is asked for together
              = help: there are no definitions
        "#]],
    );
}

#[test]
fn names_of_methods_that_are_taken() {
    let program = "
x ∈ ℝ^n
e = ‖x‖²
g = 2x
`e_g` = 3
h = 4
`g_h_into` = 5
`try_h_e`(t) = t where t ∈ ℝ
";
    check(
        program,
        &[
            &["e", "g"],
            &["g", "h"],
            &["h", "e"],
            &["g", "e"],
            &["g", "e"],
        ],
        expect![[r#"
            0, `together`: what is asked for together and `e_g` have the same name in Rust, `e_g`
              = help: name the definitions in another order, or rename one
            1, `together`: what is asked for together and `g_h_into` have the same name in Rust, `g_h_into`
              = help: name the definitions in another order, or rename one
            2, `together`: what is asked for together and `try_h_e` have the same name in Rust, `try_h_e`
              = help: name the definitions in another order, or rename one
            4, `together`: what is asked for together and another such list have the same name in Rust, `g_e`
              = help: name the definitions in another order, or rename one
        "#]],
    );
}

/// Mistakes in the program come first; a list is only then looked at.
#[test]
fn one_mistake_is_told_once() {
    let found = outcome("e = q\n", &[&["e", "z"]], Optimizations::ALL);
    assert!(found.diagnostics.has_errors() && found.misfits.is_empty());
}
