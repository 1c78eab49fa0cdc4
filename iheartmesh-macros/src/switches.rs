//! Attributes of a module that are for the compiler.
//!
//! - `#[without(plan, orbits)]` and `#[without(all)]`: leaves out optimisations, to compare results and to find out what
//!   each is worth.
//! - `#[together(e, g, H)]`: definitions that are asked for at once.

use crate::error::Error;
use iheartmesh_compiler::optimize::Optimizations;
use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};

/// What the attributes of a module say to the compiler.
#[derive(Clone, Debug)]
pub struct Switches {
    /// What `#[without(…)]` leaves on.
    pub optimizations: Optimizations,
    /// One for each `#[together(…)]`.
    pub together: Vec<Together>,
}

/// Definitions that are asked for at once.
#[derive(Clone, Debug)]
pub struct Together {
    /// The word `together`.
    pub span: Span,
    /// The names of the definitions.
    pub names: Vec<Ident>,
}

impl Together {
    /// The names as text.
    pub fn plain(&self) -> Vec<String> {
        let names = self.names.iter().map(Ident::to_string);
        names
            .map(|name| name.trim_start_matches("r#").to_owned())
            .collect()
    }
}

impl Default for Switches {
    fn default() -> Self {
        Self {
            optimizations: Optimizations::ALL,
            together: Vec::new(),
        }
    }
}

/// Takes the switches out of the attributes of an item.
pub fn take(attributes: TokenStream, errors: &mut Vec<Error>) -> (TokenStream, Switches) {
    let mut found = Switches::default();
    let mut rest = TokenStream::new();
    let mut tokens = attributes.into_iter().peekable();
    while let Some(token) = tokens.next() {
        let switches = match (&token, tokens.peek()) {
            (TokenTree::Punct(hash), Some(TokenTree::Group(group))) if hash.as_char() == '#' => {
                arguments(group.stream())
            }
            _ => None,
        };
        match switches {
            Some((name, arguments)) => {
                tokens.next();
                match name == "without" {
                    true => apply(arguments, &mut found.optimizations, errors),
                    false => found
                        .together
                        .extend(together(name.span(), arguments, errors)),
                }
            }
            None => rest.extend([token]),
        }
    }
    (rest, found)
}

/// `without` or `together`, and what stands in the parentheses.
fn arguments(attribute: TokenStream) -> Option<(Ident, TokenStream)> {
    let tokens: Vec<TokenTree> = attribute.into_iter().collect();
    match tokens.as_slice() {
        [TokenTree::Ident(name), TokenTree::Group(group)]
            if (name == "without" || name == "together")
                && group.delimiter() == Delimiter::Parenthesis =>
        {
            Some((name.clone(), group.stream()))
        }
        _ => None,
    }
}

fn apply(switches: TokenStream, optimizations: &mut Optimizations, errors: &mut Vec<Error>) {
    for token in switches {
        match &token {
            TokenTree::Punct(comma) if comma.as_char() == ',' => {}
            TokenTree::Ident(name) if name == "all" => *optimizations = Optimizations::NONE,
            TokenTree::Ident(name) if optimizations.set(&name.to_string(), false) => {}
            other => {
                let names = Optimizations::NAMES
                    .map(|name| format!("`{name}`"))
                    .join(", ");
                errors.push(
                    Error::new(other.span(), format!("there is no optimisation `{other}`")).help(
                        &format!("the optimisations are {names}; `all` leaves out all of them"),
                    ),
                );
            }
        }
    }
}

/// The names of a list; nothing where something else stands among them, which is said.
fn together(span: Span, arguments: TokenStream, errors: &mut Vec<Error>) -> Option<Together> {
    let before = errors.len();
    let mut names = Vec::new();
    for token in arguments {
        match token {
            TokenTree::Punct(comma) if comma.as_char() == ',' => {}
            TokenTree::Ident(name) => names.push(name),
            other => errors.push(
                Error::new(
                    other.span(),
                    format!("`{other}` is not the name of a definition"),
                )
                .help("names of methods stand here, as in `#[together(e, g, H)]`"),
            ),
        }
    }
    (errors.len() == before).then_some(Together { span, names })
}

#[cfg(test)]
mod tests;
