//! Comparing a neighbourhood as a method of its module, in a program that imports it, and in that program without
//! optimisations.

use iheartmesh::Error;

/// Whether all results are what is expected: these numbers, or, for `None`, no value.
pub fn check(call: &str, expected: Option<Vec<u32>>, results: [Result<Vec<u32>, Error>; 3]) {
    for (way, result) in ["as a method", "in a program", "not optimised"]
        .iter()
        .zip(results)
    {
        match (&expected, result) {
            (Some(expected), Ok(found)) => assert_eq!(&found, expected, "{call}, {way}"),
            (None, Err(Error::Undefined { .. })) => {}
            (expected, result) => panic!("{call}, {way}: {result:?} instead of {expected:?}"),
        }
    }
}

/// Compares one function: its names as a method and in the program, its arguments, and the expected numbers.
#[macro_export]
macro_rules! check {
    ($ways:expr, $method:ident, $function:ident($($argument:expr),*), $expected:expr) => {
        check!($ways, $method($($argument),*), $function($($argument),*), $expected)
    };
    ($ways:expr, $method:ident($($one:expr),*), $function:ident($($argument:expr),*), $expected:expr) => {{
        let ways = &$ways;
        let call = format!(
            "{}: {}{:?}",
            ways.soup.name,
            stringify!($method),
            ($(&$argument,)*)
        );
        let results = [
            ways.rust.$method($($one),*).map(|x| x.ids()),
            ways.program.$function($($argument),*).map(|x| x.ids()),
            ways.plain.$function($($argument),*).map(|x| x.ids()),
        ];
        support::ways::check(&call, $expected, results);
    }};
}
