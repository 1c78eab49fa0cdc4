//! Time to write and read a torus of many vertices in each format, in memory.
//!
//! `cargo bench -p iheartmesh-runtime --bench mesh_files [vertices along one side]`.

use std::time::Instant;

use glam::DVec3;
use iheartmesh_runtime::io::{self, Attributes};

fn main() {
    let n: u32 = std::env::args()
        .skip(1)
        .find_map(|argument| argument.parse().ok())
        .unwrap_or(500);
    let vertex = |i: u32, j: u32| (i % n) * n + j % n;
    let quads = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
    let positions: Vec<DVec3> = quads
        .clone()
        .map(|(i, j)| {
            DVec3::new(
                f64::from(i).sin(),
                f64::from(j).cos(),
                f64::from(i * j).sqrt(),
            )
        })
        .collect();
    let triangles: Vec<[u32; 3]> = quads
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
    for name in ["torus.obj", "torus.off", "torus.ply"] {
        let start = Instant::now();
        let bytes = io::to_bytes(name, &positions, &triangles, &Attributes::new()).expect("valid");
        let written = start.elapsed();
        let start = Instant::now();
        let file = io::from_bytes(name, &bytes).expect("valid");
        let read = start.elapsed();
        assert_eq!(file.positions.len(), positions.len());
        let per_vertex = |seconds: f64| 1e6 * seconds / positions.len() as f64;
        println!(
            "{name:<10} {:6.1} MB   written {:6.3} µs/vertex   read {:6.3} µs/vertex",
            bytes.len() as f64 / 1e6,
            per_vertex(written.as_secs_f64()),
            per_vertex(read.as_secs_f64())
        );
    }
}
