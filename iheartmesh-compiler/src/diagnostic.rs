//! What the compiler has to say to its user: several labelled places, one message, one help line.

use std::panic::Location;

use crate::span::Span;

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// The program has no meaning; no code is generated.
    Error,
    /// Probably a mistake; code is generated.
    Warning,
    /// Something worth knowing, such as an optimisation that could not be made.
    Note,
}

/// A marked place in a source with what is to be said about it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// The place.
    pub span: Span,
    /// Short text shown at the place; may be empty.
    pub text: String,
}

/// One message: lower case, no full stop, the user's symbols in backticks.
#[derive(Clone, Debug)]
pub struct Diagnostic {
    /// How bad it is.
    pub severity: Severity,
    /// The message.
    pub message: String,
    /// Marked places; the first one is where the message points to.
    pub labels: Vec<Label>,
    /// What to do about it.
    pub help: Option<String>,
    /// Where in the compiler it was made: for those who work on it, and for the test that each message is tested.
    pub raised: &'static Location<'static>,
}

impl PartialEq for Diagnostic {
    /// Whether they say the same, wherever they were made.
    fn eq(&self, other: &Self) -> bool {
        let said = |d: &Self| (d.severity, d.message.clone(), d.help.clone());
        self.labels == other.labels && said(self) == said(other)
    }
}

impl Eq for Diagnostic {}

impl Diagnostic {
    /// An error at `span`.
    #[track_caller]
    pub fn error(span: Span, message: impl Into<String>) -> Self {
        Self::new(Severity::Error, span, message)
    }

    /// A warning at `span`.
    #[track_caller]
    pub fn warning(span: Span, message: impl Into<String>) -> Self {
        Self::new(Severity::Warning, span, message)
    }

    /// A note at `span`.
    #[track_caller]
    pub fn note(span: Span, message: impl Into<String>) -> Self {
        Self::new(Severity::Note, span, message)
    }

    #[track_caller]
    fn new(severity: Severity, span: Span, message: impl Into<String>) -> Self {
        Self {
            severity,
            message: message.into(),
            labels: vec![Label {
                span,
                text: String::new(),
            }],
            help: None,
            raised: Location::caller(),
        }
    }

    /// Sets the text at the place the message points to.
    pub fn here(mut self, text: impl Into<String>) -> Self {
        self.labels[0].text = text.into();
        self
    }

    /// Marks a further place.
    pub fn label(mut self, span: Span, text: impl Into<String>) -> Self {
        self.labels.push(Label {
            span,
            text: text.into(),
        });
        self
    }

    /// Says what to do about it.
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// The place the message points to.
    pub fn span(&self) -> Span {
        self.labels[0].span
    }
}

/// Collects the messages of all stages.
#[derive(Clone, Debug, Default)]
pub struct Diagnostics {
    list: Vec<Diagnostic>,
}

impl Diagnostics {
    /// Adds a message, unless the same one is there already.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        if !self.list.contains(&diagnostic) {
            self.list.push(diagnostic);
        }
    }

    /// Adds all messages of another collection.
    pub fn extend(&mut self, other: Diagnostics) {
        for diagnostic in other.list {
            self.push(diagnostic);
        }
    }

    /// Whether there is an error among them.
    pub fn has_errors(&self) -> bool {
        self.list.iter().any(|d| d.severity == Severity::Error)
    }

    /// Whether there is none at all.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The messages in order of their place in the sources.
    pub fn sorted(&self) -> Vec<&Diagnostic> {
        let mut list: Vec<_> = self.list.iter().collect();
        list.sort_by_key(|d| (d.span(), d.severity));
        list
    }
}
