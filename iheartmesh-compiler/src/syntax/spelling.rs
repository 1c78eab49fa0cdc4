//! The one table of ASCII spellings: what the lexer accepts for a sign, and what the printer writes for it.
//!
//! A backslash followed by a name of this table is that sign; the name is the longest run of ASCII letters, and it
//! must be in the table as a whole. Any other backslash is the operator `\`, so solving for an unknown with such a
//! name needs a blank: `A \ theta`. The one-letter abbreviations of editors (`\x`, `\d`, `\T`, `\R`, `\Z`) are
//! left out on purpose: `A\x` has to stay a solve.
//!
//! | sign | ASCII | sign | ASCII | sign | ASCII |
//! | --- | --- | --- | --- | --- | --- |
//! | `ℝ` `ℤ` | `RR` `ZZ` | `∈` `∉` `⊂` | `\in` `\notin` `\subset` | `∑` `∏` `∫` | `sum` `prod` `int`, `\sum` `\prod` `\int` |
//! | `∪` `∩` | `\cup` `\cap` | `⋅` `×` | `\cdot` `\times` | `∘` `⊗` | `\circ` `\otimes` |
//! | `÷` | `/` | `±` | `+-` | `√` | `\sqrt` |
//! | `‖…‖` | `\|\|…\|\|` | `⟨a, b⟩` | `<a, b>` | `≠` `≤` `≥` | `!=` `<=` `>=` |
//! | `→` | `->` | `∅` | `{}` | `∂` `∇` `Δ` `𝕕` | `\partial` `\nabla` `\Delta` `\dd` |
//! | `π` `∞` | `\pi` `\infty` | `𝟙` | `1` | `∀` | `for` |
//! | `½` `⅒` … | `\frac12` `\frac110` … | | | | |
//! | `ᵀ` `⁻¹` `⁺` `²` | `^T` `^-1` `^+` `^2` | `xᵢ` | `x_i` | `θ` `Φ` … | `\theta` `\Phi` … |

