//! Documentation of the generated items.

use proc_macro2::TokenStream;
use quote::quote;

use super::Context;
use crate::ir::{Function, Global, Together};
use crate::span::Span;
use crate::types::{Type, display::plural};

fn lines(text: &str) -> TokenStream {
    let lines = text.lines().map(|line| format!(" {line}"));
    quote!(#(#[doc = #lines])*)
}

fn code(text: &str) -> String {
    let indent = text
        .lines()
        .skip(1)
        .filter(|l| !l.trim().is_empty())
        .map(|l| l.len() - l.trim_start().len())
        .min()
        .unwrap_or(0);
    let dedented: Vec<&str> = text
        .lines()
        .enumerate()
        .map(|(k, l)| {
            if k == 0 {
                l
            } else {
                l.get(indent..).unwrap_or(l.trim_start())
            }
        })
        .collect();
    format!("```text\n{}\n```", dedented.join("\n").trim_end())
}

/// The struct: after the user's own words, the program.
pub(super) fn structure(source: &str) -> TokenStream {
    let first = source
        .lines()
        .find(|l| !l.trim().is_empty())
        .map_or("", |l| l);
    let indent = &first[..first.len() - first.trim_start().len()];
    let dedented: Vec<&str> = source
        .lines()
        .map(|l| l.strip_prefix(indent).unwrap_or(l))
        .collect();
    let text = dedented.join("\n");
    lines(&format!(
        "\nExpanded from\n\n```text\n{}\n```",
        text.trim_matches('\n').trim_end()
    ))
}

/// `new`.
pub(super) fn new(context: &Context<'_>) -> TokenStream {
    let mut text =
        "Binds the program to its parameters and computes what depends only on the mesh.\n"
            .to_owned();
    for id in &context.program().input_order {
        let input = context.program().input(*id);
        let what = match &input.ty {
            Type::Sequence { item, .. } => match input.ty.clone() {
                Type::Sequence {
                    index: Some(element),
                    ..
                } => format!("one {item} for each of the {}", plural(element.kind)),
                _ => match input.indexed_by.as_slice() {
                    [element] => format!("one {item} for each of the {}", plural(element.kind)),
                    _ => format!("a sequence of {item}"),
                },
            },
            other => other.to_string(),
        };
        let description = input
            .description
            .as_deref()
            .map_or(String::new(), |d| format!(": {d}"));
        text.push_str(&format!("\n- `{}`: {what}{description}", input.name));
    }
    text.push_str("\n\n# Errors\nWhen the length of a parameter does not fit, or an element is not of its mesh.");
    lines(&text)
}

/// A method of a function.
pub(super) fn function(
    context: &Context<'_>,
    function: &Function,
    fallible: bool,
    all: bool,
) -> TokenStream {
    let mut text = String::new();
    if all {
        text.push_str("The value for each element, in ascending order, of\n\n");
    }
    text.push_str(&code(&written(context, function.span)));
    text.push('\n');
    if !all {
        for parameter in &function.parameters {
            let of = match parameter.within_name.is_empty() {
                true => String::new(),
                false => format!(" of `{}`", parameter.within_name),
            };
            text.push_str(&format!("\n- `{}`: {}{of}", parameter.name, parameter.ty));
        }
    }
    text.push_str(&format!("\n\nThe result is of type {}.\n", function.ty));
    let when = "an argument is not in its declared set, or a neighbour that the formula needs does not exist";
    match fallible {
        true => text.push_str(&format!("\n# Errors\nWhen {when}.")),
        false => text.push_str(&format!("\n# Panics\nWhen {when}.")),
    }
    lines(&text)
}

/// A method of overloaded functions.
pub(super) fn overloads(
    context: &Context<'_>,
    functions: &[&Function],
    fallible: bool,
) -> TokenStream {
    let mut text = "One of these, by the type of the arguments:\n\n".to_owned();
    for function in functions {
        text.push_str(&code(&written(context, function.span)));
        text.push_str("\n\n");
    }
    let when = "an argument is not in its declared set, or a neighbour that the formula needs does not exist";
    match fallible {
        true => text.push_str(&format!("# Errors\nWhen {when}.")),
        false => text.push_str(&format!("# Panics\nWhen {when}.")),
    }
    lines(&text)
}

/// A method of a definition.
pub(super) fn global(context: &Context<'_>, global: &Global, fallible: bool) -> TokenStream {
    let mut text = code(&written(context, global.span));
    let ty = context.program().arena.ty(global.value);
    text.push_str(&format!(
        "\n\nThe result is of type {ty}. It is computed on first use, and again after a parameter that it depends on was set.\n"
    ));
    let when = "a neighbour that the formula needs does not exist";
    match fallible {
        true => text.push_str(&format!("\n# Errors\nWhen {when}.")),
        false => text.push_str(&format!("\n# Panics\nWhen {when}.")),
    }
    lines(&text)
}

/// A method that writes the value of a definition.
pub(super) fn global_into(context: &Context<'_>, global: &Global, fallible: bool) -> TokenStream {
    let mut text = "Writes into `target` the value of\n\n".to_owned();
    text.push_str(&code(&written(context, global.span)));
    text.push_str(
        "\n\nMemory of `target` is used again where its size, and of a sparse matrix its pattern, is that of the value; otherwise it \
         becomes a new value. Nothing is kept, but what is known already is copied.\n",
    );
    let when = "a neighbour that the formula needs does not exist; the entries of `target` are of no use then";
    match fallible {
        true => text.push_str(&format!("\n# Errors\nWhen {when}.")),
        false => text.push_str(&format!("\n# Panics\nWhen {when}.")),
    }
    lines(&text)
}

/// A method that gives several definitions.
pub(super) fn together(
    context: &Context<'_>,
    together: &Together,
    into: bool,
    fallible: bool,
) -> TokenStream {
    let mut text = match into {
        true => "Writes the values of several definitions; numbers are returned.\n",
        false => "The values of several definitions.\n",
    }
    .to_owned();
    let program = context.program();
    for id in &together.members {
        text.push_str(&format!(
            "\n{}\n",
            code(&written(context, program.global(*id).span))
        ));
    }
    match context.united(together) {
        Some(pass) => {
            let united = together
                .members
                .iter()
                .filter(|id| pass.members.contains(id));
            let names = united.map(|id| format!("`{}`", program.global(*id).name));
            text.push_str(&format!(
                "\nOne pass computes {}, where two or more of them are not known already.\n",
                names.collect::<Vec<_>>().join(", ")
            ));
        }
        None => text.push_str("\nEach is computed by itself.\n"),
    }
    if into {
        text.push_str(
            "\nMemory at hand is used again where its size, and of a sparse matrix its pattern, is that of the value.\n",
        );
    }
    let when = "a neighbour that a formula needs does not exist";
    match fallible {
        true => text.push_str(&format!(
            "\n# Errors\nWhen {when}: that of the first definition without a value."
        )),
        false => text.push_str(&format!("\n# Panics\nWhen {when}.")),
    }
    lines(&text)
}

/// A method that sets a parameter.
pub(super) fn setter(name: &str) -> TokenStream {
    lines(&format!(
        "Sets new values of `{name}`. What was computed from the mesh is kept.\n\n# Errors\nWhen its length does not fit, or an element is not of its mesh; the old values stay."
    ))
}

fn written(context: &Context<'_>, span: Span) -> String {
    context.sources.text(span).to_owned()
}
