//! Indices that the host counts from 0, as attributes of declarations say.

use nalgebra::{DMatrix, DVector, SMatrix};

use crate::{Set, SetItem};

/// Values with integers in them that the host counts from 0 and formulas count from 1.
pub trait FromHost {
    /// Where the value is, counted from 1.
    type Counted;
    /// Each integer plus one.
    fn from_host(&self) -> Self::Counted;
}

impl FromHost for i64 {
    type Counted = i64;
    fn from_host(&self) -> i64 {
        self.saturating_add(1)
    }
}

impl<T: FromHost> FromHost for [T] {
    type Counted = Vec<T::Counted>;
    fn from_host(&self) -> Self::Counted {
        self.iter().map(T::from_host).collect()
    }
}

impl<T: FromHost + SetItem> FromHost for Set<T>
where
    T::Counted: SetItem,
{
    type Counted = Set<T::Counted>;
    fn from_host(&self) -> Self::Counted {
        self.iter().map(T::from_host).collect()
    }
}

impl FromHost for DVector<i64> {
    type Counted = Self;
    fn from_host(&self) -> Self {
        self.map(|entry| entry.from_host())
    }
}

impl FromHost for DMatrix<i64> {
    type Counted = Self;
    fn from_host(&self) -> Self {
        self.map(|entry| entry.from_host())
    }
}

impl<const R: usize, const C: usize> FromHost for SMatrix<i64, R, C> {
    type Counted = Self;
    fn from_host(&self) -> Self {
        self.map(|entry| entry.from_host())
    }
}

macro_rules! tuple {
    ($($item:ident $place:tt),*) => {
        impl<$($item: FromHost),*> FromHost for ($($item,)*) {
            type Counted = ($($item::Counted,)*);
            fn from_host(&self) -> Self::Counted {
                ($(self.$place.from_host(),)*)
            }
        }
    };
}

tuple!(A 0, B 1);
tuple!(A 0, B 1, C 2);
tuple!(A 0, B 1, C 2, D 3);
