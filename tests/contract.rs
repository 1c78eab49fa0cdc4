//! The interface of what the macro generates, as its documentation promises it.

// the tests call methods by their Greek names too
#![allow(mixed_script_confusables, uncommon_codepoints)]

use std::panic::{AssertUnwindSafe, catch_unwind};

use iheartmesh::glam::DVec3;
use iheartmesh::{CellularSet, Edge, Error, Face, FaceMesh, Set, Vertex, iheartmesh};

iheartmesh! {
    /// Parameters of every kind.
    pub struct Parameters = r#"
        ElementSets from MeshConnectivity
        Vertices, Faces, Edges, VertexOneRing, BoundaryVertices from Neighborhoods(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        x_i ∈ ℝ³ : positions
        m_i ∈ ℝ : masses
        s ∈ V
        S ⊂ V
        t ∈ ℝ
        n ∈ ℤ
        w : E → ℝ

        total = t ∑_(v ∈ V) m_v
        length = ∑_(e ∈ E) w_e ‖x_i - x_j‖ where i, j = Vertices(e)
        picked = ∑_(v ∈ S) x_v
        start = x_s
        θ(v) = t m_v where v ∈ V
        valence(v) = |Edges(v)| where v ∈ V
        edge(v) = m_v where v ∈ BoundaryVertices
        twice = 2 n
    "#;

    /// Names that are no names of Rust.
    pub struct Names = r#"
        a ∈ ℝ
        `x'` = a + 1
        `x*` = a + 2
        `f₁` = a + 3
        `gᵀ` = a + 4
        `type` = a + 5
        `1st` = a + 6
        `my name!` = a + 7
        `x(θ, ϕ)` = a + 8
        `h²` = a + 9
        n̄ = a + 10
        `self` = a + 11
        `__` = a + 12
        δt = a + 13
        ω(u) = a u where u ∈ ℝ
    "#;

    /// Sets, tuples and overloads.
    pub struct Sets = r#"
        ElementSets from MeshConnectivity
        Vertices, Edges, Faces, Diamond, VertexOneRing, NeighborVerticesInFace from Neighborhoods(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        inner(S) = S - VertexOneRing(V - S) where S ⊂ V
        corner(f, v) = tuple(j, k, S) where f ∈ F, v ∈ V, j, k = NeighborVerticesInFace(f, v), S = {j, k}
        closed(D) = CellularSet(Vertices(D) ∪ Vertices(Edges(D)) ∪ Vertices(Faces(D)), Edges(D) ∪ Edges(Faces(D)), Faces(D)) where D : CellularSet
        size(v) = |Edges(v)| where v ∈ V
        size(e) = |Faces(e)| where e ∈ E
        size(f) = |Vertices(f)| where f ∈ F
        size(S) = |S| where S ⊂ V
        size(f, v) = |Edges(f) ∩ Edges(v)| where f ∈ F, v ∈ V
        numbers(a) = {a, 2a, 1} where a ∈ ℝ
        greatest(S) = max(S) where S : {ℝ}
        ball(S, k) = { S if k < 1
                      ball(S ∪ VertexOneRing(S), k-1) otherwise
        where S ⊂ V, k ∈ ℤ
    "#;

    /// No mesh; definitions in any order; an expression without a name.
    pub struct Plain = r#"
        a ∈ ℝ
        b ∈ ℝ³
        c_i ∈ ℝ
        z = y + 1
        y = 2 a
        f(u) = p + q where u ∈ ℝ, q = p², p = u + z
        g(u, k) = c_1 u + k where u ∈ ℝ, k ∈ ℤ
        scaled(u) = u b where u ∈ ℝ
        ‖b‖² + y
    "#;
}

/// Two triangles.
fn square() -> (FaceMesh, [DVec3; 4]) {
    let mesh = FaceMesh::from_triangles(4, &[[0, 1, 2], [0, 2, 3]]).unwrap();
    let [x, y] = [DVec3::X, DVec3::Y];
    (mesh, [DVec3::ZERO, x, x + y, y])
}

/// Two triangles and a vertex of its own, with values.
fn parameters<'a>(
    mesh: &'a FaceMesh,
    x: &'a [DVec3],
    m: &'a [f64],
) -> Result<Parameters<'a>, Error> {
    Parameters::new(
        mesh,
        x,
        m,
        Vertex::new(2),
        Set::from([Vertex::new(1)]),
        2.0,
        3,
        vec![1.0; 5],
    )
}

fn panic_message<T>(call: impl FnOnce() -> T) -> String {
    let Err(payload) = catch_unwind(AssertUnwindSafe(call)) else {
        panic!("the call returns");
    };
    payload.downcast_ref::<String>().unwrap().clone()
}

#[test]
#[allow(clippy::needless_borrows_for_generic_args)] // that borrowed values go in is the point
fn values_go_in_owned_or_borrowed() {
    let (mesh, x) = square();
    let m = [1.0, 2.0, 3.0, 4.0];
    let (v, s) = (Vertex::new(0), Set::from([3, 1].map(Vertex::new)));
    let w = [1.0; 5];
    let list = x.to_vec();
    // slices, references to lists and to arrays, lists, arrays; sets owned and borrowed
    let all = [
        Parameters::new(&mesh, &x[..], &m[..], v, &s, 2.0, 3, &w[..]),
        Parameters::new(&mesh, &list, &m, v, s.clone(), 2.0, 3, w),
        Parameters::new(
            &mesh,
            list.clone(),
            m.to_vec(),
            v,
            s.clone(),
            2.0,
            3,
            w.to_vec(),
        ),
        Parameters::new(&mesh, x, m, v, &s, 2.0, 3, &w),
    ];
    for parameters in all.map(Result::unwrap) {
        assert_eq!(parameters.total(), 20.0);
        assert_eq!(parameters.length(), 4.0 + 2f64.sqrt());
        assert_eq!(parameters.picked(), x[1] + x[3]);
        assert_eq!(parameters.start(), x[0]);
        assert_eq!(parameters.twice(), 6);
        assert_eq!(parameters.valence_all(), [3, 2, 3, 2]);
        assert_eq!(parameters.θ(Vertex::new(3)), 8.0);
    }
    // coordinates without vectors
    let rows = x.map(|x| x.to_array());
    let a = Parameters::new(&mesh, rows, m, v, &s, 2.0, 3, w).unwrap();
    let b = Parameters::new(&mesh, rows.to_vec(), m, v, &s, 2.0, 3, w).unwrap();
    assert_eq!(
        (a.length(), b.length()),
        (4.0 + 2f64.sqrt(), 4.0 + 2f64.sqrt())
    );
}

#[test]
fn new_checks_what_it_is_given() {
    let (mesh, x) = square();
    let m = [1.0; 4];
    let [one, far] = [1, 4].map(|v| Set::from([Vertex::new(v)]));
    let s = Vertex::new(0);
    let w = [1.0; 5];
    let new = |x: &[DVec3], m: &[f64], s, set: &Set<Vertex>, w: &[f64]| {
        let result = Parameters::new(&mesh, x.to_vec(), m.to_vec(), s, set, 1.0, 1, w.to_vec());
        result.err().map(|error| error.to_string())
    };
    assert_eq!(new(&x, &m, s, &one, &w), None);
    for (error, expected) in [
        (
            new(&x[..3], &m[..3], s, &one, &w),
            "`x` has 3 items but needs 4: it is indexed by the 4 vertices of `M`",
        ),
        (
            new(&x, &m[..3], s, &one, &w),
            "`m` has 3 items but needs 4: it is indexed by the 4 vertices of `M`",
        ),
        (
            new(&x, &m, Vertex::new(4), &one, &w),
            "`s` is vertex 4, which is not in `M` (4 members)",
        ),
        (
            new(&x, &m, s, &far, &w),
            "`S` is vertex 4, which is not in `M` (4 members)",
        ),
        (
            new(&x, &m, s, &one, &w[..4]),
            "`w` has 4 items but needs 5: it is indexed by the 5 edges of `M`",
        ),
    ] {
        assert_eq!(error.as_deref(), Some(expected));
    }
}

#[test]
fn set_keeps_the_plan_and_refreshes_definitions() {
    let (mesh, x) = square();
    let m = [1.0, 2.0, 3.0, 4.0];
    let mut p = parameters(&mesh, &x, &m).unwrap();
    assert_eq!(
        (p.total(), p.length(), p.start()),
        (20.0, 4.0 + 2f64.sqrt(), x[2])
    );
    p.set_x(x.map(|x| 2.0 * x)).unwrap();
    assert_eq!(
        (p.total(), p.length(), p.start()),
        (20.0, 8.0 + 8f64.sqrt(), 2.0 * x[2])
    );
    p.set_m(vec![1.0; 4]).unwrap();
    p.set_t(5.0).unwrap();
    assert_eq!((p.total(), p.theta(Vertex::new(1))), (20.0, 5.0));
    p.set_s(Vertex::new(1)).unwrap();
    p.set_S(Set::from([0, 2].map(Vertex::new))).unwrap();
    p.set_n(-4).unwrap();
    p.set_w([2.0; 5]).unwrap();
    assert_eq!(
        (p.start(), p.picked(), p.twice()),
        (2.0 * x[1], 2.0 * x[2], -8)
    );
    assert_eq!(p.length(), 16.0 + 32f64.sqrt());

    // what does not fit leaves all as it was
    let error = |result: Result<(), Error>| result.unwrap_err().to_string();
    assert_eq!(
        error(p.set_x(&x[..2])),
        "`x` has 2 items but needs 4: it is indexed by the 4 vertices of `M`"
    );
    assert_eq!(
        error(p.set_s(Vertex::new(9))),
        "`s` is vertex 9, which is not in `M` (4 members)"
    );
    assert!(p.set_S(Set::from([Vertex::new(9)])).is_err() && p.set_w([1.0; 4]).is_err());
    assert_eq!((p.start(), p.length()), (2.0 * x[1], 16.0 + 32f64.sqrt()));
}

#[test]
fn elements_outside_of_their_set() {
    let (mesh, x) = square();
    let m = [1.0; 4];
    let p = parameters(&mesh, &x, &m).unwrap();
    let expected = "parameter `v` of `θ` is vertex 4, which is not in `V` (4 members)";
    assert_eq!(p.try_θ(Vertex::new(4)).unwrap_err().to_string(), expected);
    assert_eq!(
        p.try_theta(Vertex::new(4)).unwrap_err().to_string(),
        expected
    );
    assert_eq!(panic_message(|| p.θ(Vertex::new(4))), expected);
    assert_eq!(panic_message(|| p.theta(Vertex::new(4))), expected);
    assert_eq!(p.try_theta(Vertex::new(3)), Ok(2.0));

    // a set that is not all of the elements
    let fan = FaceMesh::from_triangles(5, &[[0, 1, 2], [0, 2, 3], [0, 3, 1]]).unwrap();
    let x = [DVec3::ZERO; 5];
    let p = Parameters::new(
        &fan,
        x,
        [1.0; 5],
        Vertex::new(0),
        Set::new(),
        1.0,
        1,
        [1.0; 6],
    )
    .unwrap();
    assert_eq!(p.edge_all(), [1.0; 3]);
    assert_eq!(p.try_edge(Vertex::new(1)), Ok(1.0));
    assert_eq!(
        panic_message(|| p.edge(Vertex::new(0))),
        "parameter `v` of `edge` is vertex 0, which is not in `BoundaryVertices` (3 members)"
    );
}

#[test]
fn names_of_the_language_are_names_of_rust() {
    let n = Names::new(0.0).unwrap();
    assert_eq!(
        [n.x_prime(), n.x_star(), n.f1(), n.gT()],
        [1.0, 2.0, 3.0, 4.0]
    );
    assert_eq!(
        [n.r#type(), n._1st(), n.my_name(), n.x_θ_ϕ()],
        [5.0, 6.0, 7.0, 8.0]
    );
    assert_eq!([n.h2(), n.n̄(), n.self_(), n.__()], [9.0, 10.0, 11.0, 12.0]);
    assert_eq!([n.δt(), n.deltat(), n.x_theta_phi()], [13.0, 13.0, 8.0]);
    assert_eq!([n.ω(2.0), n.omega(2.0)], [0.0, 0.0]);
    assert_eq!(n.try_deltat(), Ok(13.0));
}

#[test]
#[allow(clippy::needless_borrows_for_generic_args)]
fn sets_and_tuples() {
    let (mesh, _) = square();
    let s = Sets::new(&mesh).unwrap();
    let set = |ids: &[u32]| {
        ids.iter()
            .copied()
            .map(Vertex::new)
            .collect::<Set<Vertex>>()
    };
    assert_eq!(s.inner(set(&[0, 1, 2])), set(&[1]));
    assert_eq!(s.inner(&set(&[0, 1, 2, 3])), set(&[0, 1, 2, 3]));
    let [v0, v1, v2] = [0, 1, 2].map(Vertex::new);
    assert_eq!(s.corner(Face::new(0), v1), (v2, v0, set(&[0, 2])));
    let open = CellularSet {
        faces: Set::from([Face::new(1)]),
        ..CellularSet::default()
    };
    let closed = s.closed(&open);
    assert_eq!(closed.vertices, set(&[0, 2, 3]));
    assert_eq!(closed.edges, Set::from([1, 2, 4].map(Edge::new)));
    assert_eq!((&closed.faces, closed.cells.len()), (&open.faces, 0));
    assert_eq!(s.closed(closed.clone()), closed);
    assert_eq!(s.numbers(0.5), Set::from([0.5, 1.0]));
    assert_eq!(s.greatest(Set::from([1.0, 3.0, 2.0])), 3.0);
    assert!(s.try_greatest(&Set::new()).is_err());
    assert_eq!(
        (s.V(), s.E().len(), s.F().len()),
        (set(&[0, 1, 2, 3]), 5, 2)
    );
}

#[test]
fn overloads_are_one_method() {
    let (mesh, _) = square();
    let s = Sets::new(&mesh).unwrap();
    assert_eq!(s.size(Vertex::new(0)), 3);
    assert_eq!(s.size(Edge::new(1)), 2);
    assert_eq!(s.size(Face::new(1)), 3);
    assert_eq!(s.size(Set::from([Vertex::new(1)])), 1);
    assert_eq!(s.size(&Set::from([Vertex::new(1)])), 1);
    assert_eq!(s.size((Face::new(0), Vertex::new(1))), 2);
    assert_eq!(
        s.try_size(Edge::new(5)).unwrap_err().to_string(),
        "parameter `e` of `size` is edge 5, which is not in `E` (5 members)"
    );
    assert_eq!(
        panic_message(|| s.size((Face::new(0), Vertex::new(4)))),
        "parameter `v` of `size` is vertex 4, which is not in `V` (4 members)"
    );
}

#[test]
fn functions_may_call_themselves() {
    let (mesh, _) = square();
    let s = Sets::new(&mesh).unwrap();
    let one = Set::from([Vertex::new(1)]);
    assert_eq!(s.ball(&one, 0), one);
    assert_eq!(s.ball(&one, 1), Set::from([0, 1, 2].map(Vertex::new)));
    assert_eq!(s.ball(&one, 2), s.V());
    assert_eq!(s.ball(&one, -3), one);
}

#[test]
fn modules_without_a_mesh() {
    let mut p = Plain::new(1.0, DVec3::new(1.0, 2.0, 2.0), [7.0, 8.0]).unwrap();
    assert_eq!(
        (p.y(), p.z(), p.f(1.0), p.g(2.0, 3)),
        (2.0, 3.0, 20.0, 17.0)
    );
    assert_eq!(p.scaled(2.0), DVec3::new(2.0, 4.0, 4.0));
    assert_eq!((p.ret(), p.try_ret()), (11.0, Ok(11.0)));
    p.set_a(2.0).unwrap();
    assert_eq!((p.z(), p.ret()), (5.0, 13.0));
    p.set_c(Vec::new()).unwrap();
    assert_eq!(
        p.try_g(1.0, 1).unwrap_err().to_string().split(" (").next(),
        Some("`g(1, 1)` has no value: the sequence has no item of this number in `c_1`")
    );
}

#[test]
fn the_source_is_there() {
    assert!(Plain::SOURCE.contains("‖b‖² + y"));
    assert!(
        Sets::SOURCE.starts_with('\n')
            && Sets::SOURCE.contains("ball(S ∪ VertexOneRing(S), k-1) otherwise")
    );
}
