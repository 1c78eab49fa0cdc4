//! From text to raw tokens: maximal runs of letters stay whole, and every line break is a token.

use std::collections::BTreeMap;

use unicode_normalization::UnicodeNormalization;

use super::ast::OptimiseKind;
use super::letters::{escape, inverse, is_blank, is_break, letter, quotation};
use super::spelling;
use super::token::{Kind, TextId, Token};
use crate::diagnostic::Diagnostic;
use crate::span::{SourceId, Span};

/// The texts of words and names, each once, in NFC.
#[derive(Default)]
pub(super) struct Texts {
    list: Vec<String>,
    ids: BTreeMap<String, TextId>,
}

impl Texts {
    pub fn add(&mut self, text: &str) -> TextId {
        if let Some(id) = self.ids.get(text) {
            return *id;
        }
        let id = self.list.len() as TextId;
        self.list.push(text.to_owned());
        self.ids.insert(text.to_owned(), id);
        id
    }

    pub fn get(&self, id: TextId) -> &str {
        &self.list[id as usize]
    }
}

/// What the lexer gives.
pub(super) struct Lexed {
    pub tokens: Vec<Token>,
    pub texts: Texts,
    pub errors: Vec<Diagnostic>,
}

/// Where in a line a description may begin: after the type of a declaration.
#[derive(Clone, Copy, PartialEq)]
enum Line {
    Targets,
    Type,
    /// After a comma behind a type: a further part of the type or a further declaration.
    Further,
    Other,
}

struct Lexer<'a> {
    text: &'a str,
    source: SourceId,
    at: usize,
    space: bool,
    line: Line,
    depth: u32,
    out: Lexed,
}

/// Splits a text into raw tokens; the last one is [`Kind::End`].
pub(super) fn lex(text: &str, source: SourceId) -> Lexed {
    let mut lexer = Lexer {
        text,
        source,
        at: 0,
        space: true,
        line: Line::Targets,
        depth: 0,
        out: Lexed {
            tokens: Vec::with_capacity(text.len() / 2),
            texts: Texts::default(),
            errors: Vec::new(),
        },
    };
    while lexer.at < text.len() {
        lexer.next();
    }
    lexer.push(Kind::End, 0);
    lexer.out
}

