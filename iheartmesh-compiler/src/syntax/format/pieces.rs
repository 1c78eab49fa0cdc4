//! Tokens with their new spelling: most are one piece, `||`, `{}` and `^2` several tokens in one.

use super::super::lexer::lex;
use super::super::token::{Kind, Token};
use super::Care;
use super::gap::{Gap, is_separator};
use super::roles::Role;
use super::space::{closes, opens};
use super::spell::{Place, spell};
use crate::span::SourceId;

/// A part of the text that is written without a break.
#[derive(Debug)]
pub(super) struct Piece<'a> {
    pub text: String,
    /// The kind of its token; `²` for what becomes one.
    pub kind: Kind,
    pub role: Role,
    pub gap: Gap<'a>,
    /// What the line break or semicolon before it separates.
    pub separator: Option<Kind>,
    /// Whether it has to stand apart from the piece before it, which else it would run into.
    pub apart: bool,
    pub care: Care,
}

/// The pieces of a text; the last one is empty.
pub(super) fn pieces<'a>(
    text: &'a str,
    tokens: &[Token],
    roles: &[Role],
    ascii: bool,
    care: &dyn Fn(u32) -> Care,
) -> Vec<Piece<'a>> {
    let mut out: Vec<Piece> = Vec::with_capacity(tokens.len());
    let (mut start, mut end) = (0, 0);
    let mut separator = None;
    // the brackets that are open
    let mut open = Vec::new();
    let mut index = 0;
    while index < tokens.len() {
        let token = tokens[index];
        if is_separator(token.kind) {
            separator = Some(token.kind);
            index += 1;
            continue;
        }
        let place = Place {
            text,
            tokens,
            index,
            role: roles[index],
            ascii,
            care: care(token.start),
        };
        let mut spelled = spell(&place);
        let last = tokens[index + spelled.tokens - 1];
        let source = &text[token.start as usize..last.end as usize];
        let gap = Gap::of(&text[end..token.start as usize]);
        let touching = gap.is_tight().then(|| (&text[start..end], source));
        let before = out.last_mut().filter(|_| token.kind != Kind::End);
        let apart = before.is_some_and(|before| {
            let apart = is_apart(&before.text, &spelled.text, touching);
            let signs = place.care >= Care::Signs && open.last() == Some(&Role::Matrix);
            if apart
                && signs
                && let Some((left, right)) = touching
            {
                before.text = left.to_owned();
                spelled.text = right.to_owned();
                return false;
            }
            apart
        });
        start = token.start as usize;
        out.push(Piece {
            kind: spelled.kind,
            role: roles[index],
            text: spelled.text,
            gap,
            separator: separator.take(),
            apart,
            care: place.care,
        });
        if let Some(piece) = out.last() {
            if opens(piece) {
                open.push(piece.role);
            } else if closes(piece) {
                open.pop();
            }
        }
        end = last.end as usize;
        index += spelled.tokens;
    }
    out
}

/// Whether a blank has to stand between two spellings; `touching` are those in the text, if nothing stands between them.
fn is_apart(left: &str, right: &str, touching: Option<(&str, &str)>) -> bool {
    if left.starts_with("\\frac") && right.starts_with(|c: char| c.is_ascii_digit()) {
        return true;
    }
    // what touches in the text has its own boundary, or is split again
    let kept = touching.is_some_and(|(first, second)| {
        (left, right) == (first, second)
            || is_same_word(&format!("{first}{second}"), &format!("{left}{right}"))
    });
    !kept && joins(left, right)
}

/// Whether two texts are other tokens when nothing stands between them.
fn joins(left: &str, right: &str) -> bool {
    let tokens = lex(&format!("{left}{right}"), SourceId(0)).tokens;
    let boundary = |token: &Token| token.start as usize == left.len();
    !tokens.iter().any(boundary)
}

/// Whether two texts are one and the same word.
fn is_same_word(first: &str, second: &str) -> bool {
    let word = |text: &str| {
        let lexed = lex(text, SourceId(0));
        match lexed.tokens[..] {
            [
                Token {
                    kind: Kind::Word(id),
                    ..
                },
                _,
            ] => Some(lexed.texts.get(id).to_owned()),
            _ => None,
        }
    };
    word(first).is_some_and(|first| word(second) == Some(first))
}
