//! [`Set`]: a sorted list without duplicates, the value of every set in a program.
//!
//! Elements, integers, reals, small vectors and tuples of these can stand in a set; [`SetItem`] gives each its order.

use std::cmp::Ordering;
use std::fmt::{self, Debug};

use glam::{DMat2, DMat3, DMat4, DVec2, DVec3, DVec4};

use crate::element::{Cell, Edge, Face, Vertex};

/// A value that can stand in a [`Set`]: a total order, and one stored form for each class of equal values.
///
/// Scalars are ordered by value, vectors and tuples lexicographically.
///
/// **Reals.** −0.0 is stored as 0.0, so the two are one value. NaN is ordered as in IEEE 754 `totalOrder`
/// ([`f64::total_cmp`]): one with its sign bit set before −∞, any other after +∞; NaNs of the same bits are one value.
/// A set thus keeps its order and its length whatever is put in, although NaN ≠ NaN.
pub trait SetItem: Clone {
    /// Total order of two stored values. `Equal` means that a set keeps one of them.
    fn order(&self, other: &Self) -> Ordering;

    /// The form in which the value is stored.
    #[inline]
    fn normalised(self) -> Self {
        self
    }
}

macro_rules! ordered_set_item {
    ($($name:ty),*) => {$(
        impl SetItem for $name {
            #[inline]
            fn order(&self, other: &Self) -> Ordering {
                self.cmp(other)
            }
        }
    )*};
}

// elements are their numbers, `u32`, in generated code
ordered_set_item!(Vertex, Edge, Face, Cell, i64, u32);

impl SetItem for f64 {
    #[inline]
    fn order(&self, other: &Self) -> Ordering {
        self.total_cmp(other)
    }

    #[inline]
    fn normalised(self) -> Self {
        // −0.0 + 0.0 = 0.0; every other value, NaN payloads aside, is unchanged.
        if self == 0.0 { 0.0 } else { self }
    }
}

macro_rules! vector_set_item {
    ($($name:ty),*) => {$(
        impl SetItem for $name {
            #[inline]
            fn order(&self, other: &Self) -> Ordering {
                lexicographic(self.as_ref(), other.as_ref())
            }

            #[inline]
            fn normalised(self) -> Self {
                Self::from_array(self.to_array().map(SetItem::normalised))
            }
        }
    )*};
}

vector_set_item!(DVec2, DVec3, DVec4);

/// Matrices and longer vectors: by their numbers of rows and columns, then by their entries, column by column.
macro_rules! matrix_set_item {
    ($($name:ty $(, $parameter:ident)*;)*) => {$(
        impl<T: SetItem + nalgebra::Scalar $(, const $parameter: usize)*> SetItem for $name {
            fn order(&self, other: &Self) -> Ordering {
                let entries = self.iter().zip(other.iter());
                self.shape().cmp(&other.shape()).then_with(|| {
                    entries
                        .map(|(left, right)| left.order(right))
                        .find(|ordering| ordering.is_ne())
                        .unwrap_or(Ordering::Equal)
                })
            }

            fn normalised(self) -> Self {
                self.map(SetItem::normalised)
            }
        }
    )*};
}

matrix_set_item! {
    nalgebra::DVector<T>;
    nalgebra::DMatrix<T>;
    nalgebra::SMatrix<T, R, C>, R, C;
}

macro_rules! small_matrix_set_item {
    ($($name:ty),*) => {$(
        impl SetItem for $name {
            fn order(&self, other: &Self) -> Ordering {
                lexicographic(self.as_ref(), other.as_ref())
            }

            fn normalised(self) -> Self {
                Self::from_cols_array(&self.to_cols_array().map(SetItem::normalised))
            }
        }
    )*};
}

small_matrix_set_item!(DMat2, DMat3, DMat4);

#[inline]
fn lexicographic<const N: usize>(left: &[f64; N], right: &[f64; N]) -> Ordering {
    left.iter()
        .zip(right)
        .map(|(left, right)| left.order(right))
        .find(|ordering| ordering.is_ne())
        .unwrap_or(Ordering::Equal)
}

macro_rules! tuple_set_item {
    ($($name:ident $position:tt),*) => {
        impl<$($name: SetItem),*> SetItem for ($($name,)*) {
            #[inline]
            fn order(&self, other: &Self) -> Ordering {
                Ordering::Equal$(.then_with(|| self.$position.order(&other.$position)))*
            }

            #[inline]
            fn normalised(self) -> Self {
                ($(self.$position.normalised(),)*)
            }
        }
    };
}

tuple_set_item!(A 0);
tuple_set_item!(A 0, B 1);
tuple_set_item!(A 0, B 1, C 2);
tuple_set_item!(A 0, B 1, C 2, D 3);

