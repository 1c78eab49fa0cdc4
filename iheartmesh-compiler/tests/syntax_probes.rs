//! The probes of the language reference, and what is easy to get wrong around them.

mod syntax_support;

use expect_test::{Expect, expect};
use syntax_support::table;

const CONTEXT: &str = "a, b, c, n ∈ ℝ\n\
w_i ∈ ℝ\n\
x_i ∈ ℝ^3\n\
u, v ∈ ℝ^3\n\
A, B ∈ ℝ^(3×3)\n\
f ∈ ℝ→ℝ\n\
S, W, U ∈ {ℤ}\n\
P ∈ {ℤ×ℤ}\n\
r, s, y ∈ ℝ";

fn check(rows: &str, expected: Expect) {
    expected.assert_eq(&table(CONTEXT, rows));
}

#[test]
fn products_and_quotients() {
    check(
        r#"
        a b / c n
        1/2a
        a/b c
        x_1/2π
        -a^2
        -a b
        a - -b
        u⋅-v
        a × -b
        a + -b
        2a
        a2
        2 3
        a u⋅v
        u⋅v u
        u·v + u•v
        "#,
        expect![[r#"
            a b / c n
               => expression (* (/ (* a b) c) n)
            1/2a
               => expression (* (/ 1 2) a)
            a/b c
               => expression (* (/ a b) c)
            x_1/2π
               => expression (* (/ x[1] 2) π)
            -a^2
               => expression (neg (^ a 2))
            -a b
               => expression (neg (* a b))
            a - -b
               Error: expected an operand, found `-`
               = put the operand with its sign in parentheses, as in `a - (-b)`
            u⋅-v
               Error: expected an operand, found `-`
               = put the operand with its sign in parentheses, as in `a ⋅ (-b)`
            a × -b
               Error: expected an operand, found `-`
               = put the operand with its sign in parentheses, as in `a × (-b)`
            a + -b
               Error: expected an operand, found `-`
               = put the operand with its sign in parentheses, as in `a + (-b)`
            2a
               => expression (* 2 a)
            a2
               => expression (* a 2)
            2 3
               => expression (* 2 3)
            a u⋅v
               => expression (. (* a u) v)
            u⋅v u
               => expression (* (. u v) u)
            u·v + u•v
               => expression (+ (. u v) (. u v))
        "#]],
    );
}

#[test]
fn powers() {
    check(
        r#"
        a^-b
        a^(-b)
        a^2 × b
        a^b^c
        a²b
        a^2b
        a⁻²
        a^-2 b
        f(a)^2
        ||u||^2 × v
        √a b
        √a^2
        √a × b
        aⁿ
        "#,
        expect![[r#"
            a^-b
               => expression (^ a (neg b))
            a^(-b)
               => expression (^ a (neg b))
            a^2 × b
               => expression (× (^ a 2) b)
            a^b^c
               => expression (^ a (^ b c))
            a²b
               => expression (* (^ a 2) b)
            a^2b
               => expression (* (^ a 2) b)
            a⁻²
               => expression (^ a (neg 2))
            a^-2 b
               => expression (* (^ a (neg 2)) b)
            f(a)^2
               => expression (^ (call f a) 2)
            ||u||^2 × v
               => expression (× (^ ‖u‖ 2) v)
            √a b
               => expression (* (√ a) b)
            √a^2
               => expression (√ (^ a 2))
            √a × b
               => expression (× (√ a) b)
            aⁿ
               => expression (^ a n)
        "#]],
    );
}

#[test]
fn products_of_vectors() {
    check(
        r#"
        u × v × v
        u × v ∘ u
        u ∘ v ∘ u
        a u × v
        u × v a
        2 u×v
        A : B
        y = A : B
        A⁻¹B⁻¹u
        A^-1 B^(-1) u
        a A \ u
        A⁻¹ - B
        A⁻¹ ⋅ u
        (A⁻¹) u
        Aᵀ × B
        A × Bᵀ
        u ᵀ
        A^T u
        A^⊤u
        A⁺ + A^+
        "#,
        expect![[r#"
            u × v × v
               Error: a chain of `×` has no agreed meaning
               = put one of the products in parentheses
            u × v ∘ u
               Error: these operators are not ordered among each other
               = put one of the products in parentheses
            u ∘ v ∘ u
               => expression (∘ u (∘ v u))
            a u × v
               => expression (* a (× u v))
            u × v a
               => expression (* (× u v) a)
            2 u×v
               => expression (* 2 (× u v))
            A : B
               => parameter A : B
            y = A : B
               => define y = (: A B)
            A⁻¹B⁻¹u
               => expression (solve A (solve B u))
            A^-1 B^(-1) u
               => expression (solve A (solve B u))
            a A \ u
               => expression (* a (solve A u))
            A⁻¹ - B
               => expression (- (inv A) B)
            A⁻¹ ⋅ u
               => expression (. (inv A) u)
            (A⁻¹) u
               => expression (* (inv A) u)
            Aᵀ × B
               => expression (× (transpose A) B)
            A × Bᵀ
               => expression (× A (transpose B))
            u ᵀ
               Error: expected the end of the item, found `ᵀ`
               = a superscript follows its operand without a blank
            A^T u
               => expression (* (transpose A) u)
            A^⊤u
               => expression (* (transpose A) u)
            A⁺ + A^+
               => expression (+ (pinv A) (pinv A))
        "#]],
    );
}

#[test]
fn sets_and_operators() {
    check(
        r#"
        S ∪ W ∩ U
        S ∩ W ∪ U
        S - W - U
        S ∪ W - U
        S \ W
        S ∖ W
        { k for k ∈ S if k > 2 }
        {k | k ∈ S, k > 2}
        {k ∀ k ∈ S}
        {k for k ∈ S ∪ W}
        {}
        ∅
        {k : k ∈ S}
        { |k| | k ∈ S }
        {i + j for i, j ∈ P}
        (1,2)
        (a)
        "#,
        expect![[r#"
            S ∪ W ∩ U
               => expression (∪ S (∩ W U))
            S ∩ W ∪ U
               => expression (∪ (∩ S W) U)
            S - W - U
               => expression (- (- S W) U)
            S ∪ W - U
               => expression (- (∪ S W) U)
            S \ W
               => expression (solve S W)
            S ∖ W
               => expression (solve S W)
            { k for k ∈ S if k > 2 }
               => expression {k for k ∈ S if (> k 2)}
            {k | k ∈ S, k > 2}
               => expression {k for k ∈ S if (> k 2)}
            {k ∀ k ∈ S}
               => expression {k for k ∈ S}
            {k for k ∈ S ∪ W}
               => expression {k for k ∈ (∪ S W)}
            {}
               => expression {}
            ∅
               => expression {}
            {k : k ∈ S}
               Error: expected `,` or `}`, found `∈`
               = a set is `{a, b}` or `{e for x ∈ S if condition}`
            { |k| | k ∈ S }
               => expression {|k| for k ∈ S}
            {i + j for i, j ∈ P}
               => expression {(+ i j) for i, j ∈ P}
            (1,2)
               => expression (vector 1 2)
            (a)
               => expression a
        "#]],
    );
}

#[test]
fn calls() {
    check(
        r#"
        f(a)
        f (a)
        a(b)
        f(a)(b)
        f(a)^2
        f()
        f(a×b)
        f(a; b)
        f_a(b)
        f_1,2
        f_a
        f_(a+1)
        min(a, b) + sqrt(a)
        log_2(a)
        log₁₀(a)
        "#,
        expect![[r#"
            f(a)
               => expression (call f a)
            f (a)
               Warning: `f` is multiplied, not called
               = remove the blank before `(` to call it
            a(b)
               => expression (* a b)
            f(a)(b)
               => expression (* (call f a) b)
            f(a)^2
               => expression (^ (call f a) 2)
            f()
               => expression (call f)
            f(a×b)
               => expression (call f (× a b))
            f(a; b)
               => expression (call f a b)
            f_a(b)
               => expression (call f[a] b)
            f_1,2
               => expression (call f[1 2])
            f_a
               => expression (call f[a])
            f_(a+1)
               => expression (call f[(+ a 1)])
            min(a, b) + sqrt(a)
               => expression (+ (call min a b) (call sqrt a))
            log_2(a)
               => expression (call log[2] a)
            log₁₀(a)
               => expression (call log[10] a)
        "#]],
    );
}

#[test]
fn bars() {
    check(
        r#"
        |a|b|c|
        |a + |b||
        |a||b|
        ||u||||v||
        ||u|| ||v||
        ||a|b|
        ‖u‖₂²
        ||u||_2^2
        ||u||^2_2
        ||A||_F a
        ||A||_*
        ||u||_(∞)
        |S| + 1/|S| a
        |f(|a|)|
        |a
        "#,
        expect![[r#"
            |a|b|c|
               => expression (* (* |a| b) |c|)
            |a + |b||
               => expression |(+ a |b|)|
            |a||b|
               => expression (* |a| |b|)
            ||u||||v||
               => expression (* ‖u‖ ‖v‖)
            ||u|| ||v||
               => expression (* ‖u‖ ‖v‖)
            ||a|b|
               Error: expected `‖`, found the end of the text
               = close the bars around the operand
            ‖u‖₂²
               => expression (^ ‖u‖_2 2)
            ||u||_2^2
               => expression (^ ‖u‖_2 2)
            ||u||^2_2
               => expression (^ ‖u‖_2 2)
            ||A||_F a
               => expression (* ‖A‖_F a)
            ||A||_*
               => expression ‖A‖_*
            ||u||_(∞)
               => expression ‖u‖_∞
            |S| + 1/|S| a
               => expression (+ |S| (* (/ 1 |S|) a))
            |f(|a|)|
               => expression |(call f |a|)|
            |a
               Error: expected `|`, found the end of the text
               = close the bars around the operand
        "#]],
    );
}

#[test]
fn sums() {
    check(
        r#"
        ∑_i w_i a + b
        ∑_i w_i a / b
        ∑_i(w_i) + b
        ∑_i -w_i a
        ∑(i ∈ S) w_i
        ∑_i=1^n w_i
        ∏_i w_i
        ∑_(k ∈ S ∪ W) k
        ∑_(k ∈ {1,2}) k
        ∑_(i = 1)^n w_i
        ∑_(i=1)^(n-1) w_i
        ∑_(i for i > 2) w_i
        ∑_(i, j ∈ P) i j
        a ∑_i w_i b
        ∑_i w_i ∑_j w_j
        ∪_(k ∈ S) {k}
        ∑_j (j ∈ S) w_j
        ∑ᵢ wᵢ
        sum_(i in S) w_i
        sum_(i \in S) w_i
        ∑_index w_index
        "#,
        expect![[r#"
            ∑_i w_i a + b
               => expression (+ (∑ i (* w[i] a)) b)
            ∑_i w_i a / b
               => expression (∑ i (/ (* w[i] a) b))
            ∑_i(w_i) + b
               => expression (+ (∑ i w[i]) b)
            ∑_i -w_i a
               => expression (∑ i (neg (* w[i] a)))
            ∑(i ∈ S) w_i
               => expression (∑ (i ∈ S) w[i])
            ∑_i=1^n w_i
               Error: expected a blank after the index, found `=`
               = write `∑_i`, `∑_(i ∈ S)`, `∑_(i for condition)` or `∑_(i = a)^b`
            ∏_i w_i
               => expression (∏ i w[i])
            ∑_(k ∈ S ∪ W) k
               => expression (∑ (k ∈ (∪ S W)) k)
            ∑_(k ∈ {1,2}) k
               => expression (∑ (k ∈ {1, 2}) k)
            ∑_(i = 1)^n w_i
               => expression (∑ (i = 1 to n) w[i])
            ∑_(i=1)^(n-1) w_i
               => expression (∑ (i = 1 to (- n 1)) w[i])
            ∑_(i for i > 2) w_i
               => expression (∑ (i for (> i 2)) w[i])
            ∑_(i, j ∈ P) i j
               => expression (∑ (i, j ∈ P) (* i j))
            a ∑_i w_i b
               => expression (* a (∑ i (* w[i] b)))
            ∑_i w_i ∑_j w_j
               => expression (∑ i (* w[i] (∑ j w[j])))
            ∪_(k ∈ S) {k}
               => expression (⋃ (k ∈ S) {k})
            ∑_j (j ∈ S) w_j
               Error: expected `)`, found `∈`
               = the index of a sum stands directly after `_`, as in `∑_(j ∈ S)`
            ∑ᵢ wᵢ
               Error: expected an index, found `ᵢ`
               = write `∑_i`, `∑_(i ∈ S)`, `∑_(i for condition)` or `∑_(i = a)^b`
            sum_(i in S) w_i
               Error: unknown name `in`
               = membership is written `∈` or `\in`
            sum_(i \in S) w_i
               => expression (∑ (i ∈ S) w[i])
            ∑_index w_index
               => expression (∑ index w[index])
        "#]],
    );
}

#[test]
fn matrices() {
    check(
        r#"
        [a -b]
        [a-b c]
        [a - b]
        [a- b]
        [ab]
        [2a b]
        [||u|| a]
        [a ||u||]
        [A u; 0 1]
        [1 2 NL 3 4 NL ]
        [ NL 1 2]
        [f(a) b]
        [f (a) b]
        [|a b|; |c 1|]
        [|a| b]
        [(a - b) c]
        [∑_i(w_i) a]
        [a, b,]
        [a b; c]
        []
        [u × v w_1]
        "#,
        expect![[r#"
            [a -b]
               => expression [a, (neg b)]
            [a-b c]
               => expression [(- a b), c]
            [a - b]
               => expression [(- a b)]
            [a- b]
               => expression [(- a b)]
            [ab]
               => expression [(* a b)]
            [2a b]
               => expression [(* 2 a), b]
            [||u|| a]
               => expression [‖u‖, a]
            [a ||u||]
               => expression [a, ‖u‖]
            [A u; 0 1]
               => expression [A, u; 0, 1]
            [1 2 NL 3 4 NL ]
               => expression [1, 2; 3, 4]
            [ NL 1 2]
               => expression [1, 2]
            [f(a) b]
               => expression [(call f a), b]
            [f (a) b]
               => expression [f, a, b]
            [|a b|; |c 1|]
               => expression [a, b; c, 1]
            [|a| b]
               => expression [|a|, b]
            [(a - b) c]
               => expression [(- a b), c]
            [∑_i(w_i) a]
               => expression [(∑ i w[i]), a]
            [a, b,]
               Error: expected a cell, found `]`
               = cells are separated by blanks or commas, rows by `;` or line breaks
            [a b; c]
               Error: this row has 1 cell, but the first row has 2
               = blanks separate cells: put a sum or product in parentheses, or write it without blanks
            []
               Error: a matrix has at least one cell
               = write `0_n,m` for a matrix of zeros
            [u × v w_1]
               => expression [(× u v), w[1]]
        "#]],
    );
}

#[test]
fn subscripts() {
    check(
        r#"
        A_i1
        A_ij
        A_1,*
        A_(n+1,2)
        A_(n+1),2
        A_1, 1
        w_12
        x_i,j
        f(x_i,j)
        f(x_i, j)
        xᵢⱼ + A₁,₂ + A₁₂
        (A + B)_1,2
        f(a)_1
        w_
        x_i_1
        "#,
        expect![[r#"
            A_i1
               => expression A[i 1]
            A_ij
               Error: unknown name `ij`
               = declare it, or separate the letters to multiply them
            A_1,*
               => expression A[1 *]
            A_(n+1,2)
               => expression A[(+ n 1) 2]
            A_(n+1),2
               Error: expected the end of the item, found `,`
               = each declaration stands on a line of its own; between subscripts stands a comma without blanks
            A_1, 1
               Error: expected the end of the item, found `,`
               = each declaration stands on a line of its own; between subscripts stands a comma without blanks
            w_12
               => expression w[12]
            x_i,j
               => expression x[i j]
            f(x_i,j)
               => expression (call f x[i j])
            f(x_i, j)
               => expression (call f x[i] j)
            xᵢⱼ + A₁,₂ + A₁₂
               => expression (+ (+ x[i j] A[1 2]) A[12])
            (A + B)_1,2
               => expression (+ A B)[1 2]
            f(a)_1
               => expression (call f a)[1]
            w_
               Error: expected a subscript, found the end of the text
               = write a name, a number or `*`, or an expression in parentheses: `x_(i+1)`
            x_i_1
               Error: expected the end of the item, found `_`
               = all subscripts stand after one `_`, separated by commas, as in `x_i,1`
        "#]],
    );
}

#[test]
fn piecewise() {
    check(
        r#"
        y = { a if b > 0; c otherwise
        y = { a if b > 0; c otherwise }
        y = { a if b > 0
        y = 1 + { a if b > 0; c otherwise
        y = { a if { b if c > 0; 0 otherwise > 1
        y = { a if b > 0 NL b if c < 0 and a ≠ 1 or b ≤ 2 NL 0 otherwise
        y = { b > 0 : a; c otherwise
        y = { a if 0 < a < 2; b otherwise
        y = { a if not a > 0; b otherwise
        y = { a if (a > 0 or b > 0) and (c > 0); b otherwise
        y = { a if (a + b) c < 1; b otherwise
        y = { a if (1, 2) ∈ P or 1 ∉ S; b otherwise
        y = { a if a; b otherwise
        "#,
        expect![[r#"
            y = { a if b > 0; c otherwise
               => define y = {a if (> b 0); c otherwise
            y = { a if b > 0; c otherwise }
               Error: a piecewise value has no closing brace
               = remove the `}`; the value ends with its last line
            y = { a if b > 0
               => define y = {a if (> b 0)
            y = 1 + { a if b > 0; c otherwise
               Error: a piecewise value is no operand
               = make it the whole right-hand side of a definition of its own
            y = { a if { b if c > 0; 0 otherwise > 1
               Error: a piecewise value is no operand
               = make it the whole right-hand side of a definition of its own
            y = { a if b > 0 NL b if c < 0 and a ≠ 1 or b ≤ 2 NL 0 otherwise
               => define y = {a if (> b 0); b if (or (and (< c 0) (≠ a 1)) (≤ b 2)); 0 otherwise
            y = { b > 0 : a; c otherwise
               Error: expected `if` or `otherwise`, found `>`
               = a branch is `value if condition` or `value otherwise`
            y = { a if 0 < a < 2; b otherwise
               Error: relations cannot be chained
               = write two relations, as in `0 < a and a < …`
            y = { a if not a > 0; b otherwise
               Error: unknown name `not`
               = there is no `not`; turn the relation round, as in `a ≤ b`
            y = { a if (a > 0 or b > 0) and (c > 0); b otherwise
               => define y = {a if (and (or (> a 0) (> b 0)) (> c 0)); b otherwise
            y = { a if (a + b) c < 1; b otherwise
               => define y = {a if (< (* (+ a b) c) 1); b otherwise
            y = { a if (1, 2) ∈ P or 1 ∉ S; b otherwise
               => define y = {a if (or (∈ (vector 1 2) P) (∉ 1 S)); b otherwise
            y = { a if a; b otherwise
               Error: expected a relation, found the end of the branch
               = a condition compares, as in `a < b`, or asks for membership, as in `a ∈ S`
        "#]],
    );
}

#[test]
fn derivatives() {
    check(
        r#"
        ∂(a+b)/∂x
        ∂²y/∂x²
        ∂^2y/∂x^2
        ∂²y/∂a∂b
        ∂/∂x (a b)
        ∂f(a)/∂a
        ∇_x a
        ∇_x(a)
        ∇ₓ a
        ∂a b/∂x
        ∂y / ∂x
        𝕕y/𝕕a
        Δ a + ∇⋅u + ∇ a
        ∂y/∂x_1
        ∂ⁿy/∂x
        "#,
        expect![[r#"
            ∂(a+b)/∂x
               => expression (∂1 (+ a b) / x)
            ∂²y/∂x²
               => expression (∂2 y / x^2)
            ∂^2y/∂x^2
               => expression (∂2 y / x^2)
            ∂²y/∂a∂b
               => expression (∂2 y / a b)
            ∂/∂x (a b)
               => expression (∂1 (* a b) / x)
            ∂f(a)/∂a
               => expression (∂1 (call f a) / a)
            ∇_x a
               => expression (∇_x a)
            ∇_x(a)
               => expression (∇_x a)
            ∇ₓ a
               => expression (∇_x a)
            ∂a b/∂x
               Error: expected `/` and what to differentiate by, found `b`
               = write `∂y/∂x`, `∂²y/∂x²`, `∂(…)/∂x` or `∂/∂x (…)`, without blanks around `/`
            ∂y / ∂x
               => expression (∂1 y / x)
            𝕕y/𝕕a
               => expression (𝕕1 y / a)
            Δ a + ∇⋅u + ∇ a
               => expression (+ (+ (Δ a) (∇⋅ u)) (∇ a))
            ∂y/∂x_1
               => expression (∂1 y / x[1])
            ∂ⁿy/∂x
               Error: the order of a derivative is a small number
               = write `∂²y/∂x²` for a second derivative
        "#]],
    );
}

#[test]
fn functions() {
    check(
        r#"
        h(t) = t r where t ∈ ℝ, NL r = s, NL s = 3
        h(t,s) = t where t ∈ ℝ, NL s ∈ ℝ
        h(t) = t + NL 2 where t ∈ ℝ
        h(t) = t NL where t ∈ ℝ
        h_i,j = w_i w_j where i, j ∈ S
        h_i(t) = t w_i where i ∈ S, t ∈ ℝ
        hᵢ(t) = t where i ∈ S, t ∈ ℝ
        y_i = w_i
        y = a NL + b
        y = 2a where q ∈ ℝ
        y = 2a where q = 3
        h(t) = ∑_i w_i t where t ∈ ℝ
        h(t) = ∑_(i ∈ S) k where k = t i where t ∈ ℝ
        h(t) = ∑_(i ∈ S) k where k = t i, t ∈ ℝ
        h(t) = ∑_(i ∈ S) k with k = t i NL where t ∈ ℝ
        h(g) = g(1) where g ∈ ℝ → ℝ
        h(f) = f(1) where f ∈ ℝ
        h(t) = t where t
        h(t = 3
        h(1) = 2
        a + b = c
        y = k where NL k ∈ ℝ
        where NL k ∈ ℝ NL l ∈ ℤ
        "#,
        expect![[r#"
            h(t) = t r where t ∈ ℝ, NL r = s, NL s = 3
               => function h(t)
                    = (* t r)
                    where t ∈ ℝ
                    local r = s
                    local s = 3
            h(t,s) = t where t ∈ ℝ, NL s ∈ ℝ
               => function h(t, s)
                    = t
                    where t ∈ ℝ
                    where s ∈ ℝ
            h(t) = t + NL 2 where t ∈ ℝ
               => function h(t)
                    = (+ t 2)
                    where t ∈ ℝ
            h(t) = t NL where t ∈ ℝ
               => function h(t)
                    = t
                    where t ∈ ℝ
            h_i,j = w_i w_j where i, j ∈ S
               => function h[i, j]
                    = (* w[i] w[j])
                    where i, j ∈ S
            h_i(t) = t w_i where i ∈ S, t ∈ ℝ
               => function h[i](t)
                    = (* t w[i])
                    where i ∈ S
                    where t ∈ ℝ
            hᵢ(t) = t where i ∈ S, t ∈ ℝ
               => function h[i](t)
                    = t
                    where i ∈ S
                    where t ∈ ℝ
            y_i = w_i
               => define y[i] = w[i]
            y = a NL + b
               Error: expected an operand, found `+`
               = an expression goes on over a line break after an operator or in parentheses
            y = 2a where q ∈ ℝ
               Error: local declaration `q` is not a parameter of `y`
               = declare `q` on a line of its own to make it a parameter of the module, or write `y(q) = …`
            y = 2a where q = 3
               Error: `y` has no parameters, so it has no local definitions
               = define `q` on a line of its own
            h(t) = ∑_i w_i t where t ∈ ℝ
               => function h(t)
                    = (∑ i (* w[i] t))
                    where t ∈ ℝ
            h(t) = ∑_(i ∈ S) k where k = t i where t ∈ ℝ
               => function h(t)
                    = (∑ (i ∈ S) k where k = (* t i))
                    where t ∈ ℝ
            h(t) = ∑_(i ∈ S) k where k = t i, t ∈ ℝ
               => function h(t)
                    = (∑ (i ∈ S) k where k = (* t i))
                    where t ∈ ℝ
            h(t) = ∑_(i ∈ S) k with k = t i NL where t ∈ ℝ
               => function h(t)
                    = (∑ (i ∈ S) k where k = (* t i))
                    where t ∈ ℝ
            h(g) = g(1) where g ∈ ℝ → ℝ
               => function h(g)
                    = (call g 1)
                    where g ∈ (ℝ → ℝ)
            h(f) = f(1) where f ∈ ℝ
               => function h(f)
                    = (* f 1)
                    where f ∈ ℝ
            h(t) = t where t
               Error: expected a declaration or a definition, found `t`
               = after `where` stand `x ∈ type` for the parameters and `name = value`, separated by commas
            h(t = 3
               Error: expected `)`, found `=`
               = close the parenthesis
            h(1) = 2
               Error: expected a parameter, found `1`
               = parameters are names, separated by commas
            a + b = c
               Error: this cannot be defined
               = the left side of a definition is a name, with subscripts or with parameters in parentheses
            y = k where NL k ∈ ℝ
               Error: local declaration `k` is not a parameter of `y`
               = declare `k` on a line of its own to make it a parameter of the module, or write `y(k) = …`
            where NL k ∈ ℝ NL l ∈ ℤ
               => parameter k ∈ ℝ
                  parameter l ∈ ℤ
        "#]],
    );
}

#[test]
fn numbers_and_constants() {
    check(
        r#"
        2E3 + 2E + 1.5E-3 + 3. + .5
        ½ + ⅓ π ∞
        99999999999999999999
        1E999
        1_n + 0_n,a + 𝟙_(n×a) + 1₃,₃
        I_n + I
        #x
        #x_1
        "#,
        expect![[r#"
            2E3 + 2E + 1.5E-3 + 3. + .5
               => expression (+ (+ (+ (+ 2000.0 (* 2 E)) 0.0015) 3.0) 0.5)
            ½ + ⅓ π ∞
               => expression (+ 0.5 (* (* 0.3333333333333333 π) ∞))
            99999999999999999999
               Error: this number is too large
               = integers go up to 9223372036854775807, decimals up to about 1.8E308
            1E999
               Error: this number is too large
               = integers go up to 9223372036854775807, decimals up to about 1.8E308
            1_n + 0_n,a + 𝟙_(n×a) + 1₃,₃
               => expression (+ (+ (+ (ones n) (zeros n a)) (ones n a)) (ones 3 3))
            I_n + I
               => expression (+ I[n] I)
            #x
               => expression (# x)
            #x_1
               => expression (# x[1])
        "#]],
    );
}

#[test]
fn names() {
    check(
        r#"
        abcd
        bc
        foo = 3 NL foo foo2
        fo = 3 NL afob
        length = 3 NL lenght + 1
        `a b` = 2
        `ab
        ``
        `__ihm_x` = 2
        x̂ = 2 NL x̂ a
        θ = 1 NL \theta a
        x'
        a $ b
        a ? b
        as
        ∂¹, ∂⁰ = tuple(A, B) NL ∂¹_1,2 ∂⁰
        "#,
        expect![[r#"
            abcd
               Error: unknown name `abcd`
               = declare it, or separate the letters to multiply them
            bc
               => expression (* b c)
            foo = 3 NL foo foo2
               => define foo = 3
                  expression (* (* foo foo) 2)
            fo = 3 NL afob
               => define fo = 3
                  expression (* (* a fo) b)
            length = 3 NL lenght + 1
               Error: unknown name `lenght`
               = did you mean `length`?
            `a b` = 2
               => define `a b` = 2
            `ab
               Error: a name in back-ticks is not closed on its line
               = write a back-tick at the end of the name
            ``
               Error: a name in back-ticks is empty
               = write the name between the back-ticks
            `__ihm_x` = 2
               Error: the name `__ihm_x` is reserved
               = choose a name that does not begin with `__ihm`
            x̂ = 2 NL x̂ a
               => define x̂ = 2
                  expression (* x̂ a)
            θ = 1 NL \theta a
               => define θ = 1
                  expression (* θ a)
            x'
               Error: unexpected character `'`
               = a prime is part of a name only in back-ticks, as in `x'` between back-ticks
            a $ b
               Error: unexpected character `$`
               = this character means nothing in the language; remove it
            a ? b
               Error: unexpected character `?`
               = this character means nothing in the language; remove it
            as
               => expression (* a s)
            ∂¹, ∂⁰ = tuple(A, B) NL ∂¹_1,2 ∂⁰
               => define ∂¹, ∂⁰ = (call tuple A B)
                  expression (* ∂¹[1 2] ∂⁰)
        "#]],
    );
}

#[test]
fn optimisation() {
    check(
        r#"
        y = min_(z ∈ ℝ^3, k ∈ ℝ) z⋅u + k
        y = argmax_(z ∈ ℝ) z s.t. z < 2 NL z > 0 NL t = 3
        y = 1 + min_(z ∈ ℝ) z
        y = with initial z = 1 NL min_(z ∈ ℝ) z
        min(a, b)
        ∫_[0,1] t² 𝕕t
        int_0^1 t² 𝕕t a
        ∫ t 𝕕t
        "#,
        expect![[r#"
            y = min_(z ∈ ℝ^3, k ∈ ℝ) z⋅u + k
               => define y = (min (z ∈ ℝ[3], k ∈ ℝ) (+ (. z u) k))
            y = argmax_(z ∈ ℝ) z s.t. z < 2 NL z > 0 NL t = 3
               => define y = (argmax (z ∈ ℝ) z s.t. (< z 2) s.t. (> z 0))
                  define t = 3
            y = 1 + min_(z ∈ ℝ) z
               Error: an optimisation is no operand
               = make it the whole right-hand side of a definition of its own
            y = with initial z = 1 NL min_(z ∈ ℝ) z
               => define y = (min (z ∈ ℝ) z initial z = 1)
            min(a, b)
               => expression (call min a b)
            ∫_[0,1] t² 𝕕t
               => expression (∫ t 0 1 (^ t 2))
            int_0^1 t² 𝕕t a
               => expression (* (∫ t 0 1 (^ t 2)) a)
            ∫ t 𝕕t
               Error: expected `_` and the bounds, found `t`
               = write `∫_[a,b] value 𝕕t` or `∫_a^b value 𝕕t`
        "#]],
    );
}

#[test]
fn declarations() {
    check(
        r#"
        k ∈ ℝ^(n×m) sparse : some text, with = signs
        k : ℤ index
        k ∈ {ℝ^3}
        k ∈ {ℝ^(3)}
        k ∈ {ℤ²} vertices
        k ∈ {ℤ ∨ ℝ}
        k ∈ ℝ × ℤ
        k ∈ ℝ, ℝ^n → ℝ^n
        k ∈ ∅ → ℝ
        k ∈ {} → ℝ
        k : S → ℝ³
        k ⊂ S
        k ∈ vector(n) sparse
        k ∈ matrix(n, 2n+1)
        k_i ∈ ℝ^(n_i)
        k_ij ∈ ℝ
        k_1 ∈ ℝ
        k ∈
        k ∈ ℝ^
        k ∈ ℝ, l ∈ ℝ
        k : vertexSet
        k ∈ ℝ^(#x)
        k ∈ ℝ^2n
        "#,
        expect![[r#"
            k ∈ ℝ^(n×m) sparse : some text, with = signs
               => parameter k ∈ ℝ[n, m] sparse "some text, with = signs"
            k : ℤ index
               => parameter k : ℤ Index
            k ∈ {ℝ^3}
               => parameter k ∈ {ℝ × ℝ × ℝ}
            k ∈ {ℝ^(3)}
               => parameter k ∈ {ℝ[3]}
            k ∈ {ℤ²} vertices
               => parameter k ∈ {ℤ × ℤ} Vertices
            k ∈ {ℤ ∨ ℝ}
               => parameter k ∈ {ℤ ∨ ℝ}
            k ∈ ℝ × ℤ
               => parameter k ∈ (ℝ × ℤ)
            k ∈ ℝ, ℝ^n → ℝ^n
               => parameter k ∈ (ℝ, ℝ[n] → ℝ[n])
            k ∈ ∅ → ℝ
               => parameter k ∈ ( → ℝ)
            k ∈ {} → ℝ
               => parameter k ∈ ( → ℝ)
            k : S → ℝ³
               => parameter k : (S ↦ ℝ[3])
            k ⊂ S
               => parameter k ⊂ S
            k ∈ vector(n) sparse
               => parameter k ∈ ℝ[n] sparse
            k ∈ matrix(n, 2n+1)
               => parameter k ∈ ℝ[n, (+ (* 2 n) 1)]
            k_i ∈ ℝ^(n_i)
               => parameter k[i] ∈ ℝ[n[i]]
            k_ij ∈ ℝ
               Error: a sequence is declared with one subscript letter
               = write `x_i ∈ type`; several dimensions go into the type
            k_1 ∈ ℝ
               Error: a sequence is declared with one subscript letter
               = write `x_i ∈ type`; several dimensions go into the type
            k ∈
               Error: expected a type, found the end of the text
               = types are ℝ, ℤ, ℝ^n, ℝ^(n×m), {T}, T × U, T → U, FaceMesh and the like, or the name of a set
            k ∈ ℝ^
               Error: expected an operand, found the end of the text
               = write a name, a number or a bracket here
            k ∈ ℝ, l ∈ ℝ
               Error: expected the end of the item, found `,`
               = each declaration stands on a line of its own; between subscripts stands a comma without blanks
            k : vertexSet
               => parameter k : VertexSet
            k ∈ ℝ^(#x)
               => parameter k ∈ ℝ[(# x)]
            k ∈ ℝ^2n
               => parameter k ∈ ℝ[(* 2 n)]
        "#]],
    );
}

#[test]
fn imports() {
    check(
        r#"
        sin, cos from trigonometry NL sin(a)
        foo from Bar(M, N) NL foo(a)
        foo as bar from Bar NL bar(a)
        * from trigonometry NL sin(a) e
        vec⁻¹ from linearalgebra NL vec⁻¹_x(u)
        my_name from Other NL my_name(a)
        from Bar
        foo from
        foo from Bar(
        __ihm_a from Bar
        e from trigonometry NL e (a)
        "#,
        expect![[r#"
            sin, cos from trigonometry NL sin(a)
               => import sin, cos from trigonometry()
                  expression (call sin a)
            foo from Bar(M, N) NL foo(a)
               => import foo from Bar(M, N)
                  expression (call foo a)
            foo as bar from Bar NL bar(a)
               => import foo as bar from Bar()
                  expression (call bar a)
            * from trigonometry NL sin(a) e
               => import * from trigonometry()
                  expression (* (call sin a) e)
            vec⁻¹ from linearalgebra NL vec⁻¹_x(u)
               => import vec⁻¹ from linearalgebra()
                  expression (call vec⁻¹[x] u)
            my_name from Other NL my_name(a)
               => import my_name from Other()
                  expression (call my_name a)
            from Bar
               Error: expected a name to import, found `from`
               = write `names from Module(arguments)`
            foo from
               Error: expected the name of a module, found the end of the text
               = write `names from Module(arguments)`
            foo from Bar(
               Error: expected a parameter of this module, found the end of the text
               = write `names from Module(arguments)`
            __ihm_a from Bar
               Error: the name `__ihm_a` is reserved
               = choose a name that does not begin with `__ihm`
            e from trigonometry NL e (a)
               => import e from trigonometry()
                  expression (* e a)
        "#]],
    );
}

#[test]
fn separators() {
    check(
        r#"
        a b; c
        y = (a NL + b)
        y = a + NL b
        y = a // a comment
        y = 2 z = 3
        a)
        (a
        {a, b
        y = = 3
        "#,
        expect![[r#"
            a b; c
               => expression (* a b)
                  expression c
            y = (a NL + b)
               => define y = (+ a b)
            y = a + NL b
               => define y = (+ a b)
            y = a // a comment
               => define y = a
            y = 2 z = 3
               Error: expected the end of the item, found `=`
               = each item stands on a line of its own; use parentheses to go on over a line break
            a)
               Error: expected the end of the item, found `)`
               = each item stands on a line of its own; use parentheses to go on over a line break
            (a
               Error: expected `)`, found the end of the text
               = close the parenthesis
            {a, b
               Error: expected `,` or `}`, found the end of the text
               = a set is `{a, b}` or `{e for x ∈ S if condition}`
            y = = 3
               Error: expected an operand, found `=`
               = write a name, a number or a bracket here
        "#]],
    );
}
