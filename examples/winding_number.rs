//! Generalized winding numbers: inside and outside of a surface with holes, and the holes filled.
//!
//! ```text
//! cargo run --release --example winding_number [-- FILE]
//! ```
//!
//! The formula is in `winding_number.hlang`. Holes are cut into the surface if it has none. Then the convex hull is filled
//! with tetrahedra that have the triangles of the surface among their faces; the boundary of those that the surface
//! winds around by more than a half is the surface with its holes filled (A. Jacobson, L. Kavan, O. Sorkine-Hornung, 2013).
//! Writes it as `out/winding_number.ply`, and a slice through the field as `.png`.

mod common;

use std::collections::BTreeSet;
use std::error::Error;
use std::process::ExitCode;
use std::time::Instant;

use common::surface::{self, Surface, print_fact, print_range, print_why, say};
use common::tetrahedra::{self, Tetrahedra};
use glam::DVec3;
use iheartmesh::{FaceMesh, Vertex, iheartmesh, io};
use rayon::prelude::*;

iheartmesh! {
    /// How often a surface winds around a point, and the solid angle of each of its faces.
    pub struct WindingNumber = include "examples/winding_number.hlang";
}

/// Points along each side of the slice.
const SLICE: usize = 160;

fn main() -> ExitCode {
    surface::run_on("winding_number", "meshes/bob_small.ply", study)
}

fn study(surface: &Surface) -> Result<(), Box<dyn Error>> {
    let Some(whole) = surface.mesh.triangles() else {
        return Err("winding numbers are computed for meshes of triangles".into());
    };
    let (positions, mut open) = (&surface.positions, whole.to_vec());
    if surface.mesh.is_closed() {
        open = cut(surface, whole);
        print_fact(
            "cut out",
            &format!("{} of {} triangles", whole.len() - open.len(), whole.len()),
        );
    }
    let mesh = FaceMesh::from_triangles(positions.len(), &open)?;
    let winding = WindingNumber::new(&mesh, positions)?;

    let start = Instant::now();
    let filling = tetrahedra::conforming(positions, &open)?;
    print_fact(
        "tetrahedra",
        &format!(
            "{} in {:.1?}, with {} points more",
            filling.tetrahedra.len(),
            start.elapsed(),
            filling.points.len() - positions.len()
        ),
    );
    let start = Instant::now();
    let values = at_barycentres(&filling, |p| winding.w(p));
    let each = start.elapsed().as_secs_f64() * 1e9 / (values.len() * open.len()) as f64;
    print_range("winding number", "in the tetrahedra", &values);
    print_fact(
        "time",
        &format!("{:.1?}, {each:.1} ns for each solid angle", start.elapsed()),
    );

    let is_inside: Vec<bool> = values.iter().map(|w| *w > 0.5).collect();
    let filled = tetrahedra::boundary(&filling.tetrahedra, &is_inside);
    describe(&filling, &filled)?;
    if surface.mesh.is_closed() {
        compare(surface, whole, &filling, &is_inside)?;
    }
    write(surface, &open, &filling, &filled, |p| winding.w(p))
}

/// The triangles of a closed surface without those around a few of its vertices.
fn cut(surface: &Surface, triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let n = surface.positions.len() as u32;
    let centres: BTreeSet<u32> = (0..4).map(|hole| hole * n / 4).collect();
    let keep = |triangle: &&[u32; 3]| !triangle.iter().any(|v| centres.contains(v));
    triangles.iter().filter(keep).copied().collect()
}

fn at_barycentres(filling: &Tetrahedra, w: impl Fn(DVec3) -> f64 + Sync) -> Vec<f64> {
    let place = |vertex: &u32| filling.points[*vertex as usize];
    let barycentre = |t: &[u32; 4]| 0.25 * t.iter().map(place).sum::<DVec3>();
    let all = filling.tetrahedra.par_iter();
    all.map(|t| w(barycentre(t))).collect()
}