/// A set: its items in ascending order, each once.
///
/// Whatever it is made from is sorted and freed of duplicates. Two sets are equal if they hold the same items.
///
/// ```
/// use iheartmesh_runtime::{Set, Vertex};
///
/// let ring = Set::from([7, 2, 7, 5].map(Vertex::new));
/// assert_eq!(ring.len(), 3);
/// assert!(ring.contains(&Vertex::new(5)));
/// assert_eq!(format!("{ring:?}"), "{Vertex(2), Vertex(5), Vertex(7)}");
///
/// let lengths: Set<f64> = [0.5, -0.0, 0.0].into_iter().collect();
/// assert_eq!(lengths.as_slice(), [0.0, 0.5]);
/// ```
#[derive(Clone)]
pub struct Set<T> {
    items: Vec<T>,
}

impl<T> Set<T> {
    /// The empty set.
    #[inline]
    pub const fn new() -> Self {
        Set { items: Vec::new() }
    }

    /// Number of items.
    #[inline]
    pub fn len(&self) -> usize {
        self.items.len()
    }

    /// Whether there is no item.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// The items in ascending order.
    #[inline]
    pub fn as_slice(&self) -> &[T] {
        &self.items
    }

    /// The item at `position` (from 0) in ascending order, or `None` past the end.
    #[inline]
    pub fn get(&self, position: usize) -> Option<&T> {
        self.items.get(position)
    }

    /// The items in ascending order.
    #[inline]
    pub fn iter(&self) -> std::slice::Iter<'_, T> {
        self.items.iter()
    }

    /// The items in ascending order, as a plain list.
    #[inline]
    pub fn into_vec(self) -> Vec<T> {
        self.items
    }
}

impl<T: SetItem> Set<T> {
    /// Whether `item` is in the set, by binary search.
    #[inline]
    pub fn contains(&self, item: &T) -> bool {
        let item = item.clone().normalised();
        self.items
            .binary_search_by(|other| other.order(&item))
            .is_ok()
    }

    /// self ∪ other: the items in at least one of the two, by one merge.
    pub fn union(&self, other: &Self) -> Self {
        merge(self, other, |_| true)
    }

    /// self ∩ other: the items in both, by one merge.
    pub fn intersection(&self, other: &Self) -> Self {
        merge(self, other, |side| side == Side::Both)
    }

    /// self ∖ other: the items of this set that are not in the other, by one merge.
    pub fn difference(&self, other: &Self) -> Self {
        merge(self, other, |side| side == Side::Left)
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Side {
    Left,
    Right,
    Both,
}

#[inline]
fn merge<T: SetItem>(left: &Set<T>, right: &Set<T>, keep: impl Fn(Side) -> bool) -> Set<T> {
    let (mut left, mut right) = (left.items.as_slice(), right.items.as_slice());
    let mut items = Vec::new();
    loop {
        let side = match (left.first(), right.first()) {
            (Some(a), Some(b)) => match a.order(b) {
                Ordering::Less => Side::Left,
                Ordering::Equal => Side::Both,
                Ordering::Greater => Side::Right,
            },
            (Some(_), None) => Side::Left,
            (None, Some(_)) => Side::Right,
            (None, None) => return Set { items },
        };
        if keep(side) {
            let source = if side == Side::Right { right } else { left };
            items.push(source[0].clone());
        }
        if side != Side::Right {
            left = &left[1..];
        }
        if side != Side::Left {
            right = &right[1..];
        }
    }
}

impl<T> Default for Set<T> {
    fn default() -> Self {
        Set::new()
    }
}

impl<T> AsRef<[T]> for Set<T> {
    /// The items in ascending order.
    fn as_ref(&self) -> &[T] {
        &self.items
    }
}

impl<T: SetItem> PartialEq for Set<T> {
    fn eq(&self, other: &Self) -> bool {
        self.len() == other.len()
            && self
                .iter()
                .zip(other)
                .all(|(left, right)| left.order(right).is_eq())
    }
}

impl<T: SetItem> Eq for Set<T> {}

impl<T: Debug> Debug for Set<T> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_set().entries(&self.items).finish()
    }
}

impl<T: SetItem> From<Vec<T>> for Set<T> {
    fn from(items: Vec<T>) -> Self {
        let mut items: Vec<T> = items.into_iter().map(SetItem::normalised).collect();
        // Neighbourhoods are mostly made in order: then nothing is to be done.
        if !items.windows(2).all(|pair| pair[0].order(&pair[1]).is_lt()) {
            items.sort_unstable_by(SetItem::order);
            items.dedup_by(|left, right| left.order(right).is_eq());
        }
        Set { items }
    }
}

impl<T: SetItem> From<&[T]> for Set<T> {
    fn from(items: &[T]) -> Self {
        Set::from(items.to_vec())
    }
}

