//! Derivatives as generated code computes them, with and without optimisations: against values by hand and against the
//! reference set.

use iheartmesh::glam::{DMat2, DMat3, DVec2, DVec3};
use iheartmesh::{FaceMesh, Set, sprs};
use nalgebra::{DMatrix, DVector, dmatrix, dvector};

#[allow(dead_code)]
mod support;
#[macro_use]
#[path = "support/twice.rs"]
mod twice;

programs! {
    Small, PlainSmall = r#"
        a ∈ ℝ
        x ∈ ℝ³
        u ∈ ℝ^n
        A ∈ ℝ^(n×n)
        y = a² ‖x‖²
        da = ∂y/∂a
        daa = ∂²y/∂a²
        dx = ∂y/∂x
        dax = ∂²y/∂a∂x
        H = ∂²y/∂x²
        z = ½ uᵀ A u
        dz = ∇_u z
        d2z = ∂²z/∂u²
        dA = ∂z/∂A
        J = ∂/∂u (A u)
        r = ∂(‖x‖)/∂x
        f(t) = ∂(t³ a)/∂t where t ∈ ℝ
    "#;

    Shapes, PlainShapes = r#"
        vec, det, inv from linearalgebra
        x_i ∈ ℝ²
        q_i ∈ ℝ^(2×2)
        R ∈ ℝ^(2×2)
        w_i ∈ ℝ
        E = ∑_i w_i ‖R x_i‖²
        gx = ∂E/∂x
        gR = ∂E/∂R
        gw = ∂E/∂w
        Hx = ∂²E/∂x²
        Hxw = ∂²E/∂x∂w
        HR = ∂²E/∂R²
        D = ∑_i det(q_i)
        gq = ∂D/∂q
        Hq = ∂²D/∂q²
        T = (∑_i w_i²)²
        HT = ∂²T/∂w²
        n(v) = ∂²(‖v‖⁴)/∂v² where v ∈ ℝ²
    "#;

    Composed, PlainComposed = r#"
        sin from trigonometry
        x_i ∈ ℝ³
        u ∈ ℝ^n
        a ∈ ℝ
        b ∈ ℝ
        p ∈ ℝ³
        S ∈ {ℤ}
        E = ∑_i ‖x_i‖⁴
        g = ∂E/∂x
        N = ∂(g ⋅ g)/∂x
        H = ∂²E/∂x²
        Q = ∂(‖H‖²)/∂x
        d = min({ ‖x_i - p‖ for i ∈ S })
        dx = ∂d/∂x
        dp = ∂d/∂p
        f(z) = ∂(‖z‖³)/∂z where z ∈ ℝ^k
        fp = f(p)
        fu = f(u)
        c(z) = zᵀ z where z ∈ ℝ^k
        cp = ∂c(p)/∂p
        cu = ∂²c(u)/∂u²
        J = ∂(∂c(u)/∂u)/∂u
        s(z) = ∂(∑_i z_i²)/∂z where z_i ∈ ℝ
        y_i = sin(u_i) u_1
        Y = ∂y/∂u
        A_ij = u_i u_j
        t = ∂(∑_i ∑_j A_ij³)/∂u
        q = ∂(∑_i A_i,* ⋅ u)/∂u
        third = ∂³(a⁴ b)/∂a³
        mixed = ∂³(a² b²)/∂a²∂b
    "#;

    Calls, PlainCalls = r#"
        vec from linearalgebra
        x ∈ ℝ
        p_i ∈ ℝ²
        h(t) = t² + 1/t where t ∈ ℝ
        y = h(h(h(x)))
        dy = ∂y/∂x
        z = h(h(x))
        d2z = ∂²z/∂x²
        W = vec(p) ⋅ vec(p)
        H = ∂²W/∂p²
        G = ∂²(‖vec(p)‖⁴)/∂p²
    "#;

    Descent, PlainDescent = r#"
        ElementSets from MeshConnectivity
        Vertices, VertexOneRing from Neighborhoods(M)
        vec, vec⁻¹, psd from linearalgebra
        M : FaceMesh
        V, E, F = ElementSets(M)
        x_i ∈ ℝ³
        y_i ∈ ℝ³
        L = 1/|E| ∑_(e ∈ E) ‖x_i - x_j‖² where i, j = Vertices(e)
        D = 1/|V| ∑_(v ∈ V) ‖x_v - y_v‖²
        g = ∂(L + D)/∂x
        `x1*` = vec⁻¹_x(vec(x) - 0.1 g)
        B = ∑_(v ∈ V) ‖∑_(w ∈ VertexOneRing(v)) (x_w - x_v)‖²
        gB = ∂B/∂x
        HB = ∂²B/∂x²
        S(e) = (‖x_i - x_j‖ - 1)² where e ∈ E, i, j = Vertices(e)
        HS = ∂²(∑_(e ∈ E) S(e))/∂x²
        PS = ∑_(e ∈ E) psd(∂²S(e)/∂x²)
        slope(e) = ∂S(e)/∂x where e ∈ E
    "#;
}

