//! Names of the language as names of Rust: the rule of the public contract, in one place.

use proc_macro2::{Ident, Span};

/// A name of the language as a Rust name: letters, digits, `_` and combining marks stay; sub- and superscript digits
/// become digits, `ᵀ` becomes `T`, `*` `_star`, `'` `_prime`; anything else `_`; runs of `_` collapse and fall away at the
/// ends; a leading digit gets `_` in front.
pub fn rust_name(name: &str) -> String {
    let mut text = String::new();
    for c in name.chars() {
        match c {
            '⁰' => text.push('0'),
            '¹' => text.push('1'),
            '²' => text.push('2'),
            '³' => text.push('3'),
            '⁴'..='⁹' => text.push(digit(c, '⁰')),
            '₀'..='₉' => text.push(digit(c, '₀')),
            'ᵀ' => text.push('T'),
            '*' => text.push_str("_star"),
            '\'' | '′' => text.push_str("_prime"),
            c if c.is_alphanumeric() || is_combining(c) => text.push(c),
            _ => text.push('_'),
        }
    }
    let parts: Vec<&str> = text.split('_').filter(|p| !p.is_empty()).collect();
    let mut text = parts.join("_");
    if text.is_empty() || text.starts_with(|c: char| c.is_numeric()) {
        text.insert(0, '_');
    }
    text
}

fn digit(c: char, zero: char) -> char {
    char::from_digit(c as u32 - zero as u32, 10).unwrap_or('_')
}

fn is_combining(c: char) -> bool {
    ('\u{300}'..='\u{36f}').contains(&c)
        || ('\u{1ab0}'..='\u{1aff}').contains(&c)
        || ('\u{1dc0}'..='\u{1dff}').contains(&c)
        || ('\u{20d0}'..='\u{20ff}').contains(&c)
}

/// The ASCII name of a name with Greek letters: `theta` for `θ`. `None` when it has none, or has other letters outside of
/// ASCII.
pub fn ascii_alias(name: &str) -> Option<String> {
    let mut alias = String::new();
    let mut greek = false;
    for c in name.chars() {
        match greek_name(c) {
            Some(name) => {
                greek = true;
                alias.push_str(name);
            }
            None if c.is_ascii() => alias.push(c),
            None => return None,
        }
    }
    greek.then_some(alias)
}

fn greek_name(c: char) -> Option<&'static str> {
    const SMALL: [&str; 25] = [
        "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa",
        "lambda", "mu", "nu", "xi", "omicron", "pi", "rho", "sigma", "sigma", "tau", "upsilon",
        "phi", "chi", "psi", "omega",
    ];
    const CAPITAL: [&str; 25] = [
        "Alpha", "Beta", "Gamma", "Delta", "Epsilon", "Zeta", "Eta", "Theta", "Iota", "Kappa",
        "Lambda", "Mu", "Nu", "Xi", "Omicron", "Pi", "Rho", "Sigma", "Sigma", "Tau", "Upsilon",
        "Phi", "Chi", "Psi", "Omega",
    ];
    match c {
        'α'..='ω' => SMALL.get(c as usize - 'α' as usize).copied(),
        'Α'..='Ω' => CAPITAL.get(c as usize - 'Α' as usize).copied(),
        'ϕ' => Some("phi"),
        'ϵ' => Some("epsilon"),
        'ϑ' => Some("theta"),
        'ϱ' => Some("rho"),
        'ϖ' => Some("pi"),
        _ => None,
    }
}

/// The argument of a method for a parameter: what generated code calls its own values stays free. Greek letters are spelled
/// out, with `_` behind since there may be a parameter of that name: rustc warns where a crate has `γ` and `y`.
pub fn argument(name: &str) -> Ident {
    let name = rust_name(name);
    let variants = |c: char| greek_name(c).is_some() && (c == 'ς' || !('Α'..='ω').contains(&c));
    if let Some(alias) = ascii_alias(&name)
        && !name.contains(variants)
    {
        return ident(&format!("{alias}_"));
    }
    match name.as_str() {
        "s" | "t" | "rt" | "sizes" | "value" | "fault" => ident(&format!("{name}_")),
        _ => ident(&name),
    }
}

/// An identifier; keywords become raw identifiers.
pub fn ident(name: &str) -> Ident {
    match name {
        "self" | "Self" | "super" | "crate" | "_" => {
            Ident::new(&format!("{name}_"), Span::call_site())
        }
        _ if is_keyword(name) => Ident::new_raw(name, Span::call_site()),
        _ => Ident::new(name, Span::call_site()),
    }
}

fn is_keyword(name: &str) -> bool {
    const KEYWORDS: &[&str] = &[
        "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "do",
        "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in",
        "let", "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub", "ref",
        "return", "static", "struct", "trait", "true", "try", "type", "typeof", "unsafe",
        "unsized", "use", "virtual", "where", "while", "yield",
    ];
    KEYWORDS.contains(&name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_follow_the_contract() {
        for (name, expected) in [
            ("K", "K"),
            ("θ", "θ"),
            ("n̄", "n̄"),
            ("f₁", "f1"),
            ("B⁰ᵀ", "B0T"),
            ("∂⁰", "_0"),
            ("x*", "x_star"),
            ("x'", "x_prime"),
            ("x(θ, ϕ)", "x_θ_ϕ"),
            ("_a__b_", "a_b"),
            ("+", "_"),
        ] {
            assert_eq!(rust_name(name), expected, "{name}");
        }
    }

    #[test]
    fn greek_has_an_ascii_alias() {
        assert_eq!(ascii_alias("θ").as_deref(), Some("theta"));
        assert_eq!(ascii_alias("Δt").as_deref(), Some("Deltat"));
        assert_eq!(ascii_alias("ω").as_deref(), Some("omega"));
        assert_eq!(ascii_alias("Ω").as_deref(), Some("Omega"));
        assert_eq!(ascii_alias("K"), None);
        assert_eq!(ascii_alias("n̄θ"), None);
    }

    #[test]
    fn keywords_are_raw() {
        assert_eq!(ident("type").to_string(), "r#type");
        assert_eq!(ident("self").to_string(), "self_");
    }
}
