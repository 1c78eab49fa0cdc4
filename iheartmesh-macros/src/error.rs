//! An error of the invocation itself: a message and the tokens it is about.

use proc_macro2::Span;

/// What is wrong, and where; lower case, no full stop, as every message of the compiler.
#[derive(Clone, Debug)]
pub struct Error {
    /// The token to mark.
    pub span: Span,
    /// The message, with its help on further lines.
    pub message: String,
}

impl Error {
    /// An error at `span`.
    pub fn new(span: Span, message: impl Into<String>) -> Self {
        Self {
            span,
            message: message.into(),
        }
    }

    /// Adds what to do about it.
    pub fn help(mut self, help: &str) -> Self {
        self.message += "\n= help: ";
        self.message += help;
        self
    }
}
