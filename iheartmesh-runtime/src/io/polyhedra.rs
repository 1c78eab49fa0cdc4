//! Lists of polyhedra, and which of them are prisms and pyramids.

use super::error::{CannotWrite, counted};
use super::mesh_file::{Polygons, PolygonsIter};
use crate::element::ElementKind;

/// A list of polyhedra, each given by its faces, and each face by the numbers (from 0) of its vertices in cyclic order,
/// counter-clockwise seen from outside: what [`CellMesh::from_polyhedra`](crate::CellMesh::from_polyhedra) takes.
///
/// Prisms and pyramids are polyhedra like any other. [`push_prism`](Self::push_prism) and
/// [`push_pyramid`](Self::push_pyramid) make them of their corners, [`prism`](Self::prism) and [`pyramid`](Self::pyramid)
/// know them again.
///
/// ```
/// use iheartmesh_runtime::io::Polyhedra;
///
/// let mut polyhedra = Polyhedra::new();
/// polyhedra.push_pyramid([0, 1, 2, 3, 4]);
/// // an octahedron
/// polyhedra.push([[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]]);
/// assert_eq!(polyhedra.len(), 2);
/// let faces: Vec<&[u32]> = polyhedra.iter().next().unwrap().collect();
/// assert_eq!(faces, [&[0, 3, 2, 1][..], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]]);
/// assert_eq!(polyhedra.pyramid(0), Some([0, 1, 2, 3, 4]));
/// assert_eq!(polyhedra.pyramid(1), None);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Polyhedra {
    /// For each polyhedron, where its faces end.
    ends: Vec<usize>,
    faces: Polygons,
}

impl Polyhedra {
    /// No polyhedra.
    pub fn new() -> Self {
        Polyhedra::default()
    }

    /// Adds a polyhedron at the end: its faces, each its vertices in cyclic order, counter-clockwise seen from outside.
    /// Whether the faces close is checked by [`CellMesh::from_polyhedra`](crate::CellMesh::from_polyhedra).
    pub fn push<F: AsRef<[u32]>>(&mut self, faces: impl IntoIterator<Item = F>) {
        for face in faces {
            self.faces.push(face.as_ref());
        }
        self.ends.push(self.faces.len());
    }

    /// Adds a prism over a triangle: the three corners of its bottom, counter-clockwise seen from its top, then the
    /// three above them. Its faces are the bottom, the top, and the quadrilaterals around.
    pub fn push_prism(&mut self, corners: [u32; 6]) {
        self.push_any_prism(&corners);
    }

    /// Adds a pyramid over a quadrilateral: the four corners of its base, counter-clockwise seen from its apex, then the
    /// apex. Its faces are the base and the triangles around.
    pub fn push_pyramid(&mut self, corners: [u32; 5]) {
        self.push_any_pyramid(&corners);
    }

    /// As [`push_prism`](Self::push_prism), over a polygon: half of the corners are those of the bottom.
    pub(super) fn push_any_prism(&mut self, corners: &[u32]) {
        let (bottom, top) = corners.split_at(corners.len() / 2);
        self.faces.push_all(backwards(bottom));
        self.faces.push(top);
        for (k, (&a, &d)) in bottom.iter().zip(top).enumerate() {
            let next = (k + 1) % bottom.len();
            self.faces.push(&[a, bottom[next], top[next], d]);
        }
        self.ends.push(self.faces.len());
    }

    /// As [`push_pyramid`](Self::push_pyramid), over a polygon: the last corner is the apex.
    pub(super) fn push_any_pyramid(&mut self, corners: &[u32]) {
        if let Some((&apex, base)) = corners.split_last() {
            self.faces.push_all(backwards(base));
            for (k, &a) in base.iter().enumerate() {
                self.faces.push(&[a, base[(k + 1) % base.len()], apex]);
            }
        }
        self.ends.push(self.faces.len());
    }