/// Signs with a backslash name; the first name of a sign is the one that the printer writes.
const SIGNS: &[(&str, char)] = &[
    ("in", '∈'),
    ("notin", '∉'),
    ("subset", '⊂'),
    ("subseteq", '⊂'),
    ("sum", '∑'),
    ("prod", '∏'),
    ("int", '∫'),
    ("cup", '∪'),
    ("bigcup", '∪'),
    ("cap", '∩'),
    ("setminus", '∖'),
    ("cdot", '⋅'),
    ("dot", '⋅'),
    ("times", '×'),
    ("circ", '∘'),
    ("had", '∘'),
    ("otimes", '⊗'),
    ("kro", '⊗'),
    ("div", '÷'),
    ("pm", '±'),
    ("sqrt", '√'),
    ("dbl", '‖'),
    ("langle", '⟨'),
    ("linner", '⟨'),
    ("rangle", '⟩'),
    ("rinner", '⟩'),
    ("neq", '≠'),
    ("ne", '≠'),
    ("leq", '≤'),
    ("le", '≤'),
    ("geq", '≥'),
    ("ge", '≥'),
    ("to", '→'),
    ("arr", '→'),
    ("emptyset", '∅'),
    ("emp", '∅'),
    ("vee", '∨'),
    ("partial", '∂'),
    ("par", '∂'),
    ("nabla", '∇'),
    ("Delta", 'Δ'),
    ("dd", '𝕕'),
    ("pi", 'π'),
    ("infty", '∞'),
    ("forall", '∀'),
    ("ones", '𝟙'),
    ("RR", 'ℝ'),
    ("ZZ", 'ℤ'),
    ("half", '½'),
    ("ell", 'ℓ'),
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ϵ'),
    ("varepsilon", 'ε'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("vartheta", 'ϑ'),
    ("iota", 'ι'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("omicron", 'ο'),
    ("rho", 'ρ'),
    ("varrho", 'ϱ'),
    ("sigma", 'σ'),
    ("varsigma", 'ς'),
    ("tau", 'τ'),
    ("upsilon", 'υ'),
    ("phi", 'ϕ'),
    ("varphi", 'φ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("Gamma", 'Γ'),
    ("Theta", 'Θ'),
    ("Lambda", 'Λ'),
    ("Xi", 'Ξ'),
    ("Pi", 'Π'),
    ("Sigma", 'Σ'),
    ("Upsilon", 'Υ'),
    ("Phi", 'Φ'),
    ("Psi", 'Ψ'),
    ("Omega", 'Ω'),
];

/// The vulgar fractions with numerator and denominator.
const FRACTIONS: &[(char, f64, f64)] = &[
    ('½', 1.0, 2.0),
    ('⅓', 1.0, 3.0),
    ('⅔', 2.0, 3.0),
    ('¼', 1.0, 4.0),
    ('¾', 3.0, 4.0),
    ('⅕', 1.0, 5.0),
    ('⅖', 2.0, 5.0),
    ('⅗', 3.0, 5.0),
    ('⅘', 4.0, 5.0),
    ('⅙', 1.0, 6.0),
    ('⅚', 5.0, 6.0),
    ('⅐', 1.0, 7.0),
    ('⅛', 1.0, 8.0),
    ('⅜', 3.0, 8.0),
    ('⅝', 5.0, 8.0),
    ('⅞', 7.0, 8.0),
    ('⅑', 1.0, 9.0),
    ('⅒', 1.0, 10.0),
];

/// Characters that are also written as a subscript.
const SUBSCRIPTS: &[(char, char)] = &[
    ('₀', '0'),
    ('₁', '1'),
    ('₂', '2'),
    ('₃', '3'),
    ('₄', '4'),
    ('₅', '5'),
    ('₆', '6'),
    ('₇', '7'),
    ('₈', '8'),
    ('₉', '9'),
    ('ₐ', 'a'),
    ('ₑ', 'e'),
    ('ₒ', 'o'),
    ('ₓ', 'x'),
    ('ₔ', 'ə'),
    ('ₕ', 'h'),
    ('ₖ', 'k'),
    ('ₗ', 'l'),
    ('ₘ', 'm'),
    ('ₙ', 'n'),
    ('ₚ', 'p'),
    ('ₛ', 's'),
    ('ₜ', 't'),
    ('ᵢ', 'i'),
    ('ⱼ', 'j'),
];

/// Characters that are also written as a superscript.
const SUPERSCRIPTS: &[(char, char)] = &[
    ('⁰', '0'),
    ('¹', '1'),
    ('²', '2'),
    ('³', '3'),
    ('⁴', '4'),
    ('⁵', '5'),
    ('⁶', '6'),
    ('⁷', '7'),
    ('⁸', '8'),
    ('⁹', '9'),
    ('ᵃ', 'a'),
    ('ᵇ', 'b'),
    ('ᶜ', 'c'),
    ('ᵈ', 'd'),
    ('ᵉ', 'e'),
    ('ᶠ', 'f'),
    ('ᵍ', 'g'),
    ('ʰ', 'h'),
    ('ⁱ', 'i'),
    ('ʲ', 'j'),
    ('ᵏ', 'k'),
    ('ˡ', 'l'),
    ('ᵐ', 'm'),
    ('ⁿ', 'n'),
    ('ᵒ', 'o'),
    ('ᵖ', 'p'),
    ('ʳ', 'r'),
    ('ˢ', 's'),
    ('ᵗ', 't'),
    ('ᵘ', 'u'),
    ('ᵛ', 'v'),
    ('ʷ', 'w'),
    ('ˣ', 'x'),
    ('ʸ', 'y'),
    ('ᶻ', 'z'),
    ('ᴬ', 'A'),
    ('ᴮ', 'B'),
    ('ᴰ', 'D'),
    ('ᴱ', 'E'),
    ('ᴳ', 'G'),
    ('ᴴ', 'H'),
    ('ᴵ', 'I'),
    ('ᴶ', 'J'),
    ('ᴷ', 'K'),
    ('ᴸ', 'L'),
    ('ᴹ', 'M'),
    ('ᴺ', 'N'),
    ('ᴼ', 'O'),
    ('ᴾ', 'P'),
    ('ᴿ', 'R'),
    ('ᵁ', 'U'),
    ('ⱽ', 'V'),
    ('ᵂ', 'W'),
];

/// The sign with this backslash name.
pub fn sign(name: &str) -> Option<char> {
    SIGNS.iter().find(|(n, _)| *n == name).map(|(_, c)| *c)
}

/// The backslash name of a sign, without the backslash.
pub fn name_of(sign: char) -> Option<&'static str> {
    SIGNS.iter().find(|(_, c)| *c == sign).map(|(n, _)| *n)
}

/// The value of a vulgar fraction.
pub fn fraction(sign: char) -> Option<f64> {
    let found = FRACTIONS.iter().find(|(c, _, _)| *c == sign);
    found.map(|(_, above, below)| above / below)
}

/// The ASCII name of a vulgar fraction with its backslash, such as `\frac13`.
pub fn fraction_name(sign: char) -> Option<String> {
    let found = FRACTIONS.iter().find(|(c, _, _)| *c == sign);
    found.map(|(_, above, below)| format!("\\frac{above}{below}"))
}

/// The vulgar fraction that a text begins with, and its length in ASCII: `frac13` is `⅓`.
pub fn fraction_named(text: &str) -> Option<(usize, char)> {
    let digits = text.strip_prefix("frac")?;
    let names = FRACTIONS
        .iter()
        .map(|(sign, a, b)| (format!("{a}{b}"), *sign));
    // `frac110` is a tenth
    let found = names.filter(|(name, _)| digits.starts_with(name.as_str()));
    let longest = found.max_by_key(|(name, _)| name.len())?;
    Some((4 + longest.0.len(), longest.1))
}

/// The vulgar fraction with exactly this value.
pub fn fraction_of(value: f64) -> Option<char> {
    let found = FRACTIONS.iter().find(|(_, a, b)| a / b == value);
    found.map(|(c, _, _)| *c)
}

/// The sign that a letter or another sign looks like, and how it is written in ASCII.
pub fn look_alike(text: &str) -> Option<(&'static str, &'static str)> {
    Some(match text {
        "Σ" => ("∑", "sum"),
        "Π" => ("∏", "prod"),
        "ϵ" | "ε" | "є" | "∊" => ("∈", "\\in"),
        "∆" => ("Δ", "\\Delta"),
        "∗" | "∙" => ("⋅", "\\cdot"),
        "✕" | "⨯" => ("×", "\\times"),
        "∕" | "⁄" => ("÷", "/"),
        "–" | "—" | "‐" => ("−", "-"),
        "∣" => ("|", "|"),
        "≔" => ("=", "="),
        _ => return None,
    })
}

/// What to write for something that looks like a sign.
pub fn look_alike_help(text: &str) -> Option<String> {
    let (sign, ascii) = look_alike(text)?;
    Some(match sign == ascii {
        true => format!("`{text}` only looks like `{sign}`: write that"),
        false => format!("`{text}` only looks like `{sign}`: write that, or `{ascii}`"),
    })
}

/// The plain character that a subscript character stands for.
pub fn subscript(sign: char) -> Option<char> {
    SUBSCRIPTS.iter().find(|(s, _)| *s == sign).map(|(_, c)| *c)
}

/// The plain character that a superscript character stands for; not `ᵀ`, `⁺`, `⁻`.
pub fn superscript(sign: char) -> Option<char> {
    let found = SUPERSCRIPTS.iter().find(|(s, _)| *s == sign);
    found.map(|(_, c)| *c)
}

/// A number written in superscript digits.
pub fn superscript_number(number: i64) -> String {
    let mut text = String::new();
    for digit in number.to_string().chars() {
        let found = SUPERSCRIPTS.iter().find(|(_, c)| *c == digit);
        text.push(found.map_or('⁻', |(s, _)| *s));
    }
    text
}
