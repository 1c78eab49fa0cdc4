//! What can go wrong when a generated struct is made or used.

use std::fmt;

/// An error of a generated struct.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Error {
    /// A sequence has a wrong number of items.
    Length {
        /// The parameter.
        parameter: String,
        /// Number of its items.
        found: usize,
        /// Number of items that it needs, or that it needs at least.
        expected: usize,
        /// What it is indexed by, such as ``8 vertices of `M` ``.
        because: String,
    },
    /// Two sequences that are declared with one subscript letter have different lengths.
    Disagree {
        /// One parameter.
        first: String,
        /// Number of its items.
        first_length: usize,
        /// The other parameter.
        second: String,
        /// Number of its items.
        second_length: usize,
    },
    /// Two parameters disagree on a size.
    Size {
        /// The parameter.
        parameter: String,
        /// Which size of it: its length, its number of rows or columns.
        what: String,
        /// That size.
        found: i64,
        /// The size that it should have.
        expected: i64,
        /// How that size is written in the program.
        written: String,
        /// The parameter that the size was read from.
        source: String,
    },
    /// A size that only the items of sequences have, and there are no items.
    UnknownSize {
        /// How the size is written in the program.
        size: String,
        /// The sequences.
        sequences: Vec<String>,
    },
    /// One index runs over two sizes that differ.
    Tied {
        /// Which size of which parameter, such as ``length of `y` ``.
        what: String,
        /// That size.
        found: i64,
        /// Which size of another parameter, or of a mesh.
        other: String,
        /// That size.
        expected: i64,
        /// The index.
        index: String,
    },
    /// A size that is a quotient is not an integer.
    Fraction {
        /// The parameter.
        parameter: String,
        /// How the size is written in the program.
        written: String,
        /// What is divided.
        above: i64,
        /// What it is divided by.
        below: i64,
    },
    /// An element is not in the set that it is declared to be in.
    NotMember {
        /// The function; empty for a parameter of the struct.
        function: String,
        /// The parameter.
        parameter: String,
        /// The element.
        element: String,
        /// The set.
        set: String,
        /// Number of members of the set.
        size: usize,
    },
    /// A parameter has an index in it for which there is nothing.
    OutOfRange {
        /// The parameter.
        parameter: String,
        /// The item of the parameter with the index in it.
        entry: String,
        /// The index.
        index: i64,
        /// What it counts, such as ``rows of `K` ``.
        what: String,
        /// The index of the first.
        first: i64,
        /// How many there are.
        size: i64,
    },
    /// A function or definition has no value: something that its formula needs does not exist.
    Undefined {
        /// The function with its arguments.
        call: String,
        /// What is missing, and where in the text.
        reason: String,
    },
    /// The mesh needs a plan with more rows than `u32` can count.
    PlanTooLarge,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Length {
                parameter,
                found,
                expected,
                because,
            } => write!(
                f,
                "`{parameter}` has {found} items but needs {expected}: it is indexed by the {because}"
            ),
            Error::Disagree {
                first,
                first_length,
                second,
                second_length,
            } => write!(
                f,
                "`{first}` has {first_length} items but `{second}` has {second_length}: they are declared with the same \
                 subscript and must have one length"
            ),
            Error::Size {
                parameter,
                what,
                found,
                expected,
                written,
                source,
            } => {
                write!(
                    f,
                    "the {what} of `{parameter}` is {found} but should be {expected}"
                )?;
                if written.parse::<i64>().is_ok() {
                    return Ok(());
                }
                write!(f, ": it is `{written}`")?;
                match source.is_empty() || source == parameter {
                    true => write!(f, ", which has this value elsewhere"),
                    false => write!(f, ", and `{source}` says so"),
                }
            }
            Error::UnknownSize { size, sequences } => {
                let names: Vec<String> = sequences.iter().map(|name| format!("`{name}`")).collect();
                let verb = if names.len() == 1 { "has" } else { "have" };
                write!(
                    f,
                    "the size `{size}` is not known: {} {verb} no items, and nothing else says it",
                    names.join(" and ")
                )
            }
            Error::Tied {
                what,
                found,
                other,
                expected,
                index,
            } => write!(
                f,
                "the {what} is {found} but the {other} is {expected}: the index `{index}` runs \
                 over both"
            ),
            Error::Fraction {
                parameter,
                written,
                above,
                below,
            } => write!(
                f,
                "a size of `{parameter}` is `{written}`, but {above}/{below} is not an integer"
            ),
            Error::NotMember {
                function,
                parameter,
                element,
                set,
                size,
            } => {
                if function.is_empty() {
                    write!(
                        f,
                        "`{parameter}` is {element}, which is not in `{set}` ({size} members)"
                    )
                } else {
                    write!(
                        f,
                        "parameter `{parameter}` of `{function}` is {element}, which is not in `{set}` ({size} members)"
                    )
                }
            }
            Error::OutOfRange {
                parameter,
                entry,
                index,
                what,
                first,
                size,
            } => {
                write!(
                    f,
                    "`{parameter}` has the entry {entry}, but {index} is none of the {size} {what}"
                )?;
                match *size > 0 {
                    true => write!(
                        f,
                        ": they are numbered from {first} to {}",
                        first + size - 1
                    ),
                    false => Ok(()),
                }
            }
            Error::Undefined { call, reason } => write!(f, "`{call}` has no value: {reason}"),
            Error::PlanTooLarge => {
                write!(
                    f,
                    "the mesh is too large: its neighbourhoods have more than 2^32 - 2 entries in all"
                )
            }
        }
    }
}

impl std::error::Error for Error {}
