//! Handles to the elements of a mesh: [`Vertex`], [`Edge`], [`Face`] and [`Cell`].
//!
//! A handle is the number of an element within its kind, counted from 0, in a type of its own: a vertex number cannot
//! be passed where an edge number is meant. A handle does not know its mesh.
//!
//! Long lists of elements are stored as plain `u32` (they are the index arrays of sparse matrices); [`Elements`]
//! walks a whole element set and [`ElementSlice`] shows a stored list, both as handles and without a copy.

use std::fmt::{self, Debug, Display};
use std::hash::Hash;
use std::iter::FusedIterator;
use std::marker::PhantomData;
use std::ops::Range;

/// The four kinds of mesh elements, in the order of their dimension 0 to 3.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ElementKind {
    /// Dimension 0.
    Vertex,
    /// Dimension 1.
    Edge,
    /// Dimension 2.
    Face,
    /// Dimension 3.
    Cell,
}

impl ElementKind {
    /// Dimension of an element of this kind: 0 for a vertex, 1 for an edge, 2 for a face, 3 for a cell.
    #[inline]
    pub const fn dimension(self) -> usize {
        self as usize
    }
}

impl Display for ElementKind {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            ElementKind::Vertex => "vertex",
            ElementKind::Edge => "edge",
            ElementKind::Face => "face",
            ElementKind::Cell => "cell",
        })
    }
}

mod sealed {
    pub trait Sealed {}
}

/// What [`Vertex`], [`Edge`], [`Face`] and [`Cell`] have in common. Sealed: there are no other elements.
pub trait Element:
    sealed::Sealed + Copy + Ord + Hash + Debug + Display + Send + Sync + 'static
{
    /// The kind of element that this handle names.
    const KIND: ElementKind;

    /// Handle of the element with this number (from 0).
    fn new(id: u32) -> Self;

    /// Number of the element (from 0), in the width in which it is stored.
    fn id(self) -> u32;

    /// Number of the element (from 0), as an index into a slice of per-element values.
    #[inline]
    fn index(self) -> usize {
        self.id() as usize
    }
}

macro_rules! element {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        ///
        /// Ordered by number. `Debug` prints the handle as Rust writes it, `Display` as a sentence names it.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[repr(transparent)]
        pub struct $name(u32);

        impl $name {
            /// Handle of the element with this number (from 0).
            #[inline]
            pub const fn new(id: u32) -> Self {
                Self(id)
            }

            /// Number of the element (from 0), in the width in which it is stored.
            #[inline]
            pub const fn id(self) -> u32 {
                self.0
            }

            /// Number of the element (from 0), as an index into a slice of per-element values.
            #[inline]
            pub const fn index(self) -> usize {
                self.0 as usize
            }
        }

        impl sealed::Sealed for $name {}

        impl Element for $name {
            const KIND: ElementKind = ElementKind::$name;

            #[inline]
            fn new(id: u32) -> Self {
                Self(id)
            }

            #[inline]
            fn id(self) -> u32 {
                self.0
            }
        }

        impl Debug for $name {
            fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
                // On one line even in `{:#?}`: lists of handles stay readable.
                write!(formatter, concat!(stringify!($name), "({})"), self.0)
            }
        }

        impl Display for $name {
            fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(formatter, "{} {}", Self::KIND, self.0)
            }
        }
    };
}

element! {
    /// A vertex of a mesh: an element of dimension 0.
    ///
    /// ```
    /// use iheartmesh_runtime::Vertex;
    ///
    /// let v = Vertex::new(3);
    /// assert_eq!(v.index(), 3);
    /// assert_eq!(format!("{v:?}"), "Vertex(3)");
    /// assert_eq!(format!("{v}"), "vertex 3");
    /// ```
    Vertex
}
element! {
    /// An edge of a mesh: an element of dimension 1, oriented from its tail to its head.
    Edge
}
element! {
    /// A face of a mesh: an element of dimension 2, oriented by the cyclic order of its vertices.
    Face
}
element! {
    /// A cell of a mesh: an element of dimension 3.
    Cell
}

