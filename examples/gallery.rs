//! The formulas that the paper on I♥MESH collects from SIGGRAPH papers of 2019 to 2022 (figure 2), each as a program.
//!
//! ```text
//! cargo run --release --example gallery [-- FILE]
//! ```
//!
//! The programs are in `gallery/`. Prints how far each is from the same computation by loops, and draws those with a value at
//! each vertex into `out/gallery.png`.

#[path = "gallery/by_hand.rs"]
mod by_hand;
mod common;

use std::error::Error;
use std::process::ExitCode;

use by_hand::Topology;
use common::surface::{self, Surface, largest_difference, print_why, say};
use glam::DVec3;
use iheartmesh::nalgebra::{DMatrix, DVector};
use iheartmesh::{CellMesh, Edge, FaceMesh, iheartmesh};

iheartmesh! {
    /// A weighted mean over the vertices around each vertex.
    pub struct PointConvolution = include "examples/gallery/point_convolution.hlang";

    /// Matrices times features, over the vertices that are at most R edges away.
    pub struct GraphConvolution = include "examples/gallery/graph_convolution.hlang";

    /// How far each vertex is from the mean of those around it.
    pub struct DifferentialCoordinates = include "examples/gallery/differential_coordinates.hlang";

    /// Differences between the coefficients of patches that are next to each other.
    pub struct PatchDifferences = include "examples/gallery/patch_differences.hlang";

    /// Lengths of segments together with the widths of those before and after.
    pub struct SegmentLengths = include "examples/gallery/segment_lengths.hlang";

    /// Values at the centres of tetrahedra, averaged at their vertices.
    pub struct CellAverage = include "examples/gallery/cell_average.hlang";

    /// Angles that are missing to a full turn.
    pub struct AngleDefect = include "examples/gallery/angle_defect.hlang";

    /// The p-norm of the differences between vectors on triangles.
    pub struct EdgeEnergy = include "examples/gallery/edge_energy.hlang";
}

fn main() -> ExitCode {
    surface::run("gallery", study)
}

fn study(surface: &Surface) -> Result<(), Box<dyn Error>> {
    let (mesh, x) = (&surface.mesh, &surface.positions);
    let triangles = surface
        .manifold_triangles()
        .filter(|_| mesh.is_closed() && mesh.isolated_vertices().is_empty())
        .ok_or("the gallery takes closed meshes of triangles that are oriented alike")?;
    let topology = Topology::new(x.len(), triangles);

    let h = 0.1 * x.iter().map(|p| p.length()).fold(0.0, f64::max);
    let convolution = PointConvolution::new(mesh, x, h)?;
    let convolved: Vec<f64> = mesh.vertices().map(|j| convolution.a(j)).collect();
    let off = largest_difference(&convolved, &topology.point_convolution(x, h));
    row("[Brunel et al. 2021]", "aⱼ = ∑ αᵢⱼ aᵢⱼ / ∑ αᵢⱼ", off);

    let features = graph_convolution(surface, &topology)?;
    let coordinates = DifferentialCoordinates::new(mesh, x)?.delta_all();
    let expected = topology.differential_coordinates(x);
    let off = coordinates
        .iter()
        .zip(&expected)
        .map(|(a, b)| a.distance(*b));
    row(
        "[Song et al. 2020]",
        "vᵢ - 1/dᵢ ∑ vⱼ = δᵢ",
        off.fold(0.0, f64::max),
    );

    averages()?;

    let alpha: Vec<DVector<f64>> = centres(x, triangles)
        .iter()
        .map(|c| DVector::from_vec(vec![c.x, c.y, c.z, c.x * c.y]))
        .collect();
    let patches = PatchDifferences::new(mesh, &alpha)?;
    let (sum, squares) = topology.patch_differences(&alpha);
    let off = f64::max((patches.E_O() - sum).abs(), (patches.E_2() - squares).abs());
    row("[Chandran et al. 2022]", "E_O = ∑ ∑ ∑ (αₚᵢ - α_qᵢ)", off);
    print_why(&format!(
        "as printed {:.1e}: each difference is there with both signs; squared {:.3e}",
        patches.E_O(),
        patches.E_2()
    ));

    segments(surface, triangles)?;

    let defects = AngleDefect::new(mesh, x)?.kappa_all();
    let off = largest_difference(&defects, &topology.angle_defect(x));
    row("[Stein et al. 2020]", "κᵥ := 2π - ∑ θᵥ", off);

    let (w, p) = (vec![1.0; mesh.n_edges()], 3.0);
    let f = centres(x, triangles);
    let energy = EdgeEnergy::new(mesh, &w, &f, p)?.E_p();
    let off = (energy - topology.edge_energy(&w, &f, p)).abs();
    row(
        "[Zhang et al. 2020]",
        "E_p = (∑ wₑ ‖f_t₁ - f_t₂‖ᵖ)^(1/p)",
        off,
    );

    let lengths: Vec<f64> = coordinates.iter().map(|delta| delta.length()).collect();
    draw(
        surface,
        [
            ("aⱼ", &convolved),
            ("‖f'ₖ‖", &features),
            ("‖δᵢ‖", &lengths),
            ("κᵥ", &defects),
        ],
    )
}

