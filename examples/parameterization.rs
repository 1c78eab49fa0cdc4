//! A surface laid out in the plane: the map with the least symmetric Dirichlet energy, by Newton's method.
//!
//! ```text
//! cargo run --release --example parameterization [-- FILE]
//! ```
//!
//! Two programs, in `parameterization`: `tutte.hlang` lays the boundary around a circle and each vertex inside into the middle
//! of its neighbours, which is a sparse system of equations; `symmetric_dirichlet.hlang`, from figure 7 of the paper on
//! I♥MESH, is an energy that is least where lengths and angles are kept, with its gradient and its Hessian, the sum of
//! blocks projected by `psd`. The loop is that of [`Newton`]. Without a file, the surface is the front of Spot, each
//! triangle divided into four. Writes `out/parameterization.png`, with a checkerboard on the surface before and after,
//! `out/parameterization_convergence.png`, a plot, and `out/parameterization.ply`, the map.

mod common;

use std::error::Error;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use common::checkerboard::{Map, write_maps};
use common::disk::{around_a_circle, cut, flipped, subdivided};
use common::plot::write_convergence;
use common::raster::View;
use common::surface::{OUTPUT, print_fact, say};
use glam::{DVec2, DVec3};
use iheartmesh::nalgebra::DVector;
use iheartmesh::solve::Newton;
use iheartmesh::sprs::CsMat;
use iheartmesh::{
    FaceMesh, Failure, Objective, TwiceDifferentiable, check_gradient, iheartmesh, inverse_vec, io,
    vec,
};

iheartmesh! {
    /// The map in which each vertex is in the middle of its neighbours.
    pub struct Tutte = include "examples/parameterization/tutte.hlang";

    /// The symmetric Dirichlet energy of a map to the plane.
    pub struct SymmetricDirichlet = include "examples/parameterization/symmetric_dirichlet.hlang";
}

impl Objective for SymmetricDirichlet<'_> {
    fn set(&mut self, x: &[f64]) -> Result<(), Failure> {
        Ok(self.set_x(inverse_vec::<DVec2>(x)?)?)
    }

    fn energy(&mut self) -> Result<f64, Failure> {
        Ok(self.try_e()?)
    }

    fn gradient(&mut self, gradient: &mut DVector<f64>) -> Result<(), Failure> {
        Ok(self.try_G_into(gradient)?)
    }
}

