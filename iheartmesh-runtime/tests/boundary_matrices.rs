//! Meshes from boundary matrices: the numbering given is kept, and whatever is no mesh is an error.

use iheartmesh_runtime::complex::CellComplex;
use iheartmesh_runtime::{BoundaryMatrix, Edge, Face, FaceMesh, MeshError, Vertex};

/// The matrix with these rows, in compressed columns; zeros are left out.
fn matrix<const M: usize, const N: usize>(rows: [[i8; N]; M]) -> BoundaryMatrix {
    let mut triplets = sprs::TriMatI::<i8, u32>::new((M, N));
    for (i, row) in rows.iter().enumerate() {
        for (j, &value) in row.iter().enumerate().filter(|(_, value)| **value != 0) {
            triplets.add_triplet(i, j, value);
        }
    }
    triplets.to_csc()
}

fn d1() -> BoundaryMatrix {
    // 2           edges 0: 2→0, 1: 0→1, 2: 2→1, in no particular order
    // │ ╲
    // 0 ─ 1
    matrix([[1, -1, 0], [0, 1, 1], [-1, 0, -1]])
}

#[test]
fn the_given_numbering_is_kept() {
    let d2 = matrix([[1], [1], [-1]]);
    for (d1, d2) in [(d1(), d2.clone()), (d1().to_csr(), d2.to_csr())] {
        let mesh = FaceMesh::from_boundary_matrices(&d1, &d2).unwrap();
        let edges = mesh
            .edges()
            .map(|edge| mesh.edge_vertices(edge).map(Vertex::id));
        assert_eq!(edges.collect::<Vec<_>>(), [[2, 0], [0, 1], [2, 1]]);
        assert_eq!(mesh.complex().coboundary_elements(1, 2), [0, 2]);
        assert_eq!(mesh.face_vertices(Face::new(0)), [0, 1, 2].map(Vertex::new));
        assert_eq!(mesh.face_boundary(Face::new(0)).1, [1, 1, -1]);
        assert_eq!(mesh.vertex_edges(Vertex::new(1)), [1, 2].map(Edge::new));
        assert!(mesh.boundary(1).is_csc() && mesh.is_triangle_mesh());
    }
}

#[test]
fn matrices_of_a_mesh_give_the_mesh_back() {
    let faces: [&[u32]; 3] = [&[0, 1, 3, 4], &[1, 2, 3], &[2, 5, 6, 7, 3]];
    let mesh = FaceMesh::from_polygons(9, faces).unwrap();
    let again = FaceMesh::from_boundary_matrices(mesh.boundary(1), mesh.boundary(2)).unwrap();
    for k in [1, 2] {
        assert_eq!(mesh.boundary(k), again.boundary(k));
        assert_eq!(mesh.boundary_transpose(k), again.boundary_transpose(k));
    }
    // The same faces and directions; each now starts at its smallest vertex.
    for face in mesh.faces() {
        assert_eq!(
            mesh.face_vertices(face),
            again.face_vertices(face).to_vec()[..]
        );
    }
}

#[test]
fn what_is_no_mesh_is_an_error() {
    let d2 = matrix([[1], [1], [-1]]);
    let error = |d1: &BoundaryMatrix, d2: &BoundaryMatrix| {
        FaceMesh::from_boundary_matrices(d1, d2).unwrap_err()
    };

    let shape = error(&d1(), &matrix([[1], [1]]));
    assert_eq!(
        shape,
        MeshError::ShapeMismatch {
            k: 2,
            rows: 2,
            expected: 3
        }
    );
    assert_eq!(
        shape.to_string(),
        "∂2 has 2 rows, but ∂1 has 3 columns; both count the elements of dimension 1"
    );

    let entry = error(&d1(), &matrix([[1], [2], [-1]]));
    assert_eq!(
        entry,
        MeshError::InvalidEntry {
            k: 2,
            row: 1,
            column: 0,
            value: 2
        }
    );
    let smallest = error(&d1(), &matrix([[1], [i8::MIN], [-1]]));
    assert!(matches!(
        smallest,
        MeshError::InvalidEntry { value: i8::MIN, .. }
    ));
    let zero = BoundaryMatrix::new_csc((3, 1), vec![0, 3], vec![0, 1, 2], vec![1, 0, -1]);
    assert!(matches!(
        error(&d1(), &zero),
        MeshError::InvalidEntry { value: 0, .. }
    ));

    for bad in [
        [[1, 1, 0], [0, 1, 1], [-1, 0, -1]],
        [[0, -1, 0], [0, 1, 1], [-1, 0, -1]],
        [[1, -1, 0], [1, 1, 1], [-1, 0, -1]],
    ] {
        assert!(matches!(
            error(&matrix(bad), &d2),
            MeshError::InvalidEdge { .. }
        ));
    }

    let open = error(&d1(), &matrix([[1], [1], [1]]));
    assert_eq!(
        open.to_string(),
        "the boundary of face 0 has a boundary (the product of the two boundary matrices is not zero); check the signs \
         of its column"
    );
    assert!(matches!(
        error(&d1(), &matrix([[0], [0], [0]])),
        MeshError::TooFewCorners { corners: 0, .. }
    ));
}

#[test]
fn a_face_is_one_closed_walk() {
    let triangles = [[0, 1, 2], [2, 3, 4], [5, 6, 7]];
    let mesh = FaceMesh::from_triangles(8, &triangles).unwrap();
    // Faces that touch in a vertex, and faces apart, written into one column: cycles, but no polygons.
    for (first, second) in [(0, 1), (0, 2)] {
        let mut column = [0_i8; 9];
        for face in [first, second] {
            let (rows, signs) = mesh.complex().boundary_column(2, face);
            rows.iter()
                .zip(signs)
                .for_each(|(&row, &sign)| column[row as usize] = sign);
        }
        let d2 = matrix(column.map(|sign| [sign]));
        assert_eq!(
            FaceMesh::from_boundary_matrices(mesh.boundary(1), &d2).unwrap_err(),
            MeshError::NotAPolygon { face: 0 }
        );
        assert!(CellComplex::from_boundary_matrices(&[mesh.boundary(1), &d2]).is_ok());
    }
}

#[test]
fn a_complex_may_have_any_dimension_up_to_three() {
    // One tetrahedron: faces 0: 012, 1: 013, 2: 023, 3: 123.
    let faces = FaceMesh::from_triangles(4, &[[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]).unwrap();
    let (d1, d2) = (faces.boundary(1).clone(), faces.boundary(2).clone());
    let d3 = matrix([[-1], [1], [-1], [1]]);
    let complex = CellComplex::from_boundary_matrices(&[&d1, &d2, &d3]).unwrap();
    assert_eq!(
        (
            complex.dimension(),
            complex.n(3),
            complex.euler_characteristic()
        ),
        (3, 1, 1)
    );
    assert_eq!(
        complex.boundary_column(3, 0),
        (&[0, 1, 2, 3][..], &[-1, 1, -1, 1][..])
    );
    assert_eq!(complex.coboundary_column(3, 2), (&[0][..], &[-1][..]));

    let error = CellComplex::from_boundary_matrices(&[&d1, &d2, &matrix([[1], [1], [-1], [1]])])
        .unwrap_err();
    assert!(matches!(error, MeshError::NotAComplex { element: 0, .. }));
    assert_eq!(
        CellComplex::from_boundary_matrices(&[&d1])
            .unwrap()
            .dimension(),
        1
    );
    assert_eq!(
        CellComplex::from_boundary_matrices(&[]).unwrap_err(),
        MeshError::NumberOfMatrices { found: 0 }
    );
}
