//! Sets of elements by their numbers: sorted, without repetitions, small ones without allocation.

use smallvec::SmallVec;

use crate::complex::CellComplex;
use crate::{CellularSet, Element, Set};

/// A sorted set of element numbers.
pub type Ids = SmallVec<[u32; 16]>;

/// The set with one member.
#[inline]
pub fn singleton(id: u32) -> Ids {
    let mut ids = Ids::new();
    ids.push(id);
    ids
}

/// All numbers below `n`.
pub fn all(n: usize) -> Ids {
    (0..n as u32).collect()
}

/// Sorts and removes repetitions.
#[inline]
pub fn sorted(mut ids: Ids) -> Ids {
    if ids.len() <= 32 {
        // insertion sort: the sets around an element are small
        for k in 1..ids.len() {
            let id = ids[k];
            let mut place = k;
            while place > 0 && ids[place - 1] > id {
                ids[place] = ids[place - 1];
                place -= 1;
            }
            ids[place] = id;
        }
    } else {
        ids.sort_unstable();
    }
    ids.dedup();
    ids
}

/// Members of either.
pub fn union(a: &[u32], b: &[u32]) -> Ids {
    let mut ids = Ids::with_capacity(a.len() + b.len());
    let (mut i, mut j) = (0, 0);
    while i < a.len() && j < b.len() {
        let (x, y) = (a[i], b[j]);
        ids.push(x.min(y));
        i += usize::from(x <= y);
        j += usize::from(y <= x);
    }
    ids.extend_from_slice(&a[i..]);
    ids.extend_from_slice(&b[j..]);
    ids
}

/// Members of both.
#[inline]
pub fn intersection(a: &[u32], b: &[u32]) -> Ids {
    let mut ids = Ids::new();
    let (mut i, mut j) = (0, 0);
    while i < a.len() && j < b.len() {
        let (x, y) = (a[i], b[j]);
        if x == y {
            ids.push(x);
        }
        i += usize::from(x <= y);
        j += usize::from(y <= x);
    }
    ids
}

/// Members of the first only.
#[inline]
pub fn difference(a: &[u32], b: &[u32]) -> Ids {
    let mut ids = Ids::new();
    let mut j = 0;
    for &x in a {
        while j < b.len() && b[j] < x {
            j += 1;
        }
        if j == b.len() || b[j] != x {
            ids.push(x);
        }
    }
    ids
}

/// Members of a set other than one.
#[inline]
pub fn without(a: &[u32], b: u32) -> Ids {
    let mut ids = Ids::new();
    for &x in a {
        if x != b {
            ids.push(x);
        }
    }
    ids
}

/// A set by its sorted members.
#[inline]
pub fn copied(a: &[u32]) -> Ids {
    let mut ids = Ids::new();
    // most sets are small, and copying them one by one is faster than a general copy
    match a.len() {
        0..=8 => a.iter().for_each(|id| ids.push(*id)),
        _ => ids.extend_from_slice(a),
    }
    ids
}

/// The elements in the boundary of any of a set: the rows of the columns of ∂ᵏ.
#[inline]
pub fn boundary_of(complex: &CellComplex, k: usize, set: &[u32]) -> Ids {
    gather(set, |id| complex.boundary_elements(k, id))
}

/// The elements with any of a set in their boundary: the columns of the rows of ∂ᵏ.
#[inline]
pub fn coboundary_of(complex: &CellComplex, k: usize, set: &[u32]) -> Ids {
    gather(set, |id| complex.coboundary_elements(k, id))
}

#[inline]
fn gather<'a>(set: &[u32], column: impl Fn(usize) -> &'a [u32]) -> Ids {
    // a single column is sorted already
    if let [id] = set {
        return copied(column(*id as usize));
    }
    let mut ids = Ids::new();
    for &id in set {
        for other in column(id as usize) {
            ids.push(*other);
        }
    }
    sorted(ids)
}

/// A set as the host sees it.
pub fn set_of_handles<T: Element + crate::SetItem>(ids: &[u32]) -> Set<T> {
    ids.iter().map(|id| T::new(*id)).collect()
}

/// A set from the host.
pub fn ids_of_set<T: Element + crate::SetItem>(set: &Set<T>) -> Ids {
    set.iter().map(|element| element.id()).collect()
}

/// A cellular set as the host sees it.
pub fn cellular_set((vertices, edges, faces, cells): (Ids, Ids, Ids, Ids)) -> CellularSet {
    CellularSet {
        vertices: set_of_handles(&vertices),
        edges: set_of_handles(&edges),
        faces: set_of_handles(&faces),
        cells: set_of_handles(&cells),
    }
}

/// A cellular set from the host.
pub fn ids_of_cellular_set(set: &CellularSet) -> (Ids, Ids, Ids, Ids) {
    (
        ids_of_set(&set.vertices),
        ids_of_set(&set.edges),
        ids_of_set(&set.faces),
        ids_of_set(&set.cells),
    )
}
