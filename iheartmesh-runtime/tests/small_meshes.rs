//! Meshes small enough to check by eye. Every expectation is written out by hand from the picture beside it.

use iheartmesh_runtime::{BoundaryMatrix, Edge, Face, FaceMesh, MeshError, Set, Vertex};

fn edges<const N: usize>(ids: [u32; N]) -> Set<Edge> {
    Set::from(ids.map(Edge::new))
}

fn vertices<const N: usize>(ids: [u32; N]) -> Set<Vertex> {
    Set::from(ids.map(Vertex::new))
}

/// Tail and head of every edge.
fn edge_list(mesh: &FaceMesh) -> Vec<[u32; 2]> {
    mesh.edges()
        .map(|edge| mesh.edge_vertices(edge).map(Vertex::id))
        .collect()
}

/// Rows of a matrix as a person writes them.
fn dense(matrix: &BoundaryMatrix) -> Vec<Vec<i8>> {
    matrix
        .to_dense()
        .outer_iter()
        .map(|row| row.to_vec())
        .collect()
}

#[test]
fn two_triangles_make_a_square() {
    // 3 ──4── 2      edges 0: 0→1, 1: 0→3, 2: 1→2, 3: 1→3, 4: 2→3
    // │ ╲  1  │      both faces run counterclockwise
    // 1   3   2
    // │  0  ╲ │
    // 0 ──0── 1
    let mesh = FaceMesh::from_triangles(4, &[[0, 1, 3], [2, 3, 1]]).unwrap();
    assert_eq!(
        (mesh.n_vertices(), mesh.n_edges(), mesh.n_faces()),
        (4, 5, 2)
    );
    assert_eq!(edge_list(&mesh), [[0, 1], [0, 3], [1, 2], [1, 3], [2, 3]]);
    assert_eq!(
        dense(mesh.boundary(1)),
        [
            [-1, -1, 0, 0, 0],
            [1, 0, -1, -1, 0],
            [0, 0, 1, 0, -1],
            [0, 1, 0, 1, 1]
        ]
    );
    assert_eq!(
        dense(mesh.boundary(2)),
        [[1, 0], [-1, 0], [0, 1], [1, -1], [0, 1]]
    );
    assert_eq!(
        dense(mesh.boundary_transpose(2)),
        [[1, -1, 0, 1, 0], [0, 0, 1, -1, 1]]
    );
    assert_eq!(
        dense(mesh.unsigned_boundary(2)),
        [[1, 0], [1, 0], [0, 1], [1, 1], [0, 1]]
    );
    assert_eq!(dense(mesh.unsigned_boundary_transpose(1))[3], [0, 1, 0, 1]);
    for k in [1, 2] {
        assert!(mesh.boundary(k).is_csc() && mesh.boundary_transpose(k).is_csc());
        assert!(mesh.unsigned_boundary(k).is_csc() && mesh.unsigned_boundary_transpose(k).is_csc());
    }

    assert_eq!(mesh.vertex_edges(Vertex::new(3)), [1, 3, 4].map(Edge::new));
    assert_eq!(mesh.edge_faces(Edge::new(3)), [0, 1].map(Face::new));
    assert_eq!(mesh.face_vertices(Face::new(1)), [2, 3, 1].map(Vertex::new));
    let (face_edges, signs) = mesh.face_boundary(Face::new(1));
    assert_eq!(face_edges, [2, 3, 4].map(Edge::new));
    assert_eq!(signs, [1, -1, 1]);
    assert_eq!(mesh.face_edges(Face::new(0)).ids(), [0, 1, 3]);
    assert_eq!(mesh.triangles(), Some(&[[0, 1, 3], [2, 3, 1]][..]));
    assert_eq!(
        format!("{mesh:?}"),
        "FaceMesh { n_vertices: 4, n_edges: 5, n_faces: 2, .. }"
    );
    assert_eq!(
        format!("{:?}", mesh.complex()),
        "CellComplex { n_elements: [4, 5, 2], .. }"
    );

    assert_eq!(mesh.boundary_edges(), edges([0, 1, 2, 4]));
    assert_eq!(mesh.boundary_vertices(), vertices([0, 1, 2, 3]));
    assert!(!mesh.is_closed() && mesh.is_triangle_mesh());
    assert!(mesh.is_consistently_oriented() && mesh.is_orientable());
    assert_eq!((mesh.euler_characteristic(), mesh.n_components()), (1, 1));

    let complex = mesh.complex();
    assert_eq!(
        [0, 1, 2, 3].map(|dimension| complex.n(dimension)),
        [4, 5, 2, 0]
    );
    assert_eq!(
        complex.boundary_column(2, 1),
        (&[2, 3, 4][..], &[1, -1, 1][..])
    );
    assert_eq!(complex.coboundary_column(2, 3), (&[0, 1][..], &[1, -1][..]));
    assert_eq!(
        [0, 3, 4].map(|edge| complex.boundary_entry(2, edge, 1)),
        [0, -1, 1]
    );
}

