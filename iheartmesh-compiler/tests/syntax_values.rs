//! Sums, matrices, subscripts and the other constructs of expressions: the probes of the language reference, and what is near them.

mod syntax_support;

use expect_test::expect;
use syntax_support::check_probes as check;

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
               Error: what `i` runs over stands in parentheses
               = write `∑_(i = 1)^n`
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
               Error: unknown subscript `ij`
               = letters are indices where each stands on the left side as well, as in `y_ij = …`, or below a sum, as in `∑_i ∑_j`
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
