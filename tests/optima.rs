//! Optima and integrals, against values that are known in closed form or were computed by other means.

use iheartmesh::glam::{DMat3, DVec3};
use iheartmesh::{FaceMesh, Set, Vertex};
use nalgebra::{DMatrix, DVector, dmatrix, dvector};

#[macro_use]
#[path = "support/twice.rs"]
mod twice;

programs! {
    Unrestricted, PlainUnrestricted = r#"
        cos from trigonometry
        A ∈ ℝ^(m×n)
        b ∈ ℝ^m
        λ ∈ ℝ
        x_i ∈ ℝ³
        R_i ∈ ℝ^(3×3)
        c = min_(C ∈ ℝ^3) ∑_i ‖x_i + (R_i - I_3)C‖²
        C = argmin_(C ∈ ℝ^3) ∑_i ‖x_i + (R_i - I_3)C‖²
        u = argmin_(u ∈ ℝ^n) ‖A u - b‖² + λ‖u‖²
        t = argmin_(t ∈ ℝ) cos(t)
        far = with initial t = 8
            argmin_(t ∈ ℝ) cos(t)
        d = max_(t ∈ ℝ) 1 - (t - 2)² - λ
        v, s = argmin_(v ∈ ℝ^n, s ∈ ℝ) ‖A v - b‖² + (s - 2)² + λ‖v‖²
        H = argmin_(H ∈ ℝ^(2×3)) ‖H - [1 2 3; 4 5 6]‖²
        y_i = argmin_(y ∈ ℝ³) ‖y - x_i‖²
        z = argmin_(z_i ∈ ℝ³) ∑_i ‖z_i - 2x_i‖² + ‖z_1 - z_2‖²
        near(p) = argmin_(q ∈ ℝ³) ‖q - p‖² + λ ‖q - o‖² where p ∈ ℝ³, o = x_1
        f(k) = { l if k > 0
                 0 otherwise
            where k ∈ ℝ, l = min_(t ∈ ℝ) (t - k)² + k
        min_(t ∈ ℝ) t² + λ
    "#;

    Restricted, PlainRestricted = r#"
        Q ∈ ℝ^(n×n)
        q ∈ ℝ^n
        A ∈ ℝ^(m×n)
        b ∈ ℝ^m
        w = min_(x ∈ ℝ^n) ½ xᵀ Q x + qᵀ x s.t. A x ≤ b
        x = argmin_(x ∈ ℝ^n) ½ xᵀ Q x + qᵀ x
            s.t. A x ≤ b
                 x_i ≥ 0
        y = argmin_(y ∈ ℝ^n) ‖y‖² s.t. ∑_i y_i = 1 and y ≥ 0
        z = argmin_(z ∈ ℝ²) z_1 + z_2 subject to ‖z‖ ≤ 1
        t = argmin_(t ∈ [1, 3]) (t - 4)²
        s, r = argmin_(s ∈ ℝ, r ∈ ℝ) s² + r² s.t. s + r ≥ 2; s ∈ [0, ½]
        p = argmax_(p ∈ ℝ³) -∑_i p_i ln(p_i) s.t. ∑_i p_i = 1; p ≥ 0
        X = argmin_(X ∈ ℝ^(2×2)) ‖X - [3 0; 0 -3]‖² s.t. X_i,j ≤ 2; X ≥ -1
    "#;

    Members, PlainMembers = r#"
        S ∈ {ℤ}
        T ∈ {ℝ}
        n ∈ ℤ
        least = min_(k ∈ S) (k - 3)²
        best = argmin_(k ∈ S) (k - 3)²
        greatest = argmax_(k ∈ S) (k - 3)²
        positive = argmin_(k ∈ S) k s.t. k > 0 and k ≠ 2
        i, j = argmin_(i ∈ S, j ∈ S) i j s.t. i > j
        product = max_(i ∈ S, j ∈ S) i j s.t. i ≠ j
        whole = argmin_(k ∈ ℤ) (2 k - 7)² s.t. k ≥ -n; k < n
        none = min_(k ∈ ℤ) k s.t. k ≥ n and k < n
        real = argmin_(t ∈ ℝ) (t - 1)² s.t. t ∈ T
        mixed, u = argmin_(mixed ∈ S, u ∈ ℝ) (mixed - 3)² + (u - mixed)²
        close(k) = { 1 if k = 2 ± n; 0 otherwise where k ∈ ℤ
        nonumber = min_(t ∈ T) (t - 1/2)^0.5
        pair = argmin_(k ∈ S, l ∈ {1, 2}) (k - l - 2)²
    "#;

    OnMesh, PlainOnMesh = r#"
        ElementSets from MeshConnectivity
        VertexOneRing from Neighborhoods(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        x_v ∈ ℝ³
        m : V → ℝ
        top = argmax_(v ∈ V) m_v
        nearest(v) = argmin_(w ∈ VertexOneRing(v)) ‖x_w - x_v‖ where v ∈ V
        distance(v) = min_(w ∈ VertexOneRing(v)) ‖x_w - x_v‖ s.t. m_w > 0 where v ∈ V
        centre(v) = argmin_(y ∈ ℝ³) ∑_(w ∈ VertexOneRing(v)) ‖x_w - y‖² where v ∈ V
        energy(v) = ∫_0^1 ∑_(w ∈ VertexOneRing(v)) ‖x_v + t (x_w - x_v)‖² 𝕕t where v ∈ V
        two(v) = ‖x_a - x_b‖ where v ∈ V, a, b = argmax_(a ∈ VertexOneRing(v), b ∈ VertexOneRing(a)) ‖x_a - x_b‖
    "#;

    Integrals, PlainIntegrals = r#"
        sin from trigonometry
        a ∈ ℝ
        b ∈ ℝ^n
        third = ∫_[0, 1] t² 𝕕t
        same = int_[0, 1] t² 𝕕t
        upto(c) = ∫_0^c t² + a 𝕕t where c ∈ ℝ
        between = ∫_a^(2a) 1/t 𝕕t
        nested = ∫_[0, 1] ∫_[0, y] x y 𝕕x 𝕕y
        gauss = ∫_[-∞, ∞] exp(-t²) 𝕕t
        p = ∫_0^1 ∑_i b_i t 𝕕t
        none(c) = ∫_c^1 1/t² 𝕕t where c ∈ ℝ
        v_i = ∫_0^1 b_i t 𝕕t
        best = argmin_(s ∈ ℝ) ∫_0^1 (t - s)² 𝕕t
        q = a ∫_0^π sin(t) 𝕕t + 1
    "#;

    Without, PlainWithout = r#"
        a ∈ ℝ
        u ∈ ℝ^n
        w_i ∈ ℝ
        S ∈ {ℝ}
        ofvector = max(u)
        ofsequence = min(w)
        ofset = max(S)
        down = min_(t ∈ ℝ) a t
        open = argmax_(t ∈ ℝ) t²
        empty = min_(t ∈ ℝ) t² s.t. t ≥ a; t ≤ a - 1
        apart = min_(t ∈ ℝ²) ‖t‖² s.t. ‖t‖ ≤ 1; t_1 ≥ 2
        k(t) = { t² if t > a + 1000 where t ∈ ℝ
        inner = min_(t ∈ ℝ) k(t)
    "#;
}

#[track_caller]
fn near(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (a, b) in found.iter().zip(expected) {
        assert!(
            (a - b).abs() <= tolerance * b.abs().max(1.0),
            "{found:?} instead of {expected:?}"
        );
    }
}

fn tetrahedron() -> FaceMesh {
    FaceMesh::from_triangles(4, &[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]).expect("a mesh")
}

const POSITIONS: [DVec3; 4] = [
    DVec3::new(0.0, 0.0, 0.0),
    DVec3::new(1.0, 0.0, 0.0),
    DVec3::new(0.0, 2.0, 0.0),
    DVec3::new(0.0, 0.5, 3.0),
];

for_both! {
    #[test]
    fn unrestricted() {
        let a = dmatrix![1.0, 2.0; 3.0, 4.0; 5.0, 7.0];
        let b = dvector![1.0, -1.0, 2.0];
        let x = vec![DVec3::new(1.0, 2.0, 3.0), DVec3::new(-1.0, 0.5, 2.0)];
        let r = vec![DMat3::from_rotation_x(0.7), DMat3::from_rotation_z(1.1)];
        let lambda = 0.3;
        let s = Unrestricted::new(&a, &b, lambda, &x, &r).expect("a struct");
        // normal equations
        let normal = a.transpose() * &a + DMatrix::identity(2, 2) * lambda;
        let exact = normal.lu().solve(&(a.transpose() * &b)).expect("regular");
        near(s.u().as_slice(), exact.as_slice(), 1e-9);
        let (v, two) = (s.v(), s.s());
        near(v.as_slice(), exact.as_slice(), 1e-9);
        near(&[two], &[2.0], 1e-9);
        let stack = |i: usize| r[i] - DMat3::IDENTITY;
        let gram: DMat3 = stack(0).transpose() * stack(0) + stack(1).transpose() * stack(1);
        let right = -(stack(0).transpose() * x[0] + stack(1).transpose() * x[1]);
        let c = gram.inverse() * right;
        near(&s.C().to_array(), &c.to_array(), 1e-8);
        let value: f64 = (0..2).map(|i| (x[i] + stack(i) * c).length_squared()).sum();
        near(&[s.c()], &[value], 1e-10);
        near(&[s.t().cos()], &[-1.0], 1e-12);
        near(&[s.far()], &[3.0 * std::f64::consts::PI], 1e-8);
        near(&[s.d()], &[1.0 - lambda], 1e-12);
        near(s.H().transpose().as_slice(), &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0], 1e-9);
        for (y, x) in s.y().iter().zip(&x) {
            near(&y.to_array(), &x.to_array(), 1e-9);
        }
        // (z₁ - 2x₁) + (z₁ - z₂) = 0 and the same for z₂: the differences become a third
        let (mean, half) = (x[0] + x[1], (x[0] - x[1]) / 3.0);
        near(&s.z()[0].to_array(), &(mean + half).to_array(), 1e-8);
        near(&s.z()[1].to_array(), &(mean - half).to_array(), 1e-8);
        let p = DVec3::new(4.0, 0.0, -1.0);
        near(&s.near(p).to_array(), &((p + lambda * x[0]) / (1.0 + lambda)).to_array(), 1e-9);
        near(&[s.f(2.0), s.f(-1.0)], &[2.0, 0.0], 1e-10);
        near(&[s.ret()], &[lambda], 1e-12);
    }

    #[test]
    fn restricted() {
        let q = dmatrix![2.0, 0.5; 0.5, 1.0];
        let c = dvector![-3.0, 2.0];
        let a = dmatrix![1.0, 1.0; -1.0, 0.0];
        let b = dvector![1.0, 2.0];
        let s = Restricted::new(&q, &c, &a, &b).expect("a struct");
        // the free optimum is (16/7, -22/7): its sum is below 1
        let free = -(q.clone().lu().solve(&c).expect("regular"));
        assert!(free.sum() <= 1.0 && free[0] >= -2.0);
        let value = |x: &DVector<f64>| 0.5 * x.dot(&(&q * x)) + c.dot(x);
        near(&[s.w()], &[value(&free)], 1e-9);
        // with x ≥ 0 the second entry is 0 and x₁ ≤ 1 holds with equality
        near(s.x().as_slice(), &[1.0, 0.0], 1e-8);
        near(s.y().as_slice(), &[0.5, 0.5], 1e-9);
        let corner = -std::f64::consts::FRAC_1_SQRT_2;
        near(&s.z().to_array(), &[corner, corner], 1e-7);
        near(&[s.t()], &[3.0], 0.0);
        near(&[s.s(), s.r()], &[0.5, 1.5], 1e-9);
        near(&s.p().to_array(), &[1.0 / 3.0; 3], 1e-8);
        let x = s.X();
        near(&x.to_cols_array(), &[2.0, 0.0, 0.0, -1.0], 1e-8);
    }

    #[test]
    fn members() {
        let set: Set<i64> = [5, 1, 2, -4, 8].into_iter().collect();
        let reals: Set<f64> = [0.25, 1.5, 3.0].into_iter().collect();
        let s = Members::new(&set, &reals, 6).expect("a struct");
        assert_eq!((s.least(), s.best()), (1.0, 2));
        assert_eq!(s.greatest(), -4);
        assert_eq!(s.positive(), 1);
        // in order of the set, with i > j: -4·8 is the least product
        assert_eq!((s.i(), s.j()), (8, -4));
        assert_eq!(s.product(), 40);
        // (2k - 7)² is 1 at 3 and at 4: the first of them
        assert_eq!(s.whole(), 3);
        assert!(s.try_none().is_err());
        assert_eq!(s.real(), 1.5);
        assert_eq!([-5, -4, 2, 8].map(|k| s.close(k)), [0, 1, 0, 1]);
        // the root of -1/4 is not a number
        assert_eq!(s.nonumber(), 1.0);
        assert_eq!(s.mixed(), 2);
        near(&[s.u()], &[2.0], 1e-9);
        // (5, 2) is as good, but comes later
        assert_eq!(s.pair(), (2, 1));
    }

    #[test]
    fn on_a_mesh() {
        let mesh = tetrahedron();
        let m = vec![1.0, 4.0, 4.0, -2.0];
        let s = OnMesh::new(&mesh, &POSITIONS[..], &m).expect("a struct");
        // the first of two
        assert_eq!(s.top(), Vertex::new(1));
        let vertices = (0..4).map(Vertex::new);
        let length = |a: usize, b: usize| (POSITIONS[a] - POSITIONS[b]).length();
        for v in vertices {
            let k = v.index();
            let others: Vec<usize> = (0..4).filter(|o| *o != k).collect();
            let nearest = others.iter().copied().min_by(|a, b| length(*a, k).total_cmp(&length(*b, k)));
            assert_eq!(Some(s.nearest(v).index()), nearest);
            let positive = others.iter().filter(|o| m[**o] > 0.0).map(|o| length(*o, k));
            near(&[s.distance(v)], &[positive.fold(f64::INFINITY, f64::min)], 0.0);
            let mean = others.iter().map(|o| POSITIONS[*o]).sum::<DVec3>() / 3.0;
            near(&s.centre(v).to_array(), &mean.to_array(), 1e-8);
            // ∫ ‖p + t d‖² = ‖p‖² + p·d + ‖d‖²/3
            let energy: f64 = others
                .iter()
                .map(|o| (POSITIONS[k], POSITIONS[*o] - POSITIONS[k]))
                .map(|(p, d)| p.length_squared() + p.dot(d) + d.length_squared() / 3.0)
                .sum();
            near(&[s.energy(v)], &[energy], 1e-10);
            let longest = others.iter().flat_map(|a| (0..4).map(|b| length(*a, b))).fold(0.0, f64::max);
            near(&[s.two(v)], &[longest], 0.0);
        }
        assert_eq!(s.centre_all().len(), 4);
        assert_eq!(s.nearest_all()[0], s.nearest(Vertex::new(0)));
    }

    #[test]
    fn integrals() {
        let s = Integrals::new(1.5, dvector![1.0, 2.0, 3.0]).expect("a struct");
        near(&[s.third(), s.same()], &[1.0 / 3.0; 2], 1e-12);
        near(&[s.upto(3.0), s.upto(-1.0)], &[13.5, -1.0 / 3.0 - 1.5], 1e-12);
        near(&[s.between()], &[2f64.ln()], 1e-12);
        near(&[s.nested()], &[0.125], 1e-12);
        near(&[s.gauss()], &[std::f64::consts::PI.sqrt()], 1e-10);
        near(&[s.p()], &[3.0], 1e-12);
        near(&[s.none(0.5)], &[1.0], 1e-12);
        let error = s.try_none(-1.0).expect_err("a pole").to_string();
        assert!(error.contains("the integral diverges"), "{error}");
        near(s.v().as_slice(), &[0.5, 1.0, 1.5], 1e-12);
        near(&[s.best()], &[0.5], 1e-9);
        near(&[s.q()], &[4.0], 1e-12);
    }

    #[test]
    fn without_a_value() {
        let s = Without::new(2.0, dvector![], &[][..], Set::default()).expect("a struct");
        let says = |error: iheartmesh::Error, what: &str| {
            let text = error.to_string();
            assert!(text.contains(what), "{text}");
        };
        says(s.try_down().expect_err("unbounded"), "has no bound from below, in `min_(t ∈ ℝ) a t`");
        says(s.try_open().expect_err("unbounded"), "has no bound from above");
        says(s.try_empty().expect_err("infeasible"), "no point was found that satisfies the restrictions");
        says(s.try_apart().expect_err("infeasible"), "no point was found that satisfies the restrictions");
        says(s.try_ofvector().expect_err("empty"), "the maximum of a vector without entries in `max(u)`");
        says(s.try_ofsequence().expect_err("empty"), "the minimum of a sequence without entries in `min(w)`");
        says(s.try_ofset().expect_err("empty"), "the maximum of an empty set in `max(S)`");
        says(s.try_inner().expect_err("no case"), "no case applies");
    }
}
