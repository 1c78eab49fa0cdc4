//! What stands between two tokens: blanks, line breaks, semicolons and comments.

use super::super::letters::{is_blank, is_break};
use super::super::token::Kind;
use super::super::{ImportedNames, split};
use crate::span::SourceId;

/// A comment, without blanks at its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Comment<'a> {
    pub text: &'a str,
    /// Whether nothing stands before it on its line.
    pub own_line: bool,
    /// Whether an empty line stands before it.
    pub after_empty_line: bool,
}

/// What stands between two tokens.
#[derive(Debug, Default)]
pub(super) struct Gap<'a> {
    /// Number of blanks, if there is nothing else.
    pub blanks: usize,
    pub semicolon: bool,
    pub comments: Vec<Comment<'a>>,
    /// Whether the second token begins a line.
    pub breaks: bool,
    /// Whether an empty line stands before the second token.
    pub empty_line: bool,
}

impl<'a> Gap<'a> {
    /// Takes apart the text between two tokens.
    pub fn of(text: &'a str) -> Self {
        let mut gap = Gap::default();
        let mut breaks = 0;
        let mut at = 0;
        while let Some(c) = text[at..].chars().next() {
            if text[at..].starts_with("//") {
                let length = text[at..].find(is_break).unwrap_or(text.len() - at);
                gap.comments.push(Comment {
                    text: text[at..at + length].trim_end(),
                    own_line: breaks > 0,
                    after_empty_line: breaks > 1,
                });
                gap.breaks = true;
                breaks = 0;
                at += length;
                continue;
            }
            at += c.len_utf8();
            if is_break(c) {
                // a carriage return before a line feed is no line of its own
                breaks += !(c == '\r' && text[at..].starts_with('\n')) as usize;
                gap.breaks = true;
            } else if c == ';' {
                gap.semicolon = true;
            } else {
                gap.blanks += is_blank(c) as usize;
            }
        }
        gap.empty_line = breaks > 1;
        gap
    }

    /// Whether the two tokens touch.
    pub fn is_tight(&self) -> bool {
        self.blanks == 0 && !self.breaks && !self.semicolon
    }
}

/// Whether a token is only a separator, and with that part of a gap.
pub(super) fn is_separator(kind: Kind) -> bool {
    matches!(
        kind,
        Kind::Newline | Kind::Semicolon | Kind::Row | Kind::Branch
    )
}

/// The texts of all comments.
pub(super) fn comments(text: &str, id: SourceId, imports: &dyn ImportedNames) -> Vec<String> {
    let mut found = Vec::new();
    let mut end = 0;
    for token in split::prepare(text, id, imports).tokens {
        if !is_separator(token.kind) {
            let gap = Gap::of(&text[end..token.start as usize]);
            found.extend(gap.comments.iter().map(|comment| comment.text.to_owned()));
            end = token.end as usize;
        }
    }
    found
}
