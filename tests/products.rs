//! Products of sums of blocks and vectors: without the matrix, and with it.

#[macro_use]
#[path = "support/twice.rs"]
mod twice;

use iheartmesh::glam::DVec2;
use iheartmesh::{FaceMesh, Set, sprs::CsMat};
use nalgebra::{DMatrix, DVector};

programs! {
    Springs, PlainSprings = r#"
        ElementSets from MeshConnectivity
        OrientedVertices, Vertices from Neighborhoods(M)
        psd, tr, vec from linearalgebra
        M : FaceMesh
        V, E, F = ElementSets(M)
        x_i ∈ ℝ²
        u_i ∈ ℝ²
        c_i ∈ ℝ
        w ∈ ℝ
        D(f) = |[x_b - x_a  x_c - x_a]| where f ∈ F, a, b, c = OrientedVertices(f)
        S(f) = { (D(f) - w)² if D(f) > ½
                 0 otherwise where f ∈ F
        l(k) = (‖x_i - x_j‖² - w)² where k ∈ E, i, j = Vertices(k)
        e = ∑_(f ∈ F) S(f) + ½ ∑_(k ∈ E) l(k)
        U = ∑_(f ∈ F) c_a (D(f) - w)² where a, b, d = OrientedVertices(f)
        v = vec(u)
        g = ∂e/∂x
        H = ∂²e/∂x²
        J = ∂²U/∂x∂c
        `K` = ∂²e/∂x²
        B = 3 H - ½ K
        p = H v
        q = H g - v
        r = vᵀ H
        s = vᵀ H v
        t = (∂²e/∂x²) (2 v + g)
        a = B v
        b = -(H + K)ᵀ v / w
        y = J c
        z = Jᵀ v
        P = ∑_(f ∈ F) psd(∂²S(f)/∂x²)
        d = P v
        m = (P + H) v
        G = ∂²e/∂x²
        h = G v
        o = tr(G)
    "#;

    Columns, PlainColumns = r#"
        ElementSets from MeshConnectivity
        OrientedVertices, VertexOneRing, Vertices from Neighborhoods(M)
        psd, psd_abs, vec from linearalgebra
        M : FaceMesh
        V, E, F = ElementSets(M)
        x : V → ℝ²
        u : V → ℝ²
        w ∈ ℝ
        Z ∈ ℝ^(2#V×k)
        Y ∈ ℝ^(k×2#V)
        D(f) = |[x_b - x_a  x_c - x_a]| where f ∈ F, a, b, c = OrientedVertices(f)
        S(f) = { (D(f) - w)² if D(f) > ½
                 w ‖x_a - x_b‖² if D(f) > 0
                 0 otherwise where f ∈ F, a, b, c = OrientedVertices(f)
        l(k) = (‖x_i - x_j‖² - w)² where k ∈ E, i, j = Vertices(k)
        r(i) = ∑_(j ∈ VertexOneRing(i)) (‖x_i - x_j‖² - w)² where i ∈ V
        e = ∑_(f ∈ F) S(f) + ½ ∑_(k ∈ E) l(k)
        v = vec(u)
        H = ∂²e/∂x²
        P = ∑_(f ∈ F) psd(∂²S(f)/∂x²)
        `Q` = ∑_(k ∈ E) psd_abs(∂²l(k)/∂x²)
        R = ∑_(i ∈ V) psd(∂²r(i)/∂x²)
        a = P v
        b = (P - 2 `Q`)ᵀ v / w
        c = vᵀ P
        d = vᵀ `Q` v
        g = (H + P) (v - `Q` v)
        h = R v
        A = H Z
        B = Y H
        C = Zᵀ H Z
        `K` = (P + 3 H) Z
        N = Y `Q`
        G = Zᵀ (P - H) Z
        T = [v  vec(x)  (w v)]
        I = H T
        J = `Q` T
        O = Tᵀ P T
        L = R T - (H (P Z)) (Y v) (vᵀ T)
    "#;

    Rows, PlainRows = r#"
        ElementSets from MeshConnectivity
        OrientedVertices, VertexOneRing, Vertices, Faces from Neighborhoods(M)
        vec from linearalgebra
        M : FaceMesh
        V, E, F = ElementSets(M)
        x : V → ℝ²
        v ∈ ℝ^(2#V)
        w ∈ ℝ
        u_i ∈ ℝ
        D(f) = |[x_b - x_a  x_c - x_a]| where f ∈ F, a, b, c = OrientedVertices(f)
        r ∈ ℝ^(#F)
        r_f = D(f)² - w
        c ∈ ℝ^(#F)
        R(f) = ‖x_i‖² ‖x_j‖² where f ∈ F, i, j, k = OrientedVertices(f)
        c_f = { D(f)³ if D(f) > w
                R(f) if D(f) > 0
                1 otherwise
        q ∈ ℝ^(#E)
        q_e = ∑_(i ∈ Vertices(e)) ∑_(j ∈ VertexOneRing(i)) ‖x_i - x_j‖²
        m ∈ ℝ^(#V)
        m_v = ∑_(f ∈ Faces(v)) c_f²
        t_i = u_i² u_1
        J = ∂r/∂x
        C = ∂c/∂x
        `Q` = ∂q/∂x
        A = ∂m/∂x
        T = ∂t/∂u
        a = J v
        b = Jᵀ r
        d = rᵀ C
        f = -(C - 2 J) v / w
        g = `Q` v
        h = 3 `Q`ᵀ q
        k = A v
        l = Aᵀ m
        n = T t
        o = tᵀ T
        s = rᵀ J v
    "#;

    Pairs, PlainPairs = r#"
        psd, psd_abs, vec from linearalgebra
        x_i ∈ ℝ²
        u_i ∈ ℝ²
        w ∈ ℝ
        Q ∈ {ℤ×ℤ}
        T(i, j) = (‖x_i - 2 x_j‖² - w)² where i, j ∈ ℤ
        e = ∑_((i, j) ∈ Q) T(i, j)
        H = ∂²e/∂x²
        `θ` = ∑_((i, j) ∈ Q) psd(∂²T(i, j)/∂x²)
        A = ∑_((i, j) ∈ Q) psd_abs(∂²T(i, j)/∂x²)
        p = H vec(u)
        q = `θ` vec(u)
        r = vec(u)ᵀ A
        t_i = ‖u_i‖² ∑_j ‖u_j‖²
        B = ∂t/∂u
        y = B vec(x)
        z = tᵀ B
        s = `θ` [vec(u)  vec(x)]
    "#;
}

fn meshes() -> Vec<(FaceMesh, usize)> {
    let grid = |n: u32| {
        let mut triangles = Vec::new();
        for a in (0..n * (n - 1)).filter(|a| a % n < n - 1) {
            triangles.extend([[a, a + 1, a + n + 1], [a, a + n + 1, a + n]]);
        }
        (triangles, (n * n) as usize)
    };
    let (small, few) = grid(4);
    // large enough for several threads
    let (large, many) = grid(50);
    let all: [(&[[u32; 3]], usize); 7] = [
        (&[], 0),
        (&[], 3),
        // isolated vertices, boundaries
        (&[[1, 3, 5]], 7),
        // three faces on one edge
        (&[[0, 1, 2], [1, 0, 3], [0, 1, 4]], 5),
        // closed
        (&[[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]], 4),
        (&small, few),
        (&large, many),
    ];
    all.map(|(triangles, n)| (FaceMesh::from_triangles(n, triangles).unwrap(), n))
        .into()
}

fn points(n: usize, seed: u64) -> Vec<DVec2> {
    let mut random = fastrand::Rng::with_seed(seed);
    (0..n)
        .map(|_| DVec2::new(random.f64(), random.f64()) * 3.0 - 1.0)
        .collect()
}

/// A sparse matrix times a vector, entry by entry.
fn times(a: &CsMat<f64>, x: &DVector<f64>) -> DVector<f64> {
    let mut y = DVector::zeros(a.rows());
    for (value, (i, j)) in a {
        y[i] += value * x[j];
    }
    y
}

#[track_caller]
fn near(a: &DVector<f64>, b: &DVector<f64>) {
    assert_eq!(a.len(), b.len());
    let scale = b.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
    for (x, y) in a.iter().zip(b) {
        assert!((x - y).abs() < 1e-11 * scale, "{x} is not {y}");
    }
}

for_both! {
    #[test]
    fn products_are_those_of_the_matrix() {
        for (mesh, n) in meshes() {
            // without optimisations every set is searched
            if n > 100 && std::any::type_name::<Springs>().contains("Plain") {
                continue;
            }
            let (x, u) = (points(n, 3), points(n, 4));
            let c: Vec<f64> = points(n, 5).iter().map(|x| x.x).collect();
            let w = 0.7;
            // the products come first: nothing that they need has been computed
            let module = Springs::new(&mesh, &x, &u, &c, w).unwrap();
            let (q, p) = (module.q(), module.p());
            let v = DVector::from_iterator(2 * n, u.iter().flat_map(|x| x.to_array()));
            let c = DVector::from_row_slice(&c);
            let (h, j, g) = (module.H(), module.J(), module.g());
            let hv = times(&h, &v);
            near(&p, &hv);
            near(&q, &(times(&h, &g) - &v));
            near(&module.r().transpose().column(0).into_owned(), &hv);
            near(&DVector::from_element(1, module.s()), &DVector::from_element(1, v.dot(&hv)));
            near(&module.t(), &times(&h, &(2.0 * &v + &g)));
            near(&module.a(), &(2.5 * &hv));
            near(&module.b(), &(-2.0 / w * &hv));
            near(&module.y(), &times(&j, &c));
            near(&module.z(), &times(&j.transpose_view().to_owned(), &v));
            near(&module.d(), &times(&module.P(), &v));
            near(&module.m(), &(times(&module.P(), &v) + &hv));
            near(&module.h(), &hv);
            let trace: f64 = h.iter().filter(|(_, (i, j))| i == j).map(|(x, _)| *x).sum();
            assert!((module.o() - trace).abs() < 1e-11 * trace.abs().max(1.0));
        }
    }

    #[test]
    fn projected_blocks_and_several_columns() {
        for (mesh, n) in meshes() {
            if n > 100 && std::any::type_name::<Columns>().contains("Plain") {
                continue;
            }
            let (x, u) = (points(n, 3), points(n, 4));
            let mut random = fastrand::Rng::with_seed(8);
            for (k, w) in [(2, 0.7), (0, 0.2), (11, 4.0)] {
                if n > 100 && k != 2 {
                    continue;
                }
                let z = DMatrix::from_fn(2 * n, k, |_, _| random.f64() - 0.5);
                let y = DMatrix::from_fn(k, 2 * n, |_, _| random.f64() - 0.5);
                let module = Columns::new(&mesh, &x, &u, w, &z, &y).unwrap();
                let column = DMatrix::from_iterator(2 * n, 1, u.iter().flat_map(|x| x.to_array()));
                let mut t = DMatrix::zeros(2 * n, 3);
                t.set_column(0, &column.column(0));
                t.set_column(1, &DVector::from_iterator(2 * n, x.iter().flat_map(|x| x.to_array())));
                t.set_column(2, &(w * column.column(0)));
                // the products come first: nothing that they need has been computed
                let one = |x: DVector<f64>| DMatrix::from_columns(&[x]);
                let found = [
                    (one(module.a()), module.c().transpose()),
                    (module.A(), module.B().transpose()),
                    (module.K(), module.N().transpose()),
                    (module.C(), module.G()),
                    (module.I(), module.J()),
                    (DMatrix::from_fn(3, 3, |i, j| module.O().col(j)[i]), module.L()),
                    (one(module.b()), one(module.g())),
                    (DMatrix::from_element(1, 1, module.d()), one(module.h())),
                ];
                let times = |a: &CsMat<f64>, x: &DMatrix<f64>| {
                    let mut all = DMatrix::zeros(a.rows(), x.ncols());
                    for (value, (i, j)) in a {
                        for k in 0..x.ncols() {
                            all[(i, k)] += value * x[(j, k)];
                        }
                    }
                    all
                };
                let (h, p, q, r) = (module.H(), module.P(), module.Q(), module.R());
                let (pz, hz) = (times(&p, &z), times(&h, &z));
                let (pv, qv) = (times(&p, &column), times(&q, &column));
                let inner = &column - &qv;
                let expected = [
                    (pv.clone(), pv.clone()),
                    (hz.clone(), times(&h, &y.transpose())),
                    (&pz + 3.0 * &hz, times(&q, &y.transpose())),
                    (z.transpose() * &hz, z.transpose() * (&pz - &hz)),
                    (times(&h, &t), times(&q, &t)),
                    (
                        t.transpose() * times(&p, &t),
                        times(&r, &t) - times(&h, &pz) * (&y * &column) * (column.transpose() * &t),
                    ),
                    ((&pv - 2.0 * &qv) / w, times(&h, &inner) + times(&p, &inner)),
                    (column.transpose() * &qv, times(&r, &column)),
                ];
                for (found, expected) in found.iter().zip(&expected) {
                    for (found, expected) in [(&found.0, &expected.0), (&found.1, &expected.1)] {
                        assert_eq!(found.shape(), expected.shape());
                        let flat = |a: &DMatrix<f64>| DVector::from_column_slice(a.as_slice());
                        near(&flat(found), &flat(expected));
                    }
                }
            }
        }
    }

    #[test]
    fn derivatives_of_vectors() {
        for (mesh, n) in meshes() {
            if n > 100 {
                continue;
            }
            let (x, u) = (points(n, 3), vec![0.5, -2.0, 1.5]);
            let v = DVector::from_iterator(2 * n, points(n, 4).iter().flat_map(|x| x.to_array()));
            for w in [0.7, 0.1] {
                let module = Rows::new(&mesh, &x, &v, w, &u).unwrap();
                let row = |x: DMatrix<f64>| DVector::from_row_slice(x.transpose().as_slice());
                let found = [
                    module.a(),
                    module.b(),
                    row(module.d()),
                    module.f(),
                    module.g(),
                    module.h(),
                    module.k(),
                    module.l(),
                    module.n(),
                    row(module.o()),
                ];
                let (r, q, m, t) = (module.r(), module.q(), module.m(), module.t());
                let dense = |a: &CsMat<f64>| {
                    let mut all = DMatrix::zeros(a.rows(), a.cols());
                    for (entry, (i, j)) in a {
                        all[(i, j)] = *entry;
                    }
                    all
                };
                let [j, c, a] = [module.J(), module.C(), module.A()].map(|a| dense(&a));
                let [q_of_x, t_of_u] = [module.Q(), module.T()].map(|a| dense(&a));
                let expected = [
                    &j * &v,
                    j.transpose() * &r,
                    c.transpose() * &r,
                    -(&c - 2.0 * &j) * &v / w,
                    &q_of_x * &v,
                    3.0 * q_of_x.transpose() * q,
                    &a * &v,
                    a.transpose() * m,
                    &t_of_u * &t,
                    t_of_u.transpose() * &t,
                ];
                for (found, expected) in found.iter().zip(&expected) {
                    near(found, expected);
                }
                near(
                    &DVector::from_element(1, module.s()),
                    &DVector::from_element(1, r.dot(&(&j * &v))),
                );
            }
        }
    }

    #[test]
    fn places_from_the_host() {
        let (x, u) = (points(6, 1), points(6, 2));
        let mut module = Pairs::new(&x, &u, 0.5, Set::from(vec![])).unwrap();
        for pairs in [vec![], vec![(1, 2), (6, 3)], vec![(5, 5), (2, 1), (1, 2)]] {
            module.set_Q(Set::from(pairs)).unwrap();
            let v = DVector::from_iterator(12, u.iter().flat_map(|x| x.to_array()));
            // the same item twice in one term is one
            let (q, r, s) = (module.q(), module.r().transpose(), module.s());
            near(&module.p(), &times(&module.H(), &v));
            near(&q, &times(&module.theta(), &v));
            near(&r.column(0).into_owned(), &times(&module.A(), &v));
            // each entry takes all of u
            let (b, t, z) = (module.B(), module.t(), module.z().transpose());
            near(&z.column(0).into_owned(), &(b.transpose() * t));
            let place = DVector::from_iterator(12, x.iter().flat_map(|x| x.to_array()));
            near(&module.y(), &(b * &place));
            near(&s.column(0).into_owned(), &q);
            near(&s.column(1).into_owned(), &times(&module.theta(), &place));
        }
        for pair in [(1, 7), (0, 1)] {
            module.set_Q(Set::from(vec![pair])).unwrap();
            assert!(module.try_p().is_err());
            assert!(module.try_q().is_err());
            assert!(module.try_s().is_err());
            assert!(module.try_H().is_err());
        }
    }
}

/// The gradient along a direction, by differences.
#[test]
fn differences_of_gradients() {
    let (mesh, n) = meshes().swap_remove(4);
    let (x, u) = (points(n, 3), points(n, 4));
    let at = |t: f64| {
        let x: Vec<DVec2> = x.iter().zip(&u).map(|(x, u)| *x + t * *u).collect();
        optimized::Springs::new(&mesh, x, &u, vec![0.0; n], 0.7).unwrap()
    };
    let step = 1e-5;
    let difference = (at(step).g() - at(-step).g()) / (2.0 * step);
    let product = at(0.0).p();
    let error = DMatrix::from_columns(&[difference - &product]).amax();
    assert!(error < 1e-6 * product.amax().max(1.0));
}