/// Iterator over consecutive elements of one kind, in ascending order.
///
/// Its length is known; it can be run from both ends and cloned.
#[derive(Clone, Debug)]
pub struct Elements<T> {
    ids: Range<u32>,
    element: PhantomData<T>,
}

impl<T: Element> Elements<T> {
    /// The elements with the numbers of `ids`.
    #[inline]
    pub fn new(ids: Range<u32>) -> Self {
        Elements {
            ids,
            element: PhantomData,
        }
    }
}

impl<T: Element> Iterator for Elements<T> {
    type Item = T;

    #[inline]
    fn next(&mut self) -> Option<T> {
        self.ids.next().map(T::new)
    }

    #[inline]
    fn size_hint(&self) -> (usize, Option<usize>) {
        self.ids.size_hint()
    }

    #[inline]
    fn nth(&mut self, n: usize) -> Option<T> {
        self.ids.nth(n).map(T::new)
    }
}

impl<T: Element> DoubleEndedIterator for Elements<T> {
    #[inline]
    fn next_back(&mut self) -> Option<T> {
        self.ids.next_back().map(T::new)
    }
}

impl<T: Element> ExactSizeIterator for Elements<T> {}
impl<T: Element> FusedIterator for Elements<T> {}

/// A borrowed list of elements of one kind: stored as `u32`, read as handles.
///
/// Two lists are equal if they name the same elements in the same order. `Debug` prints the handles.
pub struct ElementSlice<'a, T> {
    ids: &'a [u32],
    element: PhantomData<T>,
}

impl<'a, T: Element> ElementSlice<'a, T> {
    /// The elements with the numbers `ids`, in that order.
    #[inline]
    pub fn new(ids: &'a [u32]) -> Self {
        ElementSlice {
            ids,
            element: PhantomData,
        }
    }

    /// The numbers of the elements, as they are stored.
    #[inline]
    pub fn ids(self) -> &'a [u32] {
        self.ids
    }

    /// Number of elements.
    #[inline]
    pub fn len(self) -> usize {
        self.ids.len()
    }

    /// Whether there is no element.
    #[inline]
    pub fn is_empty(self) -> bool {
        self.ids.is_empty()
    }

    /// The element at `position` (from 0), or `None` past the end.
    #[inline]
    pub fn get(self, position: usize) -> Option<T> {
        self.ids.get(position).copied().map(T::new)
    }

    /// Whether `element` is in the list. Linear in its length.
    #[inline]
    pub fn contains(self, element: T) -> bool {
        self.ids.contains(&element.id())
    }

    /// The elements in order.
    #[inline]
    pub fn iter(self) -> ElementSliceIter<'a, T> {
        ElementSliceIter {
            ids: self.ids.iter(),
            element: PhantomData,
        }
    }

    /// The elements in order, copied.
    pub fn to_vec(self) -> Vec<T> {
        self.iter().collect()
    }
}

impl<T> Clone for ElementSlice<'_, T> {
    #[inline]
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for ElementSlice<'_, T> {}

impl<T> PartialEq for ElementSlice<'_, T> {
    fn eq(&self, other: &Self) -> bool {
        self.ids == other.ids
    }
}

impl<T> Eq for ElementSlice<'_, T> {}

impl<T: Element> PartialEq<[T]> for ElementSlice<'_, T> {
    fn eq(&self, other: &[T]) -> bool {
        self.len() == other.len() && self.iter().zip(other).all(|(left, &right)| left == right)
    }
}

impl<T: Element, const N: usize> PartialEq<[T; N]> for ElementSlice<'_, T> {
    fn eq(&self, other: &[T; N]) -> bool {
        *self == other[..]
    }
}

