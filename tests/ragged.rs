//! Sequences whose items differ in size, sequences as arguments of any size, and sizes that are known only at run time.

use iheartmesh::glam::{DVec2, DVec3};
use iheartmesh::{Error, FaceMesh, Vertex};
use nalgebra::{DMatrix, DVector, dmatrix, dvector};

#[macro_use]
#[path = "support/twice.rs"]
mod twice;

programs! {
    Ragged, PlainRagged = r#"
        vec from linearalgebra
        x_i ∈ ℝ^(n_i)
        A_i ∈ ℝ^(m_i×n_i)
        b_i ∈ ℝ^(m_i + 1)
        s = ∑_i ‖x_i‖²
        t = ∑_i A_i,1,1
        y_i = A_i x_i
        z_i = 2 y_i + A_i x_i
        l_i = ∑_(j = 1)^(n_i) x_i,j
        k_i = ∑_j x_i,j
        w = ∑_i (b_i)ᵀ (A_i x_i, 1)
        most = max(n)
        all = ∑_i n_i
        first = n_1
        long(k) = n_k + m_k where k ∈ ℤ
        r = vec(x)
        c = |x|
        d = x_1 + x_2
        D_i = [A_i 0; 0 I_2]
        g = ∑_i y_i
        T = { n_k for k ∈ {1, 2} }
        o_i = 1_(n_i)
    "#;

    Declared, PlainDeclared = r#"
        n_i ∈ ℤ
        x_i ∈ ℝ^(n_i)
        y_i ∈ ℝ^(2n_i)
        s_i = n_i ‖x_i‖²
        total = ∑_i (x_i, x_i)⋅y_i
    "#;

    Arguments, PlainArguments = r#"
        null from linearalgebra
        x_i ∈ ℝ³
        y_i ∈ ℝ²
        w_i ∈ ℝ
        z_j ∈ ℝ^(m_j)
        Q ∈ {ℝ^(2)}
        total(u) = ∑_i u_i + u_1 where u_i ∈ ℝ^k
        ends(u) = u_1 - u_2 where u_i ∈ ℝ
        third(u) = u_3 where u_i ∈ ℝ³
        scaled(u, a) = v where u_i ∈ ℝ^k, a ∈ ℝ,
            v_i = a u_i
        longest(u) = max(n) where u_i ∈ ℝ^(n_i)
        double(u) = v where u_i ∈ ℝ^(n_i), v_i = 2 u_i
        both(u, v) = ∑_i u_i⋅v_i where u_i, v_i ∈ ℝ^k
        size(u) = k where u_i ∈ ℝ^k
        pair(t) = t_2 + t_1 1_l where t ∈ ℝ × ℝ^l
        middle(S) = 1/|S| ∑_(q ∈ S) q where S ∈ {ℝ^l}
        a = total(x)
        b = total(y)
        c = ends(w)
        d = third(x)
        e = scaled(x, 2)
        f = longest(z)
        g = longest(x)
        h = double(z)
        o = double(y)
        p = both(x, x)
        q = size(x) + size(y)
        r = pair(tuple(2, x_1))
        s = middle(Q)
        t = ends(sequence(1, 2, 3))
    "#;

    Later, PlainLater = r#"
        null from linearalgebra
        A, B ∈ ℝ^(2×3)
        C ∈ ℝ^(n×k)
        a ∈ ℝ^k
        y = null(A) + null(B)
        z = [null(A) null(B)]
        w = [null(A)ᵀ; null(B)ᵀ]
        N_i = null(R_i)
        R_i ∈ ℝ^(l×3)
        v = N_1 + N_2
        kernel(M) = null(M) where M ∈ ℝ^(q×r)
        u = kernel(A) + kernel(B)
        dot(a, b) = a⋅b where a, b ∈ ℝ^q
        s(f) = f⋅a where f ∈ ℝ^k
        m(f) = C f where f ∈ ℝ^k
        add(a) = ∑_(i = 1)^c a where a ∈ ℝ^q
        c ∈ ℤ
        t = add(a)
        o = ∑_(i = 1)^c 1_c
        h = ∑_(i = 1)^c 1_(2n)
        cut(a) = a where a ∈ ℝ^(n/2)
        Q_i,* = 2 N_1,i,*
    "#;

    Elements, PlainElements = r#"
        ElementSets from MeshConnectivity
        VertexOneRing from Neighborhoods(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        m : V → ℝ
        x_v ∈ ℝ³
        q_i ∈ V
        S_j ⊂ V
        a = ∑_v m_v
        b = ∑_v m_v x_v
        c = ∑_(v for m_v > 1) m_v
        d = ∑_i m_(q_i)
        e = |q|
        f_i = x_(q_i)
        g = ∑_j |S_j|
        h_v = 2 m_v
        H = ∑_v h_v
        near(v) = h_v where v ∈ V
        ring = ∑_i |VertexOneRing(q_i)|
        last = q_2
        first(p) = p_1 where p_i ∈ V
        k = first(q)
    "#;

    Members, PlainMembers = r#"
        ElementSets from MeshConnectivity
        M : FaceMesh
        V, E, F = ElementSets(M)
        m : V → ℝ
        c ∈ ℝ
        Heavy = { v for v ∈ V if m_v > c }
        S ⊂ V
        K ∈ {ℤ}
        P ∈ {ℤ × ℤ}
        h ∈ Heavy
        s ∈ S
        T ⊂ S
        k ∈ K
        p ∈ P
        q_i ∈ Heavy
        a = m_h + m_s + |T| + k + p_1
        f(j) = 2 j where j ∈ K
        g(u) = m_u where u ∈ Heavy
        i(L) = |L| where L ⊂ K
    "#;

    Half, PlainHalf = r#"
        n ∈ ℤ
        a ∈ ℝ^(n/2)
        b ∈ ℝ^n
        c = (a, a) + b
        d = 1_(n/2) + a
    "#;
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-12 * (1.0 + b.abs()), "{a} is not {b}");
}

