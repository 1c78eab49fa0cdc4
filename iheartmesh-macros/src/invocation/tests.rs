//! Calls as they may be written, with their errors and the places of those.

use super::{Invocation, parse};
use proc_macro2::TokenStream;

fn read(text: &str) -> Invocation {
    parse(text.parse::<TokenStream>().unwrap())
}

/// The first lines of the errors, with line and column of their tokens.
fn errors(text: &str) -> Vec<String> {
    let place = |error: &super::Error| {
        let start = error.span.start();
        let message = error.message.lines().next().unwrap();
        format!("{}:{} {message}", start.line, start.column + 1)
    };
    read(text).errors.iter().map(place).collect()
}

fn names(text: &str) -> Vec<String> {
    let items = read(text).items;
    items.iter().map(|i| i.header.name.to_string()).collect()
}

#[test]
fn several_items_and_uses() {
    let call = read(
        "use my::Rings; use crate::a::B as C;
         /// text
         #[must_use] pub(crate) struct A = r#\"x\"#;
         struct D = { \"y\" };
         pub struct E = \"z\";",
    );
    assert!(call.errors.is_empty(), "{:?}", call.errors);
    let uses: Vec<_> = call.uses.iter().map(|u| u.name.to_string()).collect();
    assert_eq!(uses, ["Rings", "C"]);
    assert_eq!(call.uses[1].path.len(), 7);
    let public: Vec<_> = call.items.iter().map(|i| i.header.is_public()).collect();
    assert_eq!(public, [false, false, true]);
    assert_eq!(call.items[2].body.source.text, "z");
    assert_eq!(
        call.items[0].header.attributes.clone().into_iter().count(),
        4
    );
}

#[test]
fn an_error_does_not_remove_the_other_items() {
    let text = "struct A = 5; struct B = \"x\"; enum C = \"x\"; struct D = \"y\"";
    assert_eq!(names(text), ["B", "D"]);
    assert_eq!(
        errors(text),
        [
            "1:12 the source of a module is a string, not a number",
            "1:31 a module is a `struct`, not `enum`",
            "1:56 missing `;` after the source of `D`",
        ]
    );
    let unread: Vec<_> = read(text)
        .unread
        .iter()
        .map(|h| h.name.to_string())
        .collect();
    assert_eq!(unread, ["A", "C"]);
}

#[test]
fn a_missing_semicolon_does_not_swallow_the_next_item() {
    let text = "struct A = \"x\" pub struct B = { /// y\n } struct C { } struct D = \"z\";";
    assert_eq!(names(text), ["A", "B", "D"]);
    assert_eq!(
        errors(text),
        [
            "1:12 missing `;` after the source of `A`",
            "1:31 missing `;` after the source of `B`",
            "2:13 expected `=` and the source of `C`, found `{`",
        ]
    );
}

#[test]
fn wrong_headers() {
    for (text, expected) in [
        (
            "struct A<'a> = \"\";",
            "1:9 a module has no generic parameters",
        ),
        (
            "struct = \"\";",
            "1:8 expected the name of the module, found `=`",
        ),
        (
            "struct A;",
            "1:9 expected `=` and the source of `A`, found `;`",
        ),
        (
            "struct",
            "1:1 expected the name of the module, found the end of the call",
        ),
        ("\"x\"", "1:1 expected `struct` or `use`, found a literal"),
        (
            "pub",
            "1:1 expected `struct` or `use`, found the end of the call",
        ),
        (
            "#",
            "1:1 expected `[` of an attribute, found the end of the call",
        ),
        ("# x", "1:3 expected `[` of an attribute, found `x`"),
        (
            "#[cfg(a)] struct A = \"\";",
            "1:3 `#[cfg]` cannot stand on one module of a call",
        ),
        (
            "struct A = include_str!(\"x\");",
            "1:12 `include_str!` is not expanded inside of this call",
        ),
        (
            "struct A = include;",
            "1:19 expected the name of a file in quotes, found `;`",
        ),
        (
            "struct A = include 3;",
            "1:20 expected the name of a file in quotes, not a number",
        ),
        (
            "struct A = \"x\" \"y\";",
            "1:16 the source of a module is one string, or several in braces",
        ),
        (
            "struct A = b\"x\";",
            "1:12 the source of a module is a string, not a byte string",
        ),
        (
            "struct __ihmA = \"x\";",
            "1:8 names that start with `__ihm` belong to this macro",
        ),
        (
            "struct A = \"\"; struct A = \"\";",
            "1:23 two modules of this call are named `A`",
        ),
        (
            "use a::A; struct A = \"\";",
            "1:18 two modules of this call are named `A`",
        ),
        ("use a::A;", "1:8 this call defines no module"),
    ] {
        assert_eq!(errors(text), [expected], "{text}");
    }
    assert_eq!(errors("").len(), 1);
}

#[test]
fn wrong_uses() {
    for (text, expected) in [
        (
            "pub use a::B;",
            "1:1 a `use` in this call takes neither attributes nor a visibility",
        ),
        (
            "use a::{B, C};",
            "1:8 expected the name of a module, found `{`",
        ),
        ("use a::*;", "1:8 expected the name of a module, found `*`"),
        ("use ;", "1:5 expected the path of a module, found `;`"),
        ("use a:B;", "1:7 expected `::`, found `B`"),
        (
            "use a::B as _;",
            "1:13 expected the name to use in the source, found `_`",
        ),
        (
            "use a::B as",
            "1:10 expected the name to use in the source, found the end of the call",
        ),
        (
            "use a::B",
            "1:8 expected `;` after the path of a module, found the end of the call",
        ),
        (
            "use a::self;",
            "1:8 `self` is not a module written with this macro",
        ),
    ] {
        let found = errors(&format!("{text} struct Z = \"\";"));
        if text.ends_with(';') {
            assert_eq!(found, [expected], "{text}");
        } else {
            assert_eq!(errors(text), [expected], "{text}");
        }
    }
}

#[test]
fn a_missing_file_is_named_in_full() {
    let call = read("struct A = include \"nowhere.hlang\"; struct B = \"\";");
    let directory = env!("CARGO_MANIFEST_DIR");
    let start = format!("cannot read `{directory}/nowhere.hlang`: ");
    assert!(
        call.errors[0].message.starts_with(&start),
        "{:?}",
        call.errors
    );
    assert_eq!(call.items.len(), 1);
}
