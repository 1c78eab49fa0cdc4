//! [`FaceMesh`]: a polygon mesh.

use std::fmt::{self, Debug};
use std::sync::Arc;

use rayon::prelude::*;

use super::MeshError;
use super::accessors::{accessors, face_accessors};
use super::polygon_edges::{self, MAX_CORNERS, Polygons};
use crate::boundary::{BoundaryMatrix, MAX_ELEMENTS};
use crate::complex::CellComplex;
use crate::element::{Edge, ElementKind, ElementSlice, Elements, Face, Vertex};

/// A mesh of polygons: vertices, edges and faces with the boundary matrices ∂¹ and ∂².
///
/// Only connectivity, no positions. A mesh never changes; clones share its memory.
///
/// **Numbering.** Vertices and faces keep the order of the input. Edges are numbered lexicographically by their two
/// vertices, the smaller first, and oriented from the smaller vertex (tail) to the larger (head), except in a mesh made
/// [from boundary matrices](Self::from_boundary_matrices), which keeps theirs.
///
/// **Signs.** ∂¹(v, e) is −1 at the tail of e and +1 at its head. ∂²(e, f) is +1 if the cyclic order of f runs along e
/// from tail to head and −1 if it runs against it.
///
/// **What is allowed.** A face is a closed walk over three or more vertices that meets none twice. Beyond that anything
/// goes: boundaries, edges with more than two faces, faces of opposite winding, the same face twice, vertices without
/// faces. [`is_closed`](Self::is_closed), [`non_manifold_edges`](Self::non_manifold_edges) and their kind tell.
///
/// Accessors panic if given an element that the mesh does not have, as indexing a slice does.
#[derive(Clone)]
pub struct FaceMesh {
    data: Arc<Data>,
}

struct Data {
    complex: CellComplex,
    /// Corners of all faces in cyclic order; those of face f stand where column f of ∂² stands.
    corners: Vec<u32>,
    all_triangles: bool,
}

impl FaceMesh {
    /// The mesh of triangles given by their vertices (numbers from 0) in cyclic order.
    ///
    /// Linear time in the number of vertices and triangles; uses rayon's threads on large meshes.
    ///
    /// # Errors
    /// - [`MeshError::VertexOutOfRange`] if a triangle names a vertex that is not below `n_vertices`;
    /// - [`MeshError::RepeatedVertex`] if one names a vertex twice;
    /// - [`MeshError::TooManyElements`], [`MeshError::TooManyCorners`] if 32 bits cannot number the elements.
    ///
    /// Of several bad faces the first is reported.
    pub fn from_triangles(
        n_vertices: usize,
        triangles: &[[u32; 3]],
    ) -> Result<FaceMesh, MeshError> {
        check_sizes(n_vertices, 3 * triangles.len())?;
        check_triangles(n_vertices, triangles)?;
        Ok(Self::from_valid(
            n_vertices,
            Vec::new(),
            triangles.as_flattened().to_vec(),
            true,
        ))
    }

    /// The mesh of polygons given by their vertices (numbers from 0) in cyclic order.
    ///
    /// ```
    /// # use iheartmesh_runtime::FaceMesh;
    /// //   4───3
    /// //   │   │ ╲
    /// //   0───1───2
    /// let faces: [&[u32]; 2] = [&[0, 1, 3, 4], &[1, 2, 3]];
    /// let mesh = FaceMesh::from_polygons(5, faces)?;
    /// assert_eq!((mesh.n_edges(), mesh.n_faces()), (6, 2));
    /// # Ok::<(), iheartmesh_runtime::MeshError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`from_triangles`](Self::from_triangles), and [`MeshError::TooFewCorners`] if a face has fewer than
    /// three vertices.
    pub fn from_polygons<I>(n_vertices: usize, faces: I) -> Result<FaceMesh, MeshError>
    where
        I: IntoIterator,
        I::Item: AsRef<[u32]>,
    {
        // a polygon has three corners at least
        let faces = faces.into_iter();
        check_sizes(n_vertices, faces.size_hint().0.saturating_mul(3))?;
        let (mut starts, mut corners) = (vec![0], Vec::new());
        let mut scratch = Vec::new();
        for (face, polygon) in faces.enumerate() {
            let polygon = polygon.as_ref();
            check_sizes(n_vertices, corners.len() + polygon.len())?;
            check_face(ElementKind::Face, n_vertices, face, polygon, &mut scratch)?;
            corners.extend_from_slice(polygon);
            starts.push(corners.len() as u32);
        }
        let all_triangles = starts.windows(2).all(|range| range[1] - range[0] == 3);
        Ok(Self::from_valid(n_vertices, starts, corners, all_triangles))
    }

