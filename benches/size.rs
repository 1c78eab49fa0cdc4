//! How large a mesh may be: a torus of 20 million triangles, its Gaussian curvature, and the memory of each step.
//!
//! ```text
//! cargo bench --bench size                           # 20 million triangles
//! cargo bench --bench size -- --triangles 2000000
//! cargo bench --bench size -- --shuffled             # vertices and faces in random order
//! ```
//!
//! Memory is what the operating system says of the process (on Linux). Under `cargo test --benches` the torus is tiny.

// The names of the program's methods are those of the formula.
#![allow(non_snake_case)]

#[path = "../examples/common/generate.rs"]
#[allow(dead_code)]
mod generate;

use std::time::Instant;

use iheartmesh::{FaceMesh, iheartmesh};

iheartmesh! {
    pub struct GaussianCurvature = include "tests/programs/gaussian_curvature.hlang";
}

/// A number of bytes that the system tells of this process, 0 where it does not.
fn status(field: &str) -> u64 {
    let text = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = text
        .lines()
        .find_map(|line| line.strip_prefix(field)?.strip_prefix(':'));
    let kibibytes = line.and_then(|line| line.split_whitespace().next()?.parse::<u64>().ok());
    1024 * kibibytes.unwrap_or(0)
}

/// Runs a step and prints a row: its time, and what it holds after it and at its most.
fn step<T>(name: &str, n_triangles: usize, compute: impl FnOnce() -> T) -> T {
    // the most since the last step; it is the most of all where the system does not let it be reset
    let _ = std::fs::write("/proc/self/clear_refs", "5");
    let before = status("VmRSS");
    let start = Instant::now();
    let result = compute();
    let seconds = start.elapsed().as_secs_f64();
    let (after, peak) = (status("VmRSS"), status("VmHWM"));
    println!(
        "| {name} | {seconds:.2} | {:.1} | {:.2} | {:.2} |",
        (after as f64 - before as f64) / n_triangles as f64,
        after as f64 / f64::from(1 << 30),
        peak as f64 / f64::from(1 << 30)
    );
    result
}

fn main() {
    let mut n_triangles = 20_000_000_usize;
    let (mut is_bench, mut is_shuffled) = (false, false);
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--bench" => is_bench = true,
            "--test" => is_bench = false,
            "--shuffled" => is_shuffled = true,
            "--triangles" => {
                let number = arguments.next().and_then(|number| number.parse().ok());
                n_triangles = number.expect("--triangles takes a number");
            }
            _ => panic!("unknown argument {argument}"),
        }
    }
    if !is_bench {
        n_triangles = 2000;
    }
    let n_along = ((n_triangles / 20) as f64).sqrt().round().max(3.0) as usize;
    let n_around = n_triangles / 2 / n_along;
    println!("| step | s | bytes a triangle that stay | GiB held | GiB at most |");
    println!("|---|---|---|---|---|");
    let (x, triangles) = step("positions and triangles", n_triangles, || {
        let (x, triangles) = generate::torus(n_around, n_along);
        match is_shuffled {
            true => generate::shuffle(&x, &triangles, 1),
            false => (x, triangles),
        }
    });
    let n_triangles = triangles.len();
    let mesh = step("`FaceMesh::from_triangles`", n_triangles, || {
        FaceMesh::from_triangles(x.len(), &triangles).expect("a torus is a mesh")
    });
    drop(triangles);
    let curvature = step("`GaussianCurvature::new`: the plan", n_triangles, || {
        GaussianCurvature::new(&mesh, &x[..]).expect("one position for each vertex")
    });
    let K = step("`K_all`", n_triangles, || curvature.K_all());
    let K = step("`K_all` again", n_triangles, || {
        drop(K);
        curvature.K_all()
    });
    // Gauss and Bonnet: a torus has no curvature in total, but for rounding
    let total: f64 = K.iter().sum();
    let absolute: f64 = K.iter().map(|k| k.abs()).sum();
    println!("\n{n_triangles} triangles; ∑K = {total:.1e}, ∑|K| = {absolute:.1}");
    assert!(total.abs() <= 1e-9 * n_triangles as f64, "∑K is {total}");
    assert!(absolute > 1.0, "∑|K| is {absolute}");
}
