//! Bilateral filtering: noise is removed from a surface, edges stay.
//!
//! ```text
//! cargo run --release --example bilateral_filter [-- FILE]
//! ```
//!
//! The filter of S. Fleishman, I. Drori and D. Cohen-Or (2003) is in `bilateral_filter.hlang`, with the neighbourhood that
//! grows from a vertex until it covers a radius. Noise is added to the surface, the filter is run a few times, and the error
//! is printed after each time. Writes the last surface as `out/bilateral_filter.ply`, and before and after as `.png`.

mod common;

use std::error::Error;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use common::surface::{self, Surface, print_fact, print_time, say};
use glam::DVec3;
use iheartmesh::{iheartmesh, io};

iheartmesh! {
    /// One step of bilateral filtering, and what it consists of.
    pub struct BilateralFilter = include "examples/bilateral_filter.hlang";
}

/// How often the filter is run. More often is for finer meshes: it also shrinks what is thin.
const STEPS: usize = 4;

/// The size of the noise, and the widths of the filter along and across the surface, as parts of the mean length of edges.
const NOISE: f64 = 0.2;
const ALONG: f64 = 1.0;
const ACROSS: f64 = 0.1;

fn main() -> ExitCode {
    surface::run("bilateral_filter", study)
}

fn study(surface: &Surface) -> Result<(), Box<dyn Error>> {
    let (mesh, clean) = (&surface.mesh, &surface.positions);
    let length = mean_edge_length(surface);
    let (along, across) = (ALONG * length, ACROSS * length);
    let normals = BilateralFilter::new(mesh, clean, along, across)?.N_all();

    let mut random = fastrand::Rng::with_seed(1);
    let mut heights = || NOISE * length * normal_distributed(&mut random);
    let noisy: Vec<DVec3> = clean
        .iter()
        .zip(&normals)
        // a vertex without a normal, as one without a face, stays
        .map(|(x, n)| if n.is_finite() { x + heights() * n } else { *x })
        .collect();

    let mut filter = BilateralFilter::new(mesh, noisy.clone(), along, across)?;
    let neighbours = mesh.vertices().map(|v| filter.Near(v).len()).sum::<usize>();
    print_fact(
        "mean edge",
        &format!("{length:.4}; noise {:.4}", NOISE * length),
    );
    print_fact(
        "filter",
        &format!(
            "σ_c = {along:.4}, σ_s = {across:.4}, {:.1} neighbours on average",
            neighbours as f64 / clean.len() as f64
        ),
    );

    say!("  after step    normals are off by    vertices are off by");
    let off = |x: &[DVec3], filter: &BilateralFilter| {
        let angle = rms(filter
            .N_all()
            .iter()
            .zip(&normals)
            .map(|(a, b)| a.angle_between(*b).to_degrees()));
        let distance = rms(x
            .iter()
            .zip(clean)
            .zip(&normals)
            .map(|((a, b), n)| (a - b).dot(*n)));
        (angle, distance / length)
    };
    let (mut x, mut time) = (noisy.clone(), Duration::MAX);
    let report = |step: usize, (angle, distance): (f64, f64)| {
        say!("  {step:>10}{angle:>18.2}°{distance:>18.4} edges");
    };
    report(0, off(&x, &filter));
    for step in 1..=STEPS {
        let start = Instant::now();
        let moved = filter.B_all();
        time = time.min(start.elapsed());
        // where there are no neighbours, nothing moves
        x = moved
            .iter()
            .zip(&x)
            .map(|(to, from)| if to.is_finite() { *to } else { *from })
            .collect();
        filter.set_x(x.clone())?;
        report(step, off(&x, &filter));
    }
    print_time("one step, B_all()", time, clean.len());
    write(surface, &noisy, &x)
}

fn mean_edge_length(surface: &Surface) -> f64 {
    let place = |v: iheartmesh::Vertex| surface.positions[v.index()];
    let lengths = surface.mesh.edges().map(|e| {
        let [i, j] = surface.mesh.edge_vertices(e);
        place(i).distance(place(j))
    });
    lengths.sum::<f64>() / surface.mesh.n_edges() as f64
}

/// A random number of the standard normal distribution (G. E. P. Box, M. E. Muller, 1958).
fn normal_distributed(random: &mut fastrand::Rng) -> f64 {
    let (radius, turn) = (1.0 - random.f64(), random.f64());
    (-2.0 * radius.ln()).sqrt() * (std::f64::consts::TAU * turn).cos()
}

/// The root of the mean square of what is finite.
fn rms(values: impl Iterator<Item = f64>) -> f64 {
    let squares: Vec<f64> = values.filter(|x| x.is_finite()).map(|x| x * x).collect();
    (squares.iter().sum::<f64>() / squares.len().max(1) as f64).sqrt()
}

fn write(surface: &Surface, noisy: &[DVec3], smooth: &[DVec3]) -> Result<(), Box<dyn Error>> {
    let [ply, png] =
        ["ply", "png"].map(|kind| format!("{}/bilateral_filter.{kind}", surface::OUTPUT));
    let faces = surface.faces();
    surface
        .picture("Bilateral filtering")
        .subtitle(&format!(
            "{}: noise along the normals, and what the filter leaves of it",
            surface.name
        ))
        .flat()
        .surface(noisy, &faces)
        .caption("noisy")
        .surface(smooth, &faces)
        .caption(&format!("after {STEPS} steps"))
        .surface(&surface.positions, &faces)
        .caption("before the noise")
        .write_png(&png)?;
    let moved: Vec<f64> = smooth
        .iter()
        .zip(noisy)
        .map(|(a, b)| a.distance(*b))
        .collect();
    let attributes = io::Attributes::new().vertex_scalar("moved", moved);
    io::write(&ply, smooth, &surface.mesh, &attributes)?;
    say!("wrote {ply} and {png}");
    Ok(())
}