    fn from_valid(
        n_vertices: usize,
        starts: Vec<u32>,
        corners: Vec<u32>,
        all_triangles: bool,
    ) -> FaceMesh {
        let complex = polygon_edges::complex(Polygons {
            n_vertices,
            starts: if all_triangles { Vec::new() } else { starts },
            corners: &corners,
            all_triangles,
        });
        FaceMesh {
            data: Arc::new(Data {
                complex,
                corners,
                all_triangles,
            }),
        }
    }

    /// The mesh with these boundary matrices, in either storage order of `sprs`: `d1` is ∂¹ (vertices × edges), `d2`
    /// is ∂² (edges × faces).
    ///
    /// All numbers and orientations are those of the matrices: edges may be in any order, several may join the same two
    /// vertices, and they may run from the larger vertex to the smaller. [`face_vertices`](Self::face_vertices) starts
    /// at the smallest vertex of each face.
    ///
    /// # Errors
    /// Those of [`CellComplex::from_boundary_matrices`], and
    /// - [`MeshError::TooFewCorners`] if a column of ∂² has fewer than three entries;
    /// - [`MeshError::NotAPolygon`] if it is not one closed walk that meets each of its vertices once.
    pub fn from_boundary_matrices(
        d1: &BoundaryMatrix,
        d2: &BoundaryMatrix,
    ) -> Result<FaceMesh, MeshError> {
        check_sizes(0, d2.nnz())?;
        let complex = CellComplex::from_boundary_matrices(&[d1, d2])?;
        let mut corners = Vec::with_capacity(d2.nnz());
        for face in 0..complex.n(2) {
            walk(&complex, face, &mut corners)?;
        }
        let all_triangles =
            (0..complex.n(2)).all(|face| complex.boundary_column(2, face).0.len() == 3);
        Ok(FaceMesh {
            data: Arc::new(Data {
                complex,
                corners,
                all_triangles,
            }),
        })
    }

    /// The edges of a face, ascending: not in the order in which the face runs along them.
    #[inline]
    pub fn face_edges(&self, face: Face) -> ElementSlice<'_, Edge> {
        ElementSlice::new(self.complex().boundary_elements(2, face.index()))
    }

    /// The vertices of a face in its cyclic order, starting where the input did.
    #[inline]
    pub fn face_vertices(&self, face: Face) -> ElementSlice<'_, Vertex> {
        let range = self.complex().boundary_range(2, face.index());
        ElementSlice::new(&self.data.corners[range])
    }

    /// Whether every face has three vertices; so also in a mesh without faces.
    #[inline]
    pub fn is_triangle_mesh(&self) -> bool {
        self.data.all_triangles
    }

    /// The vertices of all faces in cyclic order, or `None` unless [every face is a triangle](Self::is_triangle_mesh).
    ///
    /// The fastest way through the faces of a triangle mesh: the number of corners is known at compile time.
    #[inline]
    pub fn triangles(&self) -> Option<&[[u32; 3]]> {
        self.data
            .all_triangles
            .then(|| self.data.corners.as_chunks().0)
    }
}

accessors! {
    FaceMesh, "matrices", complex: data.complex,
    vertices: "those without faces included",
    elements: [n_edges edges Edge 1 "edges", n_faces faces Face 2 "faces"],
    boundary: "∂ᵏ: k = 1 is vertices × edges, k = 2 is edges × faces.",
    transpose: "(∂ᵏ)ᵀ: k = 1 is edges × vertices, k = 2 is faces × edges. Entries −1 and +1, compressed columns.",
    unsigned: "|∂ᵏ|",
    which: "k is 1 or 2",
    euler: "|V| − |E| + |F|. Vertices without faces count.",
}
face_accessors!(FaceMesh);

