//! Indices that the host counts from 0, as attributes of declarations say.

use nalgebra::{DMatrix, DVector, SMatrix};

use crate::{Set, SetItem};

/// Values with integers in them that the host counts from 0 and formulas count from 1.
pub trait HostCounted {
    /// Where the value is, counted from 1.
    type Counted;
    /// Each integer plus one.
    fn counted(&self) -> Self::Counted;
}

impl HostCounted for i64 {
    type Counted = i64;
    fn counted(&self) -> i64 {
        self.saturating_add(1)
    }
}

impl<T: HostCounted> HostCounted for [T] {
    type Counted = Vec<T::Counted>;
    fn counted(&self) -> Self::Counted {
        self.iter().map(T::counted).collect()
    }
}

impl<T: HostCounted + SetItem> HostCounted for Set<T>
where
    T::Counted: SetItem,
{
    type Counted = Set<T::Counted>;
    fn counted(&self) -> Self::Counted {
        self.iter().map(T::counted).collect()
    }
}

impl HostCounted for DVector<i64> {
    type Counted = Self;
    fn counted(&self) -> Self {
        self.map(|entry| entry.counted())
    }
}

impl HostCounted for DMatrix<i64> {
    type Counted = Self;
    fn counted(&self) -> Self {
        self.map(|entry| entry.counted())
    }
}

impl<const R: usize, const C: usize> HostCounted for SMatrix<i64, R, C> {
    type Counted = Self;
    fn counted(&self) -> Self {
        self.map(|entry| entry.counted())
    }
}

macro_rules! tuple {
    ($($item:ident $place:tt),*) => {
        impl<$($item: HostCounted),*> HostCounted for ($($item,)*) {
            type Counted = ($($item::Counted,)*);
            fn counted(&self) -> Self::Counted {
                ($(self.$place.counted(),)*)
            }
        }
    };
}

tuple!(A 0, B 1);
tuple!(A 0, B 1, C 2);
tuple!(A 0, B 1, C 2, D 3);
