//! Mean curvature at each vertex from the dihedral angles of its edges.
//!
//! ```text
//! cargo run --release --example mean_curvature [-- FILE]
//! ```
//!
//! The program is in `mean_curvature.hlang`. It brings a neighbourhood of its own, `OrientedOppositeFaces`, written on
//! the boundary matrices. Prints the curvature's range and sum, times the generated code beside loops written by hand,
//! and writes `out/mean_curvature.ply` and `.png`.

#[path = "../benches/baseline/mod.rs"]
mod baseline;
mod common;

use std::error::Error;
use std::process::ExitCode;

use common::surface::{
    self, Surface, largest_difference, one_thread, print_fact, print_range, print_time, print_why,
    say,
};
use common::timing::time_best_of;
use iheartmesh::iheartmesh;

iheartmesh! {
    /// Integrated mean curvature at each vertex, with the unit of a length: positive where the surface is convex.
    pub struct MeanCurvature = include "examples/mean_curvature.hlang";
}

fn main() -> ExitCode {
    surface::run("mean_curvature", study)
}

fn study(surface: &Surface) -> Result<(), Box<dyn Error>> {
    let Surface {
        mesh, positions, ..
    } = surface;
    let curvature = MeanCurvature::new(mesh, positions)?;

    // At an edge with one face there is no dihedral angle, so H has no value at its ends.
    let mut reason = None;
    let value = |v| {
        curvature
            .try_H(v)
            .map_err(|error| reason.get_or_insert(error))
            .unwrap_or(f64::NAN)
    };
    let values: Vec<f64> = mesh.vertices().map(value).collect();

    print_range("curvature", "in the unit of the positions", &values);
    if let Some(reason) = &reason {
        print_why("an angle needs two faces that run along an edge in opposite directions");
        print_why(&reason.to_string());
    }
    let total: f64 = values.iter().filter(|value| value.is_finite()).sum();
    print_fact("sum", &format!("{total:.6}"));
    times(surface, &curvature, &values, reason.is_none())?;
    surface.write_vertex_scalar(
        "mean_curvature",
        "Mean curvature",
        "dihedral angles times lengths of edges, ¼ ∑ l φ",
        &values,
    )
}

/// Times the generated code beside loops that a person would write over arrays of indices.
fn times(
    surface: &Surface,
    curvature: &MeanCurvature,
    values: &[f64],
    everywhere: bool,
) -> Result<(), Box<dyn Error>> {
    let Surface {
        mesh, positions, ..
    } = surface;
    let (runs, n) = (surface.runs(), positions.len());
    let one = one_thread()?;
    let all = format!("{} threads", rayon::current_num_threads());

    say!("once per mesh");
    print_time(
        "boundary matrices from the list of faces",
        surface.construction,
        n,
    );
    let (plan, made) = time_best_of(runs.min(20), || MeanCurvature::new(mesh, positions));
    made?;
    print_time("plan of the formula", plan, n);

    say!("each time the positions change");
    let (time, _) = time_best_of(runs, || {
        let each = mesh
            .vertices()
            .map(|v| curvature.try_H(v).unwrap_or(f64::NAN));
        each.collect::<Vec<f64>>()
    });
    print_time("H(i) in a loop, one thread", time, n);
    // H_all() stops at the first vertex without a value.
    if everywhere {
        let (time, _) = one.install(|| time_best_of(runs, || curvature.H_all()));
        print_time("H_all(), one thread", time, n);
        let (time, _) = time_best_of(runs, || curvature.H_all());
        print_time(&format!("H_all(), {all}"), time, n);
    }

    let Some(triangles) = surface.manifold_triangles() else {
        say!("  (the loops written by hand are for oriented triangle meshes)");
        return Ok(());
    };
    let edges = baseline::Edges::new(n, triangles);
    let adjacency = baseline::Adjacency::new(n, triangles, &edges);
    use baseline::mean_curvature as by_hand;
    let (time, gathered) = time_best_of(runs, || by_hand::gather(positions, &adjacency));
    print_time("by hand: each vertex its edges, one thread", time, n);
    let (time, _) = time_best_of(runs, || by_hand::scatter(positions, triangles, &edges));
    print_time("by hand: each edge its angle, one thread", time, n);
    let rows = by_hand::edges_of_vertices(&edges, &adjacency);
    let (time, _) = time_best_of(runs, || {
        by_hand::scatter_parallel(positions, triangles, &edges, &adjacency, &rows)
    });
    print_time(&format!("by hand: each edge its angle, {all}"), time, n);
    let difference = largest_difference(&gathered, values);
    say!("  largest difference from the values by hand: {difference:.1e}");
    Ok(())
}
