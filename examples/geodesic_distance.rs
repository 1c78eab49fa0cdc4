//! Geodesic distance from a vertex, by a wave that runs over the surface.
//!
//! ```text
//! cargo run --release --example geodesic_distance [-- FILE]
//! ```
//!
//! The step of the wave across a triangle (R. Kimmel, J. A. Sethian, 1998, in the form of L. A. Romero Calla, L. J. Fuentes
//! Perez, A. A. Montenegro, 2019) and the levels of vertices around the source are in `geodesic_distance.hlang`. Two loops run it:
//! the nearest vertex first, from a binary heap, and level after level. Prints how far both are from exact distances, and
//! writes `out/geodesic_distance.ply` and `.png`.

mod common;

use std::error::Error;
use std::process::ExitCode;
use std::time::Instant;

use common::surface::{self, Surface, print_fact, print_range, print_why, say};
use common::wave::{march, propagate};
use iheartmesh::{Set, Vertex, iheartmesh, io};

iheartmesh! {
    /// A step of the wave, and the levels of vertices around others.
    pub struct GeodesicDistance = include "examples/geodesic_distance.hlang";
}

/// Exact distances at some vertices of the bundled meshes; `meshes/README.md` says where they are from.
const EXACT: &str = include_str!("../meshes/geodesic_distances.csv");

/// A level is left behind when its distances change by less than this part.
const TOLERANCE: f64 = 1e-3;

fn main() -> ExitCode {
    surface::run("geodesic_distance", study)
}

fn study(surface: &Surface) -> Result<(), Box<dyn Error>> {
    let (mesh, positions) = (&surface.mesh, &surface.positions);
    if !mesh.is_triangle_mesh() {
        return Err("geodesic distances are computed for meshes of triangles".into());
    }
    let geodesic = GeodesicDistance::new(mesh, positions)?;
    let source = Vertex::new(0);
    print_fact("source", &format!("{source}"));

    let start = Instant::now();
    // a triangle without area has no wave that runs across it
    let marched = march(mesh, &[source], |f, v, d| {
        geodesic.try_Across(f, v, d).unwrap_or(f64::INFINITY)
    });
    print_fact("nearest first", &format!("{:.1?}", start.elapsed()));
    let start = Instant::now();
    let levels = geodesic.Levels(Set::from_iter([source]));
    let (propagated, rounds) = propagate(mesh, &levels, TOLERANCE, |v, d| geodesic.Around(v, d));
    let (time, n) = (start.elapsed(), levels.len());
    print_fact(
        "level by level",
        &format!("{time:.1?}, {n} levels, {rounds} rounds"),
    );

    print_range("distance", "", &marched);
    compare(surface, source, &marched, &propagated);
    write(surface, &marched)
}

/// Prints how far the distances are from exact ones, where these are known.
fn compare(surface: &Surface, source: Vertex, marched: &[f64], propagated: &[f64]) {
    let largest = marched
        .iter()
        .copied()
        .filter(|d| d.is_finite())
        .fold(0.0, f64::max);
    let apart = surface::largest_difference(marched, propagated) / largest;
    print_fact(
        "the two",
        &format!(
            "differ by at most {:.2} % of the largest distance",
            100.0 * apart
        ),
    );
    let exact = exact(&surface.name, source);
    if exact.is_empty() {
        print_why("exact distances are bundled for the meshes in meshes/ only");
        return;
    }
    for (what, found) in [("nearest first", marched), ("level by level", propagated)] {
        let errors: Vec<f64> = exact
            .iter()
            .map(|(v, d)| (found[v.index()] - d).abs() / d)
            .collect();
        let mean = 100.0 * errors.iter().sum::<f64>() / errors.len() as f64;
        let most = 100.0 * errors.iter().copied().fold(0.0, f64::max);
        print_fact(
            what,
            &format!(
                "off the exact distance by {mean:.2} % on average, {most:.2} % at most, at {} vertices",
                errors.len()
            ),
        );
    }
}

/// Vertices of a bundled mesh with their exact distances from a source.
fn exact(file: &str, source: Vertex) -> Vec<(Vertex, f64)> {
    let rows = EXACT.lines().skip(1).filter_map(|line| {
        let mut cells = line.split(',');
        let is_meant =
            cells.next()? == file.strip_suffix(".ply")? && cells.next()?.parse() == Ok(source.id());
        let (vertex, distance) = (cells.next()?.parse().ok()?, cells.next()?.parse().ok()?);
        is_meant.then_some((Vertex::new(vertex), distance))
    });
    rows.collect()
}

fn write(surface: &Surface, distances: &[f64]) -> Result<(), Box<dyn Error>> {
    let [ply, png] =
        ["ply", "png"].map(|kind| format!("{}/geodesic_distance.{kind}", surface::OUTPUT));
    surface
        .picture("Geodesic distance")
        .subtitle(&format!(
            "{}: distance from a vertex along the surface, with lines of equal distance",
            surface.name
        ))
        .sequential()
        .contours(23)
        .scalar_field(&surface.positions, surface.faces(), distances)
        .write_png(&png)?;
    let attributes = io::Attributes::new().vertex_scalar("distance", distances);
    io::write(&ply, &surface.positions, &surface.mesh, &attributes)?;
    say!("wrote {ply} and {png}");
    Ok(())
}
