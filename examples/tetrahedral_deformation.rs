//! A bar of tetrahedra, twisted and stretched, finds the shape of least energy by Newton's method: four energies.
//!
//! ```text
//! cargo run --release --example tetrahedral_deformation
//! ```
//!
//! The programs of figure 7 of the paper on I♥MESH are in `tetrahedral_deformation`, one for each energy; what they share, the
//! matrices of tetrahedra, they import from `deformation.hlang`. The ends of the bar are held by springs, also in the
//! programs. Writes `out/tetrahedral_deformation.png`, with the bar before and after,
//! `out/tetrahedral_deformation_convergence.png`, a plot, and `out/tetrahedral_deformation.vtk`, the last shape.

mod common;

use std::error::Error;
use std::ops::ControlFlow;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use common::bar::{bar, ends, twisted, volumes};
use common::picture::Picture;
use common::plot::write_convergence;
use common::surface::{OUTPUT, print_fact, say};
use glam::DVec3;
use iheartmesh::nalgebra::DVector;
use iheartmesh::solve::{Minimum, Newton};
use iheartmesh::sprs::CsMat;
use iheartmesh::{
    CellMesh, Failure, Objective, TwiceDifferentiable, Vertex, iheartmesh, inverse_vec, io, vec,
};

iheartmesh! {
    /// What the energies share.
    pub struct Deformation = include "examples/tetrahedral_deformation/deformation.hlang";

    /// The symmetric Dirichlet energy.
    pub struct SymmetricDirichlet = include "examples/tetrahedral_deformation/symmetric_dirichlet.hlang";

    /// The exponential symmetric Dirichlet energy.
    pub struct ExponentialSymmetricDirichlet =
        include "examples/tetrahedral_deformation/exponential_symmetric_dirichlet.hlang";

    /// The AMIPS energy.
    pub struct Amips = include "examples/tetrahedral_deformation/amips.hlang";

    /// The conformal AMIPS energy.
    pub struct ConformalAmips = include "examples/tetrahedral_deformation/conformal_amips.hlang";
}

macro_rules! objectives {
    ($($module:ident)*) => {$(
        impl Objective for $module<'_> {
            fn set(&mut self, x: &[f64]) -> Result<(), Failure> {
                Ok(self.set_x(inverse_vec::<DVec3>(x)?)?)
            }

            fn energy(&mut self) -> Result<f64, Failure> {
                Ok(self.try_e()?)
            }

            fn gradient(&mut self, gradient: &mut DVector<f64>) -> Result<(), Failure> {
                Ok(self.try_G_into(gradient)?)
            }
        }

        impl TwiceDifferentiable for $module<'_> {
            fn hessian(&mut self, hessian: &mut CsMat<f64>) -> Result<(), Failure> {
                Ok(self.try_H_into(hessian)?)
            }
        }
    )*};
}

objectives! { SymmetricDirichlet ExponentialSymmetricDirichlet Amips ConformalAmips }

/// Cubes across and along the bar, each of six tetrahedra.
const SIZE: (usize, usize) = (8, 28);
/// The angle between the ends, and the length of the bar after it is stretched.
const ANGLE: f64 = 0.6 * std::f64::consts::PI;
const STRETCH: f64 = 1.15;
/// How strongly the ends are held.
const HOLD: f64 = 1000.0;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// What Newton's method has found with one energy.
struct Found {
    name: &'static str,
    x: Vec<DVec3>,
    /// The energy after each step, above the last one.
    energies: Vec<f64>,
}

fn run() -> Result<(), Box<dyn Error>> {
    let (rest, tetrahedra) = bar(SIZE.0, SIZE.1);
    let mesh = CellMesh::from_tetrahedra(rest.len(), &tetrahedra)?;
    print_fact(
        "sizes",
        &format!("V = {}, C = {}", mesh.n_vertices(), mesh.n_cells()),
    );
    let start = twisted(&rest, ANGLE, STRETCH);
    let held = ends(&rest);
    let places: Vec<DVec3> = held.iter().map(|v| start[*v as usize]).collect();
    let held: Vec<Vertex> = held.into_iter().map(Vertex::new).collect();

    let mut all = Vec::new();
    macro_rules! minimize {
        ($($name:literal $module:ident)*) => {$(
            let mut energy = $module::new(&mesh, &rest, &start, &held, &places, HOLD)?;
            all.push(minimize($name, &mut energy, &start, &tetrahedra)?);
        )*};
    }
    minimize! {
        "symmetric Dirichlet" SymmetricDirichlet
        "exponential S. D." ExponentialSymmetricDirichlet
        "AMIPS" Amips
        "conformal AMIPS" ConformalAmips
    }
    write(&mesh, &tetrahedra, &rest, &start, &all)
}

