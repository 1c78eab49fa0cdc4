//! Time to build a `FaceMesh` of a torus of a million vertices: both boundary matrices and both transposes.
//!
//! `cargo bench -p iheartmesh-runtime --bench construction [vertices along one side]`. Prints the best of several runs,
//! on one thread and on all, for a torus numbered coherently and for the same torus numbered at random.

use std::time::Instant;

use iheartmesh_runtime::FaceMesh;

/// Triangles of an n × n torus.
fn torus(n: u32) -> Vec<[u32; 3]> {
    let vertex = |i: u32, j: u32| (i % n) * n + j % n;
    let quads = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
    quads
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [
                vertex(i, j),
                vertex(i + 1, j),
                vertex(i + 1, j + 1),
                vertex(i, j + 1),
            ];
            [[a, b, c], [a, c, d]]
        })
        .collect()
}

/// The same triangles with vertices renamed and faces reordered by a fixed pseudo-random permutation.
fn shuffled(n_vertices: usize, triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let mut state = 1_u64;
    let mut below = |n: usize| {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        ((state >> 33) as usize) % n
    };
    let mut names: Vec<u32> = (0..n_vertices as u32).collect();
    (1..n_vertices)
        .rev()
        .for_each(|i| names.swap(i, below(i + 1)));
    let mut triangles: Vec<[u32; 3]> = triangles
        .iter()
        .map(|corners| corners.map(|vertex| names[vertex as usize]))
        .collect();
    (1..triangles.len())
        .rev()
        .for_each(|i| triangles.swap(i, below(i + 1)));
    triangles
}

fn measure(label: &str, n_vertices: usize, build: impl Fn() -> FaceMesh) {
    let mut best = f64::INFINITY;
    for _ in 0..7 {
        let start = Instant::now();
        let mesh = std::hint::black_box(build());
        best = best.min(start.elapsed().as_secs_f64());
        drop(mesh);
    }
    println!(
        "{label:<48} {:8.1} ms {:8.3} µs/vertex",
        1e3 * best,
        1e6 * best / n_vertices as f64
    );
}

fn main() {
    let side = std::env::args()
        .skip(1)
        .find_map(|argument| argument.parse().ok())
        .unwrap_or(1000);
    let n_vertices = (side * side) as usize;
    let coherent = torus(side);
    let random = shuffled(n_vertices, &coherent);
    for n_threads in [1, 0] {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(n_threads)
            .build()
            .expect("threads");
        pool.install(|| {
            let threads = pool.current_num_threads();
            for (order, triangles) in [("coherent", &coherent), ("random", &random)] {
                measure(
                    &format!("{order}, {threads} thread(s), triangles"),
                    n_vertices,
                    || FaceMesh::from_triangles(n_vertices, triangles).expect("valid"),
                );
                measure(
                    &format!("{order}, {threads} thread(s), polygons"),
                    n_vertices,
                    || FaceMesh::from_polygons(n_vertices, triangles).expect("valid"),
                );
            }
        });
    }
}
