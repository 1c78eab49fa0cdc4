//! Gradient descent: a surface becomes smooth but stays near what was measured.
//!
//! ```text
//! cargo run --release --example gradient_descent [-- FILE]
//! ```
//!
//! The program of section 4.3.1 of the paper on I♥MESH is in `gradient_descent.hlang`: an energy of two sums, its gradient by
//! all positions, and one step against it. Noise is added to the surface, and the loop in Rust takes steps until the
//! energy hardly falls any more. The gradient is compared with loops written by hand. Writes the last surface as
//! `out/gradient_descent.ply`, before and after as `.png`, and `out/gradient_descent_convergence.png`, a plot.

mod common;

use std::error::Error;
use std::process::ExitCode;

use common::plot::write_convergence;
use common::surface::{self, Surface, largest_difference, print_fact, print_time, say};
use common::timing::time_best_of;
use glam::DVec3;
use iheartmesh::{FaceMesh, iheartmesh, io};

iheartmesh! {
    /// One step of gradient descent, and what it consists of.
    pub struct GradientDescent = include "examples/gradient_descent.hlang";
}

/// The energy has fallen as far as it goes when a hundred steps lower it by less than this part of it.
const PROGRESS: f64 = 1e-4;
/// The most steps.
const STEPS: usize = 20_000;
/// The size of the noise, as a part of the size of the surface.
const NOISE: f64 = 0.015;

fn main() -> ExitCode {
    surface::run_on("gradient_descent", "meshes/bob_small.ply", study)
}

fn study(surface: &Surface) -> Result<(), Box<dyn Error>> {
    let (mesh, clean) = (&surface.mesh, &surface.positions);
    let mut random = fastrand::Rng::with_seed(1);
    let mut part = || 2.0 * random.f64() - 1.0;
    let extent = |axis: usize| {
        let of = clean.iter().map(|x| x[axis]);
        of.clone().fold(f64::MIN, f64::max) - of.fold(f64::MAX, f64::min)
    };
    let size = (0..3).map(extent).fold(0.0, f64::max);
    let noisy: Vec<DVec3> = clean
        .iter()
        .map(|x| x + NOISE * size * DVec3::new(part(), part(), part()))
        .collect();

    let mut descent = GradientDescent::new(mesh, noisy.clone(), &noisy)?;
    let by_hand = gradient(mesh, &noisy, &noisy);
    let difference = largest_difference(descent.g().as_slice(), &by_hand);
    print_fact(
        "gradient",
        &format!("{difference:.1e} from that of loops written by hand"),
    );

    say!("  after step        energy    length of the gradient");
    let energy = |descent: &GradientDescent| descent.L() + descent.D();
    let report = |step: usize, descent: &GradientDescent| {
        say!(
            "  {step:>10}{:>14.8}{:>26.2e}",
            energy(descent),
            descent.g().norm()
        );
    };
    report(0, &descent);
    let (mut before, mut step, mut next_report) = (energy(&descent), 0, 10);
    let (mut energies, mut gradients) = (vec![before], vec![descent.g().norm()]);
    loop {
        let x = descent.x1_star();
        descent.set_x(x)?;
        step += 1;
        energies.push(energy(&descent));
        gradients.push(descent.g().norm());
        if step == next_report {
            report(step, &descent);
            next_report *= 10;
        }
        if step % 100 == 0 {
            let now = energy(&descent);
            if now > (1.0 - PROGRESS) * before || step == STEPS {
                break;
            }
            before = now;
        }
    }
    report(step, &descent);
    let smooth = descent.x1_star();
    let (time, _) = time_best_of(surface.runs(), || {
        descent.set_x(smooth.clone()).map(|()| descent.g())
    });
    print_time("gradient, set_x() and g()", time, clean.len());
    let plot = format!("{}/gradient_descent_convergence.png", surface::OUTPUT);
    write_convergence(
        plot.as_ref(),
        "Gradient descent with steps of 0.1",
        &[("energy", &energies), ("gradient", &gradients)],
    )?;
    say!("wrote {plot}");
    write(surface, &noisy, &smooth, step)
}

/// The gradient of the energy, item by item.
fn gradient(mesh: &FaceMesh, x: &[DVec3], y: &[DVec3]) -> Vec<f64> {
    let (smoothness, nearness) = (2.0 / mesh.n_edges() as f64, 2.0 / mesh.n_vertices() as f64);
    let mut all: Vec<DVec3> = x.iter().zip(y).map(|(x, y)| nearness * (x - y)).collect();
    for e in mesh.edges() {
        let [i, j] = mesh.edge_vertices(e).map(|v| v.index());
        let slope = smoothness * (x[i] - x[j]);
        all[i] += slope;
        all[j] -= slope;
    }
    all.iter().flat_map(|x| x.to_array()).collect()
}

fn write(
    surface: &Surface,
    noisy: &[DVec3],
    smooth: &[DVec3],
    steps: usize,
) -> Result<(), Box<dyn Error>> {
    let [ply, png] =
        ["ply", "png"].map(|kind| format!("{}/gradient_descent.{kind}", surface::OUTPUT));
    let faces = surface.faces();
    surface
        .picture("Gradient descent")
        .subtitle(&format!(
            "{}: lengths of edges and distances from the noisy surface are balanced",
            surface.name
        ))
        .flat()
        .surface(noisy, &faces)
        .caption("noisy")
        .surface(smooth, &faces)
        .caption(&format!("after {steps} steps"))
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