fn dense(a: &sprs::CsMat<f64>) -> DMatrix<f64> {
    assert!(a.is_csc());
    let mut all = DMatrix::zeros(a.rows(), a.cols());
    for (value, (i, j)) in a {
        all[(i, j)] += *value;
    }
    all
}

#[track_caller]
fn close(a: &DMatrix<f64>, b: &DMatrix<f64>) {
    assert_eq!(a.shape(), b.shape());
    let error = (a - b).amax();
    assert!(error <= 1e-10 * (1.0 + b.amax()), "{a} is not {b}");
}

#[track_caller]
fn same(a: &DVector<f64>, b: &DVector<f64>) {
    close(
        &DMatrix::from_column_slice(a.len(), 1, a.as_slice()),
        &DMatrix::from_column_slice(b.len(), 1, b.as_slice()),
    );
}

/// A tetrahedron's surface.
fn tetrahedron() -> (FaceMesh, Vec<DVec3>) {
    let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    let mesh = FaceMesh::from_triangles(4, &faces).expect("a mesh");
    let positions = vec![
        DVec3::new(0.0, 0.0, 0.0),
        DVec3::new(1.1, 0.1, 0.0),
        DVec3::new(0.2, 0.9, -0.1),
        DVec3::new(0.3, 0.2, 1.2),
    ];
    (mesh, positions)
}

fn vec(x: &[DVec3]) -> DVector<f64> {
    DVector::from_iterator(3 * x.len(), x.iter().flat_map(|x| x.to_array()))
}

