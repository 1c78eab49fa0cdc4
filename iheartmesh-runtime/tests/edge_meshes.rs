//! Edge meshes: every accessor and matrix against a definition that is slow and obvious, neighbours of points against
//! all distances, and whatever is malformed.

use iheartmesh_runtime::glam::{DVec2, DVec3};
use iheartmesh_runtime::{BoundaryMatrix, EdgeMesh, FaceMesh, MeshError, Set, Vertex};

#[path = "../../tests/support/random.rs"]
#[allow(dead_code)]
mod random;

use random::Random;

fn pairs(mesh: &EdgeMesh) -> Vec<[u32; 2]> {
    mesh.edges()
        .map(|e| mesh.edge_vertices(e).map(Vertex::id))
        .collect()
}

fn check(n: u32, edges: &[[u32; 2]], mesh: &EdgeMesh) {
    let mut expected: Vec<[u32; 2]> = edges.iter().map(|&[a, b]| [a.min(b), a.max(b)]).collect();
    expected.sort_unstable();
    expected.dedup();
    assert_eq!(mesh.n_vertices(), n as usize);
    assert_eq!(pairs(mesh), expected);
    for (e, &[tail, head]) in expected.iter().enumerate() {
        for v in 0..n {
            let sign = i8::from(v == head) - i8::from(v == tail);
            let found = mesh.complex().boundary_entry(1, v as usize, e);
            assert_eq!(found, sign);
            let entry = |matrix: &BoundaryMatrix, row: usize, column: usize| {
                matrix.get(row, column).copied().unwrap_or(0)
            };
            let (row, size) = (v as usize, sign.abs());
            assert_eq!(entry(mesh.boundary(1), row, e), sign);
            assert_eq!(entry(mesh.boundary_transpose(1), e, row), sign);
            assert_eq!(entry(mesh.unsigned_boundary(1), row, e), size);
            assert_eq!(entry(mesh.unsigned_boundary_transpose(1), e, row), size);
        }
    }
    for v in mesh.vertices() {
        let around = (0..)
            .zip(&expected)
            .filter(|(_, edge)| edge.contains(&v.id()));
        let around: Vec<u32> = around.map(|(e, _)| e).collect();
        assert_eq!(mesh.vertex_edges(v).ids(), around);
    }
    let mut component: Vec<u32> = (0..n).collect();
    for _ in 0..n {
        for &[a, b] in &expected {
            let smaller = component[a as usize].min(component[b as usize]);
            component[a as usize] = smaller;
            component[b as usize] = smaller;
        }
    }
    component.sort_unstable();
    component.dedup();
    assert_eq!(mesh.n_components(), component.len());
    assert_eq!(
        mesh.euler_characteristic(),
        i64::from(n) - expected.len() as i64
    );
    let again = EdgeMesh::from_boundary_matrices(&mesh.boundary(1).to_csr()).unwrap();
    assert_eq!(again.boundary(1), mesh.boundary(1));
    assert_eq!(pairs(&again), expected);
}

#[test]
fn random_edges() {
    for seed in 0..150 {
        let mut random = Random(seed);
        let n = 2 + random.below(20);
        let edges: Vec<[u32; 2]> = (0..random.below(30))
            .map(|_| random.distinct(n, 2).try_into().unwrap())
            .collect();
        check(
            n,
            &edges,
            &EdgeMesh::from_edges(n as usize, &edges).unwrap(),
        );
    }
    check(3, &[], &EdgeMesh::from_edges(3, &[]).unwrap());
}

#[test]
fn matrices_keep_their_directions() {
    let mut d1 = sprs::TriMatI::new((3, 2));
    for (row, column, sign) in [(2, 0, -1), (0, 0, 1), (1, 1, -1), (2, 1, 1)] {
        d1.add_triplet(row, column, sign);
    }
    let mesh = EdgeMesh::from_boundary_matrices(&d1.to_csc()).unwrap();
    assert_eq!(pairs(&mesh), [[2, 0], [1, 2]]);
}

#[test]
fn malformed_edges() {
    let message = |n, edges: &[[u32; 2]]| EdgeMesh::from_edges(n, edges).unwrap_err().to_string();
    assert_eq!(
        message(3, &[[0, 1], [2, 3], [1, 1]]),
        "edge 1 names vertex 3 at corner 1, but the mesh has 3 vertices; vertices are numbered from 0"
    );
    assert_eq!(
        message(3, &[[0, 1], [2, 2], [1, 7]]),
        "edge 1 is degenerate: vertex 2 stands in it more than once; remove the edge or the repeated corner"
    );
    assert!(matches!(
        EdgeMesh::from_edges(usize::MAX, &[]),
        Err(MeshError::TooManyElements { .. })
    ));
    let mut d1 = sprs::TriMatI::new((2, 1));
    d1.add_triplet(0, 0, 1);
    d1.add_triplet(1, 0, 1);
    assert_eq!(
        EdgeMesh::from_boundary_matrices(&d1.to_csc()).unwrap_err(),
        MeshError::InvalidEdge { edge: 0 }
    );
}

