//! Operators, calls and bars: the probes of the language reference, and what is near them.

mod syntax_support;

use expect_test::expect;
use syntax_support::check_probes as check;

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
        a^-1^-1 b
        A^-1^T
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
            a^-1^-1 b
               => expression (solve (inv a) b)
            A^-1^T
               => expression (transpose (inv A))
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
