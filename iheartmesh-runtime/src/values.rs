//! Parameters of generated structs: owned or borrowed, as the caller likes.

use std::ops::Deref;

/// A sequence that is owned or borrowed. `&[T]`, `&Vec<T>`, `&[T; N]`, `Vec<T>` and `[T; N]` turn into it; for vectors
/// owned arrays of coordinates too.
///
/// A borrowed sequence is never cloned.
#[derive(Clone, Debug)]
pub enum Values<'a, T> {
    /// Held by the struct.
    Owned(Vec<T>),
    /// Held by the caller.
    Borrowed(&'a [T]),
}

impl<T> AsRef<[T]> for Values<'_, T> {
    #[inline]
    fn as_ref(&self) -> &[T] {
        match self {
            Values::Owned(values) => values,
            Values::Borrowed(values) => values,
        }
    }
}

impl<T> Deref for Values<'_, T> {
    type Target = [T];

    #[inline]
    fn deref(&self) -> &[T] {
        self.as_ref()
    }
}

impl<T> From<Vec<T>> for Values<'_, T> {
    fn from(values: Vec<T>) -> Self {
        Values::Owned(values)
    }
}

impl<T, const N: usize> From<[T; N]> for Values<'_, T> {
    fn from(values: [T; N]) -> Self {
        Values::Owned(values.into())
    }
}

impl<'a, T> From<&'a [T]> for Values<'a, T> {
    fn from(values: &'a [T]) -> Self {
        Values::Borrowed(values)
    }
}

impl<'a, T> From<&'a Vec<T>> for Values<'a, T> {
    fn from(values: &'a Vec<T>) -> Self {
        Values::Borrowed(values)
    }
}

impl<'a, T, const N: usize> From<&'a [T; N]> for Values<'a, T> {
    fn from(values: &'a [T; N]) -> Self {
        Values::Borrowed(values)
    }
}

macro_rules! coordinates {
    ($($vector:ident $n:literal),*) => {$(
        impl From<Vec<[f64; $n]>> for Values<'_, glam::$vector> {
            /// Coordinates, as most files and libraries hand them out.
            fn from(values: Vec<[f64; $n]>) -> Self {
                Values::Owned(values.into_iter().map(glam::$vector::from).collect())
            }
        }

        impl<const N: usize> From<[[f64; $n]; N]> for Values<'_, glam::$vector> {
            /// Coordinates, as most files and libraries hand them out.
            fn from(values: [[f64; $n]; N]) -> Self {
                Values::Owned(values.map(glam::$vector::from).into())
            }
        }
    )*};
}

coordinates!(DVec2 2, DVec3 3, DVec4 4);

/// A value that is owned or borrowed. `T` and `&T` turn into it.
#[derive(Clone, Debug)]
pub enum OwnedOrBorrowed<'a, T> {
    /// Held by the struct.
    Owned(T),
    /// Held by the caller.
    Borrowed(&'a T),
}

impl<T> AsRef<T> for OwnedOrBorrowed<'_, T> {
    #[inline]
    fn as_ref(&self) -> &T {
        match self {
            OwnedOrBorrowed::Owned(value) => value,
            OwnedOrBorrowed::Borrowed(value) => value,
        }
    }
}

impl<T> From<T> for OwnedOrBorrowed<'_, T> {
    fn from(value: T) -> Self {
        OwnedOrBorrowed::Owned(value)
    }
}

impl<'a, T> From<&'a T> for OwnedOrBorrowed<'a, T> {
    fn from(value: &'a T) -> Self {
        OwnedOrBorrowed::Borrowed(value)
    }
}
