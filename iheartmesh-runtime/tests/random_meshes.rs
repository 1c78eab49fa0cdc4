//! Random polygon soups: every accessor and matrix against a definition that is slow and obvious.

use std::collections::{BTreeMap, BTreeSet};

use iheartmesh_runtime::{BoundaryMatrix, Edge, FaceMesh, Vertex};

/// A small deterministic generator (PCG), so that a failing case can be run again.
struct Random(u64);

impl Random {
    fn below(&mut self, n: u32) -> u32 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        let xorshifted = (((self.0 >> 18) ^ self.0) >> 27) as u32;
        xorshifted.rotate_right((self.0 >> 59) as u32) % n
    }

    /// Distinct vertices in random order.
    fn polygon(&mut self, n_vertices: u32, n_corners: u32) -> Vec<u32> {
        let mut corners = Vec::new();
        while corners.len() < n_corners.min(n_vertices) as usize {
            let vertex = self.below(n_vertices);
            if !corners.contains(&vertex) {
                corners.push(vertex);
            }
        }
        corners
    }
}

/// The directed sides of a polygon.
fn sides(polygon: &[u32]) -> impl Iterator<Item = (u32, u32)> + '_ {
    (0..polygon.len()).map(|i| (polygon[i], polygon[(i + 1) % polygon.len()]))
}

fn entries(matrix: &BoundaryMatrix) -> BTreeMap<(usize, usize), i8> {
    matrix
        .iter()
        .map(|(&value, (row, column))| ((row as usize, column as usize), value))
        .collect()
}

fn transposed(entries: &BTreeMap<(usize, usize), i8>) -> BTreeMap<(usize, usize), i8> {
    entries
        .iter()
        .map(|(&(row, column), &value)| ((column, row), value))
        .collect()
}

fn check(n_vertices: u32, faces: &[Vec<u32>], mesh: &FaceMesh) {
    let n = n_vertices as usize;
    let mut edges: BTreeSet<(u32, u32)> = BTreeSet::new();
    for face in faces {
        edges.extend(sides(face).map(|(a, b)| (a.min(b), a.max(b))));
    }
    let edges: Vec<(u32, u32)> = edges.into_iter().collect();
    let number = |a: u32, b: u32| edges.binary_search(&(a.min(b), a.max(b))).unwrap();
    let (mut d1, mut d2) = (BTreeMap::new(), BTreeMap::new());
    for (edge, &(tail, head)) in edges.iter().enumerate() {
        d1.insert((tail as usize, edge), -1);
        d1.insert((head as usize, edge), 1);
    }
    for (face, polygon) in faces.iter().enumerate() {
        d2.extend(sides(polygon).map(|(a, b)| ((number(a, b), face), if a < b { 1 } else { -1 })));
    }

    for (k, expected, shape) in [
        (1, &d1, (n, edges.len())),
        (2, &d2, (edges.len(), faces.len())),
    ] {
        let ones = |entries: &BTreeMap<_, i8>| {
            entries
                .keys()
                .map(|&position| (position, 1))
                .collect::<BTreeMap<_, _>>()
        };
        assert_eq!(mesh.boundary(k).shape(), shape);
        assert_eq!(mesh.boundary_transpose(k).shape(), (shape.1, shape.0));
        assert_eq!(&entries(mesh.boundary(k)), expected);
        assert_eq!(entries(mesh.boundary_transpose(k)), transposed(expected));
        assert_eq!(entries(mesh.unsigned_boundary(k)), ones(expected));
        assert_eq!(
            entries(mesh.unsigned_boundary_transpose(k)),
            ones(&transposed(expected))
        );
        for row in 0..shape.0.min(40) {
            for column in 0..shape.1.min(40) {
                let entry = expected.get(&(row, column)).copied().unwrap_or(0);
                assert_eq!(mesh.complex().boundary_entry(k, row, column), entry);
            }
        }
    }

    for (edge, &(tail, head)) in mesh.edges().zip(&edges) {
        assert_eq!(mesh.edge_vertices(edge), [tail, head].map(Vertex::new));
        let around: Vec<_> = mesh
            .faces()
            .filter(|face| {
                sides(&faces[face.index()]).any(|(a, b)| (a.min(b), a.max(b)) == (tail, head))
            })
            .collect();
        assert_eq!(mesh.edge_faces(edge), around[..]);
    }
    for vertex in mesh.vertices() {
        let id = vertex.id();
        let around: Vec<Edge> = mesh
            .edges()
            .filter(|edge| edges[edge.index()].0 == id || edges[edge.index()].1 == id)
            .collect();
        assert_eq!(mesh.vertex_edges(vertex), around[..]);
        assert_eq!(
            mesh.isolated_vertices().contains(&vertex),
            around.is_empty()
        );
    }
    for (face, polygon) in mesh.faces().zip(faces) {
        assert_eq!(mesh.face_vertices(face).ids(), polygon);
        let around: BTreeSet<u32> = sides(polygon).map(|(a, b)| number(a, b) as u32).collect();
        assert_eq!(
            mesh.face_edges(face).ids(),
            around.into_iter().collect::<Vec<_>>()
        );
    }
    assert_eq!(
        mesh.is_triangle_mesh(),
        faces.iter().all(|face| face.len() == 3)
    );

    // ∂¹∂² = 0, by the matrix product itself.
    if !faces.is_empty() {
        let product = &mesh.boundary(1).map(|&sign| i32::from(sign))
            * &mesh.boundary(2).map(|&sign| i32::from(sign));
        assert!(product.data().iter().all(|&entry| entry == 0));
    }

    let again = FaceMesh::from_boundary_matrices(mesh.boundary(1), mesh.boundary(2)).unwrap();
    for k in [1, 2] {
        assert_eq!(again.boundary_transpose(k), mesh.boundary_transpose(k));
    }
    for (face, polygon) in again.faces().zip(faces) {
        let mut rotated = polygon.clone();
        let smallest = (0..polygon.len()).min_by_key(|&i| polygon[i]).unwrap();
        rotated.rotate_left(smallest);
        assert_eq!(again.face_vertices(face).ids(), rotated);
    }
}

