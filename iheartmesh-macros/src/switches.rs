//! `#[without(plan, orbits)]` and `#[without(all)]`: leaves out optimisations, to compare results and to find out what
//! each is worth.

use crate::error::Error;
use iheartmesh_compiler::optimize::Optimizations;
use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// Takes the switches out of the attributes of an item.
pub fn take(attributes: TokenStream, errors: &mut Vec<Error>) -> (TokenStream, Optimizations) {
    let mut optimizations = Optimizations::ALL;
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
            Some(switches) => {
                tokens.next();
                apply(switches, &mut optimizations, errors);
            }
            None => rest.extend([token]),
        }
    }
    (rest, optimizations)
}

/// What stands in the parentheses of `without(…)`.
fn arguments(attribute: TokenStream) -> Option<TokenStream> {
    let tokens: Vec<TokenTree> = attribute.into_iter().collect();
    match tokens.as_slice() {
        [TokenTree::Ident(name), TokenTree::Group(group)]
            if name == "without" && group.delimiter() == Delimiter::Parenthesis =>
        {
            Some(group.stream())
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

#[cfg(test)]
mod tests;
