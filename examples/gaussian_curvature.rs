//! Gaussian curvature as the angle defect at each vertex, by the formula that a paper would print.
//!
//! ```text
//! cargo run --release --example gaussian_curvature [-- FILE]
//! ```
//!
//! Prints the curvature's range and its sum against the theorem of Gauss and Bonnet, times the generated
//! code beside loops written by hand, and writes `out/gaussian_curvature.ply` and `.png`.

#[path = "../benches/baseline/mod.rs"]
mod baseline;
mod common;

use std::error::Error;
use std::f64::consts::PI;
use std::process::ExitCode;

use common::surface::{
    self, Surface, largest_difference, one_thread, print_fact, print_range, print_time, print_why,
    say,
};
use common::timing::time_best_of;
use iheartmesh::{Vertex, iheartmesh};

iheartmesh! {
    /// Angle defect at each vertex, in radians.
    pub struct GaussianCurvature = r#"
        ElementSets from MeshConnectivity
        Faces, NeighborVerticesInFace from Neighborhoods(M)
        arccos from trigonometry

        M : FaceMesh
        V, E, F = ElementSets(M)
        x_i ∈ ℝ³

        K(v) = 2π - ∑_(f ∈ Faces(v)) θ_v,f where v ∈ V

        θ_i,f = arccos((x_j-x_i)·(x_k-x_i)/(‖x_j-x_i‖ ‖x_k-x_i‖))
            where i ∈ V, f ∈ F, j,k = NeighborVerticesInFace(f,i)
    "#;
}

fn main() -> ExitCode {
    surface::run("gaussian_curvature", study)
}

fn study(surface: &Surface) -> Result<(), Box<dyn Error>> {
    let Surface {
        mesh, positions, ..
    } = surface;
    let curvature = GaussianCurvature::new(mesh, positions)?;
    let values = curvature.K_all();

    print_range("curvature", "radians", &values);
    if values.iter().all(|value| value.is_finite()) {
        gauss_bonnet(surface, &curvature, &values);
    } else {
        print_why("a side of length 0 has no direction, so there is no angle at its ends");
    }
    times(surface, &curvature, &values)?;
    surface.write_vertex_scalar(
        "gaussian_curvature",
        "Gaussian curvature",
        "angle defect at each vertex, in radians",
        &values,
    )
}

/// Compares the sum of the curvature with what topology says that it is.
///
/// The angles of a flat convex polygon with n corners add up to (n - 2)π. Summed over all faces, the formula
/// gives 2πχ + π ∑ₑ (2 - d(e)), where d(e) is the number of faces at the edge e: nothing for an inner edge, π
/// for one at the boundary. It treats a vertex at the boundary like any other, 2π minus its angles; what is
/// missing to a straight line there is π minus its angles, and a closed loop has as many vertices as edges.
/// The angles of any other polygon add up to less (Fenchel); the curvature of such faces is in their vertices.
fn gauss_bonnet(surface: &Surface, curvature: &GaussianCurvature, values: &[f64]) {
    let mesh = &surface.mesh;
    let sum: f64 = values.iter().sum();
    print_fact("sum", &format!("{sum:.12}"));
    let mut expected = 2.0 * PI * mesh.euler_characteristic() as f64;
    print_fact("2πχ", &format!("{expected:.12}"));

    let missing: i64 = mesh
        .edges()
        .map(|edge| 2 - mesh.edge_faces(edge).len() as i64)
        .sum();
    if missing != 0 {
        expected += PI * missing as f64;
        let sign = if missing < 0 { '-' } else { '+' };
        let what = format!("2πχ {sign} {}π", missing.abs());
        print_fact(&what, &format!("{expected:.12}"));
        if missing as usize == mesh.boundary_vertices().len() {
            print_why("one π for each boundary vertex: there, too, K is 2π minus the angles,");
            print_why("where π minus the angles is how much the boundary turns");
        } else {
            print_why("π for each edge with one face, -π for each with three, and so on");
        }
    }
    if !mesh.is_triangle_mesh() {
        let excess: f64 = mesh
            .faces()
            .map(|face| {
                let corners = mesh.face_vertices(face);
                let angles: f64 = corners.iter().map(|v| curvature.theta(v, face)).sum();
                (corners.len() as f64 - 2.0) * PI - angles
            })
            .sum();
        expected += excess;
        print_fact("with the faces", &format!("{expected:.12}"));
        print_why("the angles of n-gons that are not both flat and convex miss");
        print_why(&format!("{excess:.3e} in all to their (n-2)π"));
    }
    print_fact("difference", &format!("{:.1e}", (sum - expected).abs()));
}

/// Times the generated code beside loops that a person would write over arrays of indices.
fn times(
    surface: &Surface,
    curvature: &GaussianCurvature,
    values: &[f64],
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
    let (plan, made) = time_best_of(runs.min(20), || GaussianCurvature::new(mesh, positions));
    made?;
    print_time("plan of the formula", plan, n);

    say!("each time the positions change");
    let (time, _) = time_best_of(runs, || {
        let each = mesh.vertices().map(|v: Vertex| curvature.K(v));
        each.collect::<Vec<f64>>()
    });
    print_time("K(v) in a loop, one thread", time, n);
    let (time, _) = one.install(|| time_best_of(runs, || curvature.K_all()));
    print_time("K_all(), one thread", time, n);
    let (time, _) = time_best_of(runs, || curvature.K_all());
    print_time(&format!("K_all(), {all}"), time, n);

    let Some(triangles) = surface.manifold_triangles() else {
        say!("  (the loops written by hand are for oriented triangle meshes)");
        return Ok(());
    };
    let edges = baseline::Edges::new(n, triangles);
    let adjacency = baseline::Adjacency::new(n, triangles, &edges);
    use baseline::gaussian_curvature as by_hand;
    let (time, gathered) = time_best_of(runs, || by_hand::gather(positions, &adjacency));
    print_time("by hand: each vertex its corners, one thread", time, n);
    let (time, _) = time_best_of(runs, || by_hand::scatter(positions, triangles));
    print_time("by hand: each face its angles, one thread", time, n);
    let (time, _) = time_best_of(runs, || {
        by_hand::scatter_parallel(positions, triangles, &adjacency)
    });
    print_time(&format!("by hand: each face its angles, {all}"), time, n);
    let difference = largest_difference(&gathered, values);
    say!("  largest difference from the values by hand: {difference:.1e}");
    Ok(())
}