impl TwiceDifferentiable for SymmetricDirichlet<'_> {
    fn hessian(&mut self, hessian: &mut CsMat<f64>) -> Result<(), Failure> {
        Ok(self.try_H_into(hessian)?)
    }
}

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let (name, surface, mesh) = surface()?;
    let triangles = mesh.triangles().ok_or("some faces are not triangles")?;
    say!("{name}");
    let (v, f, b) = (
        mesh.n_vertices(),
        mesh.n_faces(),
        mesh.boundary_edges().len(),
    );
    print_fact(
        "sizes",
        &format!("V = {v}, F = {f}, {b} edges at the boundary"),
    );

    let begin = Instant::now();
    let tutte = Tutte::new(&mesh, around_a_circle(&mesh, &surface)?)?;
    let start: Vec<DVec2> = tutte.try_x()?;
    print_fact(
        "Tutte",
        &format!(
            "{:.0?}, {} triangles flipped",
            begin.elapsed(),
            flipped(&start, triangles)
        ),
    );

    let begin = Instant::now();
    let mut dirichlet = SymmetricDirichlet::new(&mesh, &surface, &start)?;
    print_fact("plan", &format!("{:.0?}", begin.elapsed()));
    let start_vec = vec(&start);
    print_fact(
        "check",
        &check_gradient(&mut dirichlet, start_vec.as_slice())?.to_string(),
    );

    // a movement of the whole does not change the energy
    let newton = Newton {
        damping: 1e-9,
        ..Newton::default()
    };
    let begin = Instant::now();
    let (mut energies, mut gradients, mut decrements) = (Vec::new(), Vec::new(), Vec::new());
    say!(
        "  {:>4}{:>18}{:>14}{:>12}{:>10}",
        "step",
        "energy",
        "decrement",
        "gradient",
        "length"
    );
    let found = newton.minimize_with(&mut dirichlet, start_vec.as_slice(), |progress| {
        energies.push(progress.energy);
        gradients.push(progress.gradient);
        decrements.push(progress.decrement);
        say!(
            "  {:>4}{:>18.10}{:>14.2e}{:>12.2e}{:>10.2e}",
            progress.step,
            progress.energy,
            progress.decrement,
            progress.gradient,
            progress.length
        );
        ControlFlow::Continue(())
    })?;
    let time = begin.elapsed();
    let end: Vec<DVec2> = inverse_vec(&found.x)?;
    print_fact(
        "ended by",
        &format!("{:?} after {} steps, {time:.1?}", found.stop, found.steps),
    );
    let flips = flipped(&end, triangles);
    print_fact("flipped", &format!("{flips} of {f} triangles"));
    let area: f64 = areas(&surface, triangles).sum();
    print_fact(
        "energy",
        &format!(
            "{:.6}, at least 4 times the area, {:.6}",
            found.energy,
            4.0 * area
        ),
    );
    if flips > 0 || !found.converged() {
        return Err("there is no valid minimum".into());
    }

    let [picture, plot, file] = [".png", "_convergence.png", ".ply"]
        .map(|end| Path::new(OUTPUT).join(format!("parameterization{end}")));
    // of the same area, so that the squares compare
    let scale = (area / std::f64::consts::PI).sqrt();
    let scaled: Vec<DVec2> = start.iter().map(|x| scale * x).collect();
    write_maps(
        &picture,
        (
            "Parameterization",
            &format!("{name}, {f} triangles: squares of the plane on the surface, and the plane"),
        ),
        (
            &surface,
            View {
                azimuth: 205.0,
                elevation: 14.0,
            },
        ),
        triangles,
        &[
            Map {
                plane: &scaled,
                caption: format!("before: Tutte's map, energy {:.4}", energies[0]),
            },
            Map {
                plane: &end,
                caption: format!(
                    "after {} steps of Newton's method, energy {:.4}",
                    found.steps, found.energy
                ),
            },
        ],
        900.0,
    )?;
    let above: Vec<f64> = energies.iter().map(|e| e - found.energy).collect();
    write_convergence(
        &plot,
        "Symmetric Dirichlet energy, projected Newton",
        &[
            ("energy − least", &above),
            ("decrement", &decrements),
            ("gradient", &gradients),
        ],
    )?;
    let [u, w] = [0, 1].map(|k| end.iter().map(|x| x[k]).collect::<Vec<f64>>());
    let attributes = io::Attributes::new()
        .vertex_scalar("u", u)
        .vertex_scalar("v", w);
    io::write(&file, &surface, &mesh, &attributes)?;
    say!(
        "wrote {}, {} and {}",
        picture.display(),
        plot.display(),
        file.display()
    );
    Ok(())
}

fn areas<'a>(x: &'a [DVec3], triangles: &'a [[u32; 3]]) -> impl Iterator<Item = f64> + 'a {
    triangles.iter().map(|t| {
        let [a, b, c] = t.map(|v| x[v as usize]);
        0.5 * (b - a).cross(c - a).length()
    })
}

/// The surface of the file that the argument names, or the front of Spot.
fn surface() -> Result<(String, Vec<DVec3>, FaceMesh), Box<dyn Error>> {
    if let Some(argument) = std::env::args_os().nth(1) {
        let path = PathBuf::from(argument);
        let file = io::read(&path)?;
        let mesh = file.face_mesh()?;
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        return Ok((name.into_owned(), file.positions, mesh));
    }
    let spot = io::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("meshes/spot.ply"))?;
    let mesh = spot.face_mesh()?;
    let triangles = mesh.triangles().ok_or("some faces are not triangles")?;
    let (x, front) = cut(&spot.positions, triangles, DVec3::new(0.0, 0.5, -0.87));
    let (x, parts) = subdivided(&x, &front);
    let mesh = FaceMesh::from_triangles(x.len(), &parts)?;
    Ok(("the front of spot.ply".to_owned(), x, mesh))
}