impl<T: Element> Debug for ElementSlice<'_, T> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_list().entries(self.iter()).finish()
    }
}

impl<'a, T: Element> IntoIterator for ElementSlice<'a, T> {
    type Item = T;
    type IntoIter = ElementSliceIter<'a, T>;

    #[inline]
    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

/// Iterator over the handles of an [`ElementSlice`].
#[derive(Clone, Debug)]
pub struct ElementSliceIter<'a, T> {
    ids: std::slice::Iter<'a, u32>,
    element: PhantomData<T>,
}

impl<T: Element> Iterator for ElementSliceIter<'_, T> {
    type Item = T;

    #[inline]
    fn next(&mut self) -> Option<T> {
        self.ids.next().map(|&id| T::new(id))
    }

    #[inline]
    fn size_hint(&self) -> (usize, Option<usize>) {
        self.ids.size_hint()
    }
}

impl<T: Element> DoubleEndedIterator for ElementSliceIter<'_, T> {
    #[inline]
    fn next_back(&mut self) -> Option<T> {
        self.ids.next_back().map(|&id| T::new(id))
    }
}

impl<T: Element> ExactSizeIterator for ElementSliceIter<'_, T> {}
impl<T: Element> FusedIterator for ElementSliceIter<'_, T> {}

#[cfg(test)]
mod tests {
    use super::*;

    fn roundtrip<T: Element>() {
        for id in [0, 1, 77, u32::MAX] {
            assert_eq!(T::new(id).id(), id);
            assert_eq!(T::new(id).index(), id as usize);
        }
        assert!(T::new(1) < T::new(2));
    }

    #[test]
    fn handles_keep_their_number_and_order() {
        roundtrip::<Vertex>();
        roundtrip::<Edge>();
        roundtrip::<Face>();
        roundtrip::<Cell>();
    }

    #[test]
    fn handles_print_as_documented() {
        assert_eq!(
            format!("{:?} {:?}", Vertex::new(3), Edge::new(4)),
            "Vertex(3) Edge(4)"
        );
        assert_eq!(
            format!("{:#?} {:?}", Face::new(5), Cell::new(6)),
            "Face(5) Cell(6)"
        );
        assert_eq!(
            format!("{}, {}", Vertex::new(3), Edge::new(4)),
            "vertex 3, edge 4"
        );
        assert_eq!(
            format!("{}, {}", Face::new(5), Cell::new(6)),
            "face 5, cell 6"
        );
    }

    #[test]
    fn kinds_follow_the_dimension() {
        let kinds = [Vertex::KIND, Edge::KIND, Face::KIND, Cell::KIND];
        assert_eq!(kinds.map(ElementKind::dimension), [0, 1, 2, 3]);
        assert_eq!(
            kinds.map(|kind| kind.to_string()),
            ["vertex", "edge", "face", "cell"]
        );
    }

    #[test]
    fn slices_and_ranges_give_handles() {
        let mut all = Elements::<Edge>::new(0..4);
        assert_eq!(all.len(), 4);
        assert_eq!(all.next_back(), Some(Edge::new(3)));
        assert_eq!(all.nth(1), Some(Edge::new(1)));
        assert_eq!(all.len(), 1);

        let list = ElementSlice::<Vertex>::new(&[4, 2, 9]);
        assert_eq!(list, [Vertex::new(4), Vertex::new(2), Vertex::new(9)]);
        assert_ne!(list, [Vertex::new(4)]);
        assert_eq!(list.get(1), Some(Vertex::new(2)));
        assert_eq!(list.get(3), None);
        assert!(list.contains(Vertex::new(9)) && !list.contains(Vertex::new(3)));
        assert_eq!(format!("{list:?}"), "[Vertex(4), Vertex(2), Vertex(9)]");
        assert_eq!(
            list.iter().rev().map(Vertex::id).collect::<Vec<_>>(),
            [9, 2, 4]
        );
    }
}