impl<T: SetItem, const N: usize> From<[T; N]> for Set<T> {
    fn from(items: [T; N]) -> Self {
        Set::from(Vec::from(items))
    }
}

impl<T: Clone> From<&Set<T>> for Set<T> {
    fn from(set: &Set<T>) -> Self {
        set.clone()
    }
}

impl<T: SetItem> FromIterator<T> for Set<T> {
    fn from_iter<I: IntoIterator<Item = T>>(items: I) -> Self {
        Set::from(Vec::from_iter(items))
    }
}

impl<T> IntoIterator for Set<T> {
    type Item = T;
    type IntoIter = std::vec::IntoIter<T>;

    fn into_iter(self) -> Self::IntoIter {
        self.items.into_iter()
    }
}

impl<'a, T> IntoIterator for &'a Set<T> {
    type Item = &'a T;
    type IntoIter = std::slice::Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.items.iter()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn integers(items: &[i64]) -> Set<i64> {
        Set::from(items)
    }

    #[test]
    fn any_source_is_sorted_and_unique() {
        let expected = [1, 2, 3];
        assert_eq!(Set::from(vec![3, 1, 2, 1]).as_slice(), expected);
        assert_eq!(Set::from([3, 1, 2, 1]).as_slice(), expected);
        assert_eq!(Set::from(&[3, 1, 2, 1][..]).as_slice(), expected);
        assert_eq!(
            [3, 1, 2, 1].into_iter().collect::<Set<i64>>().as_slice(),
            expected
        );
        assert_eq!(Set::from([1, 2, 3]).into_vec(), expected);
        assert!(Set::<i64>::default().is_empty());
    }

    #[test]
    fn operations_agree_with_their_definition() {
        // Every pair of subsets of {0, 1, 2, 3}.
        let subset =
            |bits: i64| integers(&(0..4).filter(|i| bits >> i & 1 == 1).collect::<Vec<_>>());
        for a in 0..16 {
            for b in 0..16 {
                assert_eq!(subset(a).union(&subset(b)), subset(a | b));
                assert_eq!(subset(a).intersection(&subset(b)), subset(a & b));
                assert_eq!(subset(a).difference(&subset(b)), subset(a & !b));
                assert_eq!(subset(a) == subset(b), a == b);
            }
            for item in 0..4 {
                assert_eq!(subset(a).contains(&item), a >> item & 1 == 1);
            }
        }
    }

    #[test]
    fn zeros_are_one_value_and_nan_keeps_the_order() {
        let set = Set::from([
            1.0,
            f64::NAN,
            -0.0,
            0.0,
            f64::NEG_INFINITY,
            -f64::NAN,
            f64::NAN,
            f64::INFINITY,
        ]);
        assert_eq!(set.len(), 6);
        assert!(set.get(0).is_some_and(|x| x.is_nan()));
        assert_eq!(
            &set.as_slice()[1..5],
            [f64::NEG_INFINITY, 0.0, 1.0, f64::INFINITY]
        );
        assert!(set.as_slice()[2].is_sign_positive());
        assert!(set.contains(&-0.0) && set.contains(&f64::NAN) && !set.contains(&2.0));
        assert_eq!(set, set.clone());
    }

    #[test]
    fn vectors_and_tuples_are_lexicographic() {
        let (a, b, c) = (
            DVec3::new(0.0, 1.0, 9.0),
            DVec3::new(0.0, 2.0, 0.0),
            DVec3::new(-0.0, 1.0, 9.0),
        );
        assert_eq!(Set::from([b, a, c]).as_slice(), [a, b]);
        assert_eq!(
            Set::from([DVec2::new(1.0, 0.0), DVec2::new(0.0, 1.0)]).as_slice()[0],
            DVec2::new(0.0, 1.0)
        );
        assert!(Set::from([DVec4::ONE]).contains(&DVec4::ONE));

        let (v, w) = (Vertex::new(0), Vertex::new(1));
        assert_eq!(
            Set::from([(w, -0.0), (v, 2.0), (w, 0.0), (v, 1.0)]).as_slice(),
            [(v, 1.0), (v, 2.0), (w, 0.0)]
        );
        assert_eq!(
            Set::from([(1i64, 2i64, 3i64, 4i64), (1, 2, 3, 0)]).as_slice()[0],
            (1, 2, 3, 0)
        );
        assert_eq!(
            Set::from([((2i64,), 1i64, 1i64), ((1,), 2, 2)]).as_slice()[0],
            ((1,), 2, 2)
        );
    }

    #[test]
    fn iterates_in_order() {
        let set = integers(&[2, 1]);
        assert_eq!((&set).into_iter().copied().collect::<Vec<_>>(), [1, 2]);
        assert_eq!(set.iter().rev().copied().collect::<Vec<_>>(), [2, 1]);
        assert_eq!(set.into_iter().collect::<Vec<_>>(), [1, 2]);
    }
}