pub(super) fn check_sizes(n_vertices: usize, n_corners: usize) -> Result<(), MeshError> {
    if n_vertices > MAX_ELEMENTS {
        return Err(MeshError::TooManyElements {
            kind: ElementKind::Vertex,
            count: n_vertices,
            maximum: MAX_ELEMENTS,
        });
    }
    if n_corners > MAX_CORNERS {
        return Err(MeshError::TooManyCorners {
            count: n_corners,
            maximum: MAX_CORNERS,
        });
    }
    Ok(())
}

/// How many triangles one thread checks at a time; fewer are checked without asking for threads.
const PARALLEL_CHUNK: usize = 1 << 14;

fn check_triangles(n_vertices: usize, triangles: &[[u32; 3]]) -> Result<(), MeshError> {
    let is_good = |&[a, b, c]: &[u32; 3]| {
        ((a.max(b).max(c) as usize) < n_vertices) & (a != b) & (b != c) & (c != a)
    };
    // without branches
    let is_good_chunk = |chunk: &[[u32; 3]]| chunk.iter().fold(true, |all, t| all & is_good(t));
    let is_good_mesh = if triangles.len() < PARALLEL_CHUNK {
        is_good_chunk(triangles)
    } else {
        triangles.par_chunks(PARALLEL_CHUNK).all(is_good_chunk)
    };
    if is_good_mesh {
        return Ok(());
    }
    for (face, triangle) in triangles.iter().enumerate() {
        check_face(
            ElementKind::Face,
            n_vertices,
            face,
            triangle,
            &mut Vec::new(),
        )?;
    }
    Ok(())
}

pub(super) fn check_face(
    kind: ElementKind,
    n_vertices: usize,
    face: usize,
    corners: &[u32],
    scratch: &mut Vec<u32>,
) -> Result<(), MeshError> {
    if let Some(corner) = corners
        .iter()
        .position(|&vertex| vertex as usize >= n_vertices)
    {
        let vertex = corners[corner];
        return Err(MeshError::VertexOutOfRange {
            kind,
            element: face,
            corner,
            vertex,
            n_vertices,
        });
    }
    if corners.len() < 3 {
        return Err(MeshError::TooFewCorners {
            kind,
            element: face,
            corners: corners.len(),
        });
    }
    let repeated = if corners.len() <= 16 {
        (1..corners.len())
            .find(|&i| corners[..i].contains(&corners[i]))
            .map(|i| corners[i])
    } else {
        scratch.clear();
        scratch.extend_from_slice(corners);
        scratch.sort_unstable();
        scratch
            .windows(2)
            .find(|pair| pair[0] == pair[1])
            .map(|pair| pair[0])
    };
    match repeated {
        Some(vertex) => Err(MeshError::RepeatedVertex {
            kind,
            element: face,
            vertex,
        }),
        None => Ok(()),
    }
}

/// Appends the vertices of a face in cyclic order, the smallest first, by following its edges.
pub(super) fn walk(
    complex: &CellComplex,
    face: usize,
    corners: &mut Vec<u32>,
) -> Result<(), MeshError> {
    let (edges, signs) = complex.boundary_column(2, face);
    if edges.len() < 3 {
        return Err(MeshError::TooFewCorners {
            kind: ElementKind::Face,
            element: face,
            corners: edges.len(),
        });
    }
    let mut steps: Vec<(u32, u32)> = Vec::with_capacity(edges.len());
    for (&edge, &sign) in edges.iter().zip(signs) {
        let (vertices, entries) = complex.boundary_column(1, edge as usize);
        let (from, to) = if entries[0] * sign < 0 {
            (0, 1)
        } else {
            (1, 0)
        };
        steps.push((vertices[from], vertices[to]));
    }
    steps.sort_unstable();
    let start = corners.len();
    let mut vertex = steps[0].0;
    for _ in 0..steps.len() {
        corners.push(vertex);
        match steps.binary_search_by_key(&vertex, |&(from, _)| from) {
            Ok(step) => vertex = steps[step].1,
            Err(_) => return Err(MeshError::NotAPolygon { face }),
        }
    }
    // One closed walk over all steps, each from a vertex of its own.
    let is_repeated = steps.windows(2).any(|pair| pair[0].0 == pair[1].0);
    let returns_early = corners[start + 1..].contains(&steps[0].0);
    if is_repeated || returns_early || vertex != steps[0].0 {
        return Err(MeshError::NotAPolygon { face });
    }
    Ok(())
}
