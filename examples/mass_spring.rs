//! Masses on springs along the edges of tetrahedra: a body that falls, bounces and wobbles.
//!
//! ```text
//! cargo run --release --example mass_spring [-- FILE.mesh]
//! ```
//!
//! The program is in `mass_spring.hlang`: forces, one step of explicit integration, contact with the floor by cases, and
//! energies. Prints the energies, and writes `out/mass_spring.png`, an animation, `out/mass_spring_energy.png`, a plot, and
//! `out/mass_spring.vtk`, the last state with the stretch of each edge.

mod common;

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use common::animation::write_animation;
use common::picture::Picture;
use common::plot::write_plot;
use common::springs::wobble;
use common::surface::{OUTPUT, print_fact, say};
use glam::DVec3;
use iheartmesh::{FaceMesh, iheartmesh, io};

iheartmesh! {
    /// A body of masses and springs.
    pub struct MassSpring = include "examples/mass_spring.hlang";
}

const STEP: f64 = 2e-4;
const FRAMES: usize = 48;
const STEPS_PER_FRAME: usize = 200;
/// How often the energies are plotted.
const STEPS_PER_VALUE: usize = 20;

fn main() -> ExitCode {
    let path = std::env::args_os().nth(1).map_or_else(
        || Path::new(env!("CARGO_MANIFEST_DIR")).join("meshes/kuhn_cube3.mesh"),
        PathBuf::from,
    );
    match simulate(&path) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn simulate(path: &Path) -> Result<(), Box<dyn Error>> {
    let file = io::read(path)?;
    let mesh = file.cell_mesh()?;
    if mesh.n_cells() == 0 {
        return Err(format!("{}: no cells", path.display()).into());
    }
    let rest = &file.positions;
    let low = rest.iter().copied().fold(DVec3::INFINITY, DVec3::min);
    let size = rest.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max) - low;
    let floor = low.y - 0.4 * size.y;
    print_fact(
        "sizes",
        &format!(
            "V = {}, E = {}, C = {}",
            mesh.n_vertices(),
            mesh.n_edges(),
            mesh.n_cells()
        ),
    );

    let (x, v) = wobble(rest);
    let mut body = MassSpring::new(&mesh, rest, x.clone(), v, 0.5, 2000.0, 0.4, floor, STEP)?;
    let (boundary, _) = mesh.boundary_mesh()?;
    let room: Vec<DVec3> = [-0.2, 1.35]
        .into_iter()
        .flat_map(|a| [-0.2, 1.2].map(|b| (a, b)))
        .flat_map(|(a, b)| {
            [floor, low.y + 1.1 * size.y]
                .map(|y| DVec3::new(low.x + a * size.x, y, low.z + b * size.z))
        })
        .collect();
    let mut frames = Vec::new();
    let [
        mut times,
        mut kinetic,
        mut potential,
        mut elastic,
        mut total,
    ] = [const { Vec::new() }; 5];
    let ground = 0.5 * 9.8 * rest.len() as f64 * floor;
    let (mut x, mut computing) = (x, 0.0);
    for frame in 0..FRAMES {
        frames.push(picture(&boundary, &x, floor, &room).draw());
        let start = Instant::now();
        for step in 0..STEPS_PER_FRAME {
            if step % STEPS_PER_VALUE == 0 {
                let energies = [body.kinetic(), body.potential() - ground, body.elastic()];
                times.push((frame * STEPS_PER_FRAME + step) as f64 * STEP);
                kinetic.push(energies[0]);
                potential.push(energies[1]);
                elastic.push(energies[2]);
                total.push(energies.iter().sum::<f64>());
            }
            let next = body.position_all();
            body.set_v(body.velocity_all())?;
            body.set_x(next.clone())?;
            x = next;
        }
        computing += start.elapsed().as_secs_f64();
    }
    if !x.iter().all(|p| p.is_finite()) {
        return Err("the springs are too stiff for steps of this length".into());
    }
    let steps = (FRAMES * STEPS_PER_FRAME) as f64;
    print_fact(
        "time",
        &format!("{:.1} µs for each step", 1e6 * computing / steps),
    );
    print_fact(
        "energy",
        &format!(
            "{:.1} J at first, {:.1} J at last",
            total[0],
            total[total.len() - 1]
        ),
    );

    std::fs::create_dir_all(OUTPUT)?;
    let [film, plot, state] = [
        "mass_spring.png",
        "mass_spring_energy.png",
        "mass_spring.vtk",
    ]
    .map(|name| Path::new(OUTPUT).join(name));
    write_animation(&film, &frames, 40)?;
    write_plot(
        &plot,
        "Energy of masses and springs",
        ("seconds", &times),
        &[
            ("kinetic, J", &kinetic),
            ("potential, J", &potential),
            ("elastic, J", &elastic),
            ("total, J", &total),
        ],
    )?;
    let mut last = io::MeshFile::of_positions(x);
    last.edges = mesh
        .edges()
        .map(|e| mesh.edge_vertices(e).map(|v| v.id()))
        .collect();
    last.tetrahedra = file.tetrahedra.clone();
    last.hexahedra = file.hexahedra.clone();
    let stretch = |[i, j]: &[u32; 2]| {
        let length = |x: &[DVec3]| x[*i as usize].distance(x[*j as usize]);
        length(&last.positions) / length(rest)
    };
    let stretches: Vec<f64> = last.edges.iter().map(stretch).collect();
    last.attributes = io::Attributes::new().edge_scalar("stretch", stretches);
    io::write_file(&state, &last)?;
    say!(
        "wrote {}, {} and {}",
        film.display(),
        plot.display(),
        state.display()
    );
    Ok(())
}

/// The outside of the body above the floor.
fn picture(boundary: &FaceMesh, x: &[DVec3], floor: f64, room: &[DVec3]) -> Picture {
    let mut positions = x.to_vec();
    let mut faces: Vec<Vec<u32>> = boundary
        .faces()
        .map(|f| boundary.face_vertices(f).ids().to_vec())
        .collect();
    // the floor is a square below what is shown
    let first = positions.len() as u32;
    let on_floor: Vec<DVec3> = room.iter().copied().filter(|p| p.y == floor).collect();
    positions.extend([on_floor[0], on_floor[1], on_floor[3], on_floor[2]]);
    faces.push([0, 1, 2, 3].map(|k| first + k).into());
    let view = Picture::new("Masses on springs")
        .view(-30.0, 12.0)
        .around(room)
        .flat()
        .edges();
    view.surface(&positions, faces)
}
