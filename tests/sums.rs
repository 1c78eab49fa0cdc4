//! Several sums over one range, tables that several formulas read: as one by one, with and without optimisations.

use iheartmesh::glam::DVec3;
use iheartmesh::{FaceMesh, Vertex};

#[macro_use]
#[path = "support/twice.rs"]
mod twice;

programs! {
    // Each definition for the whole mesh has several sums around each vertex.
    Around, PlainAround = r#"
        ElementSets from MeshConnectivity
        Faces, VertexOneRing, NeighborVerticesInFace, PreviousVertexAroundFace from Neighborhoods(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        x_i ∈ ℝ³
        a_i ∈ ℝ

        n(f, v) = (x_j - x_v)×(x_k - x_v) where f ∈ F, v ∈ V, j, k = NeighborVerticesInFace(f, v)
        A(v) = ∑_(f ∈ Faces(v)) ‖n(f, v)‖ where v ∈ V
        L(v) = ∑_(f ∈ Faces(v)) n(f, v) where v ∈ V
        p(v) = ∑_(f ∈ Faces(v)) a_(PreviousVertexAroundFace(f, v)) where v ∈ V

        ratios = ∑_(v ∈ V) (∑_(w ∈ VertexOneRing(v)) a_w)/(∑_(w ∈ VertexOneRing(v)) ‖x_w‖)
        `variances` = ∑_(v ∈ V) ∑_(w ∈ VertexOneRing(v)) (a_w - (∑_(w ∈ VertexOneRing(v)) a_w)/(∑_(w ∈ VertexOneRing(v)) 1))²
        centres = ∑_(v ∈ V) ‖∑_(w ∈ VertexOneRing(v)) x_w + (∑_(w ∈ VertexOneRing(v)) a_w²) ∑_(w ∈ VertexOneRing(v)) a_w x_w‖
        W = ∑_(v ∈ V) ‖L(v)‖²/A(v)
        `grad` = ∂W/∂x
    "#;

    // Of two sums over one range only one is asked for, and the other may have no value.
    Chosen, PlainChosen = r#"
        ElementSets from MeshConnectivity
        VertexOneRing, OrientedOppositeFaces from Neighborhoods(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        a_i ∈ ℝ
        b_i ∈ ℝ
        i_f ∈ ℝ
        s(v, w) = b_w (i_f - i_g) where v, w ∈ V, f, g = OrientedOppositeFaces(v, w)
        c(v) = { ∑_(w ∈ VertexOneRing(v)) a_w if a_v > 0
                 ∑_(w ∈ VertexOneRing(v)) s(v, w) otherwise where v ∈ V
        y = ∑_(v ∈ V) c(v)
    "#;
}

/// Four triangles around vertex 0, with the ring of their other vertices as the boundary.
fn fan() -> (FaceMesh, [DVec3; 5], [f64; 5]) {
    let mesh = FaceMesh::from_triangles(5, &[[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]]).unwrap();
    let x = [
        DVec3::new(0.1, -0.2, 0.5),
        DVec3::X,
        DVec3::new(0.2, 1.0, 0.1),
        DVec3::new(-1.5, 0.0, 0.3),
        DVec3::new(0.0, -1.0, -0.2),
    ];
    (mesh, x, [0.5, -1.0, 2.0, 0.25, 3.0])
}

const RING: [&[usize]; 5] = [
    &[1, 2, 3, 4],
    &[0, 2, 4],
    &[0, 1, 3],
    &[0, 2, 4],
    &[0, 1, 3],
];
/// The two vertices after each vertex in its triangles.
const CORNERS: [&[[usize; 2]]; 5] = [
    &[[1, 2], [2, 3], [3, 4], [4, 1]],
    &[[2, 0], [0, 4]],
    &[[0, 1], [3, 0]],
    &[[0, 2], [4, 0]],
    &[[0, 3], [1, 0]],
];

fn assert_near(found: f64, expected: f64) {
    assert!(
        (found - expected).abs() <= 1e-13 * expected.abs().max(1.0),
        "{found} instead of {expected}"
    );
}

/// `W` of [`Around`] in loops.
fn squares_over_areas(x: &[DVec3; 5]) -> f64 {
    let one = |v: usize| {
        let normals = || {
            CORNERS[v]
                .iter()
                .map(|[j, k]| (x[*j] - x[v]).cross(x[*k] - x[v]))
        };
        let sum: DVec3 = normals().sum();
        sum.length_squared() / normals().map(DVec3::length).sum::<f64>()
    };
    (0..5).map(one).sum()
}

for_both! {
    #[test]
    fn sums_over_one_ring() {
        let (mesh, x, a) = fan();
        let module = Around::new(&mesh, x, a).unwrap();
        let around = |v: usize| RING[v].iter().copied();
        let total = |v| around(v).map(|w| a[w]).sum::<f64>();

        let ratio = |v| total(v) / around(v).map(|w| x[w].length()).sum::<f64>();
        assert_near(module.ratios(), (0..5).map(ratio).sum());

        let variance = |v: usize| {
            let mean = total(v) / RING[v].len() as f64;
            around(v).map(|w| (a[w] - mean).powi(2)).sum::<f64>()
        };
        assert_near(module.variances(), (0..5).map(variance).sum());

        let centre = |v| {
            let sum: DVec3 = around(v).map(|w| x[w]).sum();
            let weighted: DVec3 = around(v).map(|w| a[w] * x[w]).sum();
            let squares: f64 = around(v).map(|w| a[w] * a[w]).sum();
            (sum + squares * weighted).length()
        };
        assert_near(module.centres(), (0..5).map(centre).sum());

        assert_near(module.W(), squares_over_areas(&x));
        let gradient = module.grad();
        for k in 0..15 {
            let at = |step: f64| {
                let mut x = x;
                x[k / 3][k % 3] += step;
                squares_over_areas(&x)
            };
            let h = 1e-3;
            // the error of four differences is of the order of h⁴
            let slope = (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
            assert!((gradient[k] - slope).abs() < 1e-8, "{} instead of {slope}", gradient[k]);
        }

        // functions that read the same rows, each for itself
        for v in 0..5 {
            let vertex = Vertex::new(v as u32);
            let normals = || CORNERS[v].iter().map(|[j, k]| (x[*j] - x[v]).cross(x[*k] - x[v]));
            assert_near(module.A(vertex), normals().map(DVec3::length).sum());
            assert!(module.L(vertex).abs_diff_eq(normals().sum(), 1e-14));
            assert_near(module.p(vertex), CORNERS[v].iter().map(|[_, k]| a[*k]).sum());
        }
        assert_eq!(module.A_all()[3], module.A(Vertex::new(3)));
    }

    #[test]
    fn a_sum_that_is_not_asked_for_may_have_no_value() {
        let (mesh, _, _) = fan();
        let b = [1.0, 2.0, 3.0, 4.0, 5.0];
        let i = [1.0, 10.0, 100.0, 1000.0];
        // at vertex 0, inside, the other sum is asked for
        let a = [-1.0, 1.0, 2.0, 3.0, 4.0];
        let inside = 2.0 * (1.0 - 1000.0) + 3.0 * (10.0 - 1.0) + 4.0 * (100.0 - 10.0) + 5.0 * (1000.0 - 100.0);
        let outside: f64 = (1..5).map(|v| RING[v].iter().map(|w| a[*w]).sum::<f64>()).sum();
        let mut module = Chosen::new(&mesh, a, b, i).unwrap();
        assert_near(module.y(), inside + outside);
        // at vertex 1, at the boundary, it has no value
        module.set_a([-1.0, -1.0, 2.0, 3.0, 4.0]).unwrap();
        assert!(module.try_y().is_err());
    }
}
