//! The texts of a compilation, and how a byte of a text is shown as `file:line:column`.

use crate::span::{SourceId, Span};

/// One source text together with the place of each of its lines in the file that holds it.
///
/// A text may stand in a `.hlang` file of its own, or inside a string literal of a Rust file, where its
/// first line starts in the middle of a line, or in doc comment lines, where every line is indented.
#[derive(Clone, Debug)]
pub struct Source {
    /// Name of the file, as shown in diagnostics.
    pub file: String,
    /// The text itself.
    pub text: String,
    /// Line of the file (from 1) on which the text starts.
    pub first_line: u32,
    /// For each line of the text, how many characters of the file's line stand before it. Lines past the end
    /// of the list start at column 1.
    pub indents: Vec<u32>,
    /// Exact places, for a text whose lines are not consecutive lines of the file: a string literal with escapes,
    /// or a body of one literal for each line. In order of their offsets; empty where `first_line` and `indents`
    /// say everything.
    pub places: Vec<Place>,
}

/// From the byte `offset` of a text on, it stands at this line and column of the file (both from 1, in characters),
/// until the next place; a line break in between goes to column 1 of the next line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Byte of the text.
    pub offset: u32,
    /// Line of the file.
    pub line: u32,
    /// Column in that line.
    pub column: u32,
}

impl Source {
    /// A text that is a whole file.
    pub fn file(file: impl Into<String>, text: impl Into<String>) -> Self {
        Self {
            file: file.into(),
            text: text.into(),
            first_line: 1,
            indents: Vec::new(),
            places: Vec::new(),
        }
    }

    /// Line and column, both from 1 and in characters, of a byte of the text in the file.
    pub fn line_column(&self, offset: u32) -> (u32, u32) {
        let mut offset = (offset as usize).min(self.text.len());
        while !self.text.is_char_boundary(offset) {
            offset -= 1;
        }
        let next = self.places.partition_point(|p| p.offset as usize <= offset);
        if let Some(place) = next.checked_sub(1).map(|k| self.places[k]) {
            let since = &self.text[(place.offset as usize).min(offset)..offset];
            let column = since.rsplit('\n').next().unwrap_or("").chars().count() as u32;
            return match since.matches('\n').count() as u32 {
                0 => (place.line, place.column + column),
                lines => (place.line + lines, column + 1),
            };
        }
        let before = &self.text[..offset];
        let line = before.matches('\n').count();
        let start = before.rfind('\n').map_or(0, |k| k + 1);
        let column = before[start..].chars().count() as u32;
        let indent = self.indents.get(line).copied().unwrap_or(0);
        (self.first_line + line as u32, indent + column + 1)
    }
}

/// All texts of a compilation.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    list: Vec<Source>,
}

impl Sources {
    /// Adds a text and gives its id.
    pub fn add(&mut self, source: Source) -> SourceId {
        self.list.push(source);
        SourceId(self.list.len() as u32 - 1)
    }

    /// The text with this id.
    ///
    /// # Panics
    /// When the id is of another collection and out of range.
    pub fn get(&self, id: SourceId) -> &Source {
        &self.list[id.0 as usize]
    }

    /// The piece of text that a span covers.
    pub fn text(&self, span: Span) -> &str {
        self.list
            .get(span.source.0 as usize)
            .and_then(|s| s.text.get(span.start as usize..span.end as usize))
            .unwrap_or("")
    }
}
