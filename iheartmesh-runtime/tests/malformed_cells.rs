//! Cell meshes that cannot be made, each with its error.

use iheartmesh_runtime::{BoundaryMatrix, CellMesh, FaceMesh, MeshError};

#[path = "../../tests/support/random.rs"]
#[allow(dead_code)]
mod random;
#[path = "../../tests/support/solids.rs"]
#[allow(dead_code)]
mod solids;

fn message(result: Result<CellMesh, MeshError>) -> String {
    result.unwrap_err().to_string()
}

#[test]
fn malformed_tetrahedra() {
    let error = CellMesh::from_tetrahedra(4, &[[0, 1, 2, 3], [0, 1, 4, 9]]);
    assert_eq!(
        message(error),
        "cell 1 names vertex 4 at corner 2, but the mesh has 4 vertices; vertices are numbered from 0"
    );
    let error = CellMesh::from_tetrahedra(4, &[[0, 1, 2, 3], [2, 3, 1, 2], [9, 9, 9, 9]]);
    assert_eq!(
        message(error),
        "cell 1 is degenerate: vertex 2 stands in it more than once; remove the cell or the repeated corner"
    );
    let error = CellMesh::from_tetrahedra(usize::MAX, &[[0, 1, 2, 3]]);
    assert!(matches!(error, Err(MeshError::TooManyElements { .. })));
    let error = CellMesh::from_hexahedra(8, &[[0, 1, 2, 3, 4, 5, 6, u32::MAX]]);
    assert!(matches!(
        error,
        Err(MeshError::VertexOutOfRange {
            element: 0,
            corner: 7,
            ..
        })
    ));
    assert_eq!(CellMesh::from_tetrahedra(0, &[]).unwrap().n_faces(), 0);
}

#[test]
fn malformed_polyhedra() {
    let mut open = solids::tetrahedron([0, 1, 2, 3]);
    open[2].reverse();
    let good = solids::hexahedron([0, 1, 2, 3, 4, 5, 6, 7]);
    let error = CellMesh::from_polyhedra(8, [&good, &open]);
    assert_eq!(
        message(error),
        "the sides of cell 1 do not close; give all of them, each counter-clockwise seen from outside"
    );
    let mut open = good.clone();
    open.pop();
    assert_eq!(
        CellMesh::from_polyhedra(8, [&open]).unwrap_err(),
        MeshError::OpenCell { cell: 0 }
    );
    let mut twice = good.clone();
    twice.push(vec![2, 1, 0, 3]);
    twice.push(vec![1, 2, 3, 0]);
    assert_eq!(
        message(CellMesh::from_polyhedra(8, [&twice])),
        "cell 0 has the same side twice; remove one of the two"
    );
    let few = [vec![0, 1, 2], vec![0, 2, 1]];
    assert_eq!(
        message(CellMesh::from_polyhedra(8, [&few])),
        "cell 0 has too few sides (2); a cell has at least four"
    );
    let line = [vec![0, 1], vec![0, 2, 1], vec![0, 2, 1], vec![0, 2, 1]];
    assert!(matches!(
        CellMesh::from_polyhedra(8, [&line]),
        Err(MeshError::TooFewCorners {
            element: 0,
            corners: 2,
            ..
        })
    ));
    let repeated = [vec![0, 1, 0], vec![0, 2, 1], vec![0, 2, 1], vec![0, 2, 1]];
    assert!(matches!(
        CellMesh::from_polyhedra(8, [&repeated]),
        Err(MeshError::RepeatedVertex {
            element: 0,
            vertex: 0,
            ..
        })
    ));
    let no_cells: [Vec<Vec<u32>>; 0] = [];
    assert!(CellMesh::from_polyhedra(usize::MAX / 2, no_cells).is_err());
}

#[test]
fn malformed_matrices() {
    let mesh = CellMesh::from_tetrahedra(5, &[[0, 1, 2, 3], [1, 2, 3, 4]]).unwrap();
    let [d1, d2, d3] = [1, 2, 3].map(|k| mesh.boundary(k).clone());
    let from = |d1: &BoundaryMatrix, d2: &BoundaryMatrix, d3: &BoundaryMatrix| {
        CellMesh::from_boundary_matrices(d1, d2, d3).unwrap_err()
    };
    // a face that one cell has with the wrong sign
    let mut wrong = d3.clone();
    *wrong.data_mut().last_mut().unwrap() *= -1;
    let error = from(&d1, &d2, &wrong);
    assert!(
        matches!(error, MeshError::NotAComplex { element: 1, .. }),
        "{error}"
    );
    let mut wrong = d2.clone();
    wrong.data_mut()[0] *= -1;
    let error = from(&d1, &wrong, &d3);
    assert!(
        matches!(error, MeshError::NotAComplex { element: 0, .. }),
        "{error}"
    );
    let mut wrong = d3.clone();
    wrong.data_mut()[0] = 2;
    let error = from(&d1, &d2, &wrong);
    assert!(
        matches!(
            error,
            MeshError::InvalidEntry {
                k: 3,
                column: 0,
                value: 2,
                ..
            }
        ),
        "{error}"
    );
    let mut wrong = d1.clone();
    wrong.data_mut()[0] = 1;
    assert!(matches!(
        from(&wrong, &d2, &d3),
        MeshError::InvalidEdge { edge: 0 }
    ));
    assert!(matches!(
        from(&d1, &d3, &d2),
        MeshError::ShapeMismatch {
            k: 2,
            rows: 7,
            expected: 9
        }
    ));
    // two triangles as one face: closed, but no polygon
    let two = FaceMesh::from_triangles(6, &[[0, 1, 2], [3, 4, 5]]).unwrap();
    let mut both = sprs::TriMatI::new((6, 1));
    (0..6).for_each(|e| both.add_triplet(e, 0, if e == 1 || e == 4 { -1 } else { 1 }));
    let no_cells: BoundaryMatrix = sprs::TriMatI::new((1, 0)).to_csc();
    let error = from(two.boundary(1), &both.to_csc(), &no_cells);
    assert_eq!(error, MeshError::NotAPolygon { face: 0 });
}

/// Found by fuzzing: a column of ∂³ without entries is no cell.
#[test]
fn cells_need_sides_in_matrices_too() {
    let mesh = CellMesh::from_tetrahedra(4, &[[0, 1, 2, 3]]).unwrap();
    let (d1, d2) = (mesh.boundary(1), mesh.boundary(2));
    let empty = iheartmesh_runtime::sprs::CsMatI::new_csc((4, 1), vec![0_u32, 0], vec![], vec![]);
    assert_eq!(
        CellMesh::from_boundary_matrices(d1, d2, &empty).unwrap_err(),
        MeshError::TooFewSides { cell: 0, sides: 0 }
    );
    assert!(CellMesh::from_boundary_matrices(d1, d2, mesh.boundary(3)).is_ok());
}
