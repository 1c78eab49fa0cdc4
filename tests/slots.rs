//! Sums of blocks with planned places: sparse Hessians and gradients whose pattern is found once per mesh.

#[path = "../examples/common/generate.rs"]
#[allow(dead_code)]
mod generate;
#[path = "support/plane.rs"]
mod plane;
#[macro_use]
#[path = "support/twice.rs"]
mod twice;

use std::collections::BTreeMap;

use iheartmesh::glam::DVec2;
use iheartmesh::{Face, FaceMesh, Set, sprs::CsMat};
use nalgebra::{DMatrix, DVector};
use plane::{grid, meshes};

programs! {
    Springs, PlainSprings = r#"
        ElementSets from MeshConnectivity
        OrientedVertices, VertexOneRing, Vertices from Neighborhoods(M)
        psd, psd_abs from linearalgebra
        M : FaceMesh
        V, E, F = ElementSets(M)
        x_i ∈ ℝ²
        w ∈ ℝ
        l(p, q) = { ‖p - q‖⁴ if ‖p - q‖² < w
                    w ‖p - q‖² otherwise where p, q ∈ ℝ²
        D(f) = |[x_b - x_a  x_c - x_a]| where f ∈ F, a, b, c = OrientedVertices(f)
        S(f) = { (D(f) - w)² if D(f) > ½
                 0 otherwise where f ∈ F
        r(i) = ∑_(j ∈ VertexOneRing(i)) l(x_i, x_j) where i ∈ V
        e = ∑_(f ∈ F) S(f) + ∑_(i ∈ V) r(i) + w ∑_(k ∈ E) l(x_i, x_j) where i, j = Vertices(k)
        g = ∂e/∂x
        H = ∂²e/∂x²
        `θ` = ∑_(f ∈ F) psd(∂²S(f)/∂x²)
        A = ∑_(f ∈ F) psd_abs(∂²S(f)/∂x²)
        R = ∑_(i ∈ V) psd(∂²r(i)/∂x²)
        B = 3 H
    "#;

    Sums, PlainSums = r#"
        ElementSets from MeshConnectivity
        OrientedVertices, VertexOneRing, Vertices from Neighborhoods(M)
        psd, psd_abs, tr from linearalgebra
        M : FaceMesh
        V, E, F = ElementSets(M)
        x : V → ℝ²
        w ∈ ℝ
        U ⊂ F
        D(f) = |[x_b - x_a  x_c - x_a]| where f ∈ F, a, b, c = OrientedVertices(f)
        S(f) = { (D(f) - w)² if D(f) > ½
                 0 otherwise where f ∈ F
        l(k) = (‖x_i - x_j‖² - w)² where k ∈ E, i, j = Vertices(k)
        e = ∑_(f ∈ U) S(f)
        H = ∂²e/∂x²
        B = 3 H
        C = -(2 ∑_(f ∈ F) psd(∂²S(f)/∂x²)) / w
        A = ∑_(f ∈ F) psd(∂²S(f)/∂x²) - ½ (∑_(k ∈ E) psd_abs(∂²l(k)/∂x²) / w - H) + B
        L ∈ ℝ^(2#V×2#V)
        L_ij = { 1/i if i = j
        N = -(w L) + ∑_(f ∈ U) (psd(∂²S(f)/∂x²) - 2 psd_abs(∂²S(f)/∂x²) / w) - I_(2#V) / w
        O = { ∑_(f ∈ F) psd(∂²S(f)/∂x²) if w > 1
              ∑_(k ∈ E) psd(∂²l(k)/∂x²) otherwise
        R ∈ ℝ^(2#V×2#V)
        R_ij = { (w² + 100)/i if i = j
        T = R + 2 ∑_(f ∈ F) psd(∂²S(f)/∂x²) - R
        t = tr(∂²e/∂x²)
        d = (∑_(f ∈ F) psd(∂²S(f)/∂x²) + R) \ (∂e/∂x)
        q = -(∂e/∂x) / 2 - 3 ∂(∑_(k ∈ E) l(k))/∂x
    "#;

    Pairs, PlainPairs = r#"
        psd from linearalgebra
        x_i ∈ ℝ²
        w ∈ ℝ
        P ∈ {ℤ×ℤ}
        l(p, q) = (‖p - 2 q‖² - w)² where p, q ∈ ℝ²
        T(i, j) = l(x_i, x_j) where i, j ∈ ℤ
        e = ∑_((i, j) ∈ P) T(i, j)
        g = ∂e/∂x
        H = ∂²e/∂x²
        Q = ∑_((i, j) ∈ P) psd(∂²T(i, j)/∂x²)
    "#;
}

fn dense(a: &CsMat<f64>) -> DMatrix<f64> {
    let mut all = DMatrix::zeros(a.rows(), a.cols());
    for (value, (i, j)) in a {
        all[(i, j)] += *value;
    }
    all
}

#[track_caller]
fn near(a: &DMatrix<f64>, b: &DMatrix<f64>) {
    assert_eq!(a.shape(), b.shape());
    let scale = b.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
    for (x, y) in a.iter().zip(b) {
        assert!((x - y).abs() < 1e-12 * scale, "{x} is not {y}");
    }
}

/// The place of each entry, in order.
fn pattern(a: &CsMat<f64>) -> (Vec<usize>, Vec<usize>) {
    assert!(a.is_csc());
    (a.proper_indptr().to_vec(), a.indices().to_vec())
}

#[test]
fn with_and_without_planned_places() {
    for (mesh, x) in meshes(5) {
        for w in [0.3, 2.0, 100.0] {
            let planned = optimized::Springs::new(&mesh, &x, w).unwrap();
            let plain = plain::Springs::new(&mesh, &x, w).unwrap();
            assert!((planned.g() - plain.g()).amax() < 1e-12 * plain.g().amax().max(1.0));
            for (a, b) in [
                (planned.H(), plain.H()),
                (planned.theta(), plain.theta()),
                (planned.A(), plain.A()),
                (planned.R(), plain.R()),
                (planned.B(), plain.B()),
            ] {
                near(&dense(&a), &dense(&b));
                near(&dense(&a), &dense(&a).transpose());
            }
        }
    }
}

#[test]
fn sums_of_several_parts() {
    for (mesh, x) in meshes(5) {
        let faces: Vec<Face> = mesh.faces().collect();
        let mut planned = optimized::Sums::new(&mesh, &x, 2.0, Set::from(faces.clone())).unwrap();
        let mut known = planned.A();
        for (w, some) in [(0.3, 1), (2.0, 2), (2.0, 1), (100.0, 5)] {
            let some: Set<Face> = faces.iter().step_by(some).copied().collect();
            planned.set_w(w).unwrap();
            planned.set_U(some.clone()).unwrap();
            let plain = plain::Sums::new(&mesh, &x, w, some).unwrap();
            planned.A_into(&mut known);
            assert_eq!(known, planned.A());
            for (a, b) in [
                (planned.A(), plain.A()),
                (planned.B(), plain.B()),
                (planned.C(), plain.C()),
                (planned.N(), plain.N()),
                (planned.O(), plain.O()),
                (planned.T(), plain.T()),
            ] {
                near(&dense(&a), &dense(&b));
            }
            // by what they are sums of
            let (h, p) = (dense(&planned.H()), dense(&planned.C()));
            near(&dense(&planned.B()), &(3.0 * &h));
            let l = DVector::from_fn(2 * x.len(), |k, _| 1.0 / (k + 1) as f64);
            near(&dense(&planned.L()), &DMatrix::from_diagonal(&l));
            near(&p, &p.transpose());
            near(&dense(&planned.T()), &(-w * &p));
            assert!((planned.t() - h.trace()).abs() < 1e-12 * h.amax().max(1.0));
            for (a, b) in [(planned.q(), plain.q()), (planned.d(), plain.d())] {
                assert!((&a - &b).amax() < 1e-9 * b.amax().max(1.0));
            }
        }
    }
}

/// Differences of gradients, and the same for the gradient of energies.
#[test]
fn differences() {
    for (mesh, x) in meshes(5) {
        let at = |x: &[DVec2]| {
            let module = optimized::Springs::new(&mesh, x, 2.0).unwrap();
            (module.e(), module.g())
        };
        let module = optimized::Springs::new(&mesh, &x, 2.0).unwrap();
        let (g, h) = (module.g(), dense(&module.H()));
        let step = 1e-5;
        for k in 0..2 * x.len() {
            let moved = |step: f64| {
                let mut x = x.clone();
                x[k / 2][k % 2] += step;
                at(&x)
            };
            let (a, b) = (moved(step), moved(-step));
            let scale = g.amax().max(1.0);
            assert!(((a.0 - b.0) / (2.0 * step) - g[k]).abs() < 1e-6 * scale);
            let column = (a.1 - b.1) / (2.0 * step);
            let scale = h.amax().max(1.0);
            assert!((column - h.column(k)).amax() < 1e-6 * scale);
        }
    }
}

#[test]
fn projected_blocks_are_positive() {
    for (mesh, x) in meshes(5).into_iter().filter(|(_, x)| !x.is_empty()) {
        let module = optimized::Springs::new(&mesh, &x, 2.0).unwrap();
        for matrix in [module.theta(), module.A(), module.R()] {
            let values = dense(&matrix).symmetric_eigenvalues();
            assert!(values.min() > -1e-12 * values.amax().max(1.0));
        }
    }
}

#[test]
fn the_pattern_does_not_depend_on_values() {
    let (x, triangles) = grid(6);
    let mesh = FaceMesh::from_triangles(x.len(), &triangles).unwrap();
    let mut module = optimized::Springs::new(&mesh, x.clone(), 2.0).unwrap();
    let (h, p) = (pattern(&module.H()), pattern(&module.theta()));
    for factor in [0.0, 0.1, 10.0] {
        let x: Vec<DVec2> = x.iter().map(|x| *x * factor).collect();
        module.set_x(x).unwrap();
        assert_eq!(pattern(&module.H()), h);
        assert_eq!(pattern(&module.theta()), p);
    }
    // entries ascend in each column
    for column in h.0.windows(2) {
        assert!(h.1[column[0]..column[1]].is_sorted_by(|a, b| a < b));
    }
}

#[test]
fn memory_is_used_again() {
    let (x, triangles) = grid(6);
    let mesh = FaceMesh::from_triangles(x.len(), &triangles).unwrap();
    let mut module = optimized::Springs::new(&mesh, x.clone(), 2.0).unwrap();
    let mut h = CsMat::zero((0, 0));
    let mut g = DVector::zeros(0);
    module.H_into(&mut h);
    module.g_into(&mut g);
    let places = (h.data().as_ptr(), h.indices().as_ptr(), g.as_ptr());
    for factor in [0.5, 2.0] {
        let moved: Vec<DVec2> = x.iter().map(|x| *x * factor).collect();
        module.set_x(moved).unwrap();
        // computed there, and copied from what is kept
        for _ in 0..2 {
            module.try_H_into(&mut h).unwrap();
            module.try_g_into(&mut g).unwrap();
            assert_eq!(
                (h.data().as_ptr(), h.indices().as_ptr(), g.as_ptr()),
                places
            );
            assert_eq!(h, module.H());
            assert_eq!(g, module.g());
        }
        // what is not planned is copied
        let mut b = module.B();
        let place = b.data().as_ptr();
        b.data_mut().fill(0.0);
        module.B_into(&mut b);
        assert_eq!((b.data().as_ptr(), &b), (place, &module.B()));
    }
    // another pattern, the same by rows, another size: all of them become the value
    let mut other = module.H().into_csr();
    module.H_into(&mut other);
    assert_eq!(other, module.H());
    let mut other: CsMat<f64> = CsMat::eye_csc(module.H().rows());
    module.H_into(&mut other);
    assert_eq!(other, module.H());
    let mut p = module.H();
    module.theta_into(&mut p);
    assert_eq!(p, module.theta());
}

#[test]
fn every_number_of_threads_gives_the_same_bits() {
    let (x, triangles) = grid(90);
    let mesh = FaceMesh::from_triangles(x.len(), &triangles).unwrap();
    let values = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.unwrap().install(|| {
            let module = optimized::Springs::new(&mesh, &x, 2.0).unwrap();
            let bits = |x: &[f64]| x.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
            [
                bits(module.g().as_slice()),
                bits(module.H().data()),
                bits(module.theta().data()),
            ]
        })
    };
    let one = values(1);
    for threads in [2, 3, 8] {
        assert!(values(threads) == one);
    }
}

/// The Hessian of the sum over pairs by hand.
fn by_hand(x: &[DVec2], w: f64, pairs: &[(i64, i64)], project: bool) -> DMatrix<f64> {
    let mut all = DMatrix::zeros(2 * x.len(), 2 * x.len());
    for (i, j) in pairs {
        let (i, j) = (*i as usize - 1, *j as usize - 1);
        let d = x[i] - 2.0 * x[j];
        let d = DVector::from_row_slice(&d.to_array());
        let inner = 8.0 * &d * d.transpose()
            + 4.0 * (d.norm_squared() - w) * DMatrix::<f64>::identity(2, 2);
        let mut block = DMatrix::zeros(all.nrows(), all.ncols());
        for (a, p) in [(i, 1.0), (j, -2.0)] {
            for (b, q) in [(i, 1.0), (j, -2.0)] {
                let mut part = block.view_mut((2 * a, 2 * b), (2, 2));
                part += p * q * &inner;
            }
        }
        if project {
            let eigen = block.symmetric_eigen();
            let values = DMatrix::from_diagonal(&eigen.eigenvalues.map(|x| x.max(0.0)));
            block = &eigen.eigenvectors * values * eigen.eigenvectors.transpose();
        }
        all += block;
    }
    all
}

for_both! {
    #[test]
    fn places_from_the_host() {
        let (x, _) = grid(3);
        let mut module = Pairs::new(&x, 4.0, Set::from(vec![(1, 2), (4, 3)])).unwrap();
        let mut h = module.H();
        // the same item twice in one term: its parts add up before eigenvalues are replaced
        for pairs in [
            vec![(1, 2), (4, 3)],
            vec![(5, 5), (9, 1), (9, 9)],
            vec![],
            vec![(2, 1)],
        ] {
            module.set_P(Set::from(pairs.clone())).unwrap();
            for w in [0.1, 4.0, 60.0] {
                module.set_w(w).unwrap();
                module.H_into(&mut h);
                near(&dense(&h), &by_hand(&x, w, &pairs, false));
                near(&dense(&module.H()), &by_hand(&x, w, &pairs, false));
                near(&dense(&module.Q()), &by_hand(&x, w, &pairs, true));
            }
        }
        // an item that there is not
        module.set_P(Set::from(vec![(1, 10)])).unwrap();
        assert!(module.try_H().is_err());
        assert!(module.try_H_into(&mut h).is_err());
        // more items
        let (x, _) = grid(4);
        module.set_x(&x).unwrap();
        near(&dense(&module.H()), &by_hand(&x, 60.0, &[(1, 10)], false));
        module.H_into(&mut h);
        assert_eq!(h.shape(), (32, 32));
    }
}

/// What is stored are the places that some block has, also where both branches differ.
#[test]
fn stored_zeros() {
    let mesh = FaceMesh::from_triangles(5, &[[0, 1, 2]]).unwrap();
    let x = vec![DVec2::ZERO; 5];
    let module = optimized::Springs::new(&mesh, &x, 2.0).unwrap();
    let h = module.H();
    // the six rows of the face; columns of vertices without faces are empty
    assert_eq!(h.data(), vec![0.0; 36]);
    let mut columns: BTreeMap<usize, usize> = BTreeMap::new();
    for (_, (_, j)) in &h {
        *columns.entry(j).or_default() += 1;
    }
    assert_eq!(columns, (0..6).map(|j| (j, 6)).collect());
}