#[test]
fn tetrahedron() {
    //      3
    //    ╱ │ ╲      faces counterclockwise from outside
    //   0──┼──2
    //    ╲ │ ╱
    //      1
    let mesh = FaceMesh::from_triangles(4, &[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]).unwrap();
    assert_eq!(
        edge_list(&mesh),
        [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]]
    );
    assert!(mesh.is_closed() && mesh.is_consistently_oriented() && mesh.is_orientable());
    assert!(mesh.boundary_edges().is_empty() && mesh.boundary_vertices().is_empty());
    assert_eq!(mesh.euler_characteristic(), 2);
    assert_eq!(
        mesh.vertices().len() + mesh.edges().len() + mesh.faces().len(),
        14
    );

    // One face turned: not consistent any more, but it could be made so.
    let mesh = FaceMesh::from_triangles(4, &[[0, 1, 2], [0, 1, 3], [1, 2, 3], [2, 0, 3]]).unwrap();
    assert!(!mesh.is_consistently_oriented() && mesh.is_orientable() && mesh.is_closed());
}

#[test]
fn quad_and_triangle() {
    // 4 ── 3
    // │ 0  │ ╲
    // 0 ── 1 ─ 2
    let faces = [vec![4, 0, 1, 3], vec![1, 2, 3]];
    let mesh = FaceMesh::from_polygons(5, &faces).unwrap();
    assert_eq!(
        edge_list(&mesh),
        [[0, 1], [0, 4], [1, 2], [1, 3], [2, 3], [3, 4]]
    );
    assert_eq!(
        mesh.face_vertices(Face::new(0)),
        [4, 0, 1, 3].map(Vertex::new)
    );
    assert_eq!(mesh.face_boundary(Face::new(0)).0.ids(), [0, 1, 3, 5]);
    assert_eq!(mesh.face_boundary(Face::new(0)).1, [1, -1, 1, 1]);
    assert_eq!(mesh.face_boundary(Face::new(1)).1, [1, -1, 1]);
    assert!(!mesh.is_triangle_mesh() && mesh.triangles().is_none());
    assert_eq!(mesh.non_manifold_edges(), edges([]));
}

#[test]
fn three_triangles_on_one_edge() {
    //      2
    //    ╱ │
    //   1──┼──3     all three contain the edge 0→1
    //    ╲ │ ╱
    //      0 ── 4
    let mesh = FaceMesh::from_triangles(5, &[[0, 1, 2], [0, 1, 3], [1, 0, 4]]).unwrap();
    assert_eq!(mesh.non_manifold_edges(), edges([0]));
    assert_eq!(
        mesh.complex().coboundary_column(2, 0),
        (&[0, 1, 2][..], &[1, 1, -1][..])
    );
    assert!(!mesh.is_consistently_oriented() && !mesh.is_orientable() && !mesh.is_closed());
    assert_eq!(mesh.boundary_edges().len(), 6);
}

