//! Derivatives that are sparse matrices: of vectors whose entries take a few items each, of squares and products of such
//! vectors, and of what sparse matrices are multiplied with. Against differences of values and gradients.

use iheartmesh::glam::DVec2;
use iheartmesh::sprs::CsMat;
use nalgebra::{DMatrix, DVector};

#[path = "support/plane.rs"]
mod plane;
#[macro_use]
#[path = "support/twice.rs"]
mod twice;

programs! {
    Residuals, PlainResiduals = r#"
        ElementSets from MeshConnectivity
        Vertices, OrientedVertices, VertexOneRing from Neighborhoods(M)
        vec, diag, tr from linearalgebra
        M : FaceMesh
        V, E, F = ElementSets(M)
        x : V → ℝ²
        w ∈ ℝ^(#E)
        a ∈ ℝ
        S(k) = ‖x_i - x_j‖² - a where k ∈ E, i, j = Vertices(k)
        D(f) = |[x_q - x_p  x_r - x_p]| where f ∈ F, p, q, r = OrientedVertices(f)
        r ∈ ℝ^(#E)
        r_k = S(k) ‖x_(Vertices(k)_1)‖²
        s ∈ ℝ^(#F)
        s_f = { D(f)² if D(f) > a
                D(f) otherwise
        A ∈ ℝ^(#F×2)
        m(f) = D(f) x_p where f ∈ F, p, q, r = OrientedVertices(f)
        A_f,* = m(f)
        B ∈ ℝ^(2×#V)
        B_*,v = ∑_(j ∈ VertexOneRing(v)) ‖x_v - x_j‖² x_j
        C_i = ‖x_i‖² x_i
        t : F → ℝ²
        t_f = m(f)
        b = r - 2 w
        c = vec(A)
        d = vec(B)
        q = vec(C)
        J = ∂r/∂x
        `K` = ∂s/∂x
        L = ∂b/∂x
        N = ∂vec(A)/∂x
        O = ∂vec(B)/∂x
        P = ∂vec(C)/∂x
        `Q`(f) = ∂m(f)/∂x where f ∈ F
        u = J vec(x)
        v = Jᵀ r
        y = (JᵀJ) v
        e = ½ ‖r‖²
        h = (r - w)⋅w + ‖A‖² / 3 - tr(BᵀB) + (w ∘ r)ᵀ r - rᵀ diag(w) r / 2 + ‖vec(t)‖² - ‖(vec(C) - 2 vec(x)) / a‖²
        g = ∂e/∂x
        `g'` = ∂h/∂x
        G = ∂²e/∂x²
        H = ∂²h/∂x²
        R = ∂g/∂x
        T = JᵀJ
        U = `K`ᵀ`K`
        W = 3 PᵀP
        X = NᵀN - 2 LᵀJ
        Y = ∂vec(t)/∂x
        Z = YᵀY
        n = vec(t)
    "#;

    Quadratic, PlainQuadratic = r#"
        ElementSets, BoundaryMatrices from MeshConnectivity
        tr, vec from linearalgebra
        M : FaceMesh
        V, E, F = ElementSets(M)
        `∂⁰`, `∂¹` = BoundaryMatrices(M)
        u ∈ ℝ^(#V)
        b ∈ ℝ^(#V)
        X ∈ ℝ^(#V×2)
        m : V → ℝ
        s_i ∈ ℝ
        W ∈ ℝ^(#E×#E)
        W_ij = { ½ i if (i, j) ∈ T
        T ∈ {ℤ×ℤ}
        L = `∂⁰` W `∂⁰`ᵀ
        e = ½ uᵀ L u - bᵀu + ‖L u - u‖² / 2 + ∑_i u_i⁴
        f = tr(Xᵀ L X) / 2 + ‖`∂⁰`ᵀ X - W `∂⁰`ᵀ X‖²
        g = ∂e/∂u
        h = ∂f/∂X
        G = ∂²e/∂u²
        H = ∂²f/∂X²
        N = ∂²(uᵀ L b)/∂u∂b
        J = ∂(L u - u)/∂u
        `K` = ∂vec(L X)/∂X
        k = vec(L X)
        l = L u - u
        p = mᵀ L m / 2 - sᵀ L s
        q = sᵀ L
        r = (L s)ᵀ m + sᵀ s
        P = ∂²p/∂m²
        S = ∂²p/∂s²
        R = ∂²r/∂m∂s
        t = ∂p/∂s
    "#;
}

fn dense(a: &CsMat<f64>) -> DMatrix<f64> {
    assert!(a.is_csc());
    let mut all = DMatrix::zeros(a.rows(), a.cols());
    for (value, (i, j)) in a {
        all[(i, j)] += *value;
    }
    all
}

#[track_caller]
fn close(found: &DMatrix<f64>, expected: &DMatrix<f64>, tolerance: f64) {
    assert_eq!(found.shape(), expected.shape());
    if expected.is_empty() {
        return;
    }
    let error = (found - expected).amax();
    assert!(
        error <= tolerance * (1.0 + expected.amax()),
        "{error} of {}",
        expected.amax()
    );
}

/// The derivatives of a vector by central differences, a column for each number.
fn differences(n: usize, at: impl Fn(usize, f64) -> DVector<f64>) -> DMatrix<f64> {
    let step = 1e-5;
    let columns: Vec<DVector<f64>> = (0..n)
        .map(|k| (at(k, step) - at(k, -step)) / (2.0 * step))
        .collect();
    match columns.is_empty() {
        true => DMatrix::zeros(at(0, 0.0).len(), 0),
        false => DMatrix::from_columns(&columns),
    }
}

/// Points, one number of them moved.
fn moved(x: &[DVec2], k: usize, step: f64) -> Vec<DVec2> {
    let mut x = x.to_vec();
    if let Some(point) = x.get_mut(k / 2) {
        point[k % 2] += step;
    }
    x
}

for_both! {
    #[test]
    fn vectors_and_their_squares() {
        for (mesh, x) in plane::meshes(4) {
            let w = DVector::from_fn(mesh.n_edges(), |k, _| 0.3 + (k % 5) as f64);
            let module = Residuals::new(&mesh, &x, &w, 0.2).unwrap();
            let n = 2 * x.len();
            let by = |f: &dyn Fn(&Residuals) -> DVector<f64>| {
                differences(n, |k, step| {
                    f(&Residuals::new(&mesh, moved(&x, k, step), &w, 0.2).unwrap())
                })
            };
            let matrices: [(CsMat<f64>, DMatrix<f64>); 10] = [
                (module.J(), by(&|m| m.r())),
                (module.Y(), by(&|m| m.n())),
                (module.K(), by(&|m| m.s())),
                (module.L(), by(&|m| m.b())),
                (module.N(), by(&|m| m.c())),
                (module.O(), by(&|m| m.d())),
                (module.P(), by(&|m| m.q())),
                (module.G(), by(&|m| m.g())),
                (module.H(), by(&|m| m.g_prime())),
                (module.R(), by(&|m| m.g())),
            ];
            for (found, expected) in &matrices {
                close(&dense(found), expected, 1e-6);
            }
            // numbers by differences as well
            for (gradient, value) in [
                (module.g(), by(&|m| DVector::from_element(1, m.e()))),
                (module.g_prime(), by(&|m| DVector::from_element(1, m.h()))),
            ] {
                let row = DMatrix::from_row_slice(1, n, gradient.as_slice());
                close(&row, &value, 1e-6);
            }
            for f in mesh.faces() {
                let expected = by(&|m| DVector::from_column_slice(&m.m(f).to_array()));
                let found: CsMat<f64> = module.Q(f);
                close(&dense(&found), &expected, 1e-6);
                // a triangle takes the items of its corners
                assert!(found.nnz() <= 12);
            }
            // a row for each edge: the items of its vertices
            assert!(module.J().nnz() <= 4 * mesh.n_edges());
            let j = dense(&module.J());
            let [k, n_of_x, p] = [module.K(), module.N(), module.P()].map(|a| dense(&a));
            let y = dense(&module.Y());
            close(&dense(&module.Z()), &(y.transpose() * &y), 1e-12);
            close(&dense(&module.T()), &(j.transpose() * &j), 1e-12);
            close(&dense(&module.U()), &(k.transpose() * &k), 1e-12);
            close(&dense(&module.W()), &(3.0 * p.transpose() * &p), 1e-12);
            let expected = n_of_x.transpose() * &n_of_x - 2.0 * j.transpose() * &j;
            close(&dense(&module.X()), &expected, 1e-12);
            let flat = DVector::from_iterator(n, x.iter().flat_map(|x| x.to_array()));
            let products = [
                (module.u(), &j * flat),
                (module.v(), j.transpose() * module.r()),
                (module.y(), j.transpose() * &j * module.v()),
            ];
            for (found, expected) in products {
                let all = DMatrix::from_columns(&[found, expected]);
                close(&all.columns(0, 1).into(), &all.columns(1, 1).into(), 1e-12);
            }
        }
    }

    #[test]
    fn quadratic_forms_of_sparse_matrices() {
        for (mesh, x) in plane::meshes(4) {
            let (n, edges) = (x.len(), mesh.n_edges() as i64);
            let pairs = (1..=edges).flat_map(|i| [(i, i), (i, 1)]);
            let pairs: iheartmesh::Set<(i64, i64)> = pairs.collect();
            let u = DVector::from_fn(n, |i, _| (i as f64).sin());
            let b = DVector::from_fn(n, |i, _| (i as f64).cos());
            let points = DMatrix::from_fn(n, 2, |i, j| x[i][j]);
            let at = |u: DVector<f64>, points: DMatrix<f64>| {
                let [m, s] = [0, 1].map(|k| x.iter().map(|x| x[k]).collect::<Vec<f64>>());
                Quadratic::new(&mesh, u, &b, points, m, s, pairs.clone()).unwrap()
            };
            let module = at(u.clone(), points.clone());
            let by_u = |f: &dyn Fn(&Quadratic) -> DVector<f64>| {
                differences(n, |k, step| {
                    let mut u = u.clone();
                    if let Some(entry) = u.get_mut(k) {
                        *entry += step;
                    }
                    f(&at(u, points.clone()))
                })
            };
            let by_points = |f: &dyn Fn(&Quadratic) -> DVector<f64>| {
                differences(2 * n, |k, step| {
                    let mut points = points.clone();
                    if let Some(entry) = points.get_mut(k) {
                        *entry += step;
                    }
                    f(&at(u.clone(), points))
                })
            };
            let matrices: [(CsMat<f64>, DMatrix<f64>); 5] = [
                (module.G(), by_u(&|m| m.g())),
                (module.H(), by_points(&|m| m.h())),
                (module.N(), dense(&module.L())),
                (module.J(), by_u(&|m| m.l())),
                (module.K(), by_points(&|m| m.k())),
            ];
            for (found, expected) in &matrices {
                close(&dense(found), expected, 1e-6);
            }
            // sequences of numbers as vectors
            let l = dense(&module.L());
            let [m, s] = [0, 1].map(|k| DVector::from_fn(n, |i, _| x[i][k]));
            let both = &l + l.transpose();
            close(&dense(&module.P()), &(0.5 * &both), 1e-12);
            close(&dense(&module.S()), &-&both, 1e-12);
            close(&dense(&module.R()), &l, 1e-12);
            let all = DMatrix::from_columns(&[module.t(), module.q().transpose().column(0).into()]);
            let expected = DMatrix::from_columns(&[-&both * &s, l.transpose() * &s]);
            close(&all, &expected, 1e-12);
            let found = [module.p(), module.r()];
            let expected = [m.dot(&(&l * &m)) / 2.0 - s.dot(&(&l * &s)), (&l * &s).dot(&m) + s.dot(&s)];
            assert!((found[0] - expected[0]).abs() + (found[1] - expected[1]).abs() < 1e-10);
            let row = |v: &DVector<f64>| DMatrix::from_row_slice(1, v.len(), v.as_slice());
            let number = |x: f64| DVector::from_element(1, x);
            close(&row(&module.g()), &by_u(&|m| number(m.e())), 1e-6);
            close(&row(&module.h()), &by_points(&|m| number(m.f())), 1e-6);
        }
    }
}
