//! The names of methods that are taken.

use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::span::Span;

/// The Rust names of methods, to find clashes.
pub(super) struct RustNames<'a> {
    known: BTreeMap<String, (String, Span)>,
    diagnostics: &'a mut Diagnostics,
}

impl<'a> RustNames<'a> {
    pub(super) fn new(diagnostics: &'a mut Diagnostics) -> Self {
        Self {
            known: BTreeMap::from(
                [
                    ("new", "the constructor"),
                    ("SOURCE", "the text of the program"),
                ]
                .map(|(name, what)| (name.to_owned(), (what.to_owned(), Span::default()))),
            ),
            diagnostics,
        }
    }

    /// Takes a name for something; a clash is reported.
    pub(super) fn take(&mut self, rust: &str, what: &str, span: Span) -> bool {
        if let Some((other, place)) = self.known.get(rust) {
            let message = format!("{what} and {other} have the same name in Rust, `{rust}`");
            let mut diagnostic = Diagnostic::error(span, message);
            if *place != Span::default() {
                diagnostic = diagnostic.label(*place, "the other one");
            }
            self.diagnostics
                .push(diagnostic.help("rename one of the two"));
            return false;
        }
        self.known.insert(rust.to_owned(), (what.to_owned(), span));
        true
    }

    /// What has a name.
    pub(super) fn known(&self, rust: &str) -> Option<&str> {
        self.known.get(rust).map(|(what, _)| what.as_str())
    }

    /// Takes an additional name, if it is free.
    pub(super) fn alias(&mut self, rust: &str, what: &str, span: Span) -> bool {
        if self.known.contains_key(rust) {
            return false;
        }
        self.known.insert(rust.to_owned(), (what.to_owned(), span));
        true
    }
}