#[test]
fn moebius_strip() {
    // 0 ─ 1 ─ 2 ─ 3
    // │ ╱ │ ╱ │ ╱ │    the right side is glued to the left upside down
    // 3 ─ 4 ─ 5 ─ 0
    let triangles = [
        [0, 3, 1],
        [1, 3, 4],
        [1, 4, 2],
        [2, 4, 5],
        [2, 5, 3],
        [3, 5, 0],
    ];
    let mesh = FaceMesh::from_triangles(6, &triangles).unwrap();
    assert!(!mesh.is_orientable() && !mesh.is_consistently_oriented());
    assert_eq!((mesh.euler_characteristic(), mesh.n_components()), (0, 1));
    assert_eq!(mesh.boundary_edges().len(), 6);
}

#[test]
fn isolated_vertices_components_and_repeated_faces() {
    // 0 ── 1    3    4 ── 5
    //  ╲  ╱            ╲ ╱
    //   2     7         6      the left triangle is there twice
    let mesh = FaceMesh::from_triangles(8, &[[0, 1, 2], [4, 5, 6], [0, 1, 2]]).unwrap();
    assert_eq!(mesh.isolated_vertices(), vertices([3, 7]));
    assert_eq!(mesh.n_components(), 4);
    assert_eq!((mesh.n_edges(), mesh.n_faces()), (6, 3));
    assert_eq!(mesh.edge_faces(Edge::new(0)), [0, 2].map(Face::new));
    assert_eq!(mesh.boundary_edges(), edges([3, 4, 5]));
    assert!(mesh.vertex_edges(Vertex::new(7)).is_empty());
    assert!(!mesh.is_consistently_oriented() && mesh.is_orientable());
}

#[test]
fn empty_meshes() {
    for n_vertices in [0, 3] {
        let mesh = FaceMesh::from_triangles(n_vertices, &[]).unwrap();
        assert_eq!(
            (mesh.n_vertices(), mesh.n_edges(), mesh.n_faces()),
            (n_vertices, 0, 0)
        );
        assert_eq!(mesh.n_components(), n_vertices);
        assert!(mesh.is_closed() && mesh.is_triangle_mesh() && mesh.is_orientable());
        let again = FaceMesh::from_boundary_matrices(mesh.boundary(1), mesh.boundary(2)).unwrap();
        assert_eq!(again.n_vertices(), n_vertices);
        assert_eq!(mesh.unsigned_boundary_transpose(2).shape(), (0, 0));
    }
}

#[test]
fn bad_faces_are_named() {
    let message = |faces: &[&[u32]]| FaceMesh::from_polygons(5, faces).unwrap_err().to_string();
    assert_eq!(
        message(&[&[0, 1, 2], &[2, 5, 3]]),
        "face 1 names vertex 5 at corner 1, but the mesh has 5 vertices; vertices are numbered from 0"
    );
    assert_eq!(
        message(&[&[0, 1, 2], &[3, 4]]),
        "face 1 has too few corners (2); remove it or give it all its vertices"
    );
    assert_eq!(
        message(&[&[3, 3, 4]]),
        "face 0 is degenerate: vertex 3 stands in it more than once; remove the face or the repeated corner"
    );
    let mut ring: Vec<u32> = (0..40).collect();
    ring[33] = 7;
    let error = FaceMesh::from_polygons(40, [&ring]).unwrap_err();
    assert!(matches!(
        error,
        MeshError::RepeatedVertex {
            element: 0,
            vertex: 7,
            ..
        }
    ));
    let error =
        FaceMesh::from_triangles(3, &[[0, 1, 2], [0, 1, 2], [2, 1, 2], [9, 9, 9]]).unwrap_err();
    assert!(matches!(
        error,
        MeshError::RepeatedVertex {
            element: 2,
            vertex: 2,
            ..
        }
    ));
    let error = FaceMesh::from_triangles(3, &[[0, 1, u32::MAX]]).unwrap_err();
    assert!(matches!(
        error,
        MeshError::VertexOutOfRange {
            corner: 2,
            vertex: u32::MAX,
            n_vertices: 3,
            ..
        }
    ));
}

