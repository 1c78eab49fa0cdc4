//! Checks of what the host hands in, and the errors they give.

use std::fmt;

use super::Fault;
use crate::complex::CellComplex;
use crate::{CellularSet, Element, Error, Set, SetItem};

/// An element that is an argument of a function.
#[inline(always)]
pub fn check_argument<T: Element>(
    function: &str,
    parameter: &str,
    element: T,
    n: usize,
    set: &str,
) -> Result<(), Error> {
    if element.index() < n {
        return Ok(());
    }
    Err(not_member(function, parameter, element, set, n))
}

/// A set of elements that is an argument of a function.
pub fn check_set_argument<T: Element + SetItem>(
    function: &str,
    parameter: &str,
    set: &Set<T>,
    n: usize,
    within: &str,
) -> Result<(), Error> {
    match set.iter().next_back() {
        // members are sorted, so that the last one is the largest
        Some(element) if element.index() >= n => {
            Err(not_member(function, parameter, *element, within, n))
        }
        _ => Ok(()),
    }
}

/// An element that must be in a set of elements.
pub fn check_member<T: Element>(
    function: &str,
    parameter: &str,
    element: T,
    members: &[u32],
    set: &str,
) -> Result<(), Error> {
    if members.binary_search(&element.id()).is_ok() {
        return Ok(());
    }
    Err(not_member(function, parameter, element, set, members.len()))
}

/// An element that must be in a set that the host handed in.
pub fn check_element_in<T: Element + SetItem>(
    function: &str,
    parameter: &str,
    element: T,
    members: &Set<T>,
    set: &str,
) -> Result<(), Error> {
    if members.contains(&element) {
        return Ok(());
    }
    Err(not_member(function, parameter, element, set, members.len()))
}

/// A value that must be in a set.
pub fn check_in<T: SetItem + fmt::Debug>(
    function: &str,
    parameter: &str,
    value: &T,
    members: &Set<T>,
    set: &str,
) -> Result<(), Error> {
    if members.contains(value) {
        return Ok(());
    }
    Err(Error::NotMember {
        function: function.to_owned(),
        parameter: parameter.to_owned(),
        element: format!("{value:?}"),
        set: set.to_owned(),
        size: members.len(),
    })
}

/// A cellular set that is an argument of a function.
pub fn check_cellular_set(
    function: &str,
    parameter: &str,
    set: &CellularSet,
    complex: &CellComplex,
    mesh: &str,
) -> Result<(), Error> {
    let n = |dimension| match dimension <= complex.dimension() {
        true => complex.n(dimension),
        false => 0,
    };
    check_set_argument(function, parameter, &set.vertices, n(0), mesh)?;
    check_set_argument(function, parameter, &set.edges, n(1), mesh)?;
    check_set_argument(function, parameter, &set.faces, n(2), mesh)?;
    check_set_argument(function, parameter, &set.cells, n(3), mesh)
}

#[cold]
fn not_member<T: Element>(
    function: &str,
    parameter: &str,
    element: T,
    set: &str,
    size: usize,
) -> Error {
    Error::NotMember {
        function: function.to_owned(),
        parameter: parameter.to_owned(),
        element: element.to_string(),
        set: set.to_owned(),
        size,
    }
}

/// The length of a sequence that is indexed by elements; without `exact` it may be longer.
pub fn check_length(
    parameter: &str,
    found: usize,
    expected: usize,
    exact: bool,
    mesh: &str,
    elements: &str,
) -> Result<(), Error> {
    if found == expected || (!exact && found > expected) {
        return Ok(());
    }
    Err(Error::Length {
        parameter: parameter.to_owned(),
        found,
        expected,
        because: format!("{expected} {elements} of `{mesh}`"),
    })
}

/// The lengths of two sequences with one subscript letter.
pub fn check_same_length(
    first: &str,
    first_length: usize,
    second: &str,
    second_length: usize,
) -> Result<(), Error> {
    if first_length == second_length {
        return Ok(());
    }
    Err(Error::Disagree {
        first: first.to_owned(),
        first_length,
        second: second.to_owned(),
        second_length,
    })
}

