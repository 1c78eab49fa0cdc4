//! Generated derivatives of the symmetric Dirichlet energy against closed forms by hand and against dual numbers; prints
//! Markdown tables.
//!
//! ```text
//! cargo bench --bench derivatives                    # triangles and tetrahedra
//! cargo bench --bench derivatives -- --max 10000     # smaller meshes only
//! cargo bench --bench derivatives -- --table cells   # one table: triangles, cells
//! ```
//!
//! Under `cargo test --benches` it runs on a tiny mesh, to see that all agree.

// The values are what is measured; their names are those of the formulas.
#![allow(non_snake_case)]

mod baseline;
#[path = "derivatives/dual.rs"]
mod dual;
#[path = "curvature/measure.rs"]
mod measure;
#[path = "derivatives/meshes.rs"]
mod meshes;

use std::time::Duration;

use baseline::symmetric_dirichlet::{self as by_hand, Elements, Pattern};
use glam::{DMat2, DMat3, DVec2, DVec3};
use iheartmesh::nalgebra::DMatrix;
use iheartmesh::{CellMesh, FaceMesh, iheartmesh};
use measure::{Contestant, Effort, contest, contestant};
use rayon::ThreadPoolBuilder;

iheartmesh! {
    #[together(e, g, H)]
    pub struct Triangles = include "benches/derivatives/triangles.hlang";
    pub struct FromRest = include "tests/programs/symmetric_dirichlet.hlang";
    #[together(e, g, H)]
    pub struct Cells = include "benches/derivatives/tetrahedra.hlang";
}

/// Column titles and times in nanoseconds for each element.
fn row(label: &str, elements: usize, threads: usize, times: &[Duration]) {
    let times: Vec<String> = times
        .iter()
        .map(|t| format!("{:.0}", t.as_secs_f64() * 1e9 / elements as f64))
        .collect();
    println!(
        "| {label} | {elements} | {threads} | {} |",
        times.join(" | ")
    );
}

fn head(columns: &[&str]) {
    println!("\n| | elements | threads | {} |", columns.join(" | "));
    println!("|{}", "---|".repeat(columns.len() + 3));
}

/// The greatest difference of two lists, as a part of the greatest value.
fn difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len(), "the patterns differ");
    let most = b.iter().fold(0.0, |most: f64, b| most.max(b.abs()));
    let pairs = a.iter().zip(b);
    pairs.fold(0.0, |worst: f64, (a, b)| worst.max((a - b).abs() / most))
}

/// How many elements have second derivatives with a negative eigenvalue; `block` computes those of a mesh of one.
fn count_indefinite<const N: usize, Q: Copy, X: Copy>(
    elements: &Elements<N, Q>,
    x: &[X],
    dimension: usize,
    block: impl Fn(&Elements<N, Q>, &[X], &Pattern) -> Vec<f64>,
) -> usize {
    let alone: [u32; N] = std::array::from_fn(|k| k as u32);
    let pattern = Pattern::new(&[alone], N, dimension);
    let shapes = elements.inverses.iter().zip(&elements.sizes);
    let all = elements.vertices.iter().zip(shapes);
    all.filter(|(vertices, (inverse, size))| {
        let part = Elements {
            vertices: vec![alone],
            inverses: vec![**inverse],
            sizes: vec![**size],
        };
        let values = block(&part, &vertices.map(|v| x[v as usize]), &pattern);
        let n = N * dimension;
        let eigenvalues = DMatrix::from_vec(n, n, values).symmetric_eigenvalues();
        eigenvalues.min() < -1e-9 * eigenvalues.max()
    })
    .count()
}

fn say_indefinite(moved: usize, stretched: usize, count: usize) {
    println!(
        "\n{moved} of {count} elements have indefinite second derivatives; {stretched} if they are stretched."
    );
}