/// The pairs of which one is among the k nearest of the other, by all distances.
fn k_nearest(points: &[DVec3], k: usize) -> Vec<[u32; 2]> {
    let mut edges = Vec::new();
    for (i, p) in points.iter().enumerate() {
        let mut others: Vec<(f64, u32)> = (0..points.len())
            .filter(|&j| j != i)
            .map(|j| (p.distance_squared(points[j]), j as u32))
            .collect();
        others.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        edges.extend(others.iter().take(k).map(|&(_, j)| [i as u32, j]));
    }
    edges
}

fn within_radius(points: &[DVec3], radius: f64) -> Vec<[u32; 2]> {
    let pairs = (0..points.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    pairs
        .filter(|&(i, j)| points[i].distance_squared(points[j]).sqrt() <= radius)
        .map(|(i, j)| [i as u32, j as u32])
        .collect()
}

/// Points with coordinates from 0 to `below` - 1, so that there are ties and, where it is small, equal points.
fn points(seed: u64, count: usize, below: u32) -> Vec<DVec3> {
    let mut random = Random(seed);
    let mut coordinate = || f64::from(random.below(below));
    (0..count)
        .map(|_| DVec3::new(coordinate(), coordinate(), coordinate()))
        .collect()
}

#[test]
fn neighbours_of_points() {
    for seed in 0..60 {
        let below = [1, 2, 3, 5, 1000][seed as usize % 5];
        let points = points(seed, [1, 2, 20, 35][seed as usize % 4], below);
        let n = points.len() as u32;
        for k in [0, 1, 3, 8, 200] {
            let mesh = EdgeMesh::from_k_nearest(&points, k).unwrap();
            check(n, &k_nearest(&points, k), &mesh);
        }
        for radius in [0.0, 1.0, 2.0_f64.sqrt(), 2.5, 1e4] {
            let mesh = EdgeMesh::from_radius(&points, radius).unwrap();
            check(n, &within_radius(&points, radius), &mesh);
        }
    }
    assert_eq!(
        EdgeMesh::from_k_nearest::<DVec3>(&[], 3).unwrap().n_edges(),
        0
    );
    let plane = [DVec2::ZERO, DVec2::X, DVec2::new(5.0, 0.0)];
    assert_eq!(
        pairs(&EdgeMesh::from_k_nearest(&plane, 1).unwrap()),
        [[0, 1], [1, 2]]
    );
    assert_eq!(
        pairs(&EdgeMesh::from_radius(&plane, 1.0).unwrap()),
        [[0, 1]]
    );
}

/// Squares of distances that are too large or too small for a number do not make all points equal.
#[test]
fn extreme_coordinates() {
    for scale in [1e-170, 1e-300, 1e160, 1e300] {
        let points: Vec<DVec3> = [0.0, 1.0, 3.0, 7.0].map(|x| DVec3::X * (x * scale)).into();
        let mesh = EdgeMesh::from_k_nearest(&points, 1).unwrap();
        assert_eq!(pairs(&mesh), [[0, 1], [1, 2], [2, 3]], "{scale}");
        let mesh = EdgeMesh::from_radius(&points, 2.5 * scale).unwrap();
        assert_eq!(pairs(&mesh), [[0, 1], [1, 2]], "{scale}");
    }
}

#[test]
fn malformed_points() {
    for bad in [f64::NAN, f64::INFINITY, -f64::INFINITY] {
        let points = [DVec3::ZERO, DVec3::new(0.0, bad, 0.0), DVec3::ONE];
        assert_eq!(
            EdgeMesh::from_k_nearest(&points, 1).unwrap_err(),
            MeshError::NotFinite { point: 1 }
        );
        assert_eq!(
            EdgeMesh::from_radius(&points, 1.0).unwrap_err().to_string(),
            "point 1 has a coordinate that is infinite or not a number; remove the point"
        );
    }
    for radius in [-1.0, f64::NAN] {
        let error = EdgeMesh::from_radius(&[DVec3::ZERO], radius).unwrap_err();
        assert_eq!(error, MeshError::InvalidRadius);
    }
    let all = EdgeMesh::from_radius(&[DVec3::ZERO, DVec3::ONE, DVec3::X], f64::INFINITY);
    assert_eq!(all.unwrap().n_edges(), 3);
}

#[test]
fn threads_do_not_change_the_mesh() {
    let points = points(3, 3000, 40);
    let on = |n_threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(n_threads)
            .build();
        pool.unwrap().install(|| {
            [
                EdgeMesh::from_k_nearest(&points, 7).unwrap(),
                EdgeMesh::from_radius(&points, 3.0).unwrap(),
            ]
        })
    };
    let expected = on(1).map(|mesh| pairs(&mesh));
    for n_threads in [2, 3, 7] {
        assert_eq!(on(n_threads).map(|mesh| pairs(&mesh)), expected);
    }
}