/// Prints a formula, and how far the program is from the loops.
fn row(paper: &str, formula: &str, off: f64) {
    say!("  {paper:<24}{formula:<36}off by {off:.1e}");
}

fn centres(x: &[DVec3], triangles: &[[u32; 3]]) -> Vec<DVec3> {
    let centre = |t: &[u32; 3]| t.iter().map(|v| x[*v as usize]).sum::<DVec3>() / 3.0;
    triangles.iter().map(centre).collect()
}

/// The lengths of the features after the convolution.
fn graph_convolution(surface: &Surface, topology: &Topology) -> Result<Vec<f64>, Box<dyn Error>> {
    let (rings, x) = (2, &surface.positions);
    let vector = |p: &DVec3| DVector::from_vec(vec![p.x, p.y, p.z]);
    let f: Vec<DVector<f64>> = x.iter().map(vector).collect();
    let kernels: Vec<DMatrix<f64>> = x
        .iter()
        .map(|p| DMatrix::from_row_slice(2, 3, &[1.0, p.x, 0.0, p.y, 0.0, 1.0]))
        .collect();
    let b: Vec<DVector<f64>> = x
        .iter()
        .map(|p| DVector::from_vec(vec![p.z, 1.0]))
        .collect();
    let found = GraphConvolution::new(&surface.mesh, rings, &f, &kernels, &b)?.f_prime_all();
    let expected = topology.graph_convolution(rings, &f, &kernels, &b);
    let off = found.iter().zip(&expected).map(|(a, b)| (a - b).norm());
    row(
        "[Habermann et al. 2021]",
        "f'ₖ = bₖ + ∑ aₖₗ Kₗ fₗ",
        off.fold(0.0, f64::max),
    );
    Ok(found.iter().map(|f| f.norm()).collect())
}

/// On a cube of tetrahedra.
fn averages() -> Result<(), Box<dyn Error>> {
    let (x, tetrahedra) = by_hand::bent_cube(8);
    let mesh = CellMesh::from_tetrahedra(x.len(), &tetrahedra)?;
    let flow = |p: DVec3| DVec3::new(-p.y, p.x, p.z * p.z);
    let found = CellAverage::new(&mesh, &x, flow)?.F̂_all();
    let expected = by_hand::cell_average(&x, &tetrahedra, flow);
    let off = found.iter().zip(&expected).map(|(a, b)| a.distance(*b));
    row(
        "[James 2020]",
        "Fᵢ ≈ ∑ wₖ/rₖ F(rₖ) / ∑ wⱼ/rⱼ",
        off.fold(0.0, f64::max),
    );
    print_why(&format!(
        "at the vertices of {} tetrahedra",
        tetrahedra.len()
    ));
    Ok(())
}

/// On the lower half of the surface, which has a boundary.
fn segments(surface: &Surface, triangles: &[[u32; 3]]) -> Result<(), Box<dyn Error>> {
    let x = &surface.positions;
    let middle = x.iter().map(|p| p.y).sum::<f64>() / x.len() as f64;
    let is_below = |t: &&[u32; 3]| t.iter().all(|v| x[*v as usize].y < middle);
    let half: Vec<[u32; 3]> = triangles.iter().filter(is_below).copied().collect();
    let (mesh, topology) = (
        FaceMesh::from_triangles(x.len(), &half)?,
        Topology::new(x.len(), &half),
    );
    let w: Vec<f64> = (0..mesh.n_edges()).map(|e| (e as f64).sin()).collect();
    let segments = SegmentLengths::new(&mesh, x, &w)?;
    let expected = topology.segment_lengths(x, &w);
    let numbered = topology.edges.keys().enumerate();
    let off = numbered.filter_map(|(number, ends)| {
        let expected = expected.get(ends)?;
        Some((segments.l_prime(Edge::new(number as u32)) - expected).abs())
    });
    let off = off.fold(0.0, f64::max);
    row(
        "[Campen et al. 2019]",
        "l'ᵢ = w_prev(i) + lᵢ + w_next(i)",
        off,
    );
    print_why(&format!("at {} segments of a boundary", expected.len()));
    Ok(())
}

/// Draws fields side by side, each by its own scale.
fn draw(surface: &Surface, fields: [(&str, &[f64]); 4]) -> Result<(), Box<dyn Error>> {
    let (png, faces) = (format!("{}/gallery.png", surface::OUTPUT), surface.faces());
    let picture = surface
        .picture("Formulas of other papers")
        .subtitle(&format!(
            "{}: values at the vertices, by rank from least to greatest",
            surface.name
        ))
        .sequential();
    fields
        .iter()
        .fold(picture, |picture, (name, values)| {
            picture
                .scalar_field(&surface.positions, &faces, &ranks(values))
                .caption(name)
        })
        .write_png(&png)?;
    say!("wrote {png}");
    Ok(())
}

/// The part of the values that are less, for each.
fn ranks(values: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    let mut ranks = vec![0.0; values.len()];
    for (rank, place) in order.into_iter().enumerate() {
        ranks[place] = rank as f64 / values.len() as f64;
    }
    ranks
}