impl Lexer<'_> {
    fn rest(&self) -> &str {
        &self.text[self.at..]
    }

    fn span(&self, length: usize) -> Span {
        Span::new(self.source, self.at, self.at + length)
    }

    fn push(&mut self, kind: Kind, length: usize) {
        self.follow_line(kind);
        self.out.tokens.push(Token {
            kind,
            start: self.at as u32,
            end: (self.at + length) as u32,
            space: self.space,
        });
        self.at += length;
        self.space = false;
    }

    /// Keeps track of whether the line is a declaration, so that its description can be cut out.
    fn follow_line(&mut self, kind: Kind) {
        match kind {
            Kind::Newline | Kind::Semicolon | Kind::Where => {
                self.line = Line::Targets;
                self.depth = 0;
                return;
            }
            Kind::LeftParen | Kind::LeftBracket | Kind::LeftBrace => self.depth += 1,
            Kind::RightParen | Kind::RightBracket | Kind::RightBrace => {
                self.depth = self.depth.saturating_sub(1);
            }
            _ => {}
        }
        self.line = match (self.line, kind) {
            (Line::Targets | Line::Further, Kind::In | Kind::Colon | Kind::Subset) => Line::Type,
            (Line::Type, Kind::Comma) if self.depth == 0 => Line::Further,
            (
                line @ (Line::Targets | Line::Further),
                Kind::Word(_)
                | Kind::Quoted(_)
                | Kind::Comma
                | Kind::Underscore
                | Kind::SubscriptLetter(_)
                | Kind::SubscriptNumber(_)
                | Kind::Partial
                | Kind::SuperscriptNumber(_),
            ) => line,
            // the next parameter of a function type; nothing else begins with a type
            (Line::Targets, Kind::Reals | Kind::Integers) => Line::Type,
            (Line::Type | Line::Further, Kind::Assign | Kind::AddAssign) => Line::Other,
            (Line::Type | Line::Further, _) => Line::Type,
            _ => Line::Other,
        };
    }

    fn next(&mut self) {
        let Some(first) = self.rest().chars().next() else {
            return;
        };
        if is_break(first) {
            self.push(Kind::Newline, first.len_utf8());
            self.space = true;
        } else if is_blank(first) {
            self.at += first.len_utf8();
            self.space = true;
        } else if self.rest().starts_with("//") {
            self.at += self.rest().find(is_break).unwrap_or(self.rest().len());
            self.space = true;
        } else if first.is_ascii_digit() || first == '.' {
            self.number();
        } else if first == '`' {
            self.quoted();
        } else if letter(self.rest()).is_some() {
            self.word();
        } else {
            self.sign(first);
        }
    }

    fn digits(&self, from: usize) -> usize {
        let rest = &self.rest().as_bytes()[from..];
        rest.iter().take_while(|b| b.is_ascii_digit()).count()
    }

    fn number(&mut self) {
        let mut length = self.digits(0);
        let bytes = self.rest().as_bytes();
        let whole = length > 0;
        let mut real = false;
        if bytes.get(length) == Some(&b'.') {
            let after = self.digits(length + 1);
            if !whole && after == 0 {
                return self.push(Kind::Stray, 1);
            }
            length += 1 + after;
            real = true;
        }
        if bytes.get(length) == Some(&b'E') {
            let sign = matches!(bytes.get(length + 1), Some(b'+' | b'-')) as usize;
            let after = self.digits(length + 1 + sign);
            if after > 0 {
                length += 1 + sign + after;
                real = true;
            }
        }
        let text = &self.rest()[..length];
        let kind = if real {
            text.parse()
                .ok()
                .filter(|v: &f64| v.is_finite())
                .map(Kind::Real)
        } else {
            text.parse().ok().map(Kind::Integer)
        };
        if kind.is_none() {
            let message = "this number is too large";
            let error = Diagnostic::error(self.span(length), message);
            let help = "integers go up to 9223372036854775807, decimals up to about 1.8E308";
            self.out.errors.push(error.help(help));
        }
        self.push(kind.unwrap_or(Kind::Integer(0)), length);
    }

    fn quoted(&mut self) {
        let rest = &self.rest()[1..];
        let end = rest.find(|c| c == '`' || is_break(c)).unwrap_or(rest.len());
        let closed = rest[end..].starts_with('`');
        let name: String = rest[..end].nfc().collect();
        let length = end + 1 + closed as usize;
        let span = self.span(length);
        if !closed {
            let error = Diagnostic::error(span, "a name in back-ticks is not closed on its line");
            let help = "write a back-tick at the end of the name";
            self.out.errors.push(error.help(help));
        } else if name.trim().is_empty() {
            let error = Diagnostic::error(span, "a name in back-ticks is empty");
            let help = "write the name between the back-ticks";
            self.out.errors.push(error.help(help));
        } else if name.starts_with("__ihm") {
            let error = reserved(span, &name);
            self.out.errors.push(error);
        }
        let id = self.out.texts.add(&name);
        self.push(Kind::Quoted(id), length);
    }

    fn word(&mut self) {
        let mut name = String::new();
        let mut length = 0;
        loop {
            let digits = if length > 0 { self.digits(length) } else { 0 };
            if digits > 0 {
                name.push_str(&self.rest()[length..length + digits]);
                length += digits;
            } else if let Some((more, piece)) = letter(&self.rest()[length..]) {
                name.push_str(&piece);
                length += more;
            } else {
                break;
            }
        }
        let after = &self.rest()[length..];
        let next = after.bytes().next();
        if name == "s" && self.rest().starts_with("s.t.") {
            return self.push(Kind::SuchThat, 4);
        }
        for (first, second, kind) in [
            ("subject", "to", Kind::SuchThat),
            ("with", "initial", Kind::Initial),
        ] {
            let blanks = after.len() - after.trim_start_matches([' ', '\t']).len();
            let found = after[blanks..].strip_prefix(second);
            let found = found.is_some_and(|rest| letter(rest).is_none());
            if name == first && blanks > 0 && found {
                return self.push(kind, length + blanks + second.len());
            }
        }
        let kind = match name.as_str() {
            "where" | "given" => Kind::Where,
            "with" => Kind::With,
            "for" => Kind::For,
            "if" => Kind::If,
            "otherwise" => Kind::Otherwise,
            "and" => Kind::And,
            "or" => Kind::Or,
            "from" => Kind::From,
            "RR" => Kind::Reals,
            "ZZ" => Kind::Integers,
            "sum" if matches!(next, Some(b'_' | b'(')) => Kind::Sum,
            "prod" if matches!(next, Some(b'_' | b'(')) => Kind::Product,
            "int" if next == Some(b'_') => Kind::Integral,
            "min" if after.starts_with("_(") => Kind::Optimise(OptimiseKind::Min),
            "max" if after.starts_with("_(") => Kind::Optimise(OptimiseKind::Max),
            "argmin" if after.starts_with("_(") => Kind::Optimise(OptimiseKind::ArgMin),
            "argmax" if after.starts_with("_(") => Kind::Optimise(OptimiseKind::ArgMax),
            _ => Kind::Word(self.out.texts.add(&name)),
        };
        self.push(kind, length);
    }

    fn sign(&mut self, first: char) {
        if let Some((length, sign)) = escape(self.rest()) {
            let kind = self.plain_sign(sign);
            return self.push(kind, length);
        }
        let rest = self.rest();
        let pairs: [(&str, Kind); 6] = [
            ("==", Kind::EqualEqual),
            ("!=", Kind::NotEqual),
            ("<=", Kind::LessOrEqual),
            (">=", Kind::GreaterOrEqual),
            ("->", Kind::Arrow),
            ("+-", Kind::PlusMinus),
        ];
        if let Some((_, kind)) = pairs.iter().find(|(text, _)| rest.starts_with(text)) {
            return self.push(*kind, 2);
        }
        if let Some(length) = inverse(rest) {
            return self.push(Kind::Inverse, length);
        }
        if rest.starts_with("^+") && !self.space {
            return self.push(Kind::PseudoInverse, 2);
        }
        if rest.starts_with("+=") {
            return self.push(Kind::AddAssign, 2);
        }
        if first == ':' && self.line == Line::Type && self.depth == 0 {
            self.push(Kind::Colon, 1);
            return self.description();
        }
        if spelling::superscript(first).is_some() || first == '⁻' {
            return self.superscript();
        }
        if let Some(plain) = spelling::subscript(first) {
            return self.subscript(plain);
        }
        if let Some(length) = quotation(rest).filter(|_| !self.follows_operand()) {
            let message = "text in quotes means nothing in the language";
            let help = "values are numbers, sets and meshes; a description of a parameter follows a colon, as in `x ∈ ℝ: the width`";
            let error = Diagnostic::error(self.span(length), message);
            self.out.errors.push(error.help(help));
            return self.push(Kind::Unknown, length);
        }
        let kind = self.plain_sign(first);
        self.push(kind, first.len_utf8());
    }

    /// Whether a name or a bracket stands directly before, which a prime may follow.
    fn follows_operand(&self) -> bool {
        let before = self.text[..self.at].chars().next_back();
        before.is_some_and(|c| c.is_alphanumeric() || ")]}'`′".contains(c))
    }

    /// Free text up to the end of the line, a `;`, or a comment.
    fn description(&mut self) {
        let rest = self.rest();
        let mut end = rest.find(|c| c == ';' || is_break(c)).unwrap_or(rest.len());
        if let Some(comment) = rest[..end].find(" //") {
            end = comment;
        }
        let text = &rest[..end];
        let blanks = text.len() - text.trim_start().len();
        let length = text.trim().len();
        self.at += blanks;
        if length > 0 {
            self.push(Kind::Description, length);
        }
    }

    fn superscript(&mut self) {
        let rest = self.rest();
        let negative = rest.starts_with('⁻');
        let mut length = if negative { '⁻'.len_utf8() } else { 0 };
        let mut digits = String::new();
        for c in rest[length..].chars() {
            match spelling::superscript(c) {
                Some(digit) if digit.is_ascii_digit() => digits.push(digit),
                _ => break,
            }
            length += c.len_utf8();
        }
        if digits.is_empty() {
            let first = rest.chars().next().unwrap_or(' ');
            let kind = match spelling::superscript(first) {
                Some(plain) => Kind::SuperscriptLetter(self.out.texts.add(&plain.to_string())),
                None => Kind::Stray,
            };
            return self.push(kind, first.len_utf8());
        }
        let Ok(number) = digits.parse::<i64>() else {
            let error = Diagnostic::error(self.span(length), "this exponent is too large");
            self.out.errors.push(error.help("write a smaller exponent"));
            return self.push(Kind::SuperscriptNumber(1), length);
        };
        let kind = match (negative, number) {
            (true, 1) => Kind::Inverse,
            (true, _) => Kind::SuperscriptNumber(-number),
            (false, _) => Kind::SuperscriptNumber(number),
        };
        self.push(kind, length);
    }

    fn subscript(&mut self, plain: char) {
        let mut length = 0;
        let mut digits = String::new();
        for c in self.rest().chars() {
            match spelling::subscript(c) {
                Some(digit) if digit.is_ascii_digit() => digits.push(digit),
                _ => break,
            }
            length += c.len_utf8();
        }
        if digits.is_empty() {
            let length = self.rest().chars().next().map_or(0, char::len_utf8);
            let id = self.out.texts.add(&plain.to_string());
            return self.push(Kind::SubscriptLetter(id), length);
        }
        let number = digits.parse().ok();
        if number.is_none() {
            let error = Diagnostic::error(self.span(length), "this subscript is too large");
            self.out
                .errors
                .push(error.help("write a smaller subscript"));
        }
        self.push(Kind::SubscriptNumber(number.unwrap_or(0)), length);
    }

    fn plain_sign(&self, sign: char) -> Kind {
        if let Some(value) = spelling::fraction(sign) {
            return Kind::Real(value);
        }
        match sign {
            '∈' => Kind::In,
            '∉' => Kind::NotIn,
            '⊂' | '⊆' => Kind::Subset,
            ':' => Kind::Colon,
            ',' => Kind::Comma,
            ';' => Kind::Semicolon,
            '=' => Kind::Assign,
            '≠' => Kind::NotEqual,
            '<' => Kind::Less,
            '≤' | '⩽' => Kind::LessOrEqual,
            '>' => Kind::Greater,
            '≥' | '⩾' => Kind::GreaterOrEqual,
            '+' => Kind::Plus,
            '-' | '−' => Kind::Minus,
            '±' => Kind::PlusMinus,
            '/' | '÷' => Kind::Slash,
            '⋅' | '·' | '•' => Kind::Dot,
            '×' => Kind::Cross,
            '∘' => Kind::Hadamard,
            '⊗' => Kind::Kronecker,
            '\\' | '∖' => Kind::Backslash,
            '∩' => Kind::Intersection,
            '∪' | '⋃' => Kind::Union,
            '∑' => Kind::Sum,
            '∏' => Kind::Product,
            '∫' => Kind::Integral,
            '^' => Kind::Caret,
            '_' => Kind::Underscore,
            '*' => Kind::Star,
            '|' => Kind::Bar,
            '‖' | '∥' => Kind::DoubleBar,
            '⟨' => Kind::LeftAngle,
            '⟩' => Kind::RightAngle,
            '(' => Kind::LeftParen,
            ')' => Kind::RightParen,
            '[' | '⎡' => Kind::LeftBracket,
            ']' | '⎦' => Kind::RightBracket,
            '{' => Kind::LeftBrace,
            '}' => Kind::RightBrace,
            '#' => Kind::Hash,
            '√' => Kind::Root,
            '∂' => Kind::Partial,
            '∇' => Kind::Nabla,
            'Δ' => Kind::Laplace,
            '𝕕' => Kind::Total,
            'π' => Kind::Pi,
            '∞' => Kind::Infinity,
            '𝟙' => Kind::Ones,
            'ℝ' => Kind::Reals,
            'ℤ' => Kind::Integers,
            '→' => Kind::Arrow,
            '∅' => Kind::Empty,
            '∨' => Kind::Vee,
            '∀' => Kind::For,
            'ᵀ' => Kind::Transpose,
            '⊤' => Kind::Top,
            '⁺' => Kind::PseudoInverse,
            _ => Kind::Stray,
        }
    }
}

/// The error for a name that generated code keeps for itself.
pub(super) fn reserved(span: Span, name: &str) -> Diagnostic {
    Diagnostic::error(span, format!("the name `{name}` is reserved"))
        .help("choose a name that does not begin with `__ihm`")
}