fn triangles(sizes: &[usize], threads: &[usize], effort: Effort) {
    println!("\nTriangles: nanoseconds for each.");
    for n in sizes {
        let grid = meshes::triangles(*n);
        let mesh = FaceMesh::from_triangles(grid.rest.len(), &grid.elements.vertices)
            .expect("a grid is a mesh");
        let (elements, x) = (&grid.elements, &grid.positions);
        let count = elements.vertices.len();
        let pattern = Pattern::new(&elements.vertices, x.len(), 2);
        let program = || {
            Triangles::new(&mesh, &elements.inverses, &elements.sizes, x)
                .expect("the inputs fit the mesh")
        };
        // what is compared must be the same
        let mut values = vec![0.0; pattern.rows.len()];
        let mut slope = vec![0.0; 2 * x.len()];
        {
            let module = program();
            let energy = by_hand::energy(elements, x);
            assert!((module.e() - energy).abs() <= 1e-10 * energy);
            by_hand::gradient(elements, x, &mut slope);
            assert!(difference(module.g().as_slice(), &slope) < 1e-10);
            by_hand::hessian(elements, &pattern, x, false, &mut values);
            assert!(difference(module.H().data(), &values) < 1e-10);
            let mut duals = vec![0.0; values.len()];
            dual::hessian(elements, &pattern, x, &mut duals);
            assert!(difference(&duals, &values) < 1e-10);
        }
        let indefinite = |x: &[DVec2]| {
            let block = |part: &Elements<3, DMat2>, x: &[DVec2], pattern: &Pattern| {
                let mut values = vec![0.0; pattern.rows.len()];
                by_hand::hessian(part, pattern, x, false, &mut values);
                values
            };
            count_indefinite(elements, x, 2, block)
        };
        say_indefinite(indefinite(x), indefinite(&grid.gentle), count);
        head(&[
            "energy by hand",
            "`e`",
            "gradient by hand",
            "`g`",
            "Hessian by hand",
            "`H`",
            "`H_into`",
            "`e`, `g_into`, `H_into`",
            "`e_g_H_into`",
            "dual numbers",
            "psd by hand",
            "`P`",
            "`P`, stretched",
        ]);
        for threads in threads {
            let pool = ThreadPoolBuilder::new().num_threads(*threads).build();
            pool.expect("threads can be started").install(|| {
                let (mut module, mut slope) = (program(), slope.clone());
                let mut second = program();
                let mut third = program();
                let (mut fourth, mut eighth) = (program(), program());
                let (mut fifth, mut sixth, mut seventh) = (program(), program(), program());
                let (mut second_at_hand, mut all_at_hand) = (fifth.H(), sixth.H());
                let mut slope_at_hand = sixth.g();
                let (_, mut slope_together, mut second_together) = seventh.e_g_H();
                let (mut h, mut d, mut p) = (values.clone(), values.clone(), values.clone());
                let mut runs: Vec<Contestant<'_>> = vec![
                    contestant(|| by_hand::energy(elements, x)),
                    contestant(|| {
                        module.set_x(x).expect("as many as before");
                        module.e()
                    }),
                    contestant(|| by_hand::gradient(elements, x, &mut slope)),
                    contestant(|| {
                        second.set_x(x).expect("as many as before");
                        second.g()
                    }),
                    contestant(|| by_hand::hessian(elements, &pattern, x, false, &mut h)),
                    contestant(|| {
                        third.set_x(x).expect("as many as before");
                        third.H()
                    }),
                    contestant(|| {
                        fifth.set_x(x).expect("as many as before");
                        fifth.H_into(&mut second_at_hand);
                    }),
                    contestant(|| {
                        sixth.set_x(x).expect("as many as before");
                        sixth.g_into(&mut slope_at_hand);
                        sixth.H_into(&mut all_at_hand);
                        sixth.e()
                    }),
                    contestant(|| {
                        seventh.set_x(x).expect("as many as before");
                        seventh.e_g_H_into(&mut slope_together, &mut second_together)
                    }),
                    contestant(|| dual::hessian(elements, &pattern, x, &mut d)),
                    contestant(|| by_hand::hessian(elements, &pattern, x, true, &mut p)),
                    contestant(|| {
                        fourth.set_x(x).expect("as many as before");
                        fourth.P()
                    }),
                    contestant(|| {
                        eighth.set_x(&grid.gentle).expect("as many as before");
                        eighth.P()
                    }),
                ];
                row("shapes at hand", count, *threads, &contest(effort, &mut runs));
                drop(runs);
                let from_rest = || FromRest::new(&mesh, &grid.rest, x).expect("the inputs fit the mesh");
                let mut modules = [from_rest(), from_rest(), from_rest(), from_rest()];
                let [a, b, c, d] = &mut modules;
                let mut runs: Vec<Contestant<'_>> = vec![
                    contestant(|| {
                        a.set_x(x).expect("as many as before");
                        a.e()
                    }),
                    contestant(|| {
                        b.set_x(x).expect("as many as before");
                        b.g()
                    }),
                    contestant(|| {
                        c.set_x(x).expect("as many as before");
                        c.H()
                    }),
                    contestant(|| {
                        d.set_x(x).expect("as many as before");
                        d.P()
                    }),
                ];
                let times = contest(effort, &mut runs);
                let per = |k: usize| times[k].as_secs_f64() * 1e9 / count as f64;
                println!(
                    "| from positions at rest | {count} | {threads} | | {:.0} | | {:.0} | | {:.0} | | | | | | {:.0} | |",
                    per(0), per(1), per(2), per(3)
                );
            });
        }
    }
}

