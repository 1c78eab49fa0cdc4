//! Projected second derivatives of sums around vertices: with their places found once per mesh, with their entries collected and
//! sorted each time, and by hand; prints a Markdown table.
//!
//! ```text
//! cargo bench --bench projection                    # 1000 and 10 000 vertices
//! cargo bench --bench projection -- --max 100000    # larger meshes, too
//! ```
//!
//! Under `cargo test --benches` it runs on a tiny mesh, to see that all agree.

// The values are what is measured; their names are those of the formulas.
#![allow(non_snake_case)]

#[path = "../examples/common/generate.rs"]
#[allow(dead_code)]
mod generate;
#[path = "curvature/measure.rs"]
mod measure;

use std::time::Duration;

use glam::DVec3;
use iheartmesh::nalgebra::{Cholesky, DMatrix, DVector};
use iheartmesh::{FaceMesh, iheartmesh, sprs::CsMat};
use measure::{Contestant, Effort, contest, contestant};
use rayon::ThreadPoolBuilder;

iheartmesh! {
    pub struct Rings = include "benches/projection/rings.hlang";
    #[without(slots)]
    pub struct Sorted = include "benches/projection/rings.hlang";
}

/// A mesh with what a careful person would keep of it.
struct Torus {
    mesh: FaceMesh,
    x: Vec<DVec3>,
    /// Each vertex and its ring, ascending.
    around: Vec<Vec<usize>>,
    /// At each vertex the row of slots of its block, column by column, in pieces of three.
    slots: Vec<Vec<usize>>,
}

impl Torus {
    fn new(vertices: usize) -> Self {
        let n = (vertices as f64).sqrt() as usize;
        let (x, triangles) = generate::torus(n, n);
        let mesh = FaceMesh::from_triangles(x.len(), &triangles).expect("a torus is a mesh");
        let mut around: Vec<Vec<usize>> = (0..x.len()).map(|v| vec![v]).collect();
        for [a, b, c] in &triangles {
            for (v, w) in [(a, b), (b, c), (c, a)] {
                around[*v as usize].push(*w as usize);
            }
        }
        around.iter_mut().for_each(|ring| ring.sort_unstable());
        let slots = Vec::new();
        Self {
            mesh,
            x,
            around,
            slots,
        }
    }

    /// The sum at a vertex.
    fn sum(&self, v: usize) -> f64 {
        let ring = self.around[v].iter();
        ring.map(|w| self.x[*w].distance_squared(self.x[v])).sum()
    }

    /// Where the blocks go in a matrix.
    fn slots(&self, matrix: &CsMat<f64>) -> Vec<Vec<usize>> {
        let (pointers, rows) = (matrix.proper_indptr(), matrix.indices());
        let slots = self.around.iter().map(|ring| {
            let columns = ring.iter().flat_map(|w| 3 * w..3 * w + 3);
            let pieces = columns.flat_map(|column| {
                let start = pointers[column];
                let stored = &rows[start..pointers[column + 1]];
                let place = move |w: &usize| start + stored.partition_point(|row| *row < 3 * w);
                ring.iter().map(place)
            });
            pieces.collect()
        });
        slots.collect()
    }

    /// The projected second derivatives by hand, of blocks in memory that is at hand.
    fn by_hand(&self, rest: &[f64], values: &mut [f64]) {
        values.fill(0.0);
        let mut block = DMatrix::zeros(0, 0);
        for (v, (ring, slots)) in self.around.iter().zip(&self.slots).enumerate() {
            let n = 3 * ring.len();
            if block.nrows() != n {
                block = DMatrix::zeros(n, n);
            }
            let own = ring.iter().position(|w| *w == v).unwrap_or(0);
            // the gradient of the sum, and the sum
            let mut slope = DVector::zeros(n);
            let mut sum = -rest[v];
            for (k, w) in ring.iter().enumerate() {
                let u = self.x[*w] - self.x[v];
                sum += u.length_squared();
                for d in 0..3 {
                    slope[3 * k + d] += 2.0 * u[d];
                    slope[3 * own + d] -= 2.0 * u[d];
                }
            }
            block.ger(2.0, &slope, &slope, 0.0);
            for k in (0..ring.len()).filter(|k| *k != own) {
                for d in 0..3 {
                    let (i, j) = (3 * k + d, 3 * own + d);
                    block[(i, i)] += 4.0 * sum;
                    block[(j, j)] += 4.0 * sum;
                    block[(i, j)] -= 4.0 * sum;
                    block[(j, i)] -= 4.0 * sum;
                }
            }
            // what is semi-definite up to rounding stays
            let mut shifted = block.clone();
            let shift = 1e-14 * n as f64 * block.amax();
            (0..n).for_each(|k| shifted[(k, k)] += shift);
            if Cholesky::new(shifted).is_none() {
                let eigen = block.clone().symmetric_eigen();
                block.fill(0.0);
                for (value, vector) in eigen
                    .eigenvalues
                    .iter()
                    .zip(eigen.eigenvectors.column_iter())
                {
                    if *value > 0.0 {
                        block.ger(*value, &vector, &vector, 1.0);
                    }
                }
            }
            let pieces = block.as_slice().chunks_exact(3);
            for (slot, piece) in slots.iter().zip(pieces) {
                for (entry, value) in values[*slot..*slot + 3].iter_mut().zip(piece) {
                    *entry += value;
                }
            }
        }
    }
}