#[test]
fn grids_of_edges_and_of_faces_agree() {
    for (nx, ny) in [(3, 4), (1, 1), (5, 2)] {
        let (edges, faces) = (
            EdgeMesh::grid(nx, ny).unwrap(),
            FaceMesh::grid(nx, ny).unwrap(),
        );
        assert_eq!(edges.boundary(1), faces.boundary(1));
        assert_eq!(faces.n_faces(), nx * ny);
        assert!(faces.is_consistently_oriented());
        assert_eq!(faces.euler_characteristic(), 1);
        assert_eq!(
            faces.face_vertices(faces.faces().next().unwrap()).ids(),
            [0, 1, nx as u32 + 2, nx as u32 + 1]
        );
    }
    assert!(EdgeMesh::grid(usize::MAX, 2).is_err());
    assert!(FaceMesh::grid(1 << 17, 1 << 17).is_err());
}

/// ∂¹ has two entries for each edge, so there may be half as many edges as a `u32` can number.
#[test]
fn too_many_edges_is_an_error_before_memory_is_taken() {
    // 3.2·10⁹ edges, 6.4·10⁹ corners
    for error in [
        EdgeMesh::grid(40_000, 40_000).unwrap_err(),
        FaceMesh::grid(40_000, 40_000).unwrap_err(),
    ] {
        let is_right = matches!(
            error,
            MeshError::TooManyElements { maximum, .. } | MeshError::TooManyCorners { maximum, .. }
                if maximum == u32::MAX as usize / 2
        );
        assert!(is_right, "{error}");
    }
    // each of 10⁵ points is a neighbour of all others
    let points: Vec<[f64; 2]> = (0..100_000).map(|k| [f64::from(k), 0.0]).collect();
    let error = EdgeMesh::from_k_nearest(&points, usize::MAX).unwrap_err();
    assert!(
        matches!(error, MeshError::TooManyElements { count, .. } if count == 99_999 * 50_000),
        "{error}"
    );
}

#[test]
fn ends_and_isolated_vertices() {
    let mesh = EdgeMesh::from_edges(6, &[[0, 1], [1, 2], [2, 4], [4, 1]]).unwrap();
    let ids = |set: Set<Vertex>| set.iter().map(|v| v.id()).collect::<Vec<_>>();
    assert_eq!(ids(mesh.boundary_vertices()), [0]);
    assert_eq!(ids(mesh.isolated_vertices()), [3, 5]);
}

/// Very many copies of few points: in time that grows with the number of points, not with its square.
#[test]
fn copies_of_points() {
    let copies = |count: u32, different: u32| -> Vec<DVec3> {
        let point = |i: u32| {
            let k = i % different;
            // of both zeros
            let zero = if i.is_multiple_of(2) { 0.0 } else { -0.0 };
            DVec3::new(f64::from(k * k), zero, -f64::from(k))
        };
        (0..count).map(point).collect()
    };
    for (count, different) in [(40, 1), (40, 2), (60, 7), (50, 25), (30, 30)] {
        let points = copies(count, different);
        for k in [1, 3, 19, 20, 21, 39, 100] {
            let mesh = EdgeMesh::from_k_nearest(&points, k).unwrap();
            check(count, &k_nearest(&points, k), &mesh);
        }
        for radius in [0.0, 1.5, 10.0] {
            let mesh = EdgeMesh::from_radius(&points, radius).unwrap();
            check(count, &within_radius(&points, radius), &mesh);
        }
    }
    // all pairs of equal points would be 10⁹
    for different in [1, 3, 1000] {
        let points = copies(50_000, different);
        let mesh = EdgeMesh::from_k_nearest(&points, 6).unwrap();
        // each of the copies is a neighbour of the first ones
        let few = mesh.vertices().map(|v| mesh.vertex_edges(v).len()).min();
        assert_eq!((mesh.n_vertices(), few), (50_000, Some(6)), "{different}");
    }
}

/// Points in ascending order: a tree that is built in this order is a list, and 200 000 of them would take minutes.
#[test]
fn points_on_a_line() {
    let points: Vec<[f64; 2]> = (0..200_000).map(|k| [f64::from(k), 0.0]).collect();
    let mesh = EdgeMesh::from_k_nearest(&points, 2).unwrap();
    // the two at the ends reach one further
    assert_eq!(mesh.n_edges(), 199_999 + 2);
    let mesh = EdgeMesh::from_radius(&points, 2.0).unwrap();
    assert_eq!(mesh.n_edges(), 199_999 + 199_998);
}