    /// Number of polyhedra.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there is no polyhedron.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The faces of polyhedron `index` (from 0), or `None` past the end.
    pub fn get(&self, index: usize) -> Option<PolygonsIter<'_>> {
        let end = *self.ends.get(index)?;
        let start = if index == 0 { 0 } else { self.ends[index - 1] };
        Some(self.faces.range(start..end))
    }

    /// The polyhedra in order, each as an iterator over its faces.
    pub fn iter(&self) -> PolyhedraIter<'_> {
        PolyhedraIter {
            polyhedra: self,
            range: 0..self.len(),
        }
    }

    /// The faces of all polyhedra, one after the other. A face between two polyhedra stands here twice.
    pub fn faces(&self) -> &Polygons {
        &self.faces
    }

    /// The corners of polyhedron `index` in the order that [`push_prism`](Self::push_prism) takes, or `None` if it is no
    /// prism over a triangle, or past the end. Its faces may stand in any order and begin at any corner.
    pub fn prism(&self, index: usize) -> Option<[u32; 6]> {
        let corners = prism(self.get(index)?)?;
        corners.try_into().ok()
    }

    /// The corners of polyhedron `index` in the order that [`push_pyramid`](Self::push_pyramid) takes, or `None` if it is
    /// no pyramid over a quadrilateral, or past the end. Its faces may stand in any order and begin at any corner.
    pub fn pyramid(&self, index: usize) -> Option<[u32; 5]> {
        let corners = pyramid(self.get(index)?)?;
        corners.try_into().ok()
    }

    pub(super) fn corners_mut(&mut self) -> &mut [u32] {
        &mut self.faces.corners
    }
}

/// The same corner first, then the others the other way round.
pub(super) fn backwards(corners: &[u32]) -> impl Iterator<Item = u32> {
    let first = corners.iter().take(1);
    first.chain(corners.iter().skip(1).rev()).copied()
}

/// The corners of a prism over a polygon of up to six corners, around the bottom, then above them, if these are its faces,
/// in any order. If they are in the order of [`Polyhedra::push_prism`], it is the corners that they were made of.
pub(super) fn prism(faces: PolygonsIter<'_>) -> Option<Vec<u32>> {
    let n = faces.len().checked_sub(2).filter(|n| (3..=6).contains(n))?;
    if let Some(corners) = ordered_prism(faces.clone()) {
        return Some(corners);
    }
    let (place, bottom) = faces
        .clone()
        .enumerate()
        .find(|(_, face)| face.len() == n)?;
    let mut corners: Vec<u32> = backwards(bottom).collect();
    for k in 0..n {
        let edge = [corners[k], corners[(k + 1) % n]];
        let is_side = |(other, face): &(usize, &[u32])| *other != place && face.len() == 4;
        // the side that runs along the edge, and what stands above its first corner
        let mut sides = faces.clone().enumerate().filter(is_side);
        let above = sides.find_map(|(_, face)| {
            let start = (0..4).find(|&k| [face[k], face[(k + 1) % 4]] == edge)?;
            Some(face[(start + 3) % 4])
        });
        corners.push(above?);
    }
    are_faces_of(&corners, Polyhedra::push_any_prism, faces).then_some(corners)
}

/// As [`prism`], over any polygon, but only if the faces are in the order of [`Polyhedra::push_prism`].
pub(super) fn ordered_prism(faces: PolygonsIter<'_>) -> Option<Vec<u32>> {
    let mut both = faces.clone();
    let (first, second) = (both.next()?, both.next()?);
    let is_one = first.len() >= 3 && first.len() == second.len();
    let corners: Vec<u32> = backwards(first).chain(second.iter().copied()).collect();
    (is_one
        && made_of(&corners, Polyhedra::push_any_prism)
            .iter()
            .eq(faces))
    .then_some(corners)
}

/// The corners of a pyramid over a triangle or a quadrilateral, around the base, then the apex, if these are its faces, in
/// any order. If they are in the order of [`Polyhedra::push_pyramid`], it is the corners that they were made of.
pub(super) fn pyramid(faces: PolygonsIter<'_>) -> Option<Vec<u32>> {
    let n = faces.len().checked_sub(1).filter(|n| (3..=4).contains(n))?;
    if let Some(corners) = ordered_pyramid(faces.clone()) {
        return Some(corners);
    }
    let base = faces.clone().find(|face| face.len() == n)?;
    let mut all = faces.clone().flatten();
    let apex = all.find(|corner| !base.contains(corner))?;
    let corners: Vec<u32> = backwards(base).chain([*apex]).collect();
    are_faces_of(&corners, Polyhedra::push_any_pyramid, faces).then_some(corners)
}

/// As [`pyramid`], over any polygon, but only if the faces are in the order of [`Polyhedra::push_pyramid`].
pub(super) fn ordered_pyramid(faces: PolygonsIter<'_>) -> Option<Vec<u32>> {
    let mut both = faces.clone();
    let (base, side) = (both.next()?, both.next()?);
    let corners: Vec<u32> = backwards(base).chain(side.last().copied()).collect();
    let is_one = base.len() >= 3 && corners.len() == base.len() + 1;
    (is_one
        && made_of(&corners, Polyhedra::push_any_pyramid)
            .iter()
            .eq(faces))
    .then_some(corners)
}

/// The faces of the cell that is made of these corners.
fn made_of(corners: &[u32], push: impl Fn(&mut Polyhedra, &[u32])) -> Polygons {
    let mut made = Polyhedra::new();
    push(&mut made, corners);
    made.faces
}

