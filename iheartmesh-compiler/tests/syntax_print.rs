//! Printing: canonical, and read back it gives the same tree.

mod syntax_support;

use expect_test::{Expect, expect};
use iheartmesh_compiler::source::Source;
use iheartmesh_compiler::span::SourceId;
use iheartmesh_compiler::syntax::ast::Module;
use iheartmesh_compiler::syntax::print::{self, Spelling};
use iheartmesh_compiler::syntax::{NoImports, dump, parse, strip_spans};
use syntax_support::corpus;

fn read(text: &str) -> Module {
    let source = Source::file("test.hlang", text);
    let (mut module, diagnostics) = parse(&source, SourceId(0), &NoImports);
    assert!(
        !diagnostics.has_errors(),
        "{text}\n{:?}",
        diagnostics.sorted()
    );
    strip_spans(&mut module);
    module
}

#[test]
fn what_is_printed_is_read_back() {
    for (name, text) in corpus() {
        let module = read(&text);
        for spelling in [Spelling::Unicode, Spelling::Ascii] {
            let printed = print::module(&module, spelling);
            let again = read(&printed);
            assert_eq!(
                dump(&module),
                dump(&again),
                "{name} {spelling:?}\n{printed}"
            );
            assert!(module == again, "{name} {spelling:?}\n{printed}");
            let twice = print::module(&again, spelling);
            assert_eq!(printed, twice, "{name} {spelling:?}");
        }
    }
}

fn check(spelling: Spelling, expected: Expect) {
    let mut printed = String::new();
    for (name, text) in corpus() {
        if matches!(name.as_str(), "everything" | "mean_curvature" | "springs") {
            printed += &format!("// {name}\n{}", print::module(&read(&text), spelling));
        }
    }
    expected.assert_eq(&printed);
}

