//! What has no value matters only where it is needed: a branch that is not taken may name items that do not exist.

#[path = "support/plane.rs"]
mod plane;
#[allow(unused_macros)]
#[macro_use]
#[path = "support/twice.rs"]
mod twice;

use iheartmesh::FaceMesh;
use iheartmesh::glam::DVec2;
use optimized::{Held, Nested, Outside, Ratio};
use plain::{
    Held as PlainHeld, Nested as PlainNested, Outside as PlainOutside, Ratio as PlainRatio,
};

programs! {
    Nested, PlainNested = r#"
        x_i ∈ ℝ
        a, b ∈ ℤ
        p(a) = { x_a if a > 0
                 7 otherwise where a ∈ ℤ
        q(a) = { 2 x_a if a > 0
                 8 otherwise where a ∈ ℤ
        z = { p(a) if b > 1
              q(a) otherwise
        y = { x_a if b > 1
              2 x_a otherwise
    "#;
    Outside, PlainOutside = r#"
        x_i ∈ ℝ
        m, n ∈ ℤ
        t(k) = { ∑_(j = 1)^m x_j if k > n
                 1 otherwise where k ∈ ℤ
        z = ∑_(k = 1)^3 t(k)
    "#;
    Ratio, PlainRatio = r#"
        ElementSets from MeshConnectivity
        Vertices from Neighborhoods(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        x_i ∈ ℝ²
        p = ∑_(v ∈ V) ‖x_v‖²
        q = ∑_(k ∈ E) ‖x_i - x_j‖ where i, j = Vertices(k)
        e = p/q
        g = ∂e/∂x
    "#;
    Held, PlainHeld = r#"
        ElementSets from MeshConnectivity
        Vertices from Neighborhoods(M)
        psd from linearalgebra
        M : FaceMesh
        V, E, F = ElementSets(M)
        X_i ∈ ℝ² : where vertices are held
        m_i ∈ ℤ : which item of `u` is the place of a vertex, 0 where it is held
        u_k ∈ ℝ²
        p(i) = { u_(m_i) if m_i > 0
                 X_i otherwise where i ∈ V
        S(k) = (‖p(i) - p(j)‖² - 1)² where k ∈ E, i, j = Vertices(k)
        e = ∑_(k ∈ E) S(k)
        g = ∂e/∂u
        H = ∂²e/∂u²
        P = ∑_(k ∈ E) psd(∂²S(k)/∂u²)
    "#;
}

#[test]
fn what_is_not_needed_may_be_missing() {
    let x = [3.0, 5.0];
    for (a, b, z) in [
        (0, 0, Some(8.0)),
        (0, 2, Some(7.0)),
        (2, 0, Some(10.0)),
        (2, 2, Some(5.0)),
        (3, 0, None),
        (3, 2, None),
    ] {
        let (fast, plain) = (
            Nested::new(x, a, b).unwrap(),
            PlainNested::new(x, a, b).unwrap(),
        );
        assert_eq!(fast.try_z().ok(), z);
        assert_eq!(plain.try_z().ok(), z);
        let y = (a == 2).then_some(if b > 1 { 5.0 } else { 10.0 });
        assert_eq!(fast.try_y().ok(), y);
        assert_eq!(plain.try_y().ok(), y);
    }
}

#[test]
fn vertices_that_are_held_are_no_variables() {
    let (places, triangles) = plane::grid(5);
    let mut meshes = plane::meshes(4);
    meshes.push((FaceMesh::from_triangles(25, &triangles).unwrap(), places));
    for (mesh, places) in meshes {
        // every third vertex is held
        let mut free = Vec::new();
        let numbers: Vec<i64> = (0..places.len())
            .map(|i| match i % 3 {
                0 => 0,
                _ => {
                    free.push(places[i] * 1.1);
                    free.len() as i64
                }
            })
            .collect();
        let mut fast = Held::new(&mesh, &places, &numbers, &free).unwrap();
        let plain = PlainHeld::new(&mesh, &places, &numbers, &free).unwrap();
        let at = |i: usize, free: &[DVec2]| match numbers[i] {
            0 => places[i],
            k => free[k as usize - 1],
        };
        let energy = |free: &[DVec2]| -> f64 {
            let edges = mesh.edges().map(|e| {
                let [i, j] = mesh.edge_vertices(e).map(|v| v.index());
                (at(i, free).distance_squared(at(j, free)) - 1.0).powi(2)
            });
            edges.sum()
        };
        let near =
            |a: f64, b: f64, scale: f64| assert!((a - b).abs() <= 1e-6 * (1.0 + scale), "{a} {b}");
        near(fast.e(), energy(&free), energy(&free));
        let (g, h, p) = (fast.g(), fast.H(), fast.P());
        assert!((&g - &plain.g()).amax() <= 1e-9 * (1.0 + g.amax()));
        let largest = h.data().iter().fold(0.0f64, |most, x| most.max(x.abs()));
        for (one, other) in [(&h, plain.H()), (&p, plain.P())] {
            for (value, (i, j)) in one {
                near(
                    *value,
                    other.get(i, j).copied().unwrap_or_default(),
                    largest,
                );
            }
        }
        for k in 0..2 * free.len() {
            let moved = |by: f64| {
                let mut moved = free.clone();
                moved[k / 2][k % 2] += by;
                moved
            };
            let step = 1e-5;
            let slope = (energy(&moved(step)) - energy(&moved(-step))) / (2.0 * step);
            near(g[k], slope, g.amax());
            fast.set_u(moved(step)).unwrap();
            let above = fast.g();
            fast.set_u(moved(-step)).unwrap();
            let change = (above - fast.g()) / (2.0 * step);
            for (row, value) in change.iter().enumerate() {
                near(h.get(row, k).copied().unwrap_or_default(), *value, largest);
            }
        }
    }
}

#[test]
fn a_loop_that_fails_in_a_branch_matters_where_it_is_needed() {
    let x = [1.0, 2.0];
    for (m, n, expected) in [(2, 3, 3.0), (2, 1, 7.0), (5, 3, 3.0)] {
        assert_eq!(Outside::new(x, m, n).unwrap().z(), expected);
        assert_eq!(PlainOutside::new(x, m, n).unwrap().z(), expected);
    }
    assert!(Outside::new(x, 5, 2).unwrap().try_z().is_err());
    assert!(PlainOutside::new(x, 5, 2).unwrap().try_z().is_err());
}

#[test]
fn a_loop_in_a_branch_is_done_once() {
    let (x, rows) = plane::grid(4);
    let mesh = FaceMesh::from_triangles(x.len(), &rows).unwrap();
    let (fast, plain) = (
        Ratio::new(&mesh, &x).unwrap(),
        PlainRatio::new(&mesh, &x).unwrap(),
    );
    assert!((fast.g() - plain.g()).amax() < 1e-12);
    // done for each edge again, the sum over the vertices would take minutes
    let (x, rows) = plane::grid(401);
    let mesh = FaceMesh::from_triangles(x.len(), &rows).unwrap();
    let large = Ratio::new(&mesh, &x).unwrap();
    let (g, last) = (large.g(), x.len() - 1);
    let moved = |by: f64| {
        let mut moved = x.clone();
        moved[last].x += by;
        Ratio::new(&mesh, moved).unwrap().e()
    };
    let slope = (moved(1e-2) - moved(-1e-2)) / 2e-2;
    assert!(
        (g[2 * last] - slope).abs() < 1e-4 * slope.abs(),
        "{} {slope}",
        g[2 * last]
    );
}