/// Whether the cell that is made of these corners has these faces, in any order.
pub(super) fn are_faces_of(
    corners: &[u32],
    push: impl Fn(&mut Polyhedra, &[u32]),
    faces: PolygonsIter<'_>,
) -> bool {
    let made = made_of(corners, push);
    let lengths = |faces: PolygonsIter<'_>| faces.map(<[u32]>::len).sum::<usize>();
    let cycles = |faces: PolygonsIter<'_>| {
        let mut cycles: Vec<Vec<u32>> = faces.map(cycle).collect();
        cycles.sort_unstable();
        cycles
    };
    made.len() == faces.len()
        && lengths(made.iter()) == lengths(faces.clone())
        && cycles(made.iter()) == cycles(faces)
}

/// The least of all ways to write a cycle down.
fn cycle(corners: &[u32]) -> Vec<u32> {
    let least = corners.iter().min();
    let starts = (0..corners.len()).filter(|&k| Some(&corners[k]) == least);
    let rotated = starts.map(|k| [&corners[k..], &corners[..k]].concat());
    rotated.min().unwrap_or_default()
}

/// What polyhedra in files have at least.
pub(super) const LEAST: &str =
    "a polyhedron has at least four faces, and a face at least three corners";

/// What a polyhedron has too few of, as the end of a sentence about it.
pub(super) fn problem<'a>(faces: impl ExactSizeIterator<Item = &'a [u32]>) -> Option<String> {
    let n_faces = faces.len();
    let too_small = faces.enumerate().find(|(_, face)| face.len() < 3);
    match too_small {
        _ if n_faces < 4 => Some(format!("has {}", counted(n_faces, ElementKind::Face))),
        Some((index, face)) => Some(format!("has a face {index} with {} corners", face.len())),
        None => None,
    }
}

/// A polyhedron that formats without polyhedra hold.
pub(super) enum Simple {
    Prism([u32; 6]),
    Pyramid([u32; 5]),
}

/// All polyhedra for a format that holds prisms and pyramids only.
pub(super) fn simple(polyhedra: &Polyhedra, format: &str) -> Result<Vec<Simple>, CannotWrite> {
    let simple = |index| {
        let triangular = polyhedra.prism(index).map(Simple::Prism);
        let simple = triangular.or_else(|| polyhedra.pyramid(index).map(Simple::Pyramid));
        simple.ok_or_else(|| {
            let faces = || polyhedra.get(index);
            let n_corners = |cell: Option<Vec<u32>>| cell.map(|corners| corners.len());
            let kind = match (
                n_corners(faces().and_then(pyramid)),
                n_corners(faces().and_then(prism)),
            ) {
                (Some(4), _) => "tetrahedron",
                (_, Some(8)) => "hexahedron",
                _ => {
                    return CannotWrite {
                        problem: format!(
                            "a {format} file cannot hold polyhedron {index}, which is neither a prism over a triangle nor a \
                             pyramid over a quadrilateral"
                        ),
                        help: "write a .vtk file",
                    };
                }
            };
            CannotWrite {
                problem: format!(
                    "a {format} file cannot hold polyhedron {index}, which is a {kind} but not in the list of these"
                ),
                help: "make the mesh with tetrahedra first, then hexahedra, then all others, or write a .vtk file",
            }
        })
    };
    (0..polyhedra.len()).map(simple).collect()
}

/// Iterator over [`Polyhedra`]: for each, one over its faces.
#[derive(Clone, Debug)]
pub struct PolyhedraIter<'a> {
    polyhedra: &'a Polyhedra,
    range: std::ops::Range<usize>,
}

impl<'a> Iterator for PolyhedraIter<'a> {
    type Item = PolygonsIter<'a>;

    fn next(&mut self) -> Option<PolygonsIter<'a>> {
        self.polyhedra.get(self.range.next()?)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.range.size_hint()
    }
}

impl ExactSizeIterator for PolyhedraIter<'_> {}

impl<'a> IntoIterator for &'a Polyhedra {
    type Item = PolygonsIter<'a>;
    type IntoIter = PolyhedraIter<'a>;

    fn into_iter(self) -> PolyhedraIter<'a> {
        self.iter()
    }
}

impl<P, F> FromIterator<P> for Polyhedra
where
    P: IntoIterator<Item = F>,
    F: AsRef<[u32]>,
{
    fn from_iter<I: IntoIterator<Item = P>>(polyhedra: I) -> Self {
        let mut all = Polyhedra::new();
        for polyhedron in polyhedra {
            all.push(polyhedron);
        }
        all
    }
}
