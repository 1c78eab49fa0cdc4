//! Cost of the accessors of `FaceMesh` against the same loops over plain index arrays.
//!
//! `cargo bench -p iheartmesh-runtime --bench traversal [vertices along one side]`. One thread, best of several runs.

use std::hint::black_box;
use std::time::Instant;

use iheartmesh_runtime::FaceMesh;

fn measure(label: &str, n: usize, run: impl Fn() -> f64) -> f64 {
    let mut best = f64::INFINITY;
    let mut result = 0.0;
    for _ in 0..9 {
        let start = Instant::now();
        result = black_box(run());
        best = best.min(start.elapsed().as_secs_f64());
    }
    println!("{label:<52} {:8.2} ns", 1e9 * best / n as f64);
    result
}

fn main() {
    let n: u32 = std::env::args()
        .skip(1)
        .find_map(|argument| argument.parse().ok())
        .unwrap_or(300);
    let vertex = |i: u32, j: u32| (i % n) * n + j % n;
    let triangles: Vec<[u32; 3]> = (0..n)
        .flat_map(|i| (0..n).map(move |j| (i, j)))
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [
                vertex(i, j),
                vertex(i + 1, j),
                vertex(i + 1, j + 1),
                vertex(i, j + 1),
            ];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    let n_vertices = (n * n) as usize;
    let mesh = FaceMesh::from_triangles(n_vertices, &triangles).expect("valid");
    let values: Vec<f64> = (0..n_vertices).map(|i| (i as f64).sin()).collect();

    let corners = triangles.as_flattened();
    let plain = measure(
        "corners of each face, plain arrays, per face",
        triangles.len(),
        || {
            corners
                .as_chunks::<3>()
                .0
                .iter()
                .map(|face| face.iter().map(|&v| values[v as usize]).sum::<f64>())
                .sum()
        },
    );
    let accessors = measure(
        "corners of each face, face_vertices, per face",
        triangles.len(),
        || {
            mesh.faces()
                .map(|face| {
                    mesh.face_vertices(face)
                        .iter()
                        .map(|v| values[v.index()])
                        .sum::<f64>()
                })
                .sum()
        },
    );
    assert_eq!(plain, accessors);

    // Neighbours of each vertex: from the edges at it, the other end of each.
    let starts: Vec<u32> = mesh
        .boundary_transpose(1)
        .indptr()
        .into_raw_storage()
        .to_vec();
    let edges: Vec<u32> = mesh.boundary_transpose(1).indices().to_vec();
    let ends: Vec<u32> = mesh.boundary(1).indices().to_vec();
    let plain = measure(
        "neighbours of each vertex, plain arrays, per vertex",
        n_vertices,
        || {
            let mut sum = 0.0;
            for v in 0..n_vertices {
                for &edge in &edges[starts[v] as usize..starts[v + 1] as usize] {
                    let [a, b] = [ends[2 * edge as usize], ends[2 * edge as usize + 1]];
                    sum += values[if a as usize == v { b } else { a } as usize];
                }
            }
            sum
        },
    );
    let accessors = measure(
        "neighbours of each vertex, accessors, per vertex",
        n_vertices,
        || {
            let mut sum = 0.0;
            for v in mesh.vertices() {
                for edge in mesh.vertex_edges(v) {
                    let [a, b] = mesh.edge_vertices(edge);
                    sum += values[if a == v { b } else { a }.index()];
                }
            }
            sum
        },
    );
    assert_eq!(plain, accessors);
    let complex = mesh.complex();
    let columns = measure(
        "neighbours of each vertex, columns, per vertex",
        n_vertices,
        || {
            let mut sum = 0.0;
            for v in 0..n_vertices {
                for &edge in complex.coboundary_elements(1, v) {
                    let [tail, head] = complex.edge_vertices(edge as usize);
                    sum += values[if tail as usize == v { head } else { tail } as usize];
                }
            }
            sum
        },
    );
    assert_eq!(plain, columns);
}