fn vectors() -> Vec<DVector<f64>> {
    vec![dvector![1.0, 2.0], dvector![3.0, 4.0, 5.0]]
}

fn matrices() -> Vec<DMatrix<f64>> {
    vec![
        dmatrix![1.0, 2.0; 3.0, 4.0; 5.0, 6.0],
        dmatrix![7.0, 8.0, 9.0],
    ]
}

fn message<T>(result: Result<T, Error>) -> String {
    match result {
        Ok(_) => panic!("there is no error"),
        Err(error) => error.to_string(),
    }
}

fn tetrahedron() -> FaceMesh {
    FaceMesh::from_triangles(4, &[[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]).unwrap()
}

for_both! {
#[test]
fn items_of_their_own_sizes() {
    let (x, a) = (vectors(), matrices());
    let b = vec![dvector![1.0, 1.0, 1.0, 1.0], dvector![1.0, 2.0]];
    let mut module = Ragged::new(&x, &a, &b).unwrap();
    close(module.s(), 55.0);
    close(module.t(), 8.0);
    assert_eq!(module.y()[..], [dvector![5.0, 11.0, 17.0], dvector![98.0]]);
    assert_eq!(module.z()[..], [dvector![15.0, 33.0, 51.0], dvector![294.0]]);
    assert_eq!(module.l(), dvector![3.0, 12.0]);
    assert_eq!(module.k(), dvector![3.0, 12.0]);
    close(module.w(), 34.0 + 100.0);
    assert_eq!(module.most(), 3);
    assert_eq!(module.all(), 5);
    assert_eq!(module.first(), 2);
    assert_eq!(module.long(2), 4);
    assert!(module.try_long(3).is_err());
    assert_eq!(module.r(), dvector![1.0, 2.0, 3.0, 4.0, 5.0]);
    assert_eq!(module.c(), 2);
    assert!(message(module.try_d()).contains("the sizes do not fit"));
    assert!(message(module.try_g()).contains("terms of different sizes"));
    assert_eq!(module.D()[1], dmatrix![7.0, 8.0, 9.0, 0.0, 0.0; 0.0, 0.0, 0.0, 1.0, 0.0; 0.0, 0.0, 0.0, 0.0, 1.0]);
    assert_eq!(module.T().into_iter().collect::<Vec<_>>(), [2, 3]);
    assert_eq!(module.o()[..], [dvector![1.0, 1.0], dvector![1.0, 1.0, 1.0]]);
    let error = message(module.set_x(vec![dvector![1.0], dvector![3.0, 4.0, 5.0]]));
    assert_eq!(error, "the number of columns of item 1 of `A` is 2 but should be 1: it is `n_i`, and `x` says so");
    assert!(module.set_x(vec![dvector![1.0, 2.0]]).is_err());
    module.set_x(vec![dvector![0.0, 2.0], dvector![3.0, 4.0, 5.0]]).unwrap();
    close(module.s(), 54.0);
    let error = message(Ragged::new(&x, &a, vec![dvector![1.0], dvector![1.0, 2.0]]));
    assert_eq!(error, "the length of item 1 of `b` is 1 but should be 4: it is `m_i+1`, and `A` says so");
}

#[test]
fn sizes_that_are_handed_in() {
    let y = vec![dvector![1.0, 1.0, 1.0, 1.0], DVector::from_element(6, 2.0)];
    let mut module = Declared::new([2, 3], vectors(), &y).unwrap();
    close(module.s()[0], 10.0);
    close(module.s()[1], 150.0);
    close(module.total(), 6.0 + 48.0);
    let error = message(Declared::new([2, 2], vectors(), &y));
    assert_eq!(error, "the length of item 2 of `x` is 3 but should be 2: it is `n_i`, and `n` says so");
    assert!(module.set_n([2, 4]).is_err());
    assert!(module.set_n([2, 3]).is_ok());
    assert!(module.set_y(vectors()).is_err());
}

#[test]
fn sequences_as_arguments() {
    let x = [DVec3::new(1.0, 2.0, 3.0), DVec3::new(4.0, 5.0, 6.0), DVec3::new(7.0, 8.0, 9.0)];
    let y = [DVec2::new(1.0, 2.0), DVec2::new(3.0, 4.0), DVec2::new(5.0, 6.0)];
    let set = iheartmesh::Set::from(vec![y[0], y[1]]);
    let module = Arguments::new(x, y, [5.0, 3.0, 1.0], vectors(), set).unwrap();
    assert_eq!(module.a(), DVec3::new(13.0, 17.0, 21.0));
    assert_eq!(module.b(), DVec2::new(10.0, 14.0));
    close(module.c(), 2.0);
    assert_eq!(module.d(), x[2]);
    assert_eq!(module.e()[..], [x[0] * 2.0, x[1] * 2.0, x[2] * 2.0]);
    assert_eq!(module.f(), 3);
    assert_eq!(module.g(), 3);
    assert_eq!(module.h()[..], [dvector![2.0, 4.0], dvector![6.0, 8.0, 10.0]]);
    assert_eq!(module.o()[..], [y[0] * 2.0, y[1] * 2.0, y[2] * 2.0]);
    close(module.p(), 14.0 + 77.0 + 194.0);
    assert_eq!(module.q(), 5);
    assert_eq!(module.r(), x[0] + DVec3::splat(2.0));
    assert_eq!(module.s(), DVec2::new(2.0, 3.0));
    close(module.t(), -1.0);
    // what the host hands in may have any size
    assert_eq!(module.total(vec![dvector![1.0], dvector![2.0]]), dvector![4.0]);
    assert_eq!(module.size(vec![dvector![1.0, 2.0]]), 2);
    assert_eq!(module.size(Vec::new()), 0);
    assert_eq!(module.pair((1.0, dvector![1.0, 2.0])), dvector![2.0, 3.0]);
    let error = message(module.try_total(vectors()));
    assert_eq!(error, "the length of `u` is 3 but should be 2: it is `k`, which has this value elsewhere");
    let error = message(module.try_both(vec![dvector![1.0]], vectors()));
    assert!(error.contains("`u` has 1 items but `v` has 2"), "{error}");
}

#[test]
fn sizes_known_only_at_run_time() {
    let a = nalgebra::SMatrix::<f64, 2, 3>::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0);
    let b = nalgebra::SMatrix::<f64, 2, 3>::new(1.0, 0.0, 0.0, 2.0, 0.0, 0.0);
    let c = dmatrix![1.0, 2.0];
    let r = vec![dmatrix![1.0, 0.0, 0.0], dmatrix![0.0, 0.0, 1.0]];
    let module = Later::new(a, b, &c, dvector![3.0, 4.0], &r, 2).unwrap();
    assert!(message(module.try_y()).contains("the sizes do not fit in `null(A) + null(B)`"));
    assert!(message(module.try_u()).contains("the sizes do not fit"));
    assert_eq!(module.z().shape(), (3, 3));
    assert_eq!(module.w().shape(), (3, 3));
    assert_eq!(module.v().shape(), (3, 2));
    assert_eq!(module.Q(), &module.N()[0] * 2.0);
    close(module.dot(dvector![1.0, 2.0], dvector![3.0, 4.0]), 11.0);
    let error = message(module.try_dot(dvector![1.0, 2.0], dvector![3.0]));
    assert_eq!(error, "the length of `b` is 1 but should be 2: it is `q`, and `a` says so");
    close(module.s(dvector![1.0, 1.0]), 7.0);
    let error = message(module.try_s(dvector![1.0]));
    assert_eq!(error, "the length of `f` is 1 but should be 2: it is `k`, and `C` says so");
    assert!(module.try_m(dvector![1.0, 2.0, 3.0]).is_err());
    assert_eq!(module.t(), dvector![6.0, 8.0]);
    assert_eq!(module.o(), dvector![2.0, 2.0]);
    assert_eq!(module.h(), dvector![2.0, 2.0]);
    let error = message(module.try_cut(dvector![1.0]));
    assert_eq!(error, "a size of `a` is `n/2`, but 1/2 is not an integer");
    // sums without terms have their size as well
    let module = Later::new(a, a, &c, dvector![3.0, 4.0], &r, 0).unwrap();
    assert_eq!(module.y().shape(), (3, 1));
    assert_eq!(module.t(), dvector![0.0, 0.0]);
    assert_eq!(module.h(), dvector![0.0, 0.0]);
}

#[test]
fn indices_that_are_elements() {
    let mesh = tetrahedron();
    let x = [DVec3::X, DVec3::Y, DVec3::Z, DVec3::ONE];
    let v = |k| Vertex::new(k);
    let set = |list: &[u32]| list.iter().map(|k| v(*k)).collect::<iheartmesh::Set<Vertex>>();
    let q = [v(3), v(0), v(3)];
    let module = Elements::new(&mesh, [1.0, 2.0, 3.0, 4.0], x, q, vec![set(&[1, 2]), set(&[0])]).unwrap();
    close(module.a(), 10.0);
    assert_eq!(module.b(), DVec3::new(5.0, 6.0, 7.0));
    close(module.c(), 9.0);
    close(module.d(), 9.0);
    assert_eq!(module.e(), 3);
    assert_eq!(module.f()[..], [DVec3::ONE, DVec3::X, DVec3::ONE]);
    assert_eq!(module.g(), 3);
    assert_eq!(module.h().as_slice(), [2.0, 4.0, 6.0, 8.0]);
    close(module.H(), 20.0);
    close(module.near(v(2)), 6.0);
    assert_eq!(module.ring(), 9);
    assert_eq!(module.last(), v(0));
    assert_eq!(module.k(), v(3));
    assert_eq!(module.first([v(1), v(2)]), v(1));
    let error = message(Elements::new(&mesh, [1.0; 4], x, [v(1), v(4)], Vec::new()));
    assert!(error.contains("`q` is"), "{error}");
    assert!(Elements::new(&mesh, [1.0; 4], x, q, vec![set(&[4])]).is_err());
    assert!(module.try_first([v(9)]).is_err());
}

#[test]
fn members_of_sets_that_depend_on_values() {
    let mesh = tetrahedron();
    let v = |k| Vertex::new(k);
    let set = |list: &[u32]| list.iter().map(|k| v(*k)).collect::<iheartmesh::Set<Vertex>>();
    let numbers = iheartmesh::Set::from(vec![3, 5]);
    let pairs = iheartmesh::Set::from(vec![(1, 2)]);
    let new = |h: u32, s: u32, t: &[u32], k: i64, p: (i64, i64), q: u32| {
        Members::new(&mesh, vec![1.0, 2.0, 3.0, 4.0], 2.5, set(&[0, 1]), numbers.clone(), pairs.clone(), v(h), v(s), set(t), k, p, vec![v(q)])
    };
    let mut module = new(3, 1, &[0], 5, (1, 2), 2).unwrap();
    close(module.a(), 4.0 + 2.0 + 1.0 + 5.0 + 1.0);
    assert_eq!(message(new(1, 1, &[0], 5, (1, 2), 2)), "`h` is vertex 1, which is not in `Heavy` (2 members)");
    assert_eq!(message(new(3, 2, &[0], 5, (1, 2), 2)), "`s` is vertex 2, which is not in `S` (2 members)");
    assert_eq!(message(new(3, 1, &[3], 5, (1, 2), 2)), "`T` is vertex 3, which is not in `S` (2 members)");
    assert_eq!(message(new(3, 1, &[0], 4, (1, 2), 2)), "`k` is 4, which is not in `K` (2 members)");
    assert_eq!(message(new(3, 1, &[0], 5, (2, 1), 2)), "`p` is (2, 1), which is not in `P` (1 members)");
    assert_eq!(message(new(3, 1, &[0], 5, (1, 2), 0)), "`q` is vertex 0, which is not in `Heavy` (2 members)");
    assert_eq!(module.f(3), 6);
    assert_eq!(message(module.try_f(4)), "parameter `j` of `f` is 4, which is not in `K` (2 members)");
    close(module.g(v(2)), 3.0);
    assert!(module.try_g(v(0)).is_err());
    assert_eq!(module.i(iheartmesh::Set::from(vec![3])), 1);
    assert!(module.try_i(iheartmesh::Set::from(vec![3, 4])).is_err());
    // what no longer fits is not taken
    assert!(module.set_c(3.5).is_err());
    close(module.a(), 13.0);
    assert!(module.try_g(v(2)).is_ok());
    assert!(module.set_S(set(&[0])).is_err());
    module.set_T(set(&[])).unwrap();
    module.set_s(v(0)).unwrap();
    module.set_S(set(&[0])).unwrap();
    module.set_q(vec![v(3)]).unwrap();
    module.set_c(3.5).unwrap();
    close(module.a(), 4.0 + 1.0 + 0.0 + 5.0 + 1.0);
    assert!(module.try_g(v(2)).is_err());
}

#[test]
fn quotients() {
    let module = Half::new(4, dvector![1.0, 2.0], dvector![1.0, 1.0, 1.0, 1.0]).unwrap();
    assert_eq!(module.c(), dvector![2.0, 3.0, 2.0, 3.0]);
    assert_eq!(module.d(), dvector![2.0, 3.0]);
    let error = message(Half::new(3, dvector![1.0], dvector![1.0, 1.0, 1.0]));
    assert_eq!(error, "a size of `a` is `n/2`, but 3/2 is not an integer");
    assert!(Half::new(4, dvector![1.0], dvector![1.0, 1.0, 1.0, 1.0]).is_err());
}
}
