//! Formatting keeps the meaning, the comments and the lines of every program that there is, and has nothing to do twice.

mod syntax_support;

use expect_test::{Expect, expect};
use iheartmesh_compiler::source::Source;
use iheartmesh_compiler::span::SourceId;
use iheartmesh_compiler::syntax::ast::Module;
use iheartmesh_compiler::syntax::print::Spelling;
use iheartmesh_compiler::syntax::{self, NoImports, parse, strip_spans};
use syntax_support::programs;

fn read(text: &str) -> Option<Module> {
    let source = Source::file("test.hlang", text);
    let (mut module, diagnostics) = parse(&source, SourceId(0), &NoImports);
    strip_spans(&mut module);
    (!diagnostics.has_errors()).then_some(module)
}

fn format(text: &str, spelling: Spelling) -> String {
    let source = Source::file("test.hlang", text);
    match syntax::format(&source, SourceId(0), &NoImports, spelling) {
        Ok(text) => text,
        Err(diagnostics) => panic!("{text}\n{:?}", diagnostics.sorted()),
    }
}

/// The comments of a text, without blanks at their ends; no text of the tests has `//` in back-ticks.
fn comments(text: &str) -> Vec<&str> {
    let lines = text
        .lines()
        .filter_map(|line| line.find("//").map(|at| line[at..].trim_end()));
    lines.collect()
}

#[test]
fn every_program_keeps_its_meaning() {
    let mut count = 0;
    for (name, text) in programs() {
        let Some(module) = read(&text) else {
            continue;
        };
        count += 1;
        for spelling in [Spelling::Unicode, Spelling::Ascii] {
            let formatted = format(&text, spelling);
            let again = read(&formatted);
            assert!(
                again.as_ref() == Some(&module),
                "{name} {spelling:?}\n{formatted}"
            );
            assert_eq!(comments(&text), comments(&formatted), "{name} {spelling:?}");
            assert_eq!(
                formatted,
                format(&formatted, spelling),
                "{name} {spelling:?}"
            );
        }
        // every ASCII spelling stands for one sign
        let unicode = format(&text, Spelling::Unicode);
        let ascii = format(&text, Spelling::Ascii);
        assert_eq!(format(&unicode, Spelling::Ascii), ascii, "{name}");
        assert_eq!(format(&ascii, Spelling::Ascii), ascii, "{name}");
    }
    assert!(count > 300, "{count} programs");
}

fn check(text: &str, spelling: Spelling, expected: Expect) {
    expected.assert_eq(&format(text, spelling));
}

/// What users read first is formatted: `cargo hlangc fmt examples/*.hlang examples/*/*.hlang neighborhoods/src/*.hlang`.
#[test]
fn examples_and_the_library_are_formatted() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for folder in ["examples", "examples/gallery", "neighborhoods/src"] {
        for entry in std::fs::read_dir(root.join(folder)).expect("a folder") {
            let path = entry.expect("a readable folder").path();
            if path
                .extension()
                .is_some_and(|extension| extension == "hlang")
            {
                let text = std::fs::read_to_string(&path).expect("a readable file");
                assert_eq!(text, format(&text, Spelling::Unicode), "{}", path.display());
            }
        }
    }
}

/// Signs with an ASCII spelling, those that several characters stand for among them.
const SPELLINGS: &str = r#"vec, vec^-1 from linearalgebra
a, b, n, \theta \in RR
A, B \in RR^(n \times n)
u, v \in RR^3
x_i \in RR^3
f \in {} -> ZZ
S, W \in {ZZ}
y = a^2b + a^-2 - a^-1 + a^(-1) b + a^b + u^T v + A^T u - A^+B
z = ||u||_2^2 + ||a b u|| + |a + |b|| + (<u, v>) + ||A||_F
w = \frac13 a + \half b + 0.5\pi + 1_3 + \ones_n,n
g = \partial a/\partial \theta + \partial^2 a/\partial \theta^2 + \nabla_x a + \Delta a
s = sum_i x_i + prod_(i = 1)^2 a + sum_(k \in S\cup W) k + int_0^1 a^2 \dd a
t = { k \forall k \in S if k != 2 and k <= 3 or k >= 4 and k \notin W }
q = \sqrt a + \sqrt(a + b) + vec^-1_x(u) + A\circ B + A\otimes B +- 2
r = \theta a + \theta1 + `x\theta` + u \times v\cdot u
"#;

