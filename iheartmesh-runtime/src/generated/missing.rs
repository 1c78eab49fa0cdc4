//! Elements that do not exist, in the tables of plans: each with the reason, which is told when the element is needed.

use std::cell::Cell;
use std::ops::Range;
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::{Fallible, Fault};
use crate::element::ElementKind;

/// So many numbers stand for reasons instead of elements.
const KINDS: u32 = 1 << 16;

/// The first number that stands for a reason. Meshes have fewer elements.
pub const FIRST_MISSING: u32 = u32::MAX - KINDS + 1;

/// Stands in a row where an element is missing for an unknown reason.
pub const NO_ELEMENT: u32 = u32::MAX;

/// More reasons that name an element are not kept.
const MOST_NAMED: usize = 1 << 10;

/// All reasons met so far: those that the compiler wrote, and some of these with an element.
struct Reasons {
    written: Vec<&'static str>,
    named: Vec<&'static str>,
}

static REASONS: Mutex<Reasons> = Mutex::new(Reasons {
    written: Vec::new(),
    named: Vec::new(),
});

thread_local! {
    /// The last reason: most are the same as the one before.
    static LAST: Cell<(&'static str, u32)> = const { Cell::new(("", NO_ELEMENT)) };
}

fn reasons() -> MutexGuard<'static, Reasons> {
    REASONS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// What stands in a row for an element that is missing for this reason.
#[cold]
pub fn missing(fault: Fault) -> u32 {
    let (last, number) = LAST.get();
    if std::ptr::eq(last, fault.reason) {
        return number;
    }
    let written = &mut reasons().written;
    let known = written.iter().position(|reason| *reason == fault.reason);
    let number = known.unwrap_or(written.len()) as u32;
    if number >= KINDS - 1 {
        return NO_ELEMENT;
    }
    if known.is_none() {
        written.push(fault.reason);
    }
    let number = FIRST_MISSING + number;
    LAST.set((fault.reason, number));
    number
}

/// Whether an element of a row is missing.
#[inline(always)]
pub fn is_missing(stored: u32) -> bool {
    stored >= FIRST_MISSING
}

/// An element of a row, which may be missing. `fault` is told where no reason is known.
#[inline(always)]
pub fn element(stored: u32, fault: Fault) -> Fallible<u32> {
    if is_missing(stored) {
        return Err(reason(stored, fault));
    }
    Ok(stored)
}

/// The value at an element of a row, which may be missing. `fault` is told where no reason is known.
#[inline(always)]
pub fn of_element<T>(values: &[T], stored: u32, fault: Fault) -> Fallible<&T> {
    match values.get(stored as usize) {
        Some(value) => Ok(value),
        None => Err(reason(stored, fault)),
    }
}

#[cold]
fn reason(stored: u32, fault: Fault) -> Fault {
    let written = &reasons().written;
    let known = stored.checked_sub(FIRST_MISSING);
    match known.and_then(|number| written.get(number as usize)) {
        Some(reason) => Fault::new(reason),
        None => fault,
    }
}

/// Does all `n` rounds of a loop, over the elements of a kind. `some` does those in a range; where one fails, it is called again.
///
/// # Errors
/// That of the first round that fails, which it names.
#[inline]
pub fn rounds(
    kind: Option<ElementKind>,
    n: usize,
    mut some: impl FnMut(Range<usize>) -> Fallible<()>,
) -> Fallible<()> {
    match some(0..n) {
        Ok(()) => Ok(()),
        Err(fault) => Err(named(kind, 0..n, fault, |range| some(range).err())),
    }
}

/// The reason with the first element that has no value among consecutive ones, if they are all of a kind; `fault_of` computes
/// the first of them anew. Texts are kept as long as the program runs, so that only so many name an element.
#[cold]
pub(super) fn named(
    kind: Option<ElementKind>,
    elements: Range<usize>,
    fault: Fault,
    mut fault_of: impl FnMut(Range<usize>) -> Option<Fault>,
) -> Fault {
    let Some(kind) = kind else {
        return fault;
    };
    let (mut below, mut above) = (elements.start, elements.end);
    while below + 1 < above {
        let middle = below + (above - below) / 2;
        match fault_of(elements.start..middle) {
            Some(_) => above = middle,
            None => below = middle,
        }
    }
    with_element(fault, kind, below)
}

fn with_element(fault: Fault, kind: ElementKind, number: usize) -> Fault {
    let text = format!("for {kind} {number}, {}", fault.reason);
    let named = &mut reasons().named;
    if let Some(known) = named.iter().find(|known| **known == text) {
        return Fault::new(known);
    }
    if named.len() >= MOST_NAMED {
        return fault;
    }
    let text: &'static str = Box::leak(text.into_boxed_str());
    named.push(text);
    Fault::new(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn missing_elements_tell_their_reason() {
        let unknown = Fault::new("unknown");
        let (a, b) = (Fault::new("no face"), Fault::new("no edge"));
        let (x, y) = (missing(a), missing(b));
        assert!(x != y && is_missing(x) && is_missing(y));
        assert_eq!((missing(a), missing(b)), (x, y));
        assert_eq!(element(x, unknown), Err(a));
        assert_eq!(element(y, unknown), Err(b));
        assert_eq!(element(NO_ELEMENT, unknown), Err(unknown));
        assert_eq!(element(FIRST_MISSING - 1, unknown), Ok(FIRST_MISSING - 1));
    }

    #[test]
    fn the_element_is_named() {
        let fault = Fault::new("no face");
        let edge = Some(ElementKind::Edge);
        let first = |missing: usize| {
            named(edge, 10..30, fault, |range| {
                range.contains(&missing).then_some(fault)
            })
        };
        for k in 10..30 {
            assert_eq!(first(k).reason, format!("for edge {k}, no face"));
        }
        // the same text once
        assert!(std::ptr::eq(first(17).reason, first(17).reason));
        assert_eq!(named(None, 10..30, fault, |_| Some(fault)), fault);
    }
}
