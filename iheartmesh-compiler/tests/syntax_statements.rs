//! Names, declarations, functions, imports and separators: the probes of the language reference, and what is near them.

mod syntax_support;

use expect_test::expect;
use syntax_support::check_probes as check;

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
        h(i, p) = p_i where i ∈ S, p : S → ℝ
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
            h(i, p) = p_i where i ∈ S, p : S → ℝ
               => function h(i, p)
                    = p[i]
                    where i ∈ S
                    where p : (S ↦ ℝ)
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
               = the left side of a definition is a name, with subscripts or with parameters in parentheses; between back-ticks, a name may have any characters
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
               = a name with a number in it stands between back-ticks
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
               = the names stand in front, as in `sin, cos from trigonometry`
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
               Error: this `(` is not closed
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
