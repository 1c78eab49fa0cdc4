//! The second pass: runs of letters become names, longest declared word first, in the scope of their item.

use std::collections::BTreeMap;

use super::layout::lay_out;
use super::letters::letter;
use super::lexer::{Lexed, Texts, lex};
use super::names::{Collected, ItemNames, Names, collect, partial_name};
use super::token::{Kind, Token};
use super::{ImportedNames, builtin, suggest};
use crate::diagnostic::Diagnostic;
use crate::span::{SourceId, Span};

/// Longest declared word that is looked for inside a run of letters; a run that is a word as a whole may be longer.
const LONGEST_WORD: usize = 48;

/// What the parser works on.
pub(super) struct Prepared {
    pub tokens: Vec<Token>,
    pub texts: Texts,
    pub errors: Vec<Diagnostic>,
    /// The items, with the ranges of their final tokens.
    pub items: Vec<ItemNames>,
    /// Whether the module declares a name `T`.
    pub names_t: bool,
    /// Where the text could not be split into tokens.
    pub damaged: Vec<Span>,
    /// How many tokens were looked at to settle the line breaks.
    pub steps: usize,
}

struct Splitter<'a> {
    text: &'a str,
    source: SourceId,
    texts: Texts,
    module: &'a Names,
    longest: usize,
    underscores: bool,
    out: Vec<Token>,
    errors: Vec<Diagnostic>,
    /// Words that are not known: the number of their message and of their uses.
    unknown: BTreeMap<String, (usize, usize)>,
    /// How many integrals of the item have no variable yet.
    integrals: usize,
    /// First and last byte of the last unknown word that nothing is proposed for, and its message.
    puzzling: Option<(u32, u32, usize)>,
}

/// Text to tokens in which every name is settled.
pub(super) fn prepare(text: &str, source: SourceId, imports: &dyn ImportedNames) -> Prepared {
    let Lexed {
        tokens,
        texts,
        errors,
    } = lex(text, source);
    let damaged = errors.iter().map(Diagnostic::span).collect();
    let (raw, steps) = lay_out(tokens);
    let Collected { module, mut items } = collect(&raw, &texts, imports);
    let mut splitter = Splitter {
        text,
        source,
        texts,
        longest: longest(&module),
        underscores: module.keys().any(|name| name.contains('_')),
        module: &module,
        out: Vec::with_capacity(raw.len() + raw.len() / 2),
        errors,
        unknown: BTreeMap::new(),
        integrals: 0,
        puzzling: None,
    };
    let mut next = 0;
    for item in &mut items {
        splitter.out.extend(&raw[next..item.range.start]);
        let start = splitter.out.len();
        if item.import {
            splitter.out.extend(&raw[item.range.clone()]);
        } else {
            splitter.item(&raw, item);
        }
        next = item.range.end;
        item.range = start..splitter.out.len();
    }
    splitter.out.extend(&raw[next..]);
    for (message, uses) in splitter.unknown.values() {
        if *uses > 1 {
            splitter.errors[*message].labels[0].text = format!("the first of {uses} uses");
        }
    }
    Prepared {
        tokens: splitter.out,
        texts: splitter.texts,
        errors: splitter.errors,
        items,
        names_t: module.contains_key("T"),
        damaged,
        steps,
    }
}

/// Number of letters and digits of the longest word.
fn longest(names: &Names) -> usize {
    let lengths = names.keys().map(|name| name.chars().count());
    lengths.max().unwrap_or(0).min(LONGEST_WORD)
}

