//! Any numbers as triangles, polygons or boundary matrices: a mesh that keeps its own rules, or an error.

#![no_main]

use iheartmesh_runtime::complex::CellComplex;
use iheartmesh_runtime::sprs::CsMatI;
use iheartmesh_runtime::{BoundaryMatrix, FaceMesh, MeshError};
use libfuzzer_sys::fuzz_target;

/// Reads numbers from bytes, zeros after the end.
struct Reader<'a>(&'a [u8]);

impl Reader<'_> {
    fn next(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else {
            return 0;
        };
        self.0 = rest;
        *first
    }

    /// Mostly small numbers, as they come in meshes; a byte of 255 begins any number.
    fn index(&mut self) -> u32 {
        match self.next() {
            255 => u32::from_le_bytes([self.next(), self.next(), self.next(), self.next()]),
            byte => u32::from(byte) % 24,
        }
    }

    /// A matrix whose storage is well-formed and whose entries are anything.
    fn matrix(&mut self) -> BoundaryMatrix {
        let (rows, columns) = (self.next() % 12, self.next() % 12);
        let mut pointers = vec![0_u32];
        let (mut indices, mut data) = (Vec::new(), Vec::new());
        for _ in 0..columns {
            let mut row = 0;
            while row < rows && self.next() % 4 != 0 {
                row += self.next() % 4;
                if row < rows {
                    indices.push(u32::from(row));
                    data.push([1, -1, 1, -1, 1, -1, 0, 2][self.next() as usize % 8]);
                }
                row += 1;
            }
            pointers.push(indices.len() as u32);
        }
        let shape = (rows as usize, columns as usize);
        let matrix = CsMatI::try_new_csc(shape, pointers, indices, data);
        let matrix = matrix.unwrap_or_else(|(.., error)| panic!("well-formed: {error}"));
        match self.next() % 2 {
            0 => matrix,
            _ => matrix.to_csr(),
        }
    }
}

/// ∂∂ = 0, and every question has an answer.
fn check(mesh: &FaceMesh) {
    let product = mesh.boundary(1) * mesh.boundary(2);
    assert!(product.data().iter().all(|entry| *entry == 0));
    for edge in mesh.edges() {
        let [tail, head] = mesh.edge_vertices(edge);
        assert!(tail != head);
        assert!(mesh.vertex_edges(tail).len() > 0 && mesh.vertex_edges(head).len() > 0);
        let _ = mesh.edge_faces(edge);
    }
    for face in mesh.faces() {
        assert!(mesh.face_edges(face).len() == mesh.face_vertices(face).len());
    }
    let parts = mesh.n_vertices() as i64 - mesh.n_edges() as i64 + mesh.n_faces() as i64;
    assert_eq!(mesh.euler_characteristic(), parts);
    assert!(mesh.n_components() <= mesh.n_vertices());
    let closed = mesh.boundary_edges().is_empty();
    assert!(!mesh.is_closed() || closed);
    mesh.is_consistently_oriented();
    mesh.is_orientable();
    mesh.non_manifold_edges();
    mesh.isolated_vertices();
    mesh.boundary_vertices();
}

fn mesh(reader: &mut Reader) -> Result<FaceMesh, MeshError> {
    let n_vertices = reader.next() as usize % 32;
    match reader.next() % 3 {
        0 => {
            let mut triangles = Vec::new();
            while !reader.0.is_empty() {
                triangles.push([reader.index(), reader.index(), reader.index()]);
            }
            FaceMesh::from_triangles(n_vertices, &triangles)
        }
        1 => {
            let mut polygons = Vec::new();
            while !reader.0.is_empty() {
                let corners = reader.next() % 8;
                polygons.push((0..corners).map(|_| reader.index()).collect::<Vec<_>>());
            }
            FaceMesh::from_polygons(n_vertices, &polygons)
        }
        _ => {
            let (first, second, third) = (reader.matrix(), reader.matrix(), reader.matrix());
            let _ = CellComplex::from_boundary_matrices(&[&first, &second, &third]);
            FaceMesh::from_boundary_matrices(&first, &second)
        }
    }
}

fuzz_target!(|bytes: &[u8]| {
    match mesh(&mut Reader(bytes)) {
        Ok(mesh) => check(&mesh),
        Err(error) => drop(error.to_string()),
    }
});