fn minimize(
    name: &'static str,
    energy: &mut impl TwiceDifferentiable,
    start: &[DVec3],
    tetrahedra: &[[u32; 4]],
) -> Result<Found, Box<dyn Error>> {
    let newton = Newton {
        decrement: 1e-6,
        ..Newton::default()
    };
    let begin = Instant::now();
    let mut energies = Vec::new();
    let found: Minimum = newton.minimize_with(energy, vec(start).as_slice(), |progress| {
        energies.push(progress.energy);
        ControlFlow::Continue(())
    })?;
    let time = begin.elapsed();
    let x: Vec<DVec3> = inverse_vec(&found.x)?;
    let inverted = volumes(&x, tetrahedra)
        .iter()
        .filter(|v| **v <= 0.0)
        .count();
    print_fact(
        name,
        &format!(
            " {:.6} to {:.6} in {} steps, {time:.1?}; gradient {:.1e}, {inverted} tetrahedra inverted",
            energies[0], found.energy, found.steps, found.gradient
        ),
    );
    if inverted > 0 || !found.converged() {
        return Err(format!("{name}: there is no valid minimum").into());
    }
    for energy in &mut energies {
        *energy -= found.energy;
    }
    Ok(Found { name, x, energies })
}

fn write(
    mesh: &CellMesh,
    tetrahedra: &[[u32; 4]],
    rest: &[DVec3],
    start: &[DVec3],
    all: &[Found],
) -> Result<(), Box<dyn Error>> {
    let [picture, plot, file] = [".png", "_convergence.png", ".vtk"]
        .map(|end| Path::new(OUTPUT).join(format!("tetrahedral_deformation{end}")));
    let (boundary, _) = mesh.boundary_mesh()?;
    let faces: Vec<Vec<u32>> = boundary
        .faces()
        .map(|f| boundary.face_vertices(f).ids().to_vec())
        .collect();
    // how much larger than at rest the tetrahedra around each vertex are
    let growth = |x: &[DVec3]| {
        let mut sums = vec![(0.0, 0.0); x.len()];
        for ((t, now), before) in tetrahedra
            .iter()
            .zip(volumes(x, tetrahedra))
            .zip(volumes(rest, tetrahedra))
        {
            for v in t {
                sums[*v as usize].0 += now;
                sums[*v as usize].1 += before;
            }
        }
        sums.iter()
            .map(|(now, before)| now / before - 1.0)
            .collect::<Vec<f64>>()
    };
    let mut shown = Picture::new("Deformed tetrahedra")
        .subtitle(&format!(
            "a bar of {} tetrahedra, twisted and stretched; the colour is the change of volume",
            mesh.n_cells()
        ))
        .view(-30.0, 15.0)
        .flat()
        .limit(0.4)
        .scalar_field(start, &faces, &growth(start))
        .caption("before");
    for found in all {
        shown = shown
            .scalar_field(&found.x, &faces, &growth(&found.x))
            .caption(found.name);
    }
    shown.write_png(&picture)?;
    let curves: Vec<(&str, &[f64])> = all.iter().map(|f| (f.name, &f.energies[..])).collect();
    write_convergence(&plot, "Energy above the least, projected Newton", &curves)?;
    if let Some(last) = all.last() {
        let mut state = io::MeshFile::of_positions(last.x.clone());
        state.tetrahedra = tetrahedra.to_vec();
        state.attributes = io::Attributes::new().vertex_scalar("growth", growth(&last.x));
        io::write_file(&file, &state)?;
    }
    say!(
        "wrote {}, {} and {}",
        picture.display(),
        plot.display(),
        file.display()
    );
    Ok(())
}