impl Splitter<'_> {
    /// Whether a name is visible, and whether it is a function.
    fn visible(&self, item: &Names, name: &str) -> Option<bool> {
        let found = item.get(name).or_else(|| self.module.get(name));
        found
            .copied()
            .or_else(|| builtin::ALWAYS.contains(&name).then_some(true))
    }

    fn push(&mut self, kind: Kind, start: u32, end: u32, space: bool) {
        self.out.push(Token {
            kind,
            start,
            end,
            space,
        });
    }

    fn push_name(&mut self, item: &Names, name: &str, token: Token) {
        let id = self.texts.add(name);
        let kind = match self.visible(item, name) {
            Some(true) => Kind::Function(id),
            _ => Kind::Name(id),
        };
        self.push(kind, token.start, token.end, token.space);
    }

    fn item(&mut self, raw: &[Token], item: &ItemNames) {
        let names = &item.names;
        let longest = self.longest.max(longest(names));
        let mut index = item.range.start;
        self.integrals = 0;
        while index < item.range.end {
            let token = raw[index];
            index += 1;
            match token.kind {
                Kind::Integral => self.integrals += 1,
                Kind::Total => self.integrals = self.integrals.saturating_sub(1),
                _ => {}
            }
            let following = raw[index];
            match token.kind {
                Kind::Word(id) => {
                    let word = self.texts.get(id).to_owned();
                    if self.underscores
                        && let Some((name, next)) = self.joined(names, raw, index - 1)
                    {
                        let end = raw[next - 1].end;
                        self.push_name(names, &name, Token { end, ..token });
                        index = next;
                    } else {
                        let called = following.kind == Kind::LeftParen && !following.space;
                        self.word(names, &word, token, longest, called);
                    }
                }
                Kind::Quoted(id) => {
                    let name = self.texts.get(id).to_owned();
                    self.push_name(names, &name, token);
                }
                Kind::Inverse if !token.space => self.inverse(names, token),
                Kind::Partial => {
                    let Kind::SuperscriptNumber(number) = following.kind else {
                        self.out.push(token);
                        continue;
                    };
                    let name = partial_name(number);
                    let declared = self.visible(names, &name).is_some();
                    if declared && !following.space && !is_derivative(raw, index + 1) {
                        let end = following.end;
                        self.push_name(names, &name, Token { end, ..token });
                        index += 1;
                    } else {
                        self.out.push(token);
                    }
                }
                _ => self.out.push(token),
            }
        }
    }

    /// `name⁻¹` is one name where it is declared, such as `vec⁻¹`.
    fn inverse(&mut self, names: &Names, token: Token) {
        if let Some(last) = self.out.last().copied()
            && let Kind::Name(id) | Kind::Function(id) | Kind::Word(id) = last.kind
        {
            let name = format!("{}⁻¹", self.texts.get(id));
            if self.visible(names, &name).is_some() {
                self.out.pop();
                let token = Token {
                    start: last.start,
                    space: last.space,
                    ..token
                };
                return self.push_name(names, &name, token);
            }
            if let Kind::Word(_) = last.kind {
                let word = self.texts.get(id).to_owned();
                self.out.pop();
                self.unknown(names, &word, last);
            }
        }
        self.out.push(token);
    }

    /// A name with underscores, which only imports can bring: a few words joined without blanks.
    fn joined(&self, item: &Names, raw: &[Token], start: usize) -> Option<(String, usize)> {
        let Kind::Word(first) = raw[start].kind else {
            return None;
        };
        let mut name = self.texts.get(first).to_owned();
        let mut found = None;
        let mut index = start + 1;
        while index < raw.len() && index < start + 8 && !raw[index].space {
            match raw[index].kind {
                Kind::Underscore => name.push('_'),
                Kind::Word(id) => name.push_str(self.texts.get(id)),
                Kind::Integer(number) => name.push_str(&number.to_string()),
                _ => break,
            }
            index += 1;
            if self.visible(item, &name).is_some() {
                found = Some((name.clone(), index));
            }
        }
        found
    }

    /// A run of letters; `called` says that a parenthesis follows.
    fn word(&mut self, item: &Names, word: &str, token: Token, longest: usize, called: bool) {
        let whole = self.visible(item, word).is_some() || builtin::TYPE_WORDS.contains(&word);
        let single = letter(word).is_some_and(|(length, _)| length == word.len());
        if whole || single {
            return self.push_name(item, word, token);
        }
        let pieces = self.pieces(token);
        let inverse = format!("{word}⁻¹");
        let mut split = Vec::new();
        let mut at = 0;
        let mut known = true;
        while at < pieces.len() {
            let count = self.longest_word(item, &pieces[at..], longest);
            let digit = pieces[at].0.starts_with(|c: char| c.is_ascii_digit());
            let name: String = pieces[at..at + count]
                .iter()
                .map(|p| p.0.as_str())
                .collect();
            known &= count > 1 || digit || name == "I" || self.visible(item, &name).is_some();
            split.push((name, digit, at, count));
            at += count;
        }
        let letters = pieces
            .iter()
            .filter(|p| !p.0.starts_with(|c: char| c.is_ascii_digit()));
        if !known && letters.count() > 1 {
            if self.visible(item, &inverse).is_some() {
                let id = self.texts.add(word);
                return self.push(Kind::Word(id), token.start, token.end, token.space);
            }
            return match self.integrals > 0 && pieces.len() == 2 && pieces[0].0 == "d" {
                true => self.plain_differential(item, &pieces[1].0, token),
                false => self.unknown(item, word, token),
            };
        }
        if called
            && let Some(import) = builtin::import_of(word)
            && self.errors.len() < super::MOST_ERRORS
        {
            let span = Span::new(self.source, token.start as usize, token.end as usize);
            let names: Vec<&str> = split.iter().map(|(name, ..)| name.as_str()).collect();
            let message = format!("`{word}` is read as the product `{}`", names.join(" "));
            let help = format!(
                "`{import}` imports the function; separate the letters where the product is meant"
            );
            self.errors
                .push(Diagnostic::warning(span, message).help(help));
        }
        for (name, digit, at, count) in split {
            let piece = Token {
                start: pieces[at].1,
                end: pieces[at + count - 1].2,
                space: token.space && at == 0,
                kind: token.kind,
            };
            match digit {
                true => self.number(&name, piece),
                false => self.push_name(item, &name, piece),
            }
        }
    }

    /// `∫_a^b … dt` is meant for `∫_a^b … 𝕕t`: refused, and then understood.
    fn plain_differential(&mut self, item: &Names, name: &str, token: Token) {
        self.integrals -= 1;
        if self.errors.len() < super::MOST_ERRORS {
            let span = Span::new(self.source, token.start as usize, token.end as usize);
            let message = "the variable of an integral follows `𝕕`, not `d`";
            let help = format!("write `𝕕{name}`, or `\\dd {name}` in ASCII");
            self.errors
                .push(Diagnostic::error(span, message).help(help));
        }
        let end = token.start + 1;
        self.push(Kind::Total, token.start, end, token.space);
        let variable = Token {
            start: end,
            space: false,
            ..token
        };
        self.push_name(item, name, variable);
    }

    /// The letters (with their marks) and the digit groups of a run, with their places.
    fn pieces(&self, token: Token) -> Vec<(String, u32, u32)> {
        let mut pieces = Vec::new();
        let mut at = token.start as usize;
        let end = token.end as usize;
        while at < end {
            let rest = &self.text[at..end];
            let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
            let (length, piece) = match letter(rest) {
                _ if digits > 0 => (digits, rest[..digits].to_owned()),
                Some(found) => found,
                None => break,
            };
            pieces.push((piece, at as u32, (at + length) as u32));
            at += length;
        }
        pieces
    }

    /// How many pieces the longest declared word at the start of `pieces` takes; at least one.
    fn longest_word(&self, item: &Names, pieces: &[(String, u32, u32)], longest: usize) -> usize {
        let mut name = String::new();
        let mut best = 1;
        let digit = pieces[0].0.starts_with(|c: char| c.is_ascii_digit());
        for (index, piece) in pieces.iter().enumerate().take(longest) {
            name.push_str(&piece.0);
            if index > 0 && !digit && self.visible(item, &name).is_some() {
                best = index + 1;
            }
        }
        best
    }

    fn number(&mut self, digits: &str, piece: Token) {
        let number = digits.parse().unwrap_or_else(|_| {
            let span = Span::new(self.source, piece.start as usize, piece.end as usize);
            let error = Diagnostic::error(span, "this number is too large");
            let help = "integers go up to 9223372036854775807";
            self.errors.push(error.help(help));
            0
        });
        self.push(Kind::Integer(number), piece.start, piece.end, piece.space);
    }

    fn unknown(&mut self, item: &Names, word: &str, token: Token) {
        let subscript = self.out.last().is_some_and(|t| t.kind == Kind::Underscore);
        self.push(Kind::Unknown, token.start, token.end, token.space);
        if let Some((start, end, message)) = self.puzzling
            && self.text.get(end as usize..token.start as usize) == Some("_")
        {
            let whole = &self.text[start as usize..token.end as usize];
            let error = &mut self.errors[message];
            error.message = format!("unknown name `{whole}`");
            error.labels[0].span.end = token.end;
            error.help = Some(format!(
                "declare it; a name with `_` in it stands in back-ticks, `` `{whole}` ``, since `_` begins a subscript"
            ));
            self.puzzling = Some((start, token.end, message));
            // one unknown word, with what would be its subscripts
            self.out.truncate(self.out.len() - 2);
            if let Some(last) = self.out.last_mut() {
                last.end = token.end;
            }
            return;
        }
        if let Some((_, uses)) = self.unknown.get_mut(word) {
            *uses += 1;
            return;
        }
        if self.errors.len() >= super::MOST_ERRORS {
            return;
        }
        self.unknown.insert(word.to_owned(), (self.errors.len(), 1));
        let span = Span::new(self.source, token.start as usize, token.end as usize);
        let names = item.keys().chain(self.module.keys()).map(String::as_str);
        let names = names.chain(builtin::ALWAYS.iter().copied());
        let help = match suggest::closest(word, names) {
            _ if builtin::import_of(word).is_some() => {
                let import = builtin::import_of(word).unwrap_or_default();
                format!("`{import}` imports it")
            }
            _ if word == "in" => "membership is written `∈` or `\\in`".into(),
            _ if word == "not" => {
                "there is no `not`; turn the relation round, as in `a ≤ b`".into()
            }
            _ if matches!(word, "argmin" | "argmax") => {
                format!("what it runs over stands in parentheses: `{word}_(x ∈ S) …`")
            }
            Some(name) => format!("did you mean `{name}`?"),
            None => {
                self.puzzling = Some((token.start, token.end, self.errors.len()));
                if subscript {
                    let message = format!("unknown subscript `{word}`");
                    let help = "letters are indices where each stands on the left side as well, as in `y_ij = …`, or below a sum, as in `∑_i ∑_j`";
                    self.errors
                        .push(Diagnostic::error(span, message).help(help));
                    return;
                }
                "declare it, or separate the letters to multiply them".into()
            }
        };
        let error = Diagnostic::error(span, format!("unknown name `{word}`"));
        self.errors.push(error.help(help));
    }
}

/// Whether `∂²` before the token `index` begins a derivative: what follows without a blank ends in `/∂`.
fn is_derivative(raw: &[Token], mut index: usize) -> bool {
    let limit = index + 64;
    let mut depth = 0i32;
    if raw[index].kind == Kind::Underscore {
        return false;
    }
    while index < raw.len().min(limit) {
        let token = raw[index];
        if depth == 0 && token.space {
            return false;
        }
        match token.kind {
            Kind::LeftParen => depth += 1,
            Kind::RightParen => depth -= 1,
            Kind::Slash if depth == 0 => return raw[index + 1].kind == Kind::Partial,
            Kind::Newline | Kind::End => return false,
            _ => {}
        }
        if depth < 0 {
            return false;
        }
        index += 1;
    }
    false
}