#[test]
fn too_many_vertices_is_an_error_before_memory_is_taken() {
    for n_vertices in [u32::MAX as usize, u32::MAX as usize + 1, usize::MAX] {
        let error = FaceMesh::from_triangles(n_vertices, &[]).unwrap_err();
        assert!(
            matches!(error, MeshError::TooManyElements { .. }),
            "{error}"
        );
        let no_faces: [[u32; 3]; 0] = [];
        assert_eq!(
            FaceMesh::from_polygons(n_vertices, no_faces).unwrap_err(),
            error
        );
    }
}

#[test]
#[should_panic(
    expected = "there is no boundary matrix ∂3 in a mesh of dimension 2: k goes from 1 to 2"
)]
fn boundary_panics_for_other_k() {
    FaceMesh::from_triangles(3, &[[0, 1, 2]])
        .unwrap()
        .boundary(3);
}

#[test]
#[should_panic(expected = "no boundary matrix ∂0")]
fn boundary_panics_for_k_zero() {
    FaceMesh::from_triangles(3, &[[0, 1, 2]])
        .unwrap()
        .complex()
        .boundary_column(0, 0);
}

#[test]
fn a_mesh_can_be_shared_between_threads() {
    fn check<T: Clone + Send + Sync + 'static>(_: &T) {}
    let mesh = FaceMesh::from_triangles(3, &[[0, 1, 2]]).unwrap();
    check(&mesh);
    check(mesh.complex());
    let copy = mesh.clone();
    assert!(
        std::ptr::eq(copy.complex(), mesh.complex()),
        "clones share their memory"
    );
}

#[test]
fn too_many_faces_is_an_error_before_memory_is_taken() {
    // more than 2³¹ corners; the iterator says so before it gives the first face
    for n_faces in [1 << 30, 1 << 32, usize::MAX] {
        let faces = std::iter::repeat_n([0_u32, 1, 2], n_faces);
        let error = FaceMesh::from_polygons(3, faces).unwrap_err();
        assert!(matches!(error, MeshError::TooManyCorners { .. }), "{error}");
    }
}

#[test]
fn non_manifold_vertices() {
    let non_manifold = |n, faces: &[[u32; 3]]| {
        let mesh = FaceMesh::from_triangles(n, faces).unwrap();
        let found = mesh.non_manifold_vertices();
        assert_eq!(mesh.is_manifold(), found.is_empty());
        found.iter().map(|v| v.id()).collect::<Vec<u32>>()
    };
    // a fan, a disk whose faces are listed crosswise, and an isolated vertex
    assert!(non_manifold(5, &[[0, 1, 2], [0, 2, 3]]).is_empty());
    let disk = [[0, 1, 2], [0, 4, 5], [0, 3, 4], [0, 2, 3], [0, 5, 1]];
    assert!(non_manifold(7, &disk).is_empty());
    // two triangles that touch at a vertex; two disks
    assert_eq!(non_manifold(5, &[[0, 1, 2], [2, 3, 4]]), [2]);
    let cone = |a, b, c, d| [[a, b, c], [a, c, d], [a, d, b]];
    let disks = [cone(0, 1, 2, 3), cone(0, 4, 5, 6)].concat();
    assert_eq!(non_manifold(7, &disks), [0]);
    // three faces at an edge
    assert_eq!(non_manifold(5, &[[0, 1, 2], [0, 1, 3], [0, 1, 4]]), [0, 1]);
    assert!(non_manifold(3, &[]).is_empty());
}