/// A size of a parameter: `what` is found, where another parameter or the mesh asks for `expected`.
pub fn check_size(
    parameter: &str,
    what: &str,
    found: i64,
    expected: i64,
    written: &str,
    source: &str,
) -> Result<(), Error> {
    if found == expected {
        return Ok(());
    }
    Err(Error::Size {
        parameter: parameter.to_owned(),
        what: what.to_owned(),
        found,
        expected,
        written: written.to_owned(),
        source: source.to_owned(),
    })
}

/// A size that the first item of some sequence gives.
pub fn known_size(found: Option<i64>, size: &str, sequences: &[&str]) -> Result<i64, Error> {
    found.ok_or_else(|| Error::UnknownSize {
        size: size.to_owned(),
        sequences: sequences.iter().map(|name| (*name).to_owned()).collect(),
    })
}

/// Two sizes that one index runs over: of what, which one, and how large.
pub fn check_tied(
    (parameter, what, found): (&str, &str, i64),
    (other, of_other, expected): (&str, &str, i64),
    index: &str,
) -> Result<(), Error> {
    if found == expected {
        return Ok(());
    }
    Err(Error::Tied {
        what: format!("{what} of `{parameter}`"),
        found,
        other: format!("{of_other} of `{other}`"),
        expected,
        index: index.to_owned(),
    })
}

/// Pairs of numbers of rows and columns of the matrix `of`, of which the host counts the first as `first`.
pub fn check_pairs(
    parameter: &str,
    pairs: &Set<(i64, i64)>,
    first: i64,
    (rows, columns): (i64, i64),
    of: &str,
) -> Result<(), Error> {
    for (row, column) in pairs {
        for (index, size, what) in [(*row, rows, "row"), (*column, columns, "column")] {
            if index < first || index - first >= size {
                return Err(Error::OutOfRange {
                    parameter: parameter.to_owned(),
                    entry: format!("({row}, {column})"),
                    index,
                    what: format!("{what}s of `{of}`"),
                    first,
                    size,
                });
            }
        }
    }
    Ok(())
}

/// A size of an item of a sequence, counted from 0; what is wanted is a quotient.
pub fn check_item_size(
    parameter: &str,
    item: usize,
    what: &str,
    found: i64,
    (above, below): (i64, i64),
    written: &str,
    source: &str,
) -> Result<(), Error> {
    if found.checked_mul(below) == Some(above) {
        return Ok(());
    }
    let what = format!("{what} of item {}", item + 1);
    check_quotient_size(parameter, &what, found, (above, below), written, source)
}

/// A size that is a quotient must be an integer.
pub fn check_quotient(parameter: &str, above: i64, below: i64, written: &str) -> Result<(), Error> {
    if above % below == 0 {
        return Ok(());
    }
    Err(Error::Fraction {
        parameter: parameter.to_owned(),
        written: written.to_owned(),
        above,
        below,
    })
}

/// A size that is wanted as a quotient.
pub fn check_quotient_size(
    parameter: &str,
    what: &str,
    found: i64,
    (above, below): (i64, i64),
    written: &str,
    source: &str,
) -> Result<(), Error> {
    if found.checked_mul(below) == Some(above) {
        return Ok(());
    }
    check_quotient(parameter, above, below, written)?;
    check_size(parameter, what, found, above / below, written, source)
}

/// The error of a call that has no value.
#[cold]
pub fn undefined(function: &str, arguments: &[&dyn fmt::Display], fault: Fault) -> Error {
    let arguments: Vec<String> = arguments.iter().map(ToString::to_string).collect();
    let call = match arguments.is_empty() {
        true => function.to_owned(),
        false => format!("{function}({})", arguments.join(", ")),
    };
    Error::Undefined {
        call,
        reason: fault.reason.to_owned(),
    }
}

/// Ends a call that cannot go on, as indexing past the end of a slice does.
#[cold]
#[inline(never)]
#[track_caller]
pub fn fail(error: Error) -> ! {
    panic!("{error}")
}

/// Shows a value by its debug form.
pub struct Shown<'a, T>(pub &'a T);

impl<T: fmt::Debug> fmt::Display for Shown<'_, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
