//! The order in which the rows of a plan are made.

use std::hint::black_box;
use std::ops::Range;

use super::{Faces, Rows};
use crate::complex::CellComplex;
use crate::order::VertexOrder;

/// So many keys are read at once where they are not in the order of memory.
const BATCH: u32 = 16;

/// The keys of a plan: the elements below a number, in their order or in one that is easier on memory.
#[derive(Clone, Copy, Debug)]
pub struct Keys<'a>(Option<&'a VertexOrder>);

impl<'a> Keys<'a> {
    /// The vertices of a mesh, neighbours near each other.
    pub fn vertices(complex: &'a CellComplex) -> Self {
        Self(complex.vertex_order())
    }

    /// Elements in the order of their numbers.
    pub fn in_order() -> Self {
        Self(None)
    }

    /// The keys at some places.
    #[inline]
    pub fn at(self, places: Range<u32>) -> impl Iterator<Item = u32> {
        places.map(move |place| match self.0 {
            None => place,
            Some(order) => order.vertices[place as usize],
        })
    }

    /// The same, reading what a mesh says of the faces around some keys all at once, where they are not in the order of memory.
    #[inline]
    pub fn at_with_faces(
        self,
        mesh: &'a impl Faces,
        places: Range<u32>,
    ) -> impl Iterator<Item = u32> {
        let end = places.end;
        places.step_by(BATCH as usize).flat_map(move |start| {
            let places = start..end.min(start + BATCH);
            if self.0.is_some() {
                black_box(self.at(places.clone()).fold(0, |all, vertex| {
                    let faces = mesh.faces_around(vertex).iter();
                    faces.fold(all, |all, face| all ^ mesh.touch(*face))
                }));
            }
            self.at(places)
        })
    }

    /// The vertices in this order, where it is not that of their numbers.
    pub(super) fn vertices_in_order(self) -> Option<&'a [u32]> {
        self.0.map(|order| &order.vertices[..])
    }

    /// The place of each key, where it is not its number.
    pub(super) fn rank(self) -> Option<&'a [u32]> {
        self.0.map(|order| &order.rank[..])
    }

    /// A table whose rows were made in this order, in the order of the numbers of the keys.
    pub fn sorted<T: Rows>(self, table: T) -> T {
        match self.0 {
            None => table,
            Some(order) => table.taken(&order.rank),
        }
    }
}
