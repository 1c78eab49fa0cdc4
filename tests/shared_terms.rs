//! Gradients of sums whose terms share another sum: the mean that they differ from, what they are divided by.

use iheartmesh::FaceMesh;
use iheartmesh::glam::DVec2;
use nalgebra::DVector;

#[path = "support/plane.rs"]
mod plane;
#[macro_use]
#[path = "support/twice.rs"]
mod twice;

programs! {
    Shared, PlainShared = r#"
        ElementSets from MeshConnectivity
        Vertices, VertexOneRing from Neighborhoods(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        x_i ∈ ℝ²
        u : V → ℝ
        a ∈ ℝ
        c = 1/|V| ∑_(v ∈ V) x_v
        m = 1/|V| ∑_(v ∈ V) ‖x_v‖
        l(k) = ‖x_i - x_j‖ where k ∈ E, i, j = Vertices(k)
        t = ∑_(k ∈ E) l(k)
        p(v) = exp(u_v)/∑_(w ∈ V) exp(u_w) where v ∈ V
        e = ∑_(v ∈ V) ‖x_v - c‖⁴
        f = ∑_(v ∈ V) (‖x_v‖ - m)²
        H(k) = { (l(k)/t - a)² if l(k) > t/|E|
                 l(k)/t otherwise where k ∈ E
        h = ∑_(k ∈ E) H(k)
        s = -∑_(v ∈ V) p(v) log(p(v))
        Q(v, w) = { (x_v ⋅ c) (x_w ⋅ x_w) m if u_v > a
                    t² otherwise where v, w ∈ V
        q = ∑_(v ∈ V) ∑_(w ∈ VertexOneRing(v)) Q(v, w)
        A = ∂e/∂x
        B = ∂f/∂x
        C = ∂h/∂x
        D = ∂s/∂u
        G = ∂q/∂x
    "#;

    Assembled, PlainAssembled = r#"
        ElementSets from MeshConnectivity
        VertexOneRing from Neighborhoods(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        x : V → ℝ²
        m ∈ ℝ^(#V)
        L ∈ ℝ^(#V×#V)
        L_vw = { -‖x_v - x_w‖² if w ∈ VertexOneRing(v)
        L_vv = 1 - ∑_w L_vw
        `K` ∈ ℝ^(#V×#V)
        `K`_vw = { x_v ⋅ x_w if w ∈ VertexOneRing(v)
        d(v) = ∑_(w ∈ VertexOneRing(v)) `K`_vw where v ∈ V
        R = L + ½ `K`ᵀ
        y = L⁻¹ m
        e = 1_(#V) ⋅ (L m) + ∑_(v ∈ V) d(v)²
        f = y ⋅ y
        h = ∑_(v ∈ V) ∑_(w ∈ V) R_v,w³ - mᵀ R m + ∑_v R_vv²
        A = ∂e/∂x
        B = ∂f/∂x
        C = ∂h/∂x
    "#;

    Far, PlainFar = r#"
        u_i ∈ ℝ
        n ∈ ℤ
        S ∈ {ℤ}
        c = u_n²
        T(i) = { (u_i - ∑_j u_j c)² if u_i > 0
                 u_i otherwise where i ∈ ℤ
        e = ∑_(i ∈ S) T(i)
        g = ∂e/∂u
        b = ∑_i ∑_j (u_j - u_i ∑_k u_k³)²
        B = ∂b/∂u
    "#;
}

iheartmesh::iheartmesh! {
    struct Edges = r#"
        ElementSets from MeshConnectivity
        VertexOneRing from Neighborhoods(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        x : V → ℝ²
        m ∈ ℝ^(#V)
        L ∈ ℝ^(#V×#V)
        L_vw = { -‖x_v - x_w‖² if w ∈ VertexOneRing(v)
        L_vv = 1 - ∑_w L_vw
        e = 1_(#V) ⋅ (L m) + mᵀ L m
        A = ∂e/∂x
    "#;
}

type Numbers = Vec<f64>;

/// Each number with its gradient, by points or by `u`.
macro_rules! values {
    ($module:expr) => {{
        let m = $module;
        let by_points: [(f64, DVector<f64>); 4] = [
            (m.e(), m.A()),
            (m.f(), m.B()),
            (m.h(), m.C()),
            (m.q(), m.G()),
        ];
        (by_points, (m.s(), m.D()))
    }};
}

fn numbers(n: usize) -> Numbers {
    (0..n).map(|k| (k as f64).sin()).collect()
}

for_both! {
    #[test]
    fn values() {
        for (mesh, x) in plane::meshes(4) {
            let u = numbers(x.len());
            let new = |x: &[DVec2], u: &Numbers| {
                values!(Shared::new(&mesh, x.to_vec(), u.clone(), 0.1).unwrap())
            };
            let (by_points, by_u) = new(&x, &u);
            let step = 1e-6;
            for k in 0..2 * x.len() {
                let moved = |by: f64| {
                    let mut x = x.clone();
                    x[k / 2][k % 2] += by;
                    new(&x, &u).0
                };
                let (above, below) = (moved(step), moved(-step));
                for (which, (_, gradient)) in by_points.iter().enumerate() {
                    let slope = (above[which].0 - below[which].0) / (2.0 * step);
                    // the last ones divide by the number or length of edges, which may be 0
                    if slope.is_finite() || gradient[k].is_finite() {
                        let error = (gradient[k] - slope).abs();
                        assert!(error < 1e-6 * (1.0 + gradient.amax()), "{which} {error}");
                    }
                }
            }
            for k in 0..x.len() {
                let moved = |by: f64| {
                    let mut u = u.clone();
                    u[k] += by;
                    new(&x, &u).1.0
                };
                let slope = (moved(step) - moved(-step)) / (2.0 * step);
                assert!((by_u.1[k] - slope).abs() < 1e-8);
            }
        }
    }

    #[test]
    fn entries_of_sparse_matrices() {
        for (mesh, x) in plane::meshes(3) {
            let m = DVector::from_vec(numbers(x.len())).add_scalar(1.5);
            let at = |x: Vec<DVec2>| {
                let module = Assembled::new(&mesh, x, m.clone()).unwrap();
                [(module.e(), module.A()), (module.f(), module.B()), (module.h(), module.C())]
            };
            let all = at(x.clone());
            let step = 1e-6;
            for k in 0..2 * x.len() {
                let moved = |by: f64| {
                    let mut x = x.clone();
                    x[k / 2][k % 2] += by;
                    at(x)
                };
                let (above, below) = (moved(step), moved(-step));
                for (which, (_, gradient)) in all.iter().enumerate() {
                    let slope = (above[which].0 - below[which].0) / (2.0 * step);
                    let error = (gradient[k] - slope).abs();
                    assert!(error < 1e-6 * (1.0 + gradient.amax()), "{which} {slope} {error}");
                }
            }
        }
    }

    #[test]
    fn what_no_term_uses_may_be_without_a_value() {
        let set = |members: &[i64]| members.iter().copied().collect::<iheartmesh::Set<i64>>();
        // there is no fifth number
        for members in [&[][..], &[1]] {
            let module = Far::new(vec![-1.0, 2.0], 5, set(members)).unwrap();
            let expected = DVector::from_vec(vec![members.len() as f64, 0.0]);
            assert_eq!(module.g(), expected);
        }
        assert!(Far::new(vec![-1.0, 2.0], 5, set(&[2])).unwrap().try_g().is_err());
        let module = Far::new(vec![-1.0, 2.0], 2, set(&[1, 2])).unwrap();
        // (b - (a + b) b²)², and a
        let (a, b) = (-1.0, 2.0);
        let inner = b - (a + b) * b * b;
        let by_b = 1.0 - 2.0 * a * b - 3.0 * b * b;
        let expected = [1.0 - 2.0 * inner * b * b, 2.0 * inner * by_b];
        assert!((module.g() - DVector::from_row_slice(&expected)).amax() < 1e-12);
        // what the terms of the inner sum share differs from one of the outer sum to the next
        let step = 1e-6;
        let at = |a: f64, b: f64| Far::new(vec![a, b], 1, set(&[])).unwrap();
        let slopes = [
            at(a + step, b).b() - at(a - step, b).b(),
            at(a, b + step).b() - at(a, b - step).b(),
        ];
        let slopes = DVector::from_row_slice(&slopes) / (2.0 * step);
        assert!((at(a, b).B() - &slopes).amax() < 1e-7 * slopes.amax());
    }
}

#[test]
fn the_shared_sum_is_done_once() {
    // done for each term again, it would take minutes
    let (x, rows) = plane::grid(301);
    let mesh = FaceMesh::from_triangles(x.len(), &rows).unwrap();
    let u = numbers(x.len());
    let at = |x: Vec<DVec2>| values!(optimized::Shared::new(&mesh, x, u.clone(), 0.1).unwrap()).0;
    let all = at(x.clone());
    let last = x.len() - 1;
    let moved = |by: f64| {
        let mut x = x.clone();
        x[last].x += by;
        at(x)
    };
    let (above, below) = (moved(1e-2), moved(-1e-2));
    for (which, (_, gradient)) in all.iter().enumerate() {
        let slope = (above[which].0 - below[which].0) / 2e-2;
        let error = (gradient[2 * last] - slope).abs();
        assert!(error < 1e-3 * slope.abs() + 1e-6, "{which} {slope} {error}");
    }
}

#[test]
fn matrices_stay_sparse() {
    // with an adjoint for each pair of vertices, it would take 65 GB
    let (x, rows) = plane::grid(301);
    let mesh = FaceMesh::from_triangles(x.len(), &rows).unwrap();
    let m = DVector::from_vec(numbers(x.len()));
    let module = Edges::new(&mesh, &x, &m).unwrap();
    let (g, last) = (module.A(), x.len() - 1);
    let moved = |by: f64| {
        let mut x = x.clone();
        x[last].x += by;
        Edges::new(&mesh, x, &m).unwrap().e()
    };
    let slope = (moved(1e-3) - moved(-1e-3)) / 2e-3;
    assert!((g[2 * last] - slope).abs() < 1e-3 * slope.abs() + 1e-6);
}
