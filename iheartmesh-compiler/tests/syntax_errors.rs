//! What a user sees: one message for one mistake, its place, and what to do.

mod syntax_support;

use expect_test::{Expect, expect};
use iheartmesh_compiler::render::render_all;
use iheartmesh_compiler::source::{Source, Sources};
use iheartmesh_compiler::span::SourceId;
use iheartmesh_compiler::syntax::{NoImports, parse};

fn check(text: &str, expected: Expect) {
    let source = Source::file("test.hlang", text);
    let (_, diagnostics) = parse(&source, SourceId(0), &NoImports);
    let mut sources = Sources::default();
    sources.add(source);
    expected.assert_eq(&(render_all(&sources, &diagnostics) + "\n"));
}

#[test]
fn unknown_names_suggest_a_declared_one() {
    check(
        "Faces from Neighborhoods(M)\nlength ∈ ℝ\ny = lenght + Fases(3) + abc",
        expect![[r#"
            error: unknown name `lenght`
             --> test.hlang:3:5
              |
            3 | y = lenght + Fases(3) + abc
              |     ^^^^^^
              |
              = help: did you mean `length`?

            error: unknown name `Fases`
             --> test.hlang:3:14
              |
            3 | y = lenght + Fases(3) + abc
              |              ^^^^^
              |
              = help: did you mean `Faces`?

            error: unknown name `abc`
             --> test.hlang:3:25
              |
            3 | y = lenght + Fases(3) + abc
              |                         ^^^
              |
              = help: declare it, or separate the letters to multiply them
        "#]],
    );
}

#[test]
fn one_message_for_one_mistake() {
    check(
        "a ∈ ℝ\ny = (a + ) 2\nf(x) = [a, ; 3 where x ∈ ℝ\nz = y + a",
        expect![[r#"
            error: expected an operand, found `)`
             --> test.hlang:2:10
              |
            2 | y = (a + ) 2
              |          ^
              |
              = help: write a name, a number or a bracket here

            error: expected an operand, found the end of the line
             --> test.hlang:3:12
              |
            3 | f(x) = [a, ; 3 where x ∈ ℝ
              |            ^
              |
              = help: write a name, a number or a bracket here

            error: expected the end of the item, found `where`
             --> test.hlang:3:16
              |
            3 | f(x) = [a, ; 3 where x ∈ ℝ
              |                ^^^^^
              |
              = help: `where` follows a function with parameters or directly a sum; before parameters of the module it stands alone on its line
        "#]],
    );
}

#[test]
fn relations_cannot_be_chained() {
    check(
        "a ∈ ℝ\ny = { 1 if 0 < a < 2\n      0 otherwise",
        expect![[r#"
            error: relations cannot be chained
             --> test.hlang:2:18
              |
            2 | y = { 1 if 0 < a < 2
              |                  ^
              |
              = help: write two relations, as in `0 < a and a < …`
        "#]],
    );
}

#[test]
fn a_piecewise_value_is_not_closed() {
    check(
        "a ∈ ℝ\ny = { 1 if a > 2; 0 otherwise }",
        expect![[r#"
        error: a piecewise value has no closing brace
         --> test.hlang:2:31
          |
        2 | y = { 1 if a > 2; 0 otherwise }
          |                               ^
          |
          = help: remove the `}`; the value ends with its last line
    "#]],
    );
}

#[test]
fn chains_of_cross_products() {
    check(
        "u, v ∈ ℝ³\ny = u × v × u\nz = u × v ∘ u",
        expect![[r#"
        error: a chain of `×` has no agreed meaning
         --> test.hlang:2:11
          |
        2 | y = u × v × u
          |       -   ^
          |
          = help: put one of the products in parentheses

        error: these operators are not ordered among each other
         --> test.hlang:3:11
          |
        3 | z = u × v ∘ u
          |       -   ^
          |
          = help: put one of the products in parentheses
    "#]],
    );
}

#[test]
fn a_local_declaration_is_no_parameter() {
    check(
        "y = 2a where a ∈ ℝ",
        expect![[r#"
        error: local declaration `a` is not a parameter of `y`
         --> test.hlang:1:14
          |
        1 | y = 2a where a ∈ ℝ
          |              ^
          |
          = help: declare `a` on a line of its own to make it a parameter of the module, or write `y(a) = …`
    "#]],
    );
}

#[test]
fn ragged_rows() {
    check(
        "a ∈ ℝ\ny = [a 2 a\n     3 a]",
        expect![[r#"
        error: this row has 2 cells, but the first row has 3
         --> test.hlang:3:6
          |
        3 |      3 a]
          |      ^^^
          |
          = help: blanks separate cells: put a sum or product in parentheses, or write it without blanks
    "#]],
    );
}

#[test]
fn a_blank_before_the_parenthesis() {
    check(
        "f(x) = 2x where x ∈ ℝ\ny = f (2)",
        expect![[r#"
        warning: `f` is multiplied, not called
         --> test.hlang:2:5
          |
        2 | y = f (2)
          |     ^
          |
          = help: remove the blank before `(` to call it
    "#]],
    );
}

#[test]
fn a_transpose_that_could_be_a_power() {
    check(
        "T ∈ ℝ\nA ∈ ℝ^(2×2)\ny = A^T + A^(T) + Aᵀ",
        expect![[r#"
        warning: `^T` transposes, although `T` is a name
         --> test.hlang:3:6
          |
        3 | y = A^T + A^(T) + Aᵀ
          |      ^
          |
          = help: write `ᵀ` to transpose, `^(T)` for the power
    "#]],
    );
}

#[test]
fn locals_go_on_after_a_mistake() {
    check(
        "f(x) = x + y where x ∈ ℝ, y = x ×, z = 3, w = )",
        expect![[r#"
            error: expected an operand, found `,`
             --> test.hlang:1:34
              |
            1 | f(x) = x + y where x ∈ ℝ, y = x ×, z = 3, w = )
              |                                  ^
              |
              = help: write a name, a number or a bracket here

            error: expected an operand, found `)`
             --> test.hlang:1:47
              |
            1 | f(x) = x + y where x ∈ ℝ, y = x ×, z = 3, w = )
              |                                               ^
              |
              = help: write a name, a number or a bracket here
        "#]],
    );
}

#[test]
fn declarations() {
    check(
        "x ∈ ℝ^\ny ∈ ℝ^(2×\nz_ij ∈ ℝ\nw ∈ 3\nv ∈ {ℝ^100}",
        expect![[r#"
            error: expected the end of the item, found `∈`
             --> test.hlang:2:3
              |
            2 | y ∈ ℝ^(2×
              |   ^
              |
              = help: the item goes on over the line break before this; is that line complete?

            error: unknown subscript `ij`
             --> test.hlang:3:3
              |
            3 | z_ij ∈ ℝ
              |   ^^
              |
              = help: letters are indices where each stands on the left side as well, as in `y_ij = …`, or below a sum, as in `∑_i ∑_j`

            error: expected a type, found `3`
             --> test.hlang:4:5
              |
            4 | w ∈ 3
              |     ^
              |
              = help: types are ℝ, ℤ, ℝ^n, ℝ^(n×m), {T}, T × U, T → U, FaceMesh and the like, or the name of a set

            error: a tuple of 100 numbers is not supported
             --> test.hlang:5:6
              |
            5 | v ∈ {ℝ^100}
              |      ^
              |
              = help: write `{ℝ^(n)}` for a set of vectors
        "#]],
    );
}

#[test]
fn primes_and_other_characters() {
    check(
        "x ∈ ℝ\ny = x' + 1\nz = x ! 2",
        expect![[r#"
        error: unexpected character `'`
         --> test.hlang:2:6
          |
        2 | y = x' + 1
          |      ^
          |
          = help: a prime is part of a name only in back-ticks, as in `x'` between back-ticks

        error: unexpected character `!`
         --> test.hlang:3:7
          |
        3 | z = x ! 2
          |       ^
          |
          = help: this character means nothing in the language; remove it
    "#]],
    );
}

#[test]
fn too_many_errors_are_cut() {
    let text = "y = )\n".repeat(500);
    let (_, diagnostics) = parse(&Source::file("t", text), SourceId(0), &NoImports);
    assert_eq!(diagnostics.sorted().len(), 100);
}