fn cells(sizes: &[usize], threads: &[usize], effort: Effort) {
    println!("\nTetrahedra: nanoseconds for each.");
    for n in sizes {
        let grid = meshes::tetrahedra(*n);
        let (elements, x) = (&grid.elements, &grid.positions);
        let mesh =
            CellMesh::from_tetrahedra(x.len(), &elements.vertices).expect("a grid is a mesh");
        let count = elements.vertices.len();
        let program = || {
            Cells::new(&mesh, &elements.inverses, &elements.sizes, x)
                .expect("the inputs fit the mesh")
        };
        let pattern = Pattern::new(&elements.vertices, x.len(), 3);
        let mut slope = vec![0.0; 3 * x.len()];
        let mut values = vec![0.0; pattern.rows.len()];
        {
            let module = program();
            let energy = by_hand::energy_of_cells(elements, x);
            assert!((module.e() - energy).abs() <= 1e-10 * energy);
            by_hand::gradient_of_cells(elements, x, &mut slope);
            assert!(difference(module.g().as_slice(), &slope) < 1e-10);
            by_hand::hessian_of_cells(elements, &pattern, x, &mut values);
            assert!(difference(module.H().data(), &values) < 1e-10);
            let mut duals = vec![0.0; values.len()];
            dual::hessian_of_cells(elements, &pattern, x, &mut duals);
            assert!(difference(&duals, &values) < 1e-10);
        }
        let indefinite = |x: &[DVec3]| {
            let block = |part: &Elements<4, DMat3>, x: &[DVec3], pattern: &Pattern| {
                let mut values = vec![0.0; pattern.rows.len()];
                by_hand::hessian_of_cells(part, pattern, x, &mut values);
                values
            };
            count_indefinite(elements, x, 3, block)
        };
        say_indefinite(indefinite(x), indefinite(&grid.gentle), count);
        head(&[
            "energy by hand",
            "`e`",
            "gradient by hand",
            "`g`",
            "Hessian by hand",
            "`H`",
            "`H_into`",
            "`e`, `g_into`, `H_into`",
            "`e_g_H_into`",
            "dual numbers",
            "`P`",
            "`P`, stretched",
        ]);
        for threads in threads {
            let pool = ThreadPoolBuilder::new().num_threads(*threads).build();
            pool.expect("threads can be started").install(|| {
                let mut slope = slope.clone();
                let mut modules: [_; 8] = std::array::from_fn(|_| program());
                let [a, b, c, d, into, each, together, gentle] = &mut modules;
                let (mut second_at_hand, mut all_at_hand) = (into.H(), each.H());
                let mut slope_at_hand = each.g();
                let (_, mut slope_together, mut second_together) = together.e_g_H();
                let (mut h, mut duals) = (values.clone(), values.clone());
                let mut runs: Vec<Contestant<'_>> = vec![
                    contestant(|| by_hand::energy_of_cells(elements, x)),
                    contestant(|| {
                        a.set_x(x).expect("as many as before");
                        a.e()
                    }),
                    contestant(|| by_hand::gradient_of_cells(elements, x, &mut slope)),
                    contestant(|| {
                        b.set_x(x).expect("as many as before");
                        b.g()
                    }),
                    contestant(|| by_hand::hessian_of_cells(elements, &pattern, x, &mut h)),
                    contestant(|| {
                        c.set_x(x).expect("as many as before");
                        c.H()
                    }),
                    contestant(|| {
                        into.set_x(x).expect("as many as before");
                        into.H_into(&mut second_at_hand);
                    }),
                    contestant(|| {
                        each.set_x(x).expect("as many as before");
                        each.g_into(&mut slope_at_hand);
                        each.H_into(&mut all_at_hand);
                        each.e()
                    }),
                    contestant(|| {
                        together.set_x(x).expect("as many as before");
                        together.e_g_H_into(&mut slope_together, &mut second_together)
                    }),
                    contestant(|| dual::hessian_of_cells(elements, &pattern, x, &mut duals)),
                    contestant(|| {
                        d.set_x(x).expect("as many as before");
                        d.P()
                    }),
                    contestant(|| {
                        gentle.set_x(&grid.gentle).expect("as many as before");
                        gentle.P()
                    }),
                ];
                row(
                    "shapes at hand",
                    count,
                    *threads,
                    &contest(effort, &mut runs),
                );
            });
        }
    }
}

fn main() {
    let mut largest = 1_000_000;
    let mut effort = Effort {
        least_rounds: 5,
        budget: Duration::from_secs(2),
    };
    let mut table = None;
    let mut is_bench = false;
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        let mut value = || arguments.next().unwrap_or_else(|| usage(&argument));
        match argument.as_str() {
            "--bench" => is_bench = true,
            "--test" => is_bench = false,
            "--max" => largest = value().parse().unwrap_or_else(|_| usage(&argument)),
            "--seconds" => {
                let seconds: f64 = value().parse().unwrap_or_else(|_| usage(&argument));
                effort.budget =
                    Duration::try_from_secs_f64(seconds).unwrap_or_else(|_| usage(&argument));
            }
            "--table" => table = Some(value()),
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
    let sizes = |most: usize| -> Vec<usize> {
        let powers = (3..=most as u32).map(|k| 10usize.pow(k));
        let sizes: Vec<usize> = powers.filter(|n| *n <= largest).collect();
        if sizes.is_empty() { vec![20] } else { sizes }
    };
    match table.as_deref() {
        None => {
            triangles(&sizes(6), &threads, effort);
            cells(&sizes(5), &threads, effort);
        }
        Some("triangles") => triangles(&sizes(6), &threads, effort),
        Some("cells") => cells(&sizes(5), &threads, effort),
        Some(other) => usage(other),
    }
}

fn usage(argument: &str) -> ! {
    eprintln!("`{argument}`? options: --max ELEMENTS, --seconds PER_ROW, --table triangles|cells");
    std::process::exit(2)
}