#[test]
fn ascii_spellings_become_signs() {
    check(
        SPELLINGS,
        Spelling::Unicode,
        expect![[r#"
            vec, vec⁻¹ from linearalgebra
            a, b, n, θ ∈ ℝ
            A, B ∈ ℝ^(n × n)
            u, v ∈ ℝ³
            x_i ∈ ℝ³
            f ∈ ∅ → ℤ
            S, W ∈ {ℤ}
            y = a²b + a⁻² - a⁻¹ + a⁻¹ b + a^b + uᵀ v + Aᵀ u - A⁺B
            z = ‖u‖_2² + ‖a b u‖ + |a + |b|| + (⟨u, v⟩) + ‖A‖_F
            w = ⅓ a + ½ b + 0.5π + 1_3 + 𝟙_n,n
            g = ∂a/∂θ + ∂²a/∂θ² + ∇_x a + Δ a
            s = ∑_i x_i + ∏_(i = 1)^2 a + ∑_(k ∈ S ∪ W) k + ∫_0^1 a² 𝕕a
            t = { k ∀ k ∈ S if k ≠ 2 and k ≤ 3 or k ≥ 4 and k ∉ W }
            q = √a + √(a + b) + vec⁻¹_x(u) + A ∘ B + A ⊗ B ± 2
            r = θ a + θ1 + `x\theta` + u × v ⋅ u
        "#]],
    );
}

#[test]
fn signs_become_ascii() {
    let text = r#"vec, vec⁻¹ from linearalgebra // `θ` ∈ S
a, b, n, θ ∈ ℝ : the angle ∈ ℝ
A, B ∈ ℝ^(n×n)
u, v ∈ ℝ³
xᵢ ∈ ℝ³
f ∈ ∅ → ℤ
y = a²b + a²3 + a⁻² - a⁻¹b + aⁿ + uᵀv - A⁺B
z = ‖u‖₂² + ‖|a| u‖ + ‖(|a|)‖ + ⟨u, v⟩_A + ½a + ⅓ b + ⅒3
c = { a if a < ⟨u, v⟩
      b if a ≠ b and a ≤ b
      2 otherwise
w = √a + √θ + 2π + 𝟙_3 + θa + xᵢ a + x₁,₂ + `∂⁰` + a ÷ b
h = [θ a -b; a⋅b  √a c] + A_*,1
g = ∂a/∂θ + ∂²a/∂θ² + ∇ₓ a + Δa + ∑_i xᵢ + ∏_(i = 1)^2 a + ∫_0^1 a 𝕕a
s = {k ∀ k ∈ S} ∖ {1} ∪ ∅
S ∈ {ℤ}
"#;
    check(
        text,
        Spelling::Ascii,
        expect![[r#"
            vec, vec^-1 from linearalgebra // `θ` ∈ S
            a, b, n, \theta \in RR : the angle ∈ ℝ
            A, B \in RR^(n \times n)
            u, v \in RR^3
            x_i \in RR^3
            f \in {} -> ZZ
            y = a^2b + a^2 3 + a^-2 - a^-1b + a^n + u^T v - A^+B
            z = ||u||_2^2 + |||a| u|| + ||(|a|)|| + <u, v>_A + \frac12a + \frac13 b + \frac110 3
            c = { a if a < <u, v>
                  b if a != b and a <= b
                  2 otherwise
            w = \sqrt a + \sqrt\theta + 2\pi + 1_3 + \theta a + x_i a + x_1,2 + `∂⁰` + a / b
            h = [\theta a -b; a \cdot b  \sqrt a c] + A_*,1
            g = \partial a/\partial\theta + \partial^2 a/\partial\theta^2 + \nabla_x a + \Delta a + sum_i x_i + prod_(i = 1)^2 a + int_0^1 a \dd a
            s = {k for k \in S} \setminus {1} \cup {}
            S \in {ZZ}
        "#]],
    );
}

#[test]
fn lines_and_comments_stay() {
    let text = "\u{feff}\n\n// a module\r\n\r\nr ∈ ℝ   // radius\r\nA = π r² // its area\r\n\r\n\r\n\r\n// a function
p, q, a_i ∈ ℝ;n ∈ ℤ
s(h)=A h where h∈ℝ,
        // inside
  k=3,l =
 4
y={a_1,2 if p>0 // first

    // between
      b if p<0 and
      q≠0
   0 otherwise
m = [ 1   2
 3 -4 // row
   ]
o=[
1 2
3 4
]
z=f( r,
 ( r+1 )*
 2 )-
 2
t = min_(a ∈ ℝ) a s.t.   a > 1
a < 2
where
  b:ℝ
  c⊂S
  // end  \t";
    check(
        &text.replace('*', "⋅"),
        Spelling::Unicode,
        expect![[r#"
        // a module

        r ∈ ℝ    // radius
        A = π r² // its area

        // a function
        p, q, a_i ∈ ℝ; n ∈ ℤ
        s(h) = A h where h ∈ ℝ,
            // inside
            k = 3, l =
                4
        y = { a_1,2 if p > 0 // first

              // between
              b if p < 0 and
                  q ≠ 0
              0 otherwise
        m = [1   2
             3 -4 // row
            ]
        o = [
            1 2
            3 4
        ]
        z = f(r,
              (r + 1) ⋅
              2) -
            2
        t = min_(a ∈ ℝ) a s.t. a > 1
                               a < 2
        where
        b : ℝ
        c ⊂ S
        // end
    "#]],
    );
}

#[test]
fn blanks_follow_the_tree() {
    let text = "a, b, n ∈ ℝ
f ∈ ℝ, ℝ→ℝ
S ∈ {ℤ}
x_i ∈ ℝ
y = a+b-a ±b ∪S∩ S
z = a/b a / b a /b a/ b (a+b)/( a-b )
w = - a + ( -b ) + f( a,b ) + f( -a,x_1,n ) + f (a, b) + a (b)
u = 2a 3  b + a ^ 2 + a^(  -n ) + x_( n+1 )
v = [a+b a-b -b; (a+b) f(a,b) , a ; |a|  | b | a]
s = {1,a}∪{ 1 , a }∪{k for k∈S}∪{ k for k ∈ S} ∪ {  }
r = | a |+|| x ||+| |a|b |
d = #S+∑_( k∈S )k+∑_(i=1)^(n-1) x_i";
    check(
        text,
        Spelling::Unicode,
        expect![[r#"
            a, b, n ∈ ℝ
            f ∈ ℝ, ℝ → ℝ
            S ∈ {ℤ}
            x_i ∈ ℝ
            y = a + b - a ± b ∪ S ∩ S
            z = a/b a / b a / b a / b (a + b)/(a - b)
            w = -a + (-b) + f(a, b) + f(-a, x_1,n) + f (a, b) + a (b)
            u = 2a 3 b + a² + a^(-n) + x_(n + 1)
            v = [a+b a-b -b; (a + b) f(a, b), a; |a|  |b| a]
            s = {1, a} ∪ { 1, a } ∪ {k for k ∈ S} ∪ { k for k ∈ S } ∪ ∅
            r = |a| + ‖x‖ + | |a|b|
            d = #S + ∑_(k ∈ S)k + ∑_(i = 1)^(n - 1) x_i
        "#]],
    );
}

#[test]
fn a_text_with_mistakes_stays() {
    let source = Source::file("test.hlang", "a = (b +");
    let refused = syntax::format(&source, SourceId(0), &NoImports, Spelling::Unicode);
    let diagnostics = refused.expect_err("there is a mistake");
    assert!(diagnostics.has_errors());
}