#[test]
fn polygon_soups() {
    for seed in 0..150 {
        let mut random = Random(seed);
        let n_vertices = 3 + random.below(25);
        let faces: Vec<Vec<u32>> = (0..random.below(30))
            .map(|_| {
                let n_corners = 3 + random.below(6);
                random.polygon(n_vertices, n_corners)
            })
            .collect();
        check(
            n_vertices,
            &faces,
            &FaceMesh::from_polygons(n_vertices as usize, &faces).unwrap(),
        );
    }
}

#[test]
fn triangle_soups() {
    for seed in 0..150 {
        let mut random = Random(1000 + seed);
        let n_vertices = 3 + random.below(25);
        let triangles: Vec<[u32; 3]> = (0..random.below(40))
            .map(|_| random.polygon(n_vertices, 3).try_into().unwrap())
            .collect();
        let faces: Vec<Vec<u32>> = triangles.iter().map(|triangle| triangle.to_vec()).collect();
        check(
            n_vertices,
            &faces,
            &FaceMesh::from_triangles(n_vertices as usize, &triangles).unwrap(),
        );
    }
}

#[test]
fn polygons_with_many_corners_and_vertices_with_many_edges() {
    let mut random = Random(7);
    let faces: Vec<Vec<u32>> = (0..6)
        .map(|_| random.polygon(70, 60))
        .chain([vec![0, 1, 2]])
        .collect();
    check(70, &faces, &FaceMesh::from_polygons(70, &faces).unwrap());
    let fan: Vec<Vec<u32>> = (0..60)
        .map(|i| vec![99, (i * 37) % 60, ((i + 1) * 37) % 60])
        .collect();
    check(100, &fan, &FaceMesh::from_polygons(100, &fan).unwrap());
}

/// Large enough for several threads: the result is the same on any number of them.
#[test]
fn threads_do_not_change_the_mesh() {
    let mut random = Random(3);
    let n_vertices = 9000;
    let triangles: Vec<[u32; 3]> = (0..20000)
        .map(|_| random.polygon(n_vertices, 3).try_into().unwrap())
        .collect();
    let mixed: Vec<Vec<u32>> = (0..12000)
        .map(|_| {
            let n_corners = 3 + random.below(3);
            random.polygon(n_vertices, n_corners)
        })
        .collect();
    let on = |n_threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(n_threads)
            .build()
            .unwrap();
        pool.install(|| {
            [
                FaceMesh::from_triangles(n_vertices as usize, &triangles).unwrap(),
                FaceMesh::from_polygons(n_vertices as usize, &mixed).unwrap(),
            ]
        })
    };
    let expected = on(1);
    for n_threads in [2, 3, 7, 40] {
        for (mesh, expected) in on(n_threads).iter().zip(&expected) {
            for k in [1, 2] {
                assert_eq!(mesh.boundary(k), expected.boundary(k));
                assert_eq!(mesh.boundary_transpose(k), expected.boundary_transpose(k));
            }
        }
    }
    let faces: Vec<Vec<u32>> = triangles[..1500]
        .iter()
        .map(|triangle| triangle.to_vec())
        .collect();
    let n = 1 + faces.iter().flatten().max().unwrap();
    let mesh = FaceMesh::from_triangles(n as usize, &triangles[..1500]).unwrap();
    for (face, corners) in mesh.faces().zip(&faces) {
        assert_eq!(mesh.face_vertices(face).ids(), corners);
    }
    let product = &expected[1].boundary(1).map(|&sign| i32::from(sign))
        * &expected[1].boundary(2).map(|&sign| i32::from(sign));
    assert!(product.data().iter().all(|&entry| entry == 0));
}

#[test]
fn the_first_bad_face_of_a_large_mesh_is_reported() {
    let mut triangles = vec![[0, 1, 2]; 100_000];
    triangles[70_000] = [0, 3, 1];
    triangles[40_000] = [1, 1, 2];
    let error = FaceMesh::from_triangles(3, &triangles)
        .unwrap_err()
        .to_string();
    assert!(
        error.starts_with("face 40000 is degenerate: vertex 1"),
        "{error}"
    );
}
