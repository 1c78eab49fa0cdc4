//! Any numbers as edges, triangles, polygons, tetrahedra, hexahedra, polyhedra or boundary matrices: a mesh that keeps its own
//! rules, or an error.

#![no_main]

use iheartmesh_runtime::complex::CellComplex;
use iheartmesh_runtime::sprs::CsMatI;
use iheartmesh_runtime::{BoundaryMatrix, CellMesh, EdgeMesh, FaceMesh, MeshError};
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

/// The same for cells, and that their surface is closed.
fn check_cells(mesh: &CellMesh) {
    for k in 1..3 {
        let product = mesh.boundary(k) * mesh.boundary(k + 1);
        assert!(product.data().iter().all(|entry| *entry == 0));
    }
    for cell in mesh.cells() {
        assert!(!mesh.cell_boundary(cell).0.is_empty() && !mesh.cell_vertices(cell).is_empty());
    }
    for face in mesh.faces() {
        assert!(mesh.face_cells(face).len() <= mesh.n_cells());
    }
    let (boundary, faces) = mesh.boundary_mesh().expect("faces of a mesh are a mesh");
    assert_eq!(boundary.n_faces(), faces.len());
    assert!(mesh.n_components() <= mesh.n_vertices());
    mesh.is_consistently_oriented();
    mesh.euler_characteristic();
}

fn check_edges(mesh: &EdgeMesh) {
    for edge in mesh.edges() {
        let [tail, head] = mesh.edge_vertices(edge);
        assert!(tail != head && mesh.vertex_edges(tail).len() > 0);
    }
    assert!(mesh.n_components() <= mesh.n_vertices());
}

fn polygons(reader: &mut Reader) -> Vec<Vec<u32>> {
    let mut polygons = Vec::new();
    while !reader.0.is_empty() {
        let corners = reader.next() % 8;
        polygons.push((0..corners).map(|_| reader.index()).collect());
    }
    polygons
}

fn lists<const N: usize>(reader: &mut Reader) -> Vec<[u32; N]> {
    let mut lists = Vec::new();
    while !reader.0.is_empty() {
        lists.push(std::array::from_fn(|_| reader.index()));
    }
    lists
}

fn mesh(reader: &mut Reader) -> Result<(), MeshError> {
    let n_vertices = reader.next() as usize % 32;
    match reader.next() % 8 {
        0 => check(&FaceMesh::from_triangles(n_vertices, &lists(reader))?),
        1 => check(&FaceMesh::from_polygons(n_vertices, &polygons(reader))?),
        2 => check_edges(&EdgeMesh::from_edges(n_vertices, &lists(reader))?),
        3 => check_cells(&CellMesh::from_tetrahedra(n_vertices, &lists(reader))?),
        4 => check_cells(&CellMesh::from_hexahedra(n_vertices, &lists(reader))?),
        5 => {
            // some faces to each cell
            let n_faces = reader.next() as usize % 8 + 1;
            let faces = polygons(reader);
            let cells: Vec<&[Vec<u32>]> = faces.chunks(n_faces).collect();
            check_cells(&CellMesh::from_polyhedra(n_vertices, &cells)?);
        }
        6 => {
            let (first, second) = (reader.matrix(), reader.matrix());
            if let Ok(mesh) = EdgeMesh::from_boundary_matrices(&first) {
                check_edges(&mesh);
            }
            check(&FaceMesh::from_boundary_matrices(&first, &second)?);
        }
        _ => {
            let (first, second, third) = (reader.matrix(), reader.matrix(), reader.matrix());
            let _ = CellComplex::from_boundary_matrices(&[&first, &second, &third]);
            check_cells(&CellMesh::from_boundary_matrices(&first, &second, &third)?);
        }
    }
    Ok(())
}

fuzz_target!(|bytes: &[u8]| {
    if let Err(error) = mesh(&mut Reader(bytes)) {
        drop(error.to_string());
    }
});
