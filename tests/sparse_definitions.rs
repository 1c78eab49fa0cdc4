//! Definitions by entries: sparse matrices by conditions, `+=`, single entries, and indices that the host counts from 0,
//! against loops, with and without optimisations.

use iheartmesh::glam::{DVec3, dvec3};
use iheartmesh::sprs::CsMat;
use iheartmesh::{FaceMesh, Set, Vertex};
use nalgebra::{DMatrix, DVector, dmatrix, dvector};

#[macro_use]
#[path = "support/twice.rs"]
mod twice;

programs! {
    // the last program without a mesh of appendix B of the language reference
    Stiffness, PlainStiffness = r#"
        P ∈ {ℤ×ℤ} : index pairs
        n ∈ ℤ
        K ∈ ℝ^(n×n)
        d_i ∈ ℝ
        K_ij = { d_i + d_j if (i,j) ∈ P
                 0 otherwise
        K_ii = -∑_(j for j != i) K_ij
    "#;

    Counted, PlainCounted = r#"
        P ∈ {ℤ×ℤ} index
        S ∈ {ℤ} index
        k ∈ ℤ index
        s_i ∈ ℤ index
        u, w ∈ ℝ^n
        K ∈ ℝ^(n×n)
        K_ij = { u_i w_j if (i,j) ∈ P
        a = ∑_(i ∈ S) u_i
        b = u_k
        c_i = u_(s_i)
        n1 = |P|
        x = (K + 2 I_n) \ u
    "#;

    Parts, PlainParts = r#"
        P, Q ∈ {ℤ×ℤ}
        u ∈ ℝ^n
        w ∈ ℝ^m
        A ∈ ℝ^(n×n)
        G ∈ ℝ^(n×n)
        H ∈ ℝ^(n×m)
        S ∈ ℝ^(n×n) sparse
        c ∈ ℝ³
        R ∈ ℝ^(2×n)
        x_i ∈ ℝ³
        G_ij = { u_i u_j if (i,j) ∈ P and u_i > 0
                 1 if (i,j) ∈ Q
        G_ij += { 2 if (i,j) ∈ Q
        G_ij += { u_i if i < j
        H_ij = { u_i w_j if (i,j) ∈ P
                 2 if i = j
                 0 otherwise
        y_ij = { A_ij if (i,j) ∈ P
                 0 otherwise
        y_ii = u_i
        y_1,2 = 7
        y_1,* += u
        y_*,2 = 2u
        y_ii += 1
        z = 2 u
        z_1 = 3
        z_2 = z_1 + 1
        z += u
        z_i += 2 u_i
        c_1 = 1
        c_3 = z_1
        q_i = 2 x_i
        q_1 = c
        q_i += x_i
        S_ij = u_i u_j
        S_1,1 = 5
        S_1,* = 0 u
        R_2,* = u
        t_i = { u_i if u_i > 0
                0 otherwise
        later = 2 z_1
    "#;

    Laplacian, PlainLaplacian = r#"
        ElementSets from MeshConnectivity
        VertexOneRing from Neighborhoods(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        x_i ∈ ℝ³
        m : V → ℝ
        k ∈ ℤ vertices
        S ∈ {ℤ} faces
        R ∈ {ℤ×ℤ} vertices
        t_e ∈ ℤ edges
        P = ∪_(v ∈ V) { tuple(v, w) for w ∈ VertexOneRing(v) }
        L ∈ ℝ^(#V×#V)
        L_vw = { ‖x_v - x_w‖ m_v if (v,w) ∈ P
                 0 otherwise
        L_ii = -∑_(j for j ≠ i) L_ij
        r(v) = L_v,v where v ∈ V
        s = ∑_(v ∈ V) m_v + m_k
        Q ∈ ℝ^(|V|×|V|)
        Q_vw = { 1 if (v,w) ∈ R
        h = (Q - L) \ 1_(#V)
    "#;
}

fn dense(a: &CsMat<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(a.rows(), a.cols(), |i, j| {
        a.get(i, j).copied().unwrap_or(0.0)
    })
}

fn pairs(list: &[(i64, i64)]) -> Set<(i64, i64)> {
    list.iter().copied().collect()
}

fn strip() -> FaceMesh {
    FaceMesh::from_triangles(5, &[[0, 1, 2], [1, 3, 2], [2, 3, 4]]).expect("a mesh")
}

for_both! {
    #[test]
    fn the_stiffness_matrix() {
        let list = pairs(&[(1, 2), (2, 1), (3, 1), (3, 3)]);
        let d = [1.0, 20.0, 300.0];
        let module = Stiffness::new(&list, 3, &d[..]).expect("valid");
        let expected = dmatrix![-21.0, 21.0, 0.0; 21.0, -21.0, 0.0; 301.0, 0.0, 600.0 - 301.0];
        assert_eq!(dense(&module.K()), expected);
        assert!(module.K().nnz() <= 6);
    }

    #[test]
    fn indices_of_the_stiffness_matrix_are_checked() {
        let error = |list: &[(i64, i64)]| {
            Stiffness::new(pairs(list), 3, &[1.0, 2.0, 3.0][..]).expect_err("out of range").to_string()
        };
        assert_eq!(
            error(&[(1, 1), (2, 4)]),
            "`P` has the entry (2, 4), but 4 is none of the 3 columns of `K`: they are numbered from 1 to 3"
        );
        assert_eq!(
            error(&[(0, 1)]),
            "`P` has the entry (0, 1), but 0 is none of the 3 rows of `K`: they are numbered from 1 to 3"
        );
        // the lengths are compared when they are needed
        let module = Stiffness::new(pairs(&[(1, 2)]), 3, &[1.0, 2.0][..]).expect("fits");
        let error = module.try_K().expect_err("two sizes").to_string();
        assert!(error.contains("two sizes differ that one index runs over"), "{error}");
        let mut module = Stiffness::new(pairs(&[(1, 2)]), 2, &[1.0, 2.0][..]).expect("fits");
        assert_eq!(dense(&module.K()), dmatrix![-3.0, 3.0; 0.0, 0.0]);
        assert!(module.set_P(pairs(&[(2, 3)])).is_err());
        module.set_P(pairs(&[(2, 1)])).expect("fits");
        assert_eq!(dense(&module.K()), dmatrix![0.0, 0.0; 3.0, -3.0]);
    }

    #[test]
    fn the_host_counts_from_0() {
        let u = dvector![1.0, 2.0, 3.0];
        let w = dvector![10.0, 20.0, 30.0];
        let set: Set<i64> = [0, 2].into_iter().collect();
        let new = |list: &[(i64, i64)]| Counted::new(pairs(list), &set, 1, &[2, 0][..], &u, &w);
        let module = new(&[(0, 0), (2, 1)]).expect("valid");
        assert_eq!(dense(&module.K()), dmatrix![10.0, 0.0, 0.0; 0.0, 0.0, 0.0; 0.0, 60.0, 0.0]);
        assert_eq!((module.a(), module.b(), module.n1()), (4.0, 2.0, 2));
        assert_eq!(module.c(), dvector![3.0, 1.0]);
        assert_eq!(
            new(&[(0, 0), (3, 1)]).expect_err("out of range").to_string(),
            "`P` has the entry (3, 1), but 3 is none of the 3 rows of `K`: they are numbered from 0 to 2"
        );
        assert!(new(&[(-1, 0)]).is_err());
        assert!(new(&[(0, 3)]).is_err());
    }

    #[test]
    fn parts() {
        let (n, m) = (3usize, 2usize);
        let u = dvector![1.0, -2.0, 3.0];
        let w = dvector![10.0, 20.0];
        let a = dmatrix![1.0, 2.0, 3.0; 4.0, 5.0, 6.0; 7.0, 8.0, 9.0];
        let p = pairs(&[(1, 1), (2, 2), (3, 1), (1, 2)]);
        let q = pairs(&[(2, 2), (3, 1), (1, 3)]);
        let x: Vec<DVec3> = vec![dvec3(1.0, 2.0, 3.0), dvec3(4.0, 5.0, 6.0)];
        let module = Parts::new(&p, &q, &u, &w, &a, &x).expect("valid");
        let has = |set: &Set<(i64, i64)>, i: usize, j: usize| set.contains(&(i as i64 + 1, j as i64 + 1));
        let g = DMatrix::from_fn(n, n, |i, j| {
            let first = match () {
                _ if has(&p, i, j) && u[i] > 0.0 => u[i] * u[j],
                _ if has(&q, i, j) => 1.0,
                _ => 0.0,
            };
            first + if has(&q, i, j) { 2.0 } else { 0.0 } + if i < j { u[i] } else { 0.0 }
        });
        assert_eq!(dense(&module.G()), g);
        let h = DMatrix::from_fn(n, m, |i, j| match () {
            _ if has(&p, i, j) => u[i] * w[j],
            _ if i == j => 2.0,
            _ => 0.0,
        });
        assert_eq!(dense(&module.H()), h);
        let mut y = DMatrix::from_fn(n, n, |i, j| if has(&p, i, j) { a[(i, j)] } else { 0.0 });
        y.set_diagonal(&u);
        y[(0, 1)] = 7.0;
        for j in 0..n {
            y[(0, j)] += u[j];
        }
        y.set_column(1, &(2.0 * &u));
        y += DMatrix::<f64>::identity(n, n);
        assert_eq!(module.y(), y);
        let z = dvector![3.0, 4.0, 6.0] + &u + 2.0 * &u;
        assert_eq!(module.z(), z);
        assert_eq!(module.later(), 2.0 * z[0]);
        assert_eq!(module.c(), dvec3(1.0, 0.0, z[0]));
        assert_eq!(module.q(), vec![dvec3(2.0, 2.0, 3.0 + z[0]), dvec3(12.0, 15.0, 18.0)]);
        let mut s = &u * u.transpose();
        s.fill_row(0, 0.0);
        assert_eq!(dense(&module.S()), s);
        let mut r = DMatrix::zeros(2, n);
        r.set_row(1, &u.transpose());
        assert_eq!(module.R(), r);
        assert_eq!(module.t(), u.map(|x| x.max(0.0)));
    }

    #[test]
    fn the_laplacian_of_a_mesh() {
        let mesh = strip();
        let x: Vec<DVec3> = (0..5).map(|i| dvec3(f64::from(i), f64::from(i * i), 0.5)).collect();
        let m = [1.0, 2.0, 3.0, 4.0, 5.0];
        let edges = [(0usize, 1usize), (1, 2), (2, 0), (1, 3), (3, 2), (3, 4), (4, 2)];
        let new = |k: u32, pair: (u32, u32), edge: u32| {
            let pair: Set<_> = [(Vertex::new(pair.0), Vertex::new(pair.1))].into_iter().collect();
            Laplacian::new(
                &mesh, &x, &m[..], Vertex::new(k), Set::default(), pair, vec![iheartmesh::Edge::new(edge)],
            )
        };
        let module = new(3, (0, 0), 0).expect("valid");
        let mut expected = DMatrix::zeros(5, 5);
        for (a, b) in edges {
            for (v, w) in [(a, b), (b, a)] {
                let value = (x[v] - x[w]).length() * m[v];
                expected[(v, w)] += value;
                expected[(v, v)] -= value;
            }
        }
        assert!((dense(&module.L()) - &expected).amax() < 1e-12);
        assert_eq!(module.r(Vertex::new(2)), dense(&module.L())[(2, 2)]);
        assert_eq!(module.s(), 15.0 + 4.0);
        let mut q = DMatrix::<f64>::zeros(5, 5);
        q[(0, 0)] = 1.0;
        let right = (&q - &expected) * module.h();
        assert!((right - DVector::repeat(5, 1.0)).amax() < 1e-10);
        for wrong in [new(5, (0, 0), 0), new(0, (0, 5), 0), new(0, (0, 0), 7)] {
            assert!(wrong.expect_err("no such element").to_string().contains("is not in `M`"));
        }
    }
}
