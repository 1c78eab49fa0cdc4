//! How a token is spelled.

use super::super::letters::escape;
use super::super::spelling;
use super::super::token::{Kind, Token};
use super::Care;
use super::roles::Role;

/// A token with what its spelling depends on.
pub(super) struct Place<'a> {
    pub text: &'a str,
    pub tokens: &'a [Token],
    pub index: usize,
    pub role: Role,
    pub ascii: bool,
    pub care: Care,
}

/// The new spelling of one or several tokens.
pub(super) struct Spelled {
    pub text: String,
    pub kind: Kind,
    /// How many tokens it stands for.
    pub tokens: usize,
}

/// The spelling of the token at a place.
pub(super) fn spell(place: &Place) -> Spelled {
    let kind = place.kind(0);
    let joined = match place.care {
        Care::Lines => None,
        _ => place.of_several(),
    };
    if let Some((text, kind, tokens)) = joined {
        return Spelled { text, kind, tokens };
    }
    let source = place.source(0);
    let text = match place.care {
        Care::Lines => source.to_owned(),
        _ => match kind {
            Kind::Description => source.to_owned(),
            // one blank between the words
            Kind::SuchThat | Kind::Initial => {
                source.split_whitespace().collect::<Vec<_>>().join(" ")
            }
            Kind::Word(_) | Kind::Name(_) | Kind::Function(_) => name(source, place.ascii),
            _ if place.ascii => place.ascii_sign(),
            _ => place.unicode_sign(),
        },
    };
    Spelled {
        text,
        kind,
        tokens: 1,
    }
}

impl Place<'_> {
    fn token(&self, ahead: usize) -> Token {
        self.tokens[(self.index + ahead).min(self.tokens.len() - 1)]
    }

    fn kind(&self, ahead: usize) -> Kind {
        self.token(ahead).kind
    }

    fn source(&self, ahead: usize) -> &str {
        let token = self.token(ahead);
        &self.text[token.start as usize..token.end as usize]
    }

    fn before(&self) -> Option<Kind> {
        let before = self.index.checked_sub(1)?;
        (!self.token(0).space).then_some(self.tokens[before].kind)
    }

    /// Whether the tokens up to this one touch.
    fn tight(&self, count: usize) -> bool {
        (1..=count).all(|ahead| !self.token(ahead).space)
    }

    /// The spelling of several tokens that are one.
    fn of_several(&self) -> Option<(String, Kind, usize)> {
        let (kind, next) = (self.kind(0), self.kind(1));
        let (text, joined) = match (kind, self.role) {
            (Kind::Bar, Role::OpenBar | Role::CloseDoubleBar)
                if next == Kind::Bar && self.tight(1) =>
            {
                (self.double_bar(), Kind::DoubleBar)
            }
            (Kind::LeftBrace, _) if self.is_empty_set() => {
                (if self.ascii { "{}" } else { "∅" }, Kind::Empty)
            }
            (Kind::Caret, _) if self.ascii && next == Kind::Top && self.tight(1) => {
                ("^T", Kind::Transpose)
            }
            (Kind::Caret, Role::Transpose) if !self.ascii && self.tight(1) => {
                ("ᵀ", Kind::Transpose)
            }
            (Kind::Caret, _) if !self.ascii => return self.superscript(),
            _ => return None,
        };
        Some((text.to_owned(), joined, 2))
    }

    fn double_bar(&self) -> &'static str {
        match (self.ascii, self.care) {
            (false, _) => "‖",
            (true, Care::Rules | Care::Signs) => "||",
            (true, _) => "\\dbl",
        }
    }

    fn is_empty_set(&self) -> bool {
        let between = self.token(0).end as usize..self.token(1).start as usize;
        self.kind(1) == Kind::RightBrace && self.text[between].trim().is_empty()
    }

    /// `^2` and `^-2` as superscripts, where an exponent is nothing but this number.
    fn superscript(&self) -> Option<(String, Kind, usize)> {
        let order = matches!(
            self.before(),
            Some(Kind::Partial | Kind::Total | Kind::Reals | Kind::Integers)
        );
        if self.role != Role::Power && !order {
            return None;
        }
        let sign = (self.kind(1) == Kind::Minus) as usize;
        let Kind::Integer(number) = self.kind(1 + sign) else {
            return None;
        };
        if !self.tight(1 + sign) || order && sign > 0 {
            return None;
        }
        let number = if sign > 0 { -number } else { number };
        let text = spelling::superscript_number(number);
        Some((text, Kind::SuperscriptNumber(number), 2 + sign))
    }

    fn unicode_sign(&self) -> String {
        let source = self.source(0);
        match (self.kind(0), self.role) {
            (_, Role::OpenAngle) => "⟨",
            (_, Role::CloseAngle) => "⟩",
            (Kind::Reals, _) => "ℝ",
            (Kind::Integers, _) => "ℤ",
            (Kind::Sum, _) => "∑",
            (Kind::Product, _) => "∏",
            (Kind::Integral, _) => "∫",
            (Kind::Inverse, _) => "⁻¹",
            (Kind::PseudoInverse, _) => "⁺",
            (Kind::NotEqual, _) => "≠",
            (Kind::LessOrEqual, _) if source == "<=" => "≤",
            (Kind::GreaterOrEqual, _) if source == ">=" => "≥",
            (Kind::Arrow, _) => "→",
            (Kind::PlusMinus, _) => "±",
            _ => {
                let sign = escape(source).filter(|(length, _)| *length == source.len());
                return sign.map_or(source.to_owned(), |(_, sign)| sign.to_string());
            }
        }
        .to_owned()
    }

    fn ascii_sign(&self) -> String {
        let source = self.source(0);
        let careful = self.care >= Care::Brackets;
        let follows_line = self.tight(1) && self.kind(1) == Kind::Underscore;
        let text = match self.kind(0) {
            Kind::Reals => "RR",
            Kind::Integers => "ZZ",
            Kind::Sum if follows_line || self.tight(1) && self.kind(1) == Kind::LeftParen => "sum",
            Kind::Sum => "\\sum",
            Kind::Product if follows_line || self.tight(1) && self.kind(1) == Kind::LeftParen => {
                "prod"
            }
            Kind::Product => "\\prod",
            Kind::Integral if follows_line => "int",
            Kind::Integral => "\\int",
            Kind::Transpose => "^T",
            Kind::Inverse => "^-1",
            Kind::PseudoInverse => "^+",
            Kind::NotEqual => "!=",
            Kind::LessOrEqual => "<=",
            Kind::GreaterOrEqual => ">=",
            Kind::Arrow => "->",
            Kind::PlusMinus => "+-",
            Kind::Minus => "-",
            Kind::Slash => "/",
            Kind::Empty => "{}",
            Kind::For => "for",
            Kind::LeftBracket => "[",
            Kind::RightBracket => "]",
            Kind::DoubleBar => self.double_bar(),
            Kind::LeftAngle if careful => "\\langle",
            Kind::LeftAngle => "<",
            Kind::RightAngle if careful => "\\rangle",
            Kind::RightAngle => ">",
            Kind::Dot => "\\cdot",
            Kind::Subset => "\\subset",
            Kind::Union => "\\cup",
            Kind::Ones if follows_line || self.tight(1) && is_small(self.kind(1)) => "1",
            Kind::SuperscriptNumber(number) => return format!("^{number}"),
            Kind::SuperscriptLetter(_) => return self.small_letter("^", spelling::superscript),
            Kind::SubscriptLetter(_) => {
                return self.small_letter(self.subscript_prefix(), spelling::subscript);
            }
            Kind::SubscriptNumber(number) => return format!("{}{number}", self.subscript_prefix()),
            _ => return ascii_sign(source),
        };
        text.to_owned()
    }

    fn small_letter(&self, prefix: &str, plain: fn(char) -> Option<char>) -> String {
        let source = self.source(0);
        let plain = source.chars().next().and_then(plain);
        match plain.filter(char::is_ascii) {
            Some(plain) => format!("{prefix}{plain}"),
            None => source.to_owned(),
        }
    }

    /// `ᵢ` is `_i`, but `i` after a comma and `,i` after another subscript.
    fn subscript_prefix(&self) -> &'static str {
        match self.before() {
            Some(Kind::Comma) => "",
            Some(kind) if is_small(kind) => ",",
            _ => "_",
        }
    }
}

