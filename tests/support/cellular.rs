//! Sets of elements by their numbers, and cellular sets to try functions on.

use iheartmesh::{Cell, CellularSet, Edge, Face, Set, Vertex};

use super::random::Random;
use super::solids::{Parts, Solid};
use super::soups::Ids;

macro_rules! sets {
    ($($name:ident: $element:ident;)*) => {
        $(
        /// The set of the elements with these numbers.
        pub fn $name(ids: &[u32]) -> Set<$element> {
            ids.iter().copied().map($element::new).collect()
        })*
    };
}

sets! {
    vertices: Vertex;
    edges: Edge;
    faces: Face;
    cells: Cell;
}

/// The cellular set of these parts.
pub fn cellular([v, e, f, c]: &Parts) -> CellularSet {
    CellularSet {
        vertices: vertices(v),
        edges: edges(e),
        faces: faces(f),
        cells: cells(c),
    }
}

/// The numbers of a cellular set, as its `ids` has them.
pub fn numbers(parts: &Parts) -> Vec<u32> {
    cellular(parts).ids()
}

/// Sets of elements of all kinds: small ones, large ones, empty ones.
pub fn selections(solid: &Solid) -> Vec<Parts> {
    let mut random = Random(u64::from(solid.n) + 7 * solid.edges.len() as u64);
    let mut parts: Vec<Parts> = [1, 2, 3, 8, u32::MAX]
        .into_iter()
        .map(|one_of| solid.sizes().map(|size| random.subset(size, one_of)))
        .collect();
    // one element alone, of each kind
    for kind in 0..4 {
        let size = solid.sizes()[kind];
        if size > 0 {
            let mut alone = Parts::default();
            alone[kind] = vec![random.below(size)];
            parts.push(alone);
        }
    }
    parts
}

/// The elements with a part of dimension `kind` - 1, that is in exactly one of `elements`, and what these are made of.
pub fn boundary(solid: &Solid, kind: usize, elements: &[u32]) -> Parts {
    let sides = solid.touching(kind, elements, kind - 1);
    let is_boundary = |side: &u32| {
        let around = solid.touching(kind - 1, &[*side], kind);
        around.iter().filter(|k| elements.contains(k)).count() == 1
    };
    let mut parts = Parts::default();
    parts[kind - 1] = sides.into_iter().filter(is_boundary).collect();
    solid.closure(&parts)
}
