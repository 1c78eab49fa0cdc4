//! Diagnostics as text, with the marked lines of the source, as rustc prints them.

use std::ops::Range;

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};

use crate::diagnostic::{Diagnostic, Diagnostics, Severity};
use crate::source::{Source, Sources};
use crate::span::{SourceId, Span};

/// One diagnostic: message, marked lines with labels, help. No colours, no line break at the end.
///
/// Line and column are those of the file that holds the text; columns count characters.
pub fn render(sources: &Sources, diagnostic: &Diagnostic) -> String {
    let level = match diagnostic.severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
        Severity::Note => Level::NOTE,
    };
    let mut order: Vec<SourceId> = Vec::new();
    for label in &diagnostic.labels {
        if !order.contains(&label.span.source) {
            order.push(label.span.source);
        }
    }
    let mut group = Group::with_title(level.primary_title(diagnostic.message.as_str()));
    for id in order {
        let source = sources.get(id);
        let padded = Padded::new(source);
        let mut snippet = Snippet::source(padded.text.clone())
            .line_start(padded.first_line as usize)
            .path(source.file.as_str());
        for (index, label) in diagnostic.labels.iter().enumerate() {
            if label.span.source != id {
                continue;
            }
            let kind = match index {
                0 => AnnotationKind::Primary,
                _ => AnnotationKind::Context,
            };
            let annotation = kind.span(padded.range(source, label.span));
            snippet = snippet.annotation(match label.text.is_empty() {
                true => annotation,
                false => annotation.label(label.text.as_str()),
            });
        }
        group = group.element(snippet);
    }
    if let Some(help) = &diagnostic.help {
        group = group.element(Level::HELP.message(help.as_str()));
    }
    Renderer::plain().render(&[group])
}

/// All diagnostics in order of their place, with an empty line between them.
pub fn render_all(sources: &Sources, diagnostics: &Diagnostics) -> String {
    let sorted = diagnostics.sorted();
    let list: Vec<String> = sorted.iter().map(|one| render(sources, one)).collect();
    list.join("\n\n")
}

/// A text whose pieces are moved to the lines and columns that they have in the file.
struct Padded {
    text: String,
    /// Line of the file on which `text` starts.
    first_line: u32,
    /// For each piece its first byte in the source and in the moved text.
    starts: Vec<(usize, usize)>,
    line: u32,
    column: u32,
}

impl Padded {
    fn new(source: &Source) -> Self {
        let (first_line, _) = source.line_column(0);
        let mut padded = Self {
            text: String::with_capacity(source.text.len()),
            first_line,
            starts: Vec::new(),
            line: first_line,
            column: 1,
        };
        let mut places = source.places.iter().peekable();
        let mut exact = false;
        let mut start = 0;
        for (index, text) in source.text.split_inclusive('\n').enumerate() {
            let end = start + text.len();
            let mut at = match exact {
                true => (padded.line + 1, 1),
                false => {
                    let indent = source.indents.get(index).copied().unwrap_or(0);
                    (source.first_line + index as u32, indent + 1)
                }
            };
            while let Some(place) = places.next_if(|place| (place.offset as usize) < end) {
                let offset = place.offset as usize;
                // an empty piece would begin a line of its own
                if source.text.is_char_boundary(offset) && offset > start {
                    padded.piece(start, &source.text[start..offset], at);
                    start = offset;
                }
                at = (place.line, place.column);
                exact = true;
            }
            padded.piece(start, &source.text[start..end], at);
            start = end;
        }
        padded.starts.push((start, padded.text.len()));
        padded
    }

    /// Adds a piece of one line at its line and column.
    fn piece(&mut self, start: usize, piece: &str, (line, column): (u32, u32)) {
        let piece = piece.trim_end_matches(['\n', '\r']);
        // A line far away belongs to a damaged list of places.
        while self.line < line.min(self.line + 10_000) {
            self.text.push('\n');
            self.line += 1;
            self.column = 1;
        }
        while self.column < column.min(self.column + 10_000) {
            self.text.push(' ');
            self.column += 1;
        }
        self.starts.push((start, self.text.len()));
        self.text.push_str(piece);
        self.column += piece.chars().count() as u32;
    }

    fn range(&self, source: &Source, span: Span) -> Range<usize> {
        let start = self.offset(source, span.start as usize);
        start..self.offset(source, span.end as usize).max(start)
    }

    /// The place of a byte of the source, moved to the beginning of its character.
    fn offset(&self, source: &Source, offset: usize) -> usize {
        let mut offset = offset.min(source.text.len());
        while !source.text.is_char_boundary(offset) {
            offset -= 1;
        }
        let after = self.starts.partition_point(|(start, _)| *start <= offset);
        let (from, to) = self.starts[after.saturating_sub(1)];
        let end = self
            .starts
            .get(after)
            .map_or(self.text.len(), |next| next.1);
        (to + (offset - from)).min(end)
    }
}
