//! Normals of vertices as weighted sums over the faces around them, with three weightings.
//!
//! ```text
//! cargo run --release --example vertex_normals [-- FILE]
//! ```
//!
//! The program is in `vertex_normals.hlang`. Prints how far the three are apart, times the generated code beside loops
//! written by hand, and writes `out/vertex_normals.ply`, with the normals by N. Max's weighting, and `.png`.

#[path = "../benches/baseline/mod.rs"]
mod baseline;
mod common;

use std::error::Error;
use std::process::ExitCode;

use baseline::vertex_normals::{self as by_hand, Weight};
use common::surface::{self, Surface, one_thread, print_fact, print_time, print_why, say};
use common::timing::time_best_of;
use glam::DVec3;
use iheartmesh::{iheartmesh, io};

iheartmesh! {
    /// Unit normals of the vertices: weighted by N. Max (1999), by areas, and by angles.
    pub struct VertexNormals = include "examples/vertex_normals.hlang";
}

/// The differences between two weightings at each vertex, in degrees.
type Differences = [(&'static str, Vec<f64>); 3];

fn main() -> ExitCode {
    surface::run("vertex_normals", study)
}

fn study(surface: &Surface) -> Result<(), Box<dyn Error>> {
    let Surface {
        mesh, positions, ..
    } = surface;
    let normals = VertexNormals::new(mesh, positions)?;

    let values = normals.N_max_all();
    let differences: Differences = [
        ("Max and areas", normals.max_area_all()),
        ("Max and angles", normals.max_angle_all()),
        ("areas and angles", normals.area_angle_all()),
    ];
    for (which, degrees) in &differences {
        let (mean, most) = (mean(degrees), degrees.iter().copied().fold(0.0, f64::max));
        print_fact(
            which,
            &format!("differ by {mean:.3}° on average, {most:.3}° at most"),
        );
    }
    let undefined = values.iter().filter(|normal| !normal.is_finite()).count();
    if undefined > 0 {
        print_fact("without a normal", &format!("{undefined} vertices"));
        print_why("without a face, or with a side of length 0");
    }
    times(surface, &normals, &values)?;
    write(surface, values, &differences)
}

fn mean(values: &[f64]) -> f64 {
    let finite: Vec<f64> = values
        .iter()
        .copied()
        .filter(|value| value.is_finite())
        .collect();
    finite.iter().sum::<f64>() / finite.len() as f64
}

/// Times the generated code beside loops that a person would write over arrays of indices.
fn times(
    surface: &Surface,
    normals: &VertexNormals,
    values: &[DVec3],
) -> Result<(), Box<dyn Error>> {
    let Surface {
        mesh, positions, ..
    } = surface;
    let (runs, n) = (surface.runs(), positions.len());
    let one = one_thread()?;

    say!("once per mesh");
    print_time(
        "boundary matrices from the list of faces",
        surface.construction,
        n,
    );
    let (plan, made) = time_best_of(runs.min(20), || VertexNormals::new(mesh, positions));
    made?;
    print_time("plan of all formulas", plan, n);

    say!("each time the positions change, one thread");
    let (time, _) = one.install(|| time_best_of(runs, || normals.N_max_all()));
    print_time("N_max_all()", time, n);
    let (time, _) = one.install(|| time_best_of(runs, || normals.N_area_all()));
    print_time("N_area_all()", time, n);
    let (time, _) = one.install(|| time_best_of(runs, || normals.N_angle_all()));
    print_time("N_angle_all()", time, n);

    let Some(triangles) = surface.manifold_triangles() else {
        say!("  (the loops written by hand are for oriented triangle meshes)");
        return Ok(());
    };
    let edges = baseline::Edges::new(n, triangles);
    let adjacency = baseline::Adjacency::new(n, triangles, &edges);
    for (weight, name) in [
        (Weight::Max, "Max"),
        (Weight::Area, "areas"),
        (Weight::Angle, "angles"),
    ] {
        let (time, _) = time_best_of(runs, || by_hand::gather(positions, &adjacency, weight));
        print_time(
            &format!("by hand: each vertex its corners, {name}"),
            time,
            n,
        );
    }
    let difference = by_hand::gather(positions, &adjacency, Weight::Max)
        .iter()
        .zip(values)
        .map(|(left, right)| (left - right).length())
        .filter(|difference| difference.is_finite())
        .fold(0.0, f64::max);
    say!("  largest difference from the values by hand: {difference:.1e}");
    Ok(())
}

fn write(
    surface: &Surface,
    normals: Vec<DVec3>,
    differences: &Differences,
) -> Result<(), Box<dyn Error>> {
    let [ply, png] =
        ["ply", "png"].map(|kind| format!("{}/vertex_normals.{kind}", surface::OUTPUT));
    let faces = surface.faces();
    let picture = surface
        .picture("Normals of vertices")
        .subtitle(&format!(
            "{}: angle between two weightings, in degrees",
            surface.name
        ))
        .sequential()
        .limit(f64::max(4.0 * mean(&differences[0].1), 1e-6));
    differences[..2]
        .iter()
        .fold(picture, |picture, (which, degrees)| {
            picture
                .scalar_field(&surface.positions, &faces, degrees)
                .caption(which)
        })
        .write_png(&png)?;

    let [(_, max_area), (_, max_angle), _] = differences;
    let attributes = io::Attributes::new()
        .vertex_vector("normal", normals)
        .vertex_scalar("degrees_to_area_weighted", max_area.as_slice())
        .vertex_scalar("degrees_to_angle_weighted", max_angle.as_slice());
    io::write(&ply, &surface.positions, &surface.mesh, &attributes)?;
    say!("wrote {ply} and {png}");
    Ok(())
}
