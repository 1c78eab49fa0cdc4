//! The lexical rules of the language reference (its §1), line by line.

mod syntax_support;

use expect_test::expect;
use syntax_support::{check_probes as check, table};

#[test]
fn source_text() {
    check(
        r#"
        q = a // b and more
        q = a; p = b;; ;t = c;
        q = (a + NL b)
        q = a + NL b
        q = a NL b
        q = [a b NL c n]
        q = min_(z ∈ ℝ) z NL s.t. z > 1 NL z < 2
        h(t) = k NL where t ∈ ℝ, NL k = t, j = k
        q = ∑_(i ∈ S) k NL where k = i
        ∑_(i ∈ S) k where k = j, NL j = i
        where NL k ∈ ℝ NL j ∈ ℤ
        q = f( NL a NL )
        q = { NL a if b > 0 NL b otherwise
        "#,
        expect![[r#"
            q = a // b and more
               => define q = a
            q = a; p = b;; ;t = c;
               => define q = a
                  define p = b
                  define t = c
            q = (a + NL b)
               => define q = (+ a b)
            q = a + NL b
               => define q = (+ a b)
            q = a NL b
               => define q = a
                  expression b
            q = [a b NL c n]
               => define q = [a, b; c, n]
            q = min_(z ∈ ℝ) z NL s.t. z > 1 NL z < 2
               => define q = (min (z ∈ ℝ) z s.t. (> z 1) s.t. (< z 2))
            h(t) = k NL where t ∈ ℝ, NL k = t, j = k
               => function h(t)
                    = k
                    where t ∈ ℝ
                    local k = t
                    local j = k
            q = ∑_(i ∈ S) k NL where k = i
               => define q = (∑ (i ∈ S) k where k = i)
            ∑_(i ∈ S) k where k = j, NL j = i
               => expression (∑ (i ∈ S) k where k = j where j = i)
            where NL k ∈ ℝ NL j ∈ ℤ
               => parameter k ∈ ℝ
                  parameter j ∈ ℤ
            q = f( NL a NL )
               => define q = (call f a)
            q = { NL a if b > 0 NL b otherwise
               => define q = {a if (> b 0); b otherwise
        "#]],
    );
    // tabs, carriage returns, form feeds and other ends of lines; a byte order mark; blanks that are not ASCII
    let odd = "\u{feff}a\t∈ ℝ\r\nb ∈ ℝ\rc ∈ ℝ\u{c}q = a\u{a0}b\u{2028}p = q";
    expect![[r#"
        ﻿a	∈ ℝ NL b ∈ ℝc ∈ ℝq = a b p = q
           => parameter a ∈ ℝ
              parameter b ∈ ℝ
              parameter c ∈ ℝ
              define q = (* a b)
              define p = q
    "#]]
    .assert_eq(&table(
        "",
        &odd.replace('\n', " NL ").replace('\r', "\u{85}"),
    ));
}

#[test]
fn identifiers() {
    let context =
        "ab, c, cab9 ∈ ℝ\nx̂, n̄, Ũ, ё, 位 ∈ ℝ\n`two words`, `x'`, `a+b`, `where` ∈ ℝ\nb, a ∈ ℝ";
    expect![[r#"
        abc + cab + cab9 + cab8
           => expression (+ (+ (+ (* ab c) (* c ab)) cab9) (* (* c ab) 8))
        a b + ab + b a
           => expression (+ (+ (* a b) ab) (* b a))
        x̂n̄ + Ũ² + ё位
           => expression (+ (+ (* x̂ n̄) (^ Ũ 2)) (* ё 位))
        `two words` `x'` + `a+b` + `where`
           => expression (+ (+ (* `two words` x') a+b) where)
        `ab` + ab + `c`
           => expression (+ (+ ab ab) c)
        x'
           Error: unexpected character `'`
           = a prime is part of a name only in back-ticks, as in `x'` between back-ticks
        'ab'
           Error: text in quotes means nothing in the language
           = values are numbers, sets and meshes; a description of a parameter follows a colon, as in `x ∈ ℝ: the width`
        a_b + ab_c
           => expression (+ a[b] ab[c])
        xy
           Error: unknown name `xy`
           = declare it, or separate the letters to multiply them
        abz
           Error: unknown name `abz`
           = did you mean `ab`?
        zz
           Error: unknown name `zz`
           = declare it, or separate the letters to multiply them
        `ab
           Error: a name in back-ticks is not closed on its line
           = write a back-tick at the end of the name
        ``
           Error: a name in back-ticks is empty
           = write the name between the back-ticks
        ab9 + a9b
           => expression (+ (* ab 9) (* (* a 9) b))
    "#]]
    .assert_eq(&table(
        context,
        r#"
        abc + cab + cab9 + cab8
        a b + ab + b a
        x̂n̄ + Ũ² + ё位
        `two words` `x'` + `a+b` + `where`
        `ab` + ab + `c`
        x'
        'ab'
        a_b + ab_c
        xy
        abz
        zz
        `ab
        ``
        ab9 + a9b
        "#,
    ));
}

#[test]
fn scopes_of_words() {
    check(
        r#"
        h(rs) = rs t where rs ∈ ℝ, t = r s
        h(t) = t where t ∈ ℝ NL k = rs
        ∑_(vec ∈ S) vec a
        { elem + 1 for elem ∈ S if elem > 2 }
        ∫_0^1 time² 𝕕time
        q = min_(var ∈ ℝ) var²
        h(t) = loc a where t ∈ ℝ, loc = t NL q = loc
        ∑_(i ∈ S) weight where weight = i
        nn ∈ ℝ^(mm×3) NL q = mm nn
        "#,
        expect![[r#"
            h(rs) = rs t where rs ∈ ℝ, t = r s
               => function h(rs)
                    = (* rs t)
                    where rs ∈ ℝ
                    local t = (* r s)
            h(t) = t where t ∈ ℝ NL k = rs
               => function h(t)
                    = t
                    where t ∈ ℝ
                  define k = (* r s)
            ∑_(vec ∈ S) vec a
               => expression (∑ (vec ∈ S) (* vec a))
            { elem + 1 for elem ∈ S if elem > 2 }
               => expression {(+ elem 1) for elem ∈ S if (> elem 2)}
            ∫_0^1 time² 𝕕time
               => expression (∫ time 0 1 (^ time 2))
            q = min_(var ∈ ℝ) var²
               => define q = (min (var ∈ ℝ) (^ var 2))
            h(t) = loc a where t ∈ ℝ, loc = t NL q = loc
               Error: unknown name `loc`
               = did you mean `log`?
            ∑_(i ∈ S) weight where weight = i
               => expression (∑ (i ∈ S) weight where weight = i)
            nn ∈ ℝ^(mm×3) NL q = mm nn
               => parameter nn ∈ ℝ[mm, 3]
                  define q = (* mm nn)
        "#]],
    );
}

#[test]
fn small_characters() {
    check(
        r#"
        xᵢ + wₐ + A₁,₂ + A₁₂ + A_12
        xᵢⱼ
        x₁ᵢ
        xᵣ
        ∑ᵢ wᵢ
        a²³ + a⁻² + a⁰
        aⁿ + aᴬ
        aᵀ⁻¹ + A⁻¹ᵀ + A⁺
        a⁻
        a⁻ⁿ
        f₁
        x₁₂₃₄₅₆₇₈₉₁₂₃₄₅₆₇₈₉₁₂
        a⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹
        "#,
        expect![[r#"
            xᵢ + wₐ + A₁,₂ + A₁₂ + A_12
               => expression (+ (+ (+ (+ x[i] w[a]) A[1 2]) A[12]) A[12])
            xᵢⱼ
               => expression x[i j]
            x₁ᵢ
               => expression x[1 i]
            xᵣ
               Error: unexpected character `ᵣ`
               = there is no such subscript character in the language; write `x_r`
            ∑ᵢ wᵢ
               Error: expected an index, found `ᵢ`
               = write `∑_i`, `∑_(i ∈ S)`, `∑_(i for condition)` or `∑_(i = a)^b`
            a²³ + a⁻² + a⁰
               => expression (+ (+ (^ a 23) (^ a (neg 2))) (^ a 0))
            aⁿ + aᴬ
               => expression (+ (^ a n) (^ a A))
            aᵀ⁻¹ + A⁻¹ᵀ + A⁺
               => expression (+ (+ (inv (transpose a)) (transpose (inv A))) (pinv A))
            a⁻
               Error: unexpected character `⁻`
               = an exponent with a sign is a number, as in `a⁻²`, or stands after `^`, as in `a^-n`; the transpose of an inverse is `(A⁻¹)ᵀ`
            a⁻ⁿ
               Error: unexpected character `⁻`
               = an exponent with a sign is a number, as in `a⁻²`, or stands after `^`, as in `a^-n`; the transpose of an inverse is `(A⁻¹)ᵀ`
            f₁
               => expression (call f[1])
            x₁₂₃₄₅₆₇₈₉₁₂₃₄₅₆₇₈₉₁₂
               Error: this subscript is too large
               = write a smaller subscript
            a⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹
               Error: this exponent is too large
               = write a smaller exponent
        "#]],
    );
}

#[test]
fn keywords() {
    let context =
        "s, t, a, o, r, i, f, n, m, x ∈ ℝ\nforce, asa, minx, orange, wherever, integral ∈ ℝ";
    expect![[r#"
        a s + o r + i f
           => expression (+ (+ (* a s) (* o r)) (* i f))
        as
           => expression (* a s)
        or
           Error: expected an operand, found `or`
           = an expression goes on over a line break after an operator or in parentheses
        if
           Error: expected an operand, found `if`
           = an expression goes on over a line break after an operator or in parentheses
        force asa + minx orange wherever integral
           => expression (+ (* force asa) (* (* (* minx orange) wherever) integral))
        s t + 1
           => expression (+ (* s t) 1)
        s,t ∈ ℝ
           => parameter s, t ∈ ℝ
        s s.t. t
           Error: expected the end of the item, found `s.t.`
           = each item stands on a line of its own; use parentheses to go on over a line break
        sum + min + int + exp
           Error: unknown name `sum`
           = declare it, or separate the letters to multiply them
        exp(s) + log(s) + ln(s) + sqrt(s) + sum_i x
           => expression (+ (+ (+ (+ (call exp s) (call log s)) (call ln s)) (call sqrt s)) (∑ i x))
        `for` ∈ ℝ NL q = `for`
           => parameter for ∈ ℝ
              define q = for
        for ∈ ℝ
           Error: expected an operand, found `for`
           = this word has a meaning of its own; between back-ticks it is a name
        q = given
           Error: expected an operand, found `given`
           = write a name, a number or a bracket here
    "#]]
    .assert_eq(&table(
        context,
        r#"
        a s + o r + i f
        as
        or
        if
        force asa + minx orange wherever integral
        s t + 1
        s,t ∈ ℝ
        s s.t. t
        sum + min + int + exp
        exp(s) + log(s) + ln(s) + sqrt(s) + sum_i x
        `for` ∈ ℝ NL q = `for`
        for ∈ ℝ
        q = given
        "#,
    ));
}

#[test]
fn numbers() {
    check(
        r#"
        12 + 12. + 12.5 + .5 + 0
        2E3 + 2E+3 + 2E-3 + 2.5E3 + .5E3
        2E + 2e3
        ½ ⅓ ⅔ ¼ ¾ ⅕ ⅖ ⅗ ⅘ ⅙ ⅚ ⅐ ⅛ ⅜ ⅝ ⅞ ⅑ ⅒
        \frac12 \frac110 \frac19 \half
        1.2.3
        1..2
        .
        π + ∞
        9223372036854775807
        9223372036854775808
        "#,
        expect![[r#"
            12 + 12. + 12.5 + .5 + 0
               => expression (+ (+ (+ (+ 12 12.0) 12.5) 0.5) 0)
            2E3 + 2E+3 + 2E-3 + 2.5E3 + .5E3
               => expression (+ (+ (+ (+ 2000.0 2000.0) 0.002) 2500.0) 500.0)
            2E + 2e3
               => expression (+ (* 2 E) (* (* 2 e) 3))
            ½ ⅓ ⅔ ¼ ¾ ⅕ ⅖ ⅗ ⅘ ⅙ ⅚ ⅐ ⅛ ⅜ ⅝ ⅞ ⅑ ⅒
               => expression (* (* (* (* (* (* (* (* (* (* (* (* (* (* (* (* (* 0.5 0.3333333333333333) 0.6666666666666666) 0.25) 0.75) 0.2) 0.4) 0.6) 0.8) 0.16666666666666666) 0.8333333333333334) 0.14285714285714285) 0.125) 0.375) 0.625) 0.875) 0.1111111111111111) 0.1)
            \frac12 \frac110 \frac19 \half
               => expression (* (* (* 0.5 0.1) 0.1111111111111111) 0.5)
            1.2.3
               => expression (* 1.2 0.3)
            1..2
               => expression (* 1.0 0.2)
            .
               Error: unexpected character `.`
               = this character means nothing in the language; remove it
            π + ∞
               => expression (+ π ∞)
            9223372036854775807
               => expression 9223372036854775807
            9223372036854775808
               Error: this number is too large
               = integers go up to 9223372036854775807, decimals up to about 1.8E308
        "#]],
    );
}

#[test]
fn euler_is_a_name_unless_imported() {
    expect![[r#"
        q = e^a
           => define q = (^ e a)
    "#]]
    .assert_eq(&table("e from trigonometry\na ∈ ℝ", "q = e^a"));
    expect![[r#"
        q = e^a
           => define q = (^ e a)
    "#]]
    .assert_eq(&table("e, a ∈ ℝ", "q = e^a"));
}

#[test]
fn spellings_of_operators() {
    check(
        r#"
        k ∈ ℝ
        k : RR^3
        k \in ZZ
        k ⊂ S
        k \subset S
        k ⊆ S
        { k for k ∈ S if k ∉ W and k \notin U }
        q = ∑_i w_i + sum_i w_i + \sum_i w_i
        q = ∪_(k ∈ S) {k} ∪ ⋃_(k ∈ S) {k} \cup \bigcup_(k ∈ S) {k}
        q = S ∪ W ∩ U + S \cup W \cap U
        q = S - W + S \ W + S ∖ W
        q = u ⋅ v + u · v + u • v + u \cdot v
        q = u × v + u \times v
        q = (A ∘ B) + (A ⊗ B) + (A : B)
        q = a / b + a ÷ b
        q = a ± b +- c
        q = a - b − c
        q = a^b + a²
        q = Aᵀ + A^T + A^⊤
        q = A⁻¹ + A^(-1) + A^-1 + A^( -1)
        q = A⁺ + A^+
        q = √a + sqrt(a) + \sqrt a
        q = |a| + ||u|| + ‖u‖ + ∥u∥
        q = <u,v> + ⟨u, v⟩
        q = { 1 if a = b or a == b or a ≠ b or a != b; 2 if a < b or a <= b or a ≤ b or a ⩽ b; 3 if a > b or a >= b or a ≥ b or a ⩾ b
        g ∈ ℝ → ℝ NL j ∈ ℝ -> ℝ
        g ∈ ∅ → ℝ NL j ∈ {} → ℝ
        q = ∂a/∂x + ∇_x a + Δ a + 𝕕a/𝕕x
        q = ∫_[0,1] t 𝕕t + int_[0,1] t \dd t
        q = 𝟙_3 + 1_3
        q = { k for k ∈ S } + { k ∀ k ∈ S }
        q = #x
        h(a, b; c) = a where a, b, c ∈ ℝ
        h(axb) = a where a ∈ ℝ
        A_1,* + A_*,1
        a * b
        "#,
        expect![[r#"
            k ∈ ℝ
               => parameter k ∈ ℝ
            k : RR^3
               => parameter k : ℝ[3]
            k \in ZZ
               => parameter k ∈ ℤ
            k ⊂ S
               => parameter k ⊂ S
            k \subset S
               => parameter k ⊂ S
            k ⊆ S
               => parameter k ⊂ S
            { k for k ∈ S if k ∉ W and k \notin U }
               => expression {k for k ∈ S if (and (∉ k W) (∉ k U))}
            q = ∑_i w_i + sum_i w_i + \sum_i w_i
               => define q = (+ (+ (∑ i w[i]) (∑ i w[i])) (∑ i w[i]))
            q = ∪_(k ∈ S) {k} ∪ ⋃_(k ∈ S) {k} \cup \bigcup_(k ∈ S) {k}
               => define q = (⋃ (k ∈ S) (∪ {k} (⋃ (k ∈ S) (∪ {k} (⋃ (k ∈ S) {k})))))
            q = S ∪ W ∩ U + S \cup W \cap U
               => define q = (+ (∪ S (∩ W U)) (∪ S (∩ W U)))
            q = S - W + S \ W + S ∖ W
               => define q = (+ (+ (- S W) (solve S W)) (solve S W))
            q = u ⋅ v + u · v + u • v + u \cdot v
               => define q = (+ (+ (+ (. u v) (. u v)) (. u v)) (. u v))
            q = u × v + u \times v
               => define q = (+ (× u v) (× u v))
            q = (A ∘ B) + (A ⊗ B) + (A : B)
               => define q = (+ (+ (∘ A B) (⊗ A B)) (: A B))
            q = a / b + a ÷ b
               => define q = (+ (/ a b) (/ a b))
            q = a ± b +- c
               => define q = (± (± a b) c)
            q = a - b − c
               => define q = (- (- a b) c)
            q = a^b + a²
               => define q = (+ (^ a b) (^ a 2))
            q = Aᵀ + A^T + A^⊤
               => define q = (+ (+ (transpose A) (transpose A)) (transpose A))
            q = A⁻¹ + A^(-1) + A^-1 + A^( -1)
               => define q = (+ (+ (+ (inv A) (inv A)) (inv A)) (inv A))
            q = A⁺ + A^+
               => define q = (+ (pinv A) (pinv A))
            q = √a + sqrt(a) + \sqrt a
               => define q = (+ (+ (√ a) (call sqrt a)) (√ a))
            q = |a| + ||u|| + ‖u‖ + ∥u∥
               => define q = (+ (+ (+ |a| ‖u‖) ‖u‖) ‖u‖)
            q = <u,v> + ⟨u, v⟩
               => define q = (+ (inner u v) (inner u v))
            q = { 1 if a = b or a == b or a ≠ b or a != b; 2 if a < b or a <= b or a ≤ b or a ⩽ b; 3 if a > b or a >= b or a ≥ b or a ⩾ b
               => define q = {1 if (or (or (or (= a b) (= a b)) (≠ a b)) (≠ a b)); 2 if (or (or (or (< a b) (≤ a b)) (≤ a b)) (≤ a b)); 3 if (or (or (or (> a b) (≥ a b)) (≥ a b)) (≥ a b))
            g ∈ ℝ → ℝ NL j ∈ ℝ -> ℝ
               => parameter g ∈ (ℝ → ℝ)
                  parameter j ∈ (ℝ → ℝ)
            g ∈ ∅ → ℝ NL j ∈ {} → ℝ
               => parameter g ∈ ( → ℝ)
                  parameter j ∈ ( → ℝ)
            q = ∂a/∂x + ∇_x a + Δ a + 𝕕a/𝕕x
               => define q = (+ (+ (+ (∂1 a / x) (∇_x a)) (Δ a)) (𝕕1 a / x))
            q = ∫_[0,1] t 𝕕t + int_[0,1] t \dd t
               => define q = (+ (∫ t 0 1 t) (∫ t 0 1 t))
            q = 𝟙_3 + 1_3
               => define q = (+ (ones 3) (ones 3))
            q = { k for k ∈ S } + { k ∀ k ∈ S }
               => define q = (+ {k for k ∈ S} {k for k ∈ S})
            q = #x
               => define q = (# x)
            h(a, b; c) = a where a, b, c ∈ ℝ
               => function h(a, b, c)
                    = a
                    where a, b, c ∈ ℝ
            h(axb) = a where a ∈ ℝ
               => function h(axb)
                    = a
                    where a ∈ ℝ
            A_1,* + A_*,1
               => expression (+ A[1 *] A[* 1])
            a * b
               Error: expected the end of the item, found `*`
               = products are written side by side, as in `2 a`, or with `⋅`
        "#]],
    );
}