#[test]
fn unicode() {
    check(
        Spelling::Unicode,
        expect![[r#"
            // everything
            sin, cos, atan2, e from trigonometry
            * from linearalgebra
            tr, vec⁻¹ as unvec from linearalgebra
            where
            a, b, c, θ ∈ ℝ : scalars
            n, m : ℤ
            u, v ∈ ℝ³
            A, B ∈ ℝ^(n×n) sparse
            x_i ∈ ℝ^(d_i)
            y_i ∈ ℝ^(d_i×m) : ragged
            S, W ∈ {ℤ} index
            P ∈ {ℤ × ℤ}
            R ∈ {ℝ^(3)}
            Q ∈ {ℤ × ℤ × ℤ}
            Z ∈ {ℝ³ ∨ ℤ}
            t ∈ ℝ × ℤ × ℝ³
            f ∈ ℝ, ℝ^n → ℝ^n
            g ∈ ∅ → ℝ
            h ∈ ℝ × ℝ → ℝ, ℤ
            k ∈ ℝ^(2 n + 1)
            K : ℝ^(n×m) sparse
            L ⊂ S
            M : FaceMesh
            N : CellMesh
            V ∈ VertexSet
            Y ∈ CellularSet
            p : V → ℝ³
            r ∈ ℝ
            q = a b/c + 2 a - ½ b⁻¹ + a⁻¹ + θ_1 ± a
            D = A \ u + A \ B \ u + Aᵀ ⊗ B + A ∘ B + Aᵀ A⁺ + A⁺
            F = A : B
            G = u × v ⋅ v × u + ⟨u, v⟩ + ⟨u, v⟩_A
            normed = ‖u‖_2² + ‖u‖_2² + ‖u‖_1² + |a| |S| + ‖A‖_F + ‖A‖_* + ‖u‖_∞ + ‖u‖_∞
            absolute = |a| b |c| + |a + (|b|)|
            sets = (S ∪ W ∩ {1, 2, n}) \ {k for k ∈ S if k > 2} ∪ {k for k ∈ S} ∪ ∅
            union = ∪_(k ∈ S) {k, k + 1}
            pairs = {i + j for i, j ∈ P if i ≠ j or i < j and (i, j) ∉ P}
            `∂¹`, `∂⁰` = tuple(A, B)
            blocks = [A u; 0 1]
            cells = [a, -b; a - b, c; a - b, -c]
            spaced = [x_1 - x_2, (a b); (|a|), (2 b)]
            bars = [a b; c 1]
            ones = 1_n + 1_n,m + 0_n,m + I_n + 0_3,3 + 1_(n + 1)
            sizes = #x + #A
            trig = sin(a)² + cos(a)² + atan2(a, b) + sqrt(a) + √a b + log_2(a) + exp(0.001) + e^a
            first = S_1 + t_2 + x_i,1 + y_1,1,* + x_(n + 1, *) + f(a, k)_1 + (A + B)_1,2 + A_i,j
            sums = ∑_i a_i b_i + ∑_(i for i > 2 and i ≠ n) a_i + ∏_(i = 1)^n a_i - ∑_(i = 1)^(n - 1) -a_i
            nested = a ∑_i b_i ∑_j c_j a
            gradients = ∂q/∂a + ∂²q/∂a∂b + ∂²q/∂a² + ∂(a b)/∂a + ∂(a + b)/∂a + 𝕕q/𝕕a
            fields = ∇_a q + ∇_x q + ∇_a q + Δ q + ∇⋅ u
            area = ∫_[0, 1] s² 𝕕s + ∫_[0, π] s 𝕕s
            best = argmin_(s ∈ ℝ³, l ∈ ℝ) ‖s‖² + l s.t. l ≥ 2; s_1 > 0
            start = with initial s = 1; l = 2
                min_(s ∈ ℝ, l ∈ ℝ) s l s.t. s > 0; l > s
            w_i = a_i
            w_1 = 2
            C_i,j = { a if i = j
                  b if i < j
                  0 otherwise
            C_i,j += { c if (i, j) ∈ P
            C_i,* = u
            O_i,i = a_i
            j(s, o) = s + z
                where s ∈ ℝ, o ∈ ℝ → ℝ,
                    z = b,
                    b = o(s)
            o() = 3
            `x'` = `two words` + 3.5 + ½ + 3.0
            `two words` = (1, u, 2)
            tight = θ_1 π ∞
            g
            // mean_curvature
            atan2 from trigonometry
            ElementSets, BoundaryMatrices from MeshConnectivity
            VertexOneRing, OrientedVertices, EdgeIndex, Faces from Neighborhoods(M)
            M : FaceMesh
            x_i ∈ ℝ³
            V, E, F = ElementSets(M)
            N(f) = (x_j - x_i) × (x_k - x_i)/‖(x_j - x_i) × (x_k - x_i)‖
                where f ∈ F,
                    i, j, k = OrientedVertices(f)
            l_i,j = ‖x_j - x_i‖
                where i, j ∈ V
            φ_i,j = atan2(e ⋅ `n₁` × `n₂`, `n₁` ⋅ `n₂`)
                where i, j ∈ V,
                    e = (x_j - x_i)/‖x_j - x_i‖,
                    `f₁`, `f₂` = OrientedOppositeFaces(i, j),
                    `n₁` = N(`f₁`),
                    `n₂` = N(`f₂`)
            H(i) = ¼ ∑_(j ∈ VertexOneRing(i)) l_i,j φ_i,j
                where i ∈ V
            `∂⁰`, `∂¹` = BoundaryMatrices(M)
            OrientedOppositeFaces(i, j) = tuple(f1, f2)
                where i, j ∈ V,
                    e = EdgeIndex(i, j),
                    fs = Faces(e),
                    f1 = {f for f ∈ fs if `∂¹`_e,f `∂⁰`_i,e = -1},
                    f2 = fs - f1
            // springs
            ElementSets from MeshConnectivity
            Vertices from Neighborhoods(M)
            vec, vec⁻¹ from linearalgebra
            M : FaceMesh
            V, E, F = ElementSets(M)
            q_i ∈ ℝ²
            r ∈ E → ℝ
            s ∈ ℝ
            W = ½ ∑_(e ∈ E) (‖q_i - q_j‖ - r_e)² where i, j = Vertices(e)
            g = ∂W/∂q
            H = ∂²W/∂q²
            moved = vec⁻¹_q(vec(q) - s g)
        "#]],
    );
}

#[test]
fn ascii() {
    check(
        Spelling::Ascii,
        expect![[r#"
            // everything
            sin, cos, atan2, e from trigonometry
            * from linearalgebra
            tr, vec^-1 as unvec from linearalgebra
            where
            a, b, c, \theta \in RR : scalars
            n, m : ZZ
            u, v \in RR^3
            A, B \in RR^(n \times n) sparse
            x_i \in RR^(d_i)
            y_i \in RR^(d_i \times m) : ragged
            S, W \in {ZZ} index
            P \in {ZZ \times ZZ}
            R \in {RR^(3)}
            Q \in {ZZ \times ZZ \times ZZ}
            Z \in {RR^3 \vee ZZ}
            t \in RR \times ZZ \times RR^3
            f \in RR, RR^n -> RR^n
            g \in {} -> RR
            h \in RR \times RR -> RR, ZZ
            k \in RR^(2 n + 1)
            K : RR^(n \times m) sparse
            L \subset S
            M : FaceMesh
            N : CellMesh
            V \in VertexSet
            Y \in CellularSet
            p : V -> RR^3
            r \in RR
            q = a b/c + 2 a - 0.5 b^-1 + a^-1 + \theta_1 +- a
            D = A \ u + A \ B \ u + A^T \otimes B + A \circ B + A^T A^+ + A^+
            F = A : B
            G = u \times v \cdot v \times u + (<u, v>) + (<u, v>_A)
            normed = ||u||_2^2 + ||u||_2^2 + ||u||_1^2 + |a| |S| + ||A||_F + ||A||_* + ||u||_\infty + ||u||_\infty
            absolute = |a| b |c| + |a + (|b|)|
            sets = (S \cup W \cap {1, 2, n}) \ {k for k \in S if k > 2} \cup {k for k \in S} \cup {}
            union = \cup_(k \in S) {k, k + 1}
            pairs = {i + j for i, j \in P if i != j or i < j and (i, j) \notin P}
            `∂¹`, `∂⁰` = tuple(A, B)
            blocks = [A u; 0 1]
            cells = [a, -b; a - b, c; a - b, -c]
            spaced = [x_1 - x_2, (a b); (|a|), (2 b)]
            bars = [a b; c 1]
            ones = 1_n + 1_n,m + 0_n,m + I_n + 0_3,3 + 1_(n + 1)
            sizes = #x + #A
            trig = sin(a)^2 + cos(a)^2 + atan2(a, b) + sqrt(a) + \sqrt a b + log_2(a) + exp(0.001) + e^a
            first = S_1 + t_2 + x_i,1 + y_1,1,* + x_(n + 1, *) + f(a, k)_1 + (A + B)_1,2 + A_i,j
            sums = sum_i a_i b_i + sum_(i for i > 2 and i != n) a_i + prod_(i = 1)^n a_i - sum_(i = 1)^(n - 1) -a_i
            nested = a sum_i b_i sum_j c_j a
            gradients = \partial q/\partial a + \partial^2 q/\partial a\partial b + \partial^2 q/\partial a^2 + \partial (a b)/\partial a + \partial (a + b)/\partial a + \dd q/\dd a
            fields = \nabla_a q + \nabla_x q + \nabla_a q + \Delta q + \nabla\cdot u
            area = int_[0, 1] s^2 \dd s + int_[0, \pi] s \dd s
            best = argmin_(s \in RR^3, l \in RR) ||s||^2 + l s.t. l >= 2; s_1 > 0
            start = with initial s = 1; l = 2
                min_(s \in RR, l \in RR) s l s.t. s > 0; l > s
            w_i = a_i
            w_1 = 2
            C_i,j = { a if i = j
                  b if i < j
                  0 otherwise
            C_i,j += { c if (i, j) \in P
            C_i,* = u
            O_i,i = a_i
            j(s, o) = s + z
                where s \in RR, o \in RR -> RR,
                    z = b,
                    b = o(s)
            o() = 3
            `x'` = `two words` + 3.5 + 0.5 + 3.0
            `two words` = (1, u, 2)
            tight = \theta_1 \pi \infty
            g
            // mean_curvature
            atan2 from trigonometry
            ElementSets, BoundaryMatrices from MeshConnectivity
            VertexOneRing, OrientedVertices, EdgeIndex, Faces from Neighborhoods(M)
            M : FaceMesh
            x_i \in RR^3
            V, E, F = ElementSets(M)
            N(f) = (x_j - x_i) \times (x_k - x_i)/||(x_j - x_i) \times (x_k - x_i)||
                where f \in F,
                    i, j, k = OrientedVertices(f)
            l_i,j = ||x_j - x_i||
                where i, j \in V
            \varphi_i,j = atan2(e \cdot `n₁` \times `n₂`, `n₁` \cdot `n₂`)
                where i, j \in V,
                    e = (x_j - x_i)/||x_j - x_i||,
                    `f₁`, `f₂` = OrientedOppositeFaces(i, j),
                    `n₁` = N(`f₁`),
                    `n₂` = N(`f₂`)
            H(i) = 0.25 sum_(j \in VertexOneRing(i)) l_i,j \varphi_i,j
                where i \in V
            `∂⁰`, `∂¹` = BoundaryMatrices(M)
            OrientedOppositeFaces(i, j) = tuple(f1, f2)
                where i, j \in V,
                    e = EdgeIndex(i, j),
                    fs = Faces(e),
                    f1 = {f for f \in fs if `∂¹`_e,f `∂⁰`_i,e = -1},
                    f2 = fs - f1
            // springs
            ElementSets from MeshConnectivity
            Vertices from Neighborhoods(M)
            vec, vec^-1 from linearalgebra
            M : FaceMesh
            V, E, F = ElementSets(M)
            q_i \in RR^2
            r \in E -> RR
            s \in RR
            W = 0.5 sum_(e \in E) (||q_i - q_j|| - r_e)^2 where i, j = Vertices(e)
            g = \partial W/\partial q
            H = \partial^2 W/\partial q^2
            moved = vec^-1_q(vec(q) - s g)
        "#]],
    );
}
