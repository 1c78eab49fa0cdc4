//! A thin sheet, held at one side, bends under its weight until it is at rest.
//!
//! ```text
//! cargo run --release --example discrete_shell
//! ```
//!
//! The program is in `discrete_shell.hlang`: the energy of discrete shells (Grinspun et al. 2003), whose terms for bending take the four
//! vertices of the two triangles at an edge. First the derivatives are compared with finite differences by
//! [`check_derivatives`], then Newton's method looks for the least energy. Writes `out/discrete_shell.png`, before and after,
//! `out/discrete_shell_convergence.png`, a plot, and `out/discrete_shell.ply`, the shape.

mod common;

use std::error::Error;
use std::ops::ControlFlow;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use common::picture::Picture;
use common::plot::write_convergence;
use common::surface::{OUTPUT, print_fact, say};
use glam::DVec3;
use iheartmesh::solve::Newton;
use iheartmesh::{
    FaceMesh, Functions, Vertex, check_derivatives, iheartmesh, inverse_vec, io, vec,
};

iheartmesh! {
    /// A thin shell with its own weight.
    pub struct Shell = include "examples/discrete_shell.hlang";
}

/// Squares along and across the sheet, each of two triangles, and the length of their sides.
const SIZE: [u32; 2] = [36, 14];
const SIDE: f64 = 0.05;
/// Resistance to stretching and to bending, and weight.
const STRETCHING: f64 = 200.0;
const BENDING: f64 = 0.02;
const WEIGHT: f64 = 0.5;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// A flat sheet, and the vertices of its first two rows.
fn sheet() -> (Vec<DVec3>, Vec<[u32; 3]>, Vec<Vertex>) {
    let [nx, nz] = SIZE;
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    let mut held = Vec::new();
    for i in 0..=nx {
        for k in 0..=nz {
            let here = i * (nz + 1) + k;
            positions.push(SIDE * DVec3::new(f64::from(i), 0.0, f64::from(k)));
            if i < 2 {
                held.push(Vertex::new(here));
            }
            if i < nx && k < nz {
                let [a, b, c, d] = [here, here + 1, here + nz + 2, here + nz + 1];
                // the diagonals change from square to square, so that the sheet is as stiff along one as along the other
                triangles.extend(match (i + k) % 2 {
                    0 => [[a, b, c], [a, c, d]],
                    _ => [[a, b, d], [b, c, d]],
                });
            }
        }
    }
    (positions, triangles, held)
}

fn run() -> Result<(), Box<dyn Error>> {
    let (rest, triangles, held) = sheet();
    let mesh = FaceMesh::from_triangles(rest.len(), &triangles)?;
    let (v, e, f) = (mesh.n_vertices(), mesh.n_edges(), mesh.n_faces());
    print_fact("sizes", &format!("V = {v}, E = {e}, F = {f}"));

    // derivatives, at a shape that is not flat
    let bent: Vec<DVec3> = rest
        .iter()
        .map(|x| {
            *x + 0.1
                * DVec3::new(
                    (3.0 * x.z).sin(),
                    (4.0 * x.x).sin() + x.z,
                    (2.0 * x.x).cos(),
                )
        })
        .collect();
    let shell = Shell::new(&mesh, &rest, &rest, &held, STRETCHING, BENDING, WEIGHT)?;
    let mut energy = Functions {
        state: shell,
        set: |m: &mut Shell, x: &[f64]| Ok(m.set_x(inverse_vec::<DVec3>(x)?)?),
        energy: |m: &mut Shell| Ok(m.try_e()?),
        gradient: |m: &mut Shell| Ok(m.try_G()?),
        hessian: |m: &mut Shell| Ok(m.try_H()?),
    };
    let report = check_derivatives(&mut energy, vec(&bent).as_slice())?;
    print_fact("check", &report.to_string());
    if !report.is_within(1e-6) {
        return Err("the derivatives are wrong".into());
    }

    // the same with projected blocks in place of the Hessian
    let mut energy = Functions {
        state: energy.state,
        set: energy.set,
        energy: energy.energy,
        gradient: energy.gradient,
        hessian: |m: &mut Shell| Ok(m.try_P()?),
    };
    let newton = Newton {
        damping: 1e-9,
        ..Newton::default()
    };
    let begin = Instant::now();
    let (mut energies, mut gradients, mut decrements) = (Vec::new(), Vec::new(), Vec::new());
    let found = newton.minimize_with(&mut energy, vec(&rest).as_slice(), |progress| {
        energies.push(progress.energy);
        gradients.push(progress.gradient);
        decrements.push(progress.decrement);
        ControlFlow::Continue(())
    })?;
    print_fact(
        "found",
        &format!(
            "{:?} after {} steps, {:.1?}; energy {:.8}, gradient {:.1e}",
            found.stop,
            found.steps,
            begin.elapsed(),
            found.energy,
            found.gradient
        ),
    );
    if !found.converged() {
        return Err("there is no shape at rest".into());
    }
    let shape: Vec<DVec3> = inverse_vec(&found.x)?;
    let low = shape.iter().fold(0.0, |low: f64, x| low.min(x.y));
    let longest = f64::from(SIZE[0]) * SIDE;
    print_fact(
        "depth",
        &format!("{:.3}, of a sheet of length {longest:.2}", -low),
    );

    let [picture, plot, file] = [".png", "_convergence.png", ".ply"]
        .map(|end| Path::new(OUTPUT).join(format!("discrete_shell{end}")));
    Picture::new("Discrete shell")
        .subtitle(&format!(
            "a sheet of {f} triangles, held at its left side; the height"
        ))
        .view(25.0, 20.0)
        .flat()
        .edges()
        .scalar_field(&rest, &triangles, &vec![0.0; rest.len()])
        .caption("before")
        .scalar_field(
            &shape,
            &triangles,
            &shape.iter().map(|x| x.y).collect::<Vec<_>>(),
        )
        .caption(&format!(
            "at rest, after {} steps of Newton's method",
            found.steps
        ))
        .write_png(&picture)?;
    let above: Vec<f64> = energies.iter().map(|e| e - found.energy).collect();
    write_convergence(
        &plot,
        "Energy of a discrete shell, projected Newton",
        &[
            ("energy − least", &above),
            ("decrement", &decrements),
            ("gradient", &gradients),
        ],
    )?;
    let depth: Vec<f64> = shape.iter().map(|x| -x.y).collect();
    let attributes = io::Attributes::new().vertex_scalar("depth", depth);
    io::write(&file, &shape, &mesh, &attributes)?;
    say!(
        "wrote {}, {} and {}",
        picture.display(),
        plot.display(),
        file.display()
    );
    Ok(())
}