for_both! {
#[test]
fn numbers_vectors_and_matrices() {
    let x = DVec3::new(1.0, -2.0, 2.0);
    let u = dvector![1.0, 2.0];
    let a = dmatrix![3.0, 1.0; -1.0, 2.0];
    let mut module = Small::new(3.0, x, &u, &a).unwrap();
    assert_eq!(module.da(), 54.0);
    assert_eq!(module.daa(), 18.0);
    assert_eq!(module.dx(), 18.0 * x);
    assert_eq!(module.dax(), 12.0 * x);
    assert_eq!(module.H(), DMat3::from_diagonal(DVec3::splat(18.0)));
    same(&module.dz(), &(0.5 * (&a + a.transpose()) * &u));
    close(&module.d2z(), &(0.5 * (&a + a.transpose())));
    same(&module.dA(), &dvector![0.5, 1.0, 1.0, 2.0]);
    close(&module.J(), &a);
    assert_eq!(module.r(), x / 3.0);
    assert_eq!(module.f(2.0), 36.0);
    // where the length has no derivative it is 0
    module.set_x(DVec3::ZERO).unwrap();
    assert_eq!(module.r(), DVec3::ZERO);
}

#[test]
fn sequences_in_the_order_of_vec() {
    let x = [DVec2::new(1.0, 2.0), DVec2::new(-1.0, 3.0)];
    let q = [
        DMat2::from_cols_array(&[1.0, 2.0, 3.0, 4.0]),
        DMat2::from_cols_array(&[5.0, 6.0, 7.0, 8.0]),
    ];
    let r = DMat2::from_cols_array(&[1.0, 0.5, -1.0, 2.0]);
    let module = Shapes::new(x, q, r, [2.0, 3.0]).unwrap();
    let gram = r.transpose() * r;
    let (g0, g1) = (4.0 * (gram * x[0]), 6.0 * (gram * x[1]));
    same(&module.gx(), &dvector![g0.x, g0.y, g1.x, g1.y]);
    let outer = |k: usize, w: f64| {
        let y = r * x[k];
        [x[k].x * y, x[k].y * y].map(|c| 2.0 * w * c)
    };
    let (a, b) = (outer(0, 2.0), outer(1, 3.0));
    let g_r = module.gR();
    for (k, column) in [a[0] + b[0], a[1] + b[1]].into_iter().enumerate() {
        assert!((g_r[2 * k] - column.x).abs() < 1e-12 && (g_r[2 * k + 1] - column.y).abs() < 1e-12);
    }
    same(&module.gw(), &dvector![(r * x[0]).length_squared(), (r * x[1]).length_squared()]);
    let block = dmatrix![gram.x_axis.x, gram.y_axis.x; gram.x_axis.y, gram.y_axis.y];
    let mut expected = DMatrix::zeros(4, 4);
    expected.view_mut((0, 0), (2, 2)).copy_from(&(4.0 * &block));
    expected.view_mut((2, 2), (2, 2)).copy_from(&(6.0 * &block));
    let hx = module.Hx();
    assert_eq!(hx.nnz(), 8);
    close(&dense(&hx), &expected);
    let mut mixed = DMatrix::zeros(4, 2);
    for (k, x) in x.iter().enumerate() {
        let column = 2.0 * (gram * *x);
        mixed[(2 * k, k)] = column.x;
        mixed[(2 * k + 1, k)] = column.y;
    }
    close(&dense(&module.Hxw()), &mixed);
    same(&module.gq(), &dvector![4.0, -3.0, -2.0, 1.0, 8.0, -7.0, -6.0, 5.0]);
    let mut expected = DMatrix::zeros(8, 8);
    for k in [0, 4] {
        for (i, j, value) in [(0, 3, 1.0), (3, 0, 1.0), (1, 2, -1.0), (2, 1, -1.0)] {
            expected[(k + i, k + j)] = value;
        }
    }
    close(&dense(&module.Hq()), &expected);
    // not a sum of terms of a few items: dense
    let t: DMatrix<f64> = module.HT();
    close(&t, &dmatrix![84.0, 48.0; 48.0, 124.0]);
    let v = DVec2::new(1.0, 2.0);
    let n = module.n(v);
    assert!((n - DMat2::from_cols_array(&[28.0, 16.0, 16.0, 52.0])).abs_diff_eq(DMat2::ZERO, 1e-12));
}

#[test]
fn calls_inside_of_calls_and_stacked_items() {
    let m = Calls::new(0.8, vec![DVec2::new(1.0, 2.0), DVec2::new(-0.5, 0.25)]).unwrap();
    let h = |t: f64| t * t + 1.0 / t;
    let slope = |t: f64| 2.0 * t - 1.0 / (t * t);
    let bend = |t: f64| 2.0 + 2.0 / (t * t * t);
    let (a, b, c) = (0.8, h(0.8), h(h(0.8)));
    assert!((m.dy() - slope(a) * slope(b) * slope(c)).abs() < 1e-12);
    let expected = bend(b) * slope(a).powi(2) + slope(b) * bend(a);
    assert!((m.d2z() - expected).abs() < 1e-12);
    assert_eq!(dense(&m.H()), 2.0 * DMatrix::identity(4, 4));
    let u = dvector![1.0, 2.0, -0.5, 0.25];
    let expected = 8.0 * &u * u.transpose() + DMatrix::identity(4, 4) * (4.0 * u.norm_squared());
    close(&m.G(), &expected);
}

#[test]
fn derivatives_of_derivatives_and_of_definitions() {
    let x = [DVec3::new(1.0, 2.0, -2.0), DVec3::new(0.0, 0.6, 0.8)];
    let u = dvector![1.0, 2.0, -1.0];
    let p = DVec3::new(1.0, 0.0, 0.0);
    let members: Set<i64> = [1, 2].into_iter().collect();
    let m = Composed::new(x, &u, 3.0, 2.0, p, members).unwrap();
    let each = |f: &dyn Fn(DVec3) -> DVec3| vec(&x.map(f));
    same(&m.g(), &each(&|x| 4.0 * x.length_squared() * x));
    same(&m.N(), &each(&|x| 96.0 * x.length_squared().powi(2) * x));
    // of 4 ‖x‖² I + 8 x xᵀ
    same(&m.Q(), &each(&|x| 4.0 * 176.0 * x.length_squared() * x));
    assert!(m.d() < 2.0);
    let away = (x[1] - p) / (x[1] - p).length();
    same(&m.dx(), &vec(&[DVec3::ZERO, away]));
    assert!((m.dp() + away).length() < 1e-12);
    assert!((m.fp() - 3.0 * p).length() < 1e-12);
    same(&m.fu(), &(3.0 * u.norm() * &u));
    assert_eq!(m.cp(), 2.0 * p);
    let twice = DMatrix::identity(3, 3) * 2.0;
    close(&m.cu(), &twice);
    close(&m.J(), &twice);
    same(&m.s([1.0, -2.0]), &dvector![2.0, -4.0]);
    let y = DMatrix::from_fn(3, 3, |i, j| {
        let own = if i == j { u[i].cos() * u[0] } else { 0.0 };
        own + if j == 0 { u[i].sin() } else { 0.0 }
    });
    close(&m.Y(), &y);
    let (cubes, sum): (f64, f64) = (u.iter().map(|x| x.powi(3)).sum(), u.sum());
    same(&m.t(), &u.map(|x| 6.0 * cubes * x * x));
    same(&m.q(), &u.map(|x| u.norm_squared() + 2.0 * x * sum));
    assert_eq!((m.third(), m.mixed()), (24.0 * 3.0 * 2.0, 8.0));
}

#[test]
fn sums_over_elements() {
    let (mesh, x) = tetrahedron();
    let y: Vec<DVec3> = x.iter().map(|x| *x * 1.5 + DVec3::X).collect();
    let module = Descent::new(&mesh, &x, &y).unwrap();
    let n = x.len();
    // every vertex is beside every other one
    let sum: DVec3 = x.iter().sum();
    let slope = |v: usize| (2.0 / 6.0) * (4.0 * x[v] - sum) + 0.5 * (x[v] - y[v]);
    let expected: Vec<DVec3> = (0..n).map(slope).collect();
    same(&module.g(), &vec(&expected));
    let step: Vec<DVec3> = (0..n).map(|v| x[v] - 0.1 * expected[v]).collect();
    same(&vec(&module.x1_star()), &vec(&step));
    // B = ‖K x‖² with K the Laplacian of the complete graph, K² = 4 K
    let k: DMatrix<f64> = DMatrix::from_fn(n, n, |i, j| if i == j { -3.0 } else { 1.0 });
    let h = (&k * &k * 2.0).kronecker(&DMatrix::identity(3, 3));
    close(&dense(&module.HB()), &h);
    same(&module.gB(), &(&h * vec(&x)));
    // springs
    let mut plain = DMatrix::zeros(3 * n, 3 * n);
    let mut projected = plain.clone();
    for i in 0..n {
        for j in 0..i {
            let d = x[i] - x[j];
            let l = d.length();
            let u = nalgebra::Vector3::from(d.to_array()) / l;
            let across = nalgebra::Matrix3::identity() - u * u.transpose();
            let k = 2.0 * u * u.transpose() + 2.0 * (1.0 - 1.0 / l) * across;
            let p = 2.0 * u * u.transpose() + 2.0 * (1.0 - 1.0 / l).max(0.0) * across;
            for (all, block) in [(&mut plain, k), (&mut projected, p)] {
                for (a, b, sign) in [(i, i, 1.0), (j, j, 1.0), (i, j, -1.0), (j, i, -1.0)] {
                    let mut view = all.view_mut((3 * a, 3 * b), (3, 3));
                    view += sign * block;
                }
            }
        }
    }
    close(&dense(&module.HS()), &plain);
    close(&dense(&module.PS()), &projected);
    let total: DVector<f64> = mesh.edges().map(|e| module.slope(e)).sum();
    let all: Vec<DVector<f64>> = module.slope_all();
    same(&total, &all.into_iter().sum());
}
}