/// Says whether the filled surface is closed, and how much of the input is in it.
fn describe(filling: &Tetrahedra, filled: &[[u32; 3]]) -> Result<(), Box<dyn Error>> {
    let mesh = FaceMesh::from_triangles(filling.points.len(), filled)?;
    print_fact(
        "filled",
        &format!(
            "{} triangles, {} edges at the boundary, {} with more than two faces",
            filled.len(),
            mesh.boundary_edges().len(),
            mesh.non_manifold_edges().len()
        ),
    );
    let found: BTreeSet<[u32; 3]> = filled.iter().map(|t| tetrahedra::sorted(*t)).collect();
    let kept = filling
        .triangles
        .iter()
        .filter(|t| found.contains(&tetrahedra::sorted(**t)))
        .count();
    print_fact(
        "kept",
        &format!(
            "{kept} of {} triangles of the input",
            filling.triangles.len()
        ),
    );
    if filling.missing > 0 {
        print_why(&format!(
            "{} of them are not faces of tetrahedra",
            filling.missing
        ));
    }
    Ok(())
}

/// Compares with the surface before the holes were cut: a tetrahedron is in it where its winding number is 1.
fn compare(
    surface: &Surface,
    whole: &[[u32; 3]],
    filling: &Tetrahedra,
    is_inside: &[bool],
) -> Result<(), Box<dyn Error>> {
    let mesh = FaceMesh::from_triangles(surface.positions.len(), whole)?;
    let winding = WindingNumber::new(&mesh, &surface.positions)?;
    let before = at_barycentres(filling, |p| winding.w(p));
    let off = before
        .iter()
        .map(|w| (w - w.round()).abs())
        .fold(0.0, f64::max);
    print_fact(
        "before the cuts",
        &format!("winding numbers differ from 0 or 1 by at most {off:.1e}"),
    );
    let alike = before
        .iter()
        .zip(is_inside)
        .filter(|(w, inside)| (**w > 0.5) == **inside)
        .count();
    print_fact(
        "inside as before",
        &format!("{alike} of {} tetrahedra", is_inside.len()),
    );
    Ok(())
}

fn write(
    surface: &Surface,
    open: &[[u32; 3]],
    filling: &Tetrahedra,
    filled: &[[u32; 3]],
    w: impl Fn(DVec3) -> f64 + Sync,
) -> Result<(), Box<dyn Error>> {
    let [ply, png] =
        ["ply", "png"].map(|kind| format!("{}/winding_number.{kind}", surface::OUTPUT));
    let (points, squares, azimuth) = slice(&surface.positions);
    let values: Vec<f64> = points.par_iter().map(|p| w(*p)).collect();
    surface
        .picture("Generalized winding number")
        .view(azimuth, 14.0)
        .subtitle(&format!(
            "{}: how often the surface winds around a point; 1 is inside, 0 is outside",
            surface.name
        ))
        .sequential()
        .limit(1.0)
        .flat()
        .edges()
        .surface(&surface.positions, open)
        .caption("with holes")
        .scalar_field(&points, &squares, &values)
        .chart()
        .contours(9)
        .caption("slice through the field")
        .surface(&filling.points, filled)
        .caption("boundary of w > ½")
        .write_png(&png)?;
    let mesh = FaceMesh::from_triangles(filling.points.len(), filled)?;
    let values: Vec<f64> = mesh
        .vertices()
        .map(|v: Vertex| f64::from(v.index() >= surface.positions.len()))
        .collect();
    let attributes = io::Attributes::new().vertex_scalar("refines", values);
    io::write(&ply, &filling.points, &mesh, &attributes)?;
    say!("wrote {ply} and {png}");
    Ok(())
}

/// A grid of squares across the middle of the surface, upright and along its longer horizontal side, and the azimuth from
/// which it is seen well.
fn slice(positions: &[DVec3]) -> (Vec<DVec3>, Vec<[u32; 4]>, f64) {
    let low = positions.iter().copied().fold(DVec3::INFINITY, DVec3::min);
    let high = positions
        .iter()
        .copied()
        .fold(DVec3::NEG_INFINITY, DVec3::max);
    let (size, middle) = (high - low, low.midpoint(high));
    let (along, azimuth) = match size.x > size.z {
        true => (DVec3::X, -20.0),
        false => (DVec3::Z, -70.0),
    };
    let n = SLICE as u32;
    let at = |k: u32| f64::from(k) / f64::from(n - 1) - 0.5;
    let points = (0..n).flat_map(|row| {
        (0..n).map(move |column| middle + 1.1 * size * (at(column) * along + at(row) * DVec3::Y))
    });
    let squares = (0..n - 1).flat_map(|row| {
        (0..n - 1).map(move |column| [0, 1, n + 1, n].map(|step| row * n + column + step))
    });
    (points.collect(), squares.collect(), azimuth)
}
