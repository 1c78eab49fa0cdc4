//! Failures of formulas, and accesses that may fail.

use super::NO_INTEGER;
use crate::Error;

/// Why a formula has no value: a text that the compiler wrote for the place in the formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The reason.
    pub reason: &'static str,
}

impl Fault {
    /// A failure with this reason. Written before the access that may fail, in the middle of loops.
    #[inline(always)]
    pub const fn new(reason: &'static str) -> Self {
        Self { reason }
    }
}

/// A value, or why there is none.
pub type Fallible<T> = Result<T, Fault>;

/// Why a plan could not be made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PlanError {
    /// Too many rows.
    TooLarge,
    /// A set that it needs for all of the mesh has no value.
    Fault(Fault),
}

impl From<Fault> for PlanError {
    fn from(fault: Fault) -> Self {
        PlanError::Fault(fault)
    }
}

impl From<PlanError> for Error {
    fn from(error: PlanError) -> Self {
        match error {
            PlanError::TooLarge => Error::PlanTooLarge,
            PlanError::Fault(fault) => Error::Undefined {
                call: "new".to_owned(),
                reason: fault.reason.to_owned(),
            },
        }
    }
}

/// The value at an index, from 0.
#[inline(always)]
pub fn at<T>(values: &[T], index: usize, fault: Fault) -> Fallible<&T> {
    match values.get(index) {
        Some(value) => Ok(value),
        None => Err(fault),
    }
}

/// The value with a number, from 1.
#[inline(always)]
pub fn entry<T>(values: &[T], number: i64, fault: Fault) -> Fallible<&T> {
    match usize::try_from(number.wrapping_sub(1))
        .ok()
        .and_then(|index| values.get(index))
    {
        Some(value) => Ok(value),
        None => Err(fault),
    }
}

/// The place of the value with a number, from 1.
#[inline]
pub fn entry_mut<T>(values: &mut [T], number: i64, fault: Fault) -> Fallible<&mut T> {
    let index = usize::try_from(number.wrapping_sub(1)).ok();
    index.and_then(|index| values.get_mut(index)).ok_or(fault)
}

/// An integer of a row, which may be missing.
#[inline(always)]
pub fn integer(stored: u32, fault: Fault) -> Fallible<i64> {
    if stored == NO_INTEGER {
        Err(fault)
    } else {
        Ok(i64::from(stored as i32))
    }
}

/// An integer as it is stored in a row.
#[inline]
pub fn encoded(value: i64) -> Fallible<u32> {
    match i32::try_from(value) {
        Ok(value) if value != i32::MIN => Ok(value as u32),
        _ => Err(Fault::new(
            "an integer that depends only on the mesh is larger than 2^31",
        )),
    }
}

/// A set that must have so many members.
#[inline]
pub fn sized<S: AsRef<[T]>, T>(set: S, n: usize, fault: Fault) -> Fallible<S> {
    if set.as_ref().len() == n {
        Ok(set)
    } else {
        Err(fault)
    }
}

/// A result of integer arithmetic, if it is in range.
#[inline(always)]
pub fn integers(value: Option<i64>, fault: Fault) -> Fallible<i64> {
    value.ok_or(fault)
}

/// Whether a number takes the place of the least one so far. What is not a number never does, and gives way to all others.
#[inline(always)]
pub fn is_less<T: PartialOrd>(value: &T, best: &T) -> bool {
    value < best || is_no_number(best) && !is_no_number(value)
}

/// Whether a number takes the place of the greatest one so far.
#[inline(always)]
pub fn is_greater<T: PartialOrd>(value: &T, best: &T) -> bool {
    value > best || is_no_number(best) && !is_no_number(value)
}

#[inline(always)]
fn is_no_number<T: PartialOrd>(value: &T) -> bool {
    value.partial_cmp(value).is_none()
}

/// Calls of functions that call themselves go no deeper than this, so that one without an end fails before the stack
/// of a thread is used up.
const DEEPEST_RECURSION: u32 = 500;

thread_local! {
    static DEPTH: std::cell::Cell<u32> = const { std::cell::Cell::new(0) };
}

/// One call of a function that calls itself; ends when it is dropped.
pub struct Recursion(());

impl Recursion {
    /// Goes one call deeper.
    ///
    /// # Errors
    /// When it would be too deep.
    pub fn enter(fault: Fault) -> Fallible<Self> {
        DEPTH.with(|depth| {
            if depth.get() >= DEEPEST_RECURSION {
                return Err(fault);
            }
            depth.set(depth.get() + 1);
            Ok(Self(()))
        })
    }
}

impl Drop for Recursion {
    fn drop(&mut self) {
        DEPTH.with(|depth| depth.set(depth.get() - 1));
    }
}