fn is_small(kind: Kind) -> bool {
    matches!(kind, Kind::SubscriptNumber(_) | Kind::SubscriptLetter(_))
}

/// The backslash name of a sign, where it has one; of several the one that the table prefers.
fn ascii_sign(source: &str) -> String {
    let sign = match escape(source) {
        Some((length, sign)) if length == source.len() => sign,
        _ => {
            let mut letters = source.chars();
            match (letters.next(), letters.next()) {
                (Some(sign), None) if !sign.is_ascii() => sign,
                _ => return source.to_owned(),
            }
        }
    };
    match spelling::fraction_name(sign) {
        Some(name) => name,
        None => spelling::name_of(sign).map_or(source.to_owned(), |name| format!("\\{name}")),
    }
}

/// A name; what stands in back-ticks stays.
fn name(source: &str, ascii: bool) -> String {
    if source.starts_with('`') || ascii && source.starts_with(['∂', '\\']) {
        return source.to_owned();
    }
    if ascii {
        let text = super::super::print::ascii_word(source);
        return match text.strip_suffix("⁻¹") {
            Some(root) => format!("{root}^-1"),
            None => text,
        };
    }
    let mut text = String::new();
    let mut rest = source;
    while let Some(first) = rest.chars().next() {
        let (length, sign) = match escape(rest) {
            Some((length, sign)) => (length, sign.to_string()),
            None => (first.len_utf8(), first.to_string()),
        };
        text += &sign;
        rest = &rest[length..];
    }
    for inverse in ["^-1", "^(-1)"] {
        if let Some(root) = text.strip_suffix(inverse) {
            return format!("{root}⁻¹");
        }
    }
    text
}
