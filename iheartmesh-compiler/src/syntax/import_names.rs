//! Names in imports, where `_` and `⁻¹` are letters.

use std::ops::Range;

use super::lexer::Texts;
use super::names::partial_name;
use super::token::{Kind, Token};

/// The texts of an import.
pub(super) struct ImportHeader {
    /// Names and what they are renamed to; `None` for `*`.
    pub names: Option<Vec<(String, Option<String>)>>,
    pub module: String,
}

/// Reads an import without checking it.
pub(super) fn import_header(tokens: &[Token], texts: &Texts, range: Range<usize>) -> ImportHeader {
    if tokens[range.start].kind == Kind::From {
        return reversed_header(tokens, texts, range);
    }
    let mut names = Vec::new();
    let mut module = String::new();
    let mut all = false;
    let mut after = false;
    let mut renames = false;
    let mut index = range.start;
    while index < range.end {
        match tokens[index].kind {
            Kind::Star => all = true,
            Kind::From => after = true,
            Kind::LeftParen => break,
            _ => {}
        }
        let Some((name, next)) = import_name(tokens, texts, index) else {
            index += 1;
            continue;
        };
        index = next;
        if after {
            module = name;
            break;
        } else if name == "as" && !names.is_empty() {
            renames = true;
        } else if std::mem::take(&mut renames) {
            if let Some((_, rename)) = names.last_mut() {
                *rename = Some(name);
            }
        } else {
            names.push((name, None));
        }
    }
    ImportHeader {
        names: (!all).then_some(names),
        module,
    }
}

/// Reads `from module: names` or `from module import names`, which is refused: its names are known nevertheless.
fn reversed_header(tokens: &[Token], texts: &Texts, range: Range<usize>) -> ImportHeader {
    let mut found = Vec::new();
    let mut index = range.start + 1;
    while index < range.end {
        match import_name(tokens, texts, index) {
            Some((name, next)) => {
                if found.len() != 1 || name != "import" {
                    found.push(name);
                }
                index = next;
            }
            None => index += 1,
        }
    }
    let mut found = found.into_iter();
    ImportHeader {
        module: found.next().unwrap_or_default(),
        names: Some(found.map(|name| (name, None)).collect()),
    }
}

/// A name of an import, in which `_` and `⁻¹` count as letters, with the index after it.
pub(super) fn import_name(
    tokens: &[Token],
    texts: &Texts,
    start: usize,
) -> Option<(String, usize)> {
    let mut name = String::new();
    let mut index = start;
    while let Some(token) = tokens.get(index)
        && (index == start || !token.space)
    {
        match token.kind {
            Kind::Quoted(id) if index == start => {
                return Some((texts.get(id).to_owned(), index + 1));
            }
            Kind::Word(id) => name.push_str(texts.get(id)),
            Kind::Underscore => name.push('_'),
            Kind::Integer(number) if index > start => name.push_str(&number.to_string()),
            Kind::Inverse if index > start => name.push_str("⁻¹"),
            Kind::Partial => match tokens.get(index + 1).map(|token| token.kind) {
                Some(Kind::SuperscriptNumber(number)) if index == start => {
                    return Some((partial_name(number), index + 2));
                }
                _ => break,
            },
            _ => break,
        }
        index += 1;
    }
    (index > start).then_some((name, index))
}
