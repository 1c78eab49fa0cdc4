//! Normals of vertices on three kinds of mesh, from one short program each: triangles, polygons, and points alone.
//!
//! ```text
//! cargo run --release --example normals [-- FILE]
//! ```
//!
//! The programs are in `normals/`. The polygons are the quadrilaterals around the edges of the mesh, the points its
//! vertices with their ten nearest neighbours. Prints how far the normals are apart, and writes `out/normals.png` and
//! `out/normals.ply`, with those of the points.

mod common;

use std::collections::BTreeMap;
use std::error::Error;
use std::process::ExitCode;

use common::surface::{self, Surface, print_fact, say};
use glam::DVec3;
use iheartmesh::{Edge, EdgeMesh, FaceMesh, iheartmesh, io};

iheartmesh! {
    /// Normals of triangle meshes, weighted by areas.
    pub struct Triangles = include "examples/normals/triangles.hlang";

    /// Normals of polygon meshes, weighted as by N. Max (1999).
    pub struct Polygons = include "examples/normals/polygons.hlang";

    /// Normals of point clouds: third principal components.
    pub struct Points = include "examples/normals/points.hlang";
}

fn main() -> ExitCode {
    surface::run("normals", study)
}

fn study(surface: &Surface) -> Result<(), Box<dyn Error>> {
    let (mesh, x) = (&surface.mesh, &surface.positions);
    if !mesh.is_triangle_mesh() {
        return Err("this example takes meshes of triangles".into());
    }
    let triangles = Triangles::new(mesh, x)?.N_all();

    let (polygon_mesh, corners) = quadrilaterals(mesh, x)?;
    let polygons = Polygons::new(&polygon_mesh, &corners)?.N_all();

    let points = EdgeMesh::from_k_nearest(x, 10)?;
    let near = Points::new(&points, x)?.N_all();
    print_fact(
        "neighbours",
        &format!(
            "{} pairs of points, of which one is among the 10 nearest of the other",
            points.n_edges()
        ),
    );

    let angle = |p: DVec3, q: DVec3| p.cross(q).length().atan2(p.dot(q)).to_degrees();
    let [mut of_polygons, mut of_points] = [Vec::new(), Vec::new()];
    for v in 0..x.len() {
        of_polygons.push(angle(triangles[v], polygons[v]));
        // a direction without a side
        let degrees = angle(triangles[v], near[v]);
        of_points.push(degrees.min(180.0 - degrees));
    }
    for (what, degrees) in [("polygons", &of_polygons), ("points", &of_points)] {
        let finite: Vec<f64> = degrees.iter().copied().filter(|a| a.is_finite()).collect();
        let mean = finite.iter().sum::<f64>() / finite.len() as f64;
        let most = finite.iter().copied().fold(0.0, f64::max);
        print_fact(
            what,
            &format!("{mean:.2}° from those of the triangles on average, {most:.1}° at most"),
        );
    }

    // how much each faces upwards or downwards, which is the same for both directions of a normal
    let upward = |normals: &[DVec3]| -> Vec<f64> { normals.iter().map(|n| n.y.abs()).collect() };
    let (discs, disc_faces, disc_values) = discs(x, &near, &upward(&near), &points);
    let [ply, png] = ["ply", "png"].map(|kind| format!("{}/normals.{kind}", surface::OUTPUT));
    surface
        .picture("Normals on three kinds of mesh")
        .subtitle(&format!(
            "{}: how far the normals are from horizontal, |y|",
            surface.name
        ))
        .sequential()
        .limit(1.0)
        .scalar_field(x, surface.faces(), &upward(&triangles))
        .caption("triangles")
        .scalar_field(&corners, polygon_faces(&polygon_mesh), &upward(&polygons))
        .caption("quadrilaterals")
        .scalar_field(&discs, disc_faces, &disc_values)
        .caption("points")
        .write_png(&png)?;
    let attributes = io::Attributes::new().vertex_vector("normal", near);
    io::write(&ply, x, &io::Polygons::new(), &attributes)?;
    say!("wrote {ply} and {png}");
    Ok(())
}

/// One quadrilateral for each edge with two faces: its ends and the centres of the faces. The vertices of the mesh keep
/// their numbers.
fn quadrilaterals(mesh: &FaceMesh, x: &[DVec3]) -> Result<(FaceMesh, Vec<DVec3>), Box<dyn Error>> {
    let mut positions = x.to_vec();
    for f in mesh.faces() {
        let corners = mesh.face_vertices(f);
        positions.push(corners.iter().map(|v| x[v.index()]).sum::<DVec3>() / corners.len() as f64);
    }
    let centre = |f: usize| (x.len() + f) as u32;
    let around = |e: Edge| -> Option<[u32; 4]> {
        let [tail, head] = mesh.edge_vertices(e).map(|v| v.id());
        let (faces, signs) = mesh.complex().coboundary_column(2, e.index());
        let along = faces.iter().zip(signs).find(|(_, sign)| **sign > 0)?.0;
        let against = faces.iter().zip(signs).find(|(_, sign)| **sign < 0)?.0;
        Some([
            tail,
            centre(*against as usize),
            head,
            centre(*along as usize),
        ])
    };
    let faces: Vec<[u32; 4]> = mesh.edges().filter_map(around).collect();
    Ok((FaceMesh::from_polygons(positions.len(), &faces)?, positions))
}

fn polygon_faces(mesh: &FaceMesh) -> Vec<Vec<u32>> {
    mesh.faces()
        .map(|f| mesh.face_vertices(f).ids().to_vec())
        .collect()
}

/// A small hexagon around each point, at right angles to its normal, with its value at the corners.
fn discs(
    x: &[DVec3],
    normals: &[DVec3],
    values: &[f64],
    near: &EdgeMesh,
) -> (Vec<DVec3>, Vec<[u32; 6]>, Vec<f64>) {
    let mut nearest: BTreeMap<usize, f64> = BTreeMap::new();
    for e in near.edges() {
        let [i, j] = near.edge_vertices(e).map(|v| v.index());
        let length = x[i].distance(x[j]);
        for end in [i, j] {
            let least = nearest.entry(end).or_insert(f64::INFINITY);
            *least = least.min(length);
        }
    }
    let (mut positions, mut faces, mut all) = (Vec::new(), Vec::new(), Vec::new());
    for (i, (&centre, &normal)) in x.iter().zip(normals).enumerate() {
        let (u, v) = normal.any_orthonormal_pair();
        let radius = 0.7 * nearest.get(&i).copied().unwrap_or(0.0);
        let first = positions.len() as u32;
        for k in 0..6 {
            let (sin, cos) = (f64::from(k) * std::f64::consts::FRAC_PI_3).sin_cos();
            positions.push(centre + radius * (cos * u + sin * v));
            all.push(values[i]);
        }
        faces.push([0, 1, 2, 3, 4, 5].map(|k| first + k));
    }
    (positions, faces, all)
}
