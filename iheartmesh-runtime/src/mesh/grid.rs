//! Regular grids.

use super::cell::check_sizes;
use super::edge::check_count;
use super::{CellMesh, EdgeMesh, FaceMesh, MeshError, face};
use crate::boundary::MAX_ELEMENTS;
use crate::element::ElementKind;

/// (a + 1) · (b + 1) · …, the number of vertices.
fn n_vertices(sizes: &[usize]) -> Result<usize, MeshError> {
    sizes
        .iter()
        .try_fold(1usize, |n, size| n.checked_mul(size.checked_add(1)?))
        .filter(|&n| n <= MAX_ELEMENTS)
        .ok_or(MeshError::TooManyElements {
            kind: ElementKind::Vertex,
            count: usize::MAX,
            maximum: MAX_ELEMENTS,
        })
}

impl FaceMesh {
    /// The grid of `nx` × `ny` squares. Vertex (i, j) has the number i + (nx + 1) j, square (i, j) the number i + nx j;
    /// squares run counter-clockwise where x points right and y up.
    ///
    /// # Errors
    /// [`MeshError::TooManyElements`], [`MeshError::TooManyCorners`] if 32 bits cannot number the elements.
    pub fn grid(nx: usize, ny: usize) -> Result<FaceMesh, MeshError> {
        let n = n_vertices(&[nx, ny])?;
        face::check_sizes(n, nx.saturating_mul(ny).saturating_mul(4))?;
        let vertex = |i: usize, j: usize| (i + (nx + 1) * j) as u32;
        let squares = (0..ny).flat_map(|j| {
            (0..nx).map(move |i| {
                [
                    vertex(i, j),
                    vertex(i + 1, j),
                    vertex(i + 1, j + 1),
                    vertex(i, j + 1),
                ]
            })
        });
        FaceMesh::from_polygons(n, squares)
    }
}

impl CellMesh {
    /// The grid of `nx` × `ny` × `nz` cubes. Vertex (i, j, k) has the number i + (nx + 1)(j + (ny + 1) k), cube (i, j, k)
    /// the number i + nx (j + ny k); cubes are positively oriented where x, y, z are right-handed.
    ///
    /// # Errors
    /// [`MeshError::TooManyElements`], [`MeshError::TooManyCorners`] if 32 bits cannot number the elements.
    pub fn grid(nx: usize, ny: usize, nz: usize) -> Result<CellMesh, MeshError> {
        let n = n_vertices(&[nx, ny, nz])?;
        let n_cells = nx * ny * nz;
        check_sizes(n, n_cells, n_cells.saturating_mul(24))?;
        let vertex = |i: usize, j: usize, k: usize| (i + (nx + 1) * (j + (ny + 1) * k)) as u32;
        let mut cubes = Vec::with_capacity(n_cells);
        for k in 0..nz {
            for j in 0..ny {
                for i in 0..nx {
                    let layer = |k| {
                        [
                            vertex(i, j, k),
                            vertex(i + 1, j, k),
                            vertex(i + 1, j + 1, k),
                            vertex(i, j + 1, k),
                        ]
                    };
                    let ([a, b, c, d], [e, f, g, h]) = (layer(k), layer(k + 1));
                    cubes.push([a, b, c, d, e, f, g, h]);
                }
            }
        }
        CellMesh::from_hexahedra(n, &cubes)
    }
}

impl EdgeMesh {
    /// The edges of the grid of `nx` × `ny` squares, with the same numbers of vertices and edges as
    /// [`FaceMesh::grid`] has.
    ///
    /// # Errors
    /// [`MeshError::TooManyElements`] if 32 bits cannot number the elements.
    pub fn grid(nx: usize, ny: usize) -> Result<EdgeMesh, MeshError> {
        let n = n_vertices(&[nx, ny])?;
        let vertex = |i: usize, j: usize| (i + (nx + 1) * j) as u32;
        let n_edges = nx * (ny + 1) + ny * (nx + 1);
        check_count(ElementKind::Edge, n_edges)?;
        let mut edges = Vec::with_capacity(n_edges);
        for j in 0..=ny {
            for i in 0..=nx {
                if i < nx {
                    edges.push([vertex(i, j), vertex(i + 1, j)]);
                }
                if j < ny {
                    edges.push([vertex(i, j), vertex(i, j + 1)]);
                }
            }
        }
        EdgeMesh::from_edges(n, &edges)
    }
}
