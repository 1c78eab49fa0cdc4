//! Which attributes are switches, and what they turn off.

use super::take;
use crate::error::Error;
use iheartmesh_compiler::optimize::Optimizations;
use proc_macro2::TokenStream;

/// The attributes that are left, the optimisations that are on, and the errors.
fn read(attributes: &str) -> (String, Vec<&'static str>, Vec<Error>) {
    let tokens: TokenStream = attributes.parse().unwrap();
    let mut errors = Vec::new();
    let (rest, found) = take(tokens, &mut errors);
    (rest.to_string(), names(found.optimizations), errors)
}

fn names(on: Optimizations) -> Vec<&'static str> {
    let is_on = |name: &&str| {
        let mut without = on;
        without.set(name, false) && without != on
    };
    Optimizations::NAMES.into_iter().filter(is_on).collect()
}

#[test]
fn no_switch_leaves_everything_on() {
    let (rest, on, errors) = read("#[derive(Debug)] #[doc = \"text\"]");
    assert_eq!(rest, "# [derive (Debug)] # [doc = \"text\"]");
    assert_eq!(on, Optimizations::NAMES);
    assert!(errors.is_empty());
}

#[test]
fn each_switch_turns_off_its_own() {
    for name in Optimizations::NAMES {
        let (rest, on, errors) = read(&format!("#[without({name})]"));
        let others: Vec<_> = Optimizations::NAMES
            .into_iter()
            .filter(|n| *n != name)
            .collect();
        assert_eq!((rest.as_str(), on), ("", others));
        assert!(errors.is_empty());
    }
}

#[test]
fn several_switches_in_one_or_more_attributes() {
    let (rest, on, errors) =
        read("#[without(plan, orbits)] #[must_use] #[without(traverse,)] #[inline]");
    assert_eq!(rest, "# [must_use] # [inline]");
    assert!(!on.contains(&"plan") && !on.contains(&"orbits") && !on.contains(&"traverse"));
    assert_eq!(on.len(), Optimizations::NAMES.len() - 3);
    assert!(errors.is_empty());
}

#[test]
fn all_turns_off_everything() {
    assert_eq!(read("#[without(all)]").1, Vec::<&str>::new());
    assert_eq!(read("#[without(plan, all)]").1, Vec::<&str>::new());
    assert_eq!(read("#[without()]").1, Optimizations::NAMES);
}

#[test]
fn other_attributes_of_the_name_stay() {
    for other in [
        "# [without]",
        "# [without = \"plan\"]",
        "# [a :: without (plan)]",
    ] {
        let (rest, on, errors) = read(other);
        assert_eq!(rest, other.parse::<TokenStream>().unwrap().to_string());
        assert_eq!(on, Optimizations::NAMES);
        assert!(errors.is_empty());
    }
}

#[test]
fn unknown_optimisations_are_reported_where_they_stand() {
    let (rest, on, errors) = read("#[without(plan, speed, 3)]");
    assert_eq!(rest, "");
    assert!(!on.contains(&"plan"));
    let said: Vec<_> = errors
        .iter()
        .map(|e| (e.span.start().column, e.message.lines().next().unwrap()))
        .collect();
    assert_eq!(
        said,
        [
            (16, "there is no optimisation `speed`"),
            (23, "there is no optimisation `3`"),
        ]
    );
    assert!(errors[0].message.contains("`plan`") && errors[0].message.contains("`all`"));
}

#[test]
fn definitions_asked_for_together() {
    let tokens: TokenStream = "#[together(e, g, H)] #[must_use] #[together(r#type, κ,)]"
        .parse()
        .unwrap();
    let mut errors = Vec::new();
    let (rest, found) = take(tokens, &mut errors);
    assert_eq!(rest.to_string(), "# [must_use]");
    let lists: Vec<_> = found.together.iter().map(|list| list.plain()).collect();
    assert_eq!(lists, [vec!["e", "g", "H"], vec!["type", "κ"]]);
    assert_eq!(found.together[0].span.start().column, 2);
    assert!(errors.is_empty());
}

#[test]
fn what_is_no_name_is_reported_where_it_stands() {
    let tokens: TokenStream = "#[together(e, 3, H)]".parse().unwrap();
    let mut errors = Vec::new();
    let (_, found) = take(tokens, &mut errors);
    assert!(found.together.is_empty());
    assert_eq!(errors.len(), 1);
    assert_eq!(errors[0].span.start().column, 14);
    assert!(
        errors[0]
            .message
            .starts_with("`3` is not the name of a definition")
    );
}