fn difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len(), "the patterns differ");
    let most = b.iter().fold(0.0, |most: f64, b| most.max(b.abs()));
    let pairs = a.iter().zip(b);
    pairs.fold(0.0, |worst: f64, (a, b)| worst.max((a - b).abs() / most))
}

fn table(vertices: usize, threads: &[usize], effort: Effort) {
    let mut torus = Torus::new(vertices);
    let n = torus.x.len();
    let pattern = Rings::new(&torus.mesh, &torus.x, vec![1.0; n]).map(|rings| rings.P());
    torus.slots = torus.slots(&pattern.expect("inputs that fit"));
    let torus = &torus;
    for (label, one_of) in [("none", 0), ("one in eight", 8), ("all", 1)] {
        let rest: Vec<f64> = (0..n)
            .map(|v| match one_of > 0 && v % one_of == 0 {
                true => 2.0 * torus.sum(v),
                false => 0.5 * torus.sum(v),
            })
            .collect();
        for threads in threads {
            let pool = ThreadPoolBuilder::new().num_threads(*threads).build();
            pool.expect("threads can be started").install(|| {
                let rings = || Rings::new(&torus.mesh, &torus.x, &rest).expect("inputs that fit");
                let (mut second, mut planned) = (rings(), rings());
                let mut sorted =
                    Sorted::new(&torus.mesh, &torus.x, &rest).expect("inputs that fit");
                let (mut h, mut p) = (second.H(), planned.P());
                let x = &torus.x;
                let mut values = vec![0.0; p.nnz()];
                // what is compared must be the same
                torus.by_hand(&rest, &mut values);
                assert!(difference(p.data(), &values) < 1e-10);
                assert!(difference(sorted.P().data(), &values) < 1e-10);
                let mut runs: Vec<Contestant<'_>> = vec![
                    contestant(|| {
                        second.set_x(x).expect("as many as before");
                        second.H_into(&mut h);
                    }),
                    contestant(|| torus.by_hand(&rest, &mut values)),
                    contestant(|| {
                        sorted.set_x(x).expect("as many as before");
                        sorted.P()
                    }),
                    contestant(|| {
                        planned.set_x(x).expect("as many as before");
                        planned.P_into(&mut p);
                    }),
                ];
                let times = contest(effort, &mut runs);
                let times: Vec<String> = times
                    .iter()
                    .map(|t| format!("{:.2}", t.as_secs_f64() * 1e6 / n as f64))
                    .collect();
                println!("| {n} | {label} | {threads} | {} |", times.join(" | "));
            });
        }
    }
}

fn main() {
    let mut largest = 10_000;
    let mut effort = Effort {
        least_rounds: 3,
        budget: Duration::from_secs(2),
    };
    let mut is_bench = false;
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--bench" => is_bench = true,
            "--test" => is_bench = false,
            "--max" => {
                let value = arguments.next().and_then(|value| value.parse().ok());
                largest = value.unwrap_or_else(|| usage(&argument));
            }
            _ => usage(&argument),
        }
    }
    if !is_bench {
        largest = 0;
        effort = Effort {
            least_rounds: 1,
            budget: Duration::ZERO,
        };
    }
    let all = std::thread::available_parallelism().map_or(1, usize::from);
    let threads: Vec<usize> = if all > 1 { vec![1, all] } else { vec![1] };
    let mut sizes: Vec<usize> = (3..7).map(|k| 10usize.pow(k)).collect();
    sizes.retain(|n| *n <= largest);
    if sizes.is_empty() {
        sizes.push(20);
    }
    println!("Sums around vertices of valence 6, blocks of 21 rows: microseconds a vertex.\n");
    println!(
        "| vertices | indefinite | threads | `H_into` | psd by hand | `P`, sorted each time | `P_into` |"
    );
    println!("|{}", "---|".repeat(7));
    for vertices in sizes {
        table(vertices, &threads, effort);
    }
}

fn usage(argument: &str) -> ! {
    eprintln!("`{argument}`? options: --max VERTICES");
    std::process::exit(2)
}
