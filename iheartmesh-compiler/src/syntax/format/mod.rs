//! The formatter: spelling, spacing and indentation in one way; the author's lines and comments stay.
//!
//! It rewrites tokens rather than printing the tree, so that whatever is no part of a tree is kept: comments, redundant parentheses,
//! `vector(3)` beside `ℝ³`, the lines of a matrix. What it writes is read again, and must be the same tree with the same
//! comments; an item for which that fails is written again with more of its own text, and the last resort is to refuse.

mod gap;
mod pieces;
mod roles;
mod space;
mod spell;
mod write;

use super::ast::Module;
use super::print::Spelling;
use super::strip::strip_spans;
use super::{ImportedNames, parser};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::source::Source;
use crate::span::{SourceId, Span};

/// How much of an item is changed; each keeps more than the one before.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Care {
    /// Spelling, and blanks by rule.
    Rules,
    /// A sign stays where its other spelling would need a blank; in a matrix that would separate cells.
    Signs,
    /// Bars and angles have spellings that mean the same everywhere.
    Brackets,
    /// Blanks stay where they are.
    Blanks,
    /// Lines and their indentation only.
    Lines,
}

impl Care {
    fn more(self) -> Option<Care> {
        match self {
            Care::Rules => Some(Care::Signs),
            Care::Signs => Some(Care::Brackets),
            Care::Brackets => Some(Care::Blanks),
            Care::Blanks => Some(Care::Lines),
            Care::Lines => None,
        }
    }
}

/// Most passes until nothing changes any more: a new spelling may make a further rule apply.
const MOST_PASSES: usize = 4;

/// The canonical text of a module, in one of the spellings; the same names, tree and comments.
///
/// # Errors
/// The diagnostics of a text with mistakes.
pub fn format(
    source: &Source,
    id: SourceId,
    imports: &dyn ImportedNames,
    spelling: Spelling,
) -> Result<String, Diagnostics> {
    let mut text = pass(&source.text, id, imports, spelling)?;
    for _ in 1..MOST_PASSES {
        let next = pass(&text, id, imports, spelling)?;
        if next == text {
            break;
        }
        text = next;
    }
    Ok(text)
}

fn pass(
    text: &str,
    id: SourceId,
    imports: &dyn ImportedNames,
    spelling: Spelling,
) -> Result<String, Diagnostics> {
    let (mut module, diagnostics, _) = parser::parse(text, id, imports);
    if diagnostics.has_errors() {
        return Err(diagnostics);
    }
    let spans: Vec<Span> = module.items.iter().map(|item| item.span).collect();
    let mut cares = vec![Care::Rules; spans.len()];
    let prepared = super::split::prepare(text, id, imports);
    let roles = roles::roles(&mut module, &prepared.tokens);
    loop {
        let care = |start: u32| {
            let item = spans.partition_point(|span| span.end <= start);
            cares.get(item).copied().unwrap_or(Care::Rules)
        };
        let ascii = spelling == Spelling::Ascii;
        let pieces = pieces::pieces(text, &prepared.tokens, &roles, ascii, &care);
        let written = write::write(&pieces);
        let different = differences(&module, &written, id, imports);
        let same_comments =
            || gap::comments(text, id, imports) == gap::comments(&written, id, imports);
        if different.is_empty() && same_comments() {
            return Ok(written);
        }
        let mut changed = false;
        for (index, care) in cares.iter_mut().enumerate() {
            let wrong = different.is_empty() || different.contains(&index);
            if let Some(more) = care.more().filter(|_| wrong) {
                *care = more;
                changed = true;
            }
        }
        if !changed {
            let index = different.first().copied().unwrap_or(0);
            let span = spans.get(index).copied().unwrap_or_default();
            let mut refused = Diagnostics::default();
            let message = "bug in iheartmesh: formatting this item would change its meaning";
            refused.push(
                Diagnostic::error(span, message)
                    .help("the text is left as it is; please report it"),
            );
            return Err(refused);
        }
    }
}

/// The items that a text has changed; all of them where it is not clear which.
fn differences(
    module: &Module,
    text: &str,
    id: SourceId,
    imports: &dyn ImportedNames,
) -> Vec<usize> {
    let (mut again, diagnostics, _) = parser::parse(text, id, imports);
    strip_spans(&mut again);
    if diagnostics.has_errors() || again.items.len() != module.items.len() {
        return (0..module.items.len().max(1)).collect();
    }
    let pairs = module.items.iter().zip(&again.items).enumerate();
    pairs
        .filter(|(_, (before, after))| before != after)
        .map(|(index, _)| index)
        .collect()
}
