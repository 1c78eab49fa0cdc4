//! Parameters of a struct of the less usual kinds: subsets, sets of numbers, cellular sets, tuples, two meshes.

use iheartmesh::glam::DVec3;
use iheartmesh::{CellularSet, Edge, Error, Face, FaceMesh, Set, Vertex};

#[macro_use]
#[path = "support/twice.rs"]
mod twice;

programs! {
    // Subsets and sets of other kinds.
    Inputs, PlainInputs = r#"
        ElementSets from MeshConnectivity
        Vertices, Faces, BoundaryVertices from Neighborhoods(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        R ∈ {ℝ}
        x_i ∈ ℝ³
        s ∈ BoundaryVertices
        S ⊂ BoundaryVertices
        D : CellularSet
        count = |R|
        largest = max(R)
        touched = Vertices(D)
        `part of D` = |Faces(D)|
        corner(v) = x_v where v ∈ S
        here = x_s
        far(T) = ∑_(v ∈ T) x_v where T ⊂ BoundaryVertices
    "#;

    // Two sequences with one subscript letter.
    Pairs, PlainPairs = r#"
        a_i ∈ ℝ
        b_i ∈ ℝ³
        c ∈ ℝ
        d(k) = a_k b_k where k ∈ ℤ
    "#;

    // A sequence that is a parameter of a function, and indexed by elements there.
    Weights, PlainWeights = r#"
        ElementSets from MeshConnectivity
        M : FaceMesh
        V, E, F = ElementSets(M)
        w(y) = ∑_(v ∈ V) y_v where y_i ∈ ℝ
    "#;

    // A set of pairs.
    Indices, PlainIndices = r#"
        P ∈ {ℤ×ℤ}
        n = |P|
    "#;

    // A tuple.
    Tuple, PlainTuple = r#"
        t ∈ ℝ×ℤ
        y = t_1 t_2
    "#;

    // A function of values on a mesh.
    Total, PlainTotal = r#"
        ElementSets from MeshConnectivity
        M : FaceMesh
        V, E, F = ElementSets(M)
        total(y) = ∑_(v ∈ V) y_v where y : V → ℝ
    "#;

    // Two meshes, whose elements have one type in Rust.
    Two, PlainTwo = r#"
        ElementSets from MeshConnectivity
        M : FaceMesh
        N : FaceMesh
        V, E, F = ElementSets(M)
        A, B, C = ElementSets(N)
        x : V → ℝ
        y : A → ℝ
        f(v) = x_v where v ∈ V
        g(v) = y_v where v ∈ A
        f(v, w) = x_v - y_w where v ∈ V, w ∈ A
    "#;
}

/// Three triangles around vertex 0; the others are on the boundary.
fn fan() -> (FaceMesh, [DVec3; 4]) {
    let mesh = FaceMesh::from_triangles(4, &[[0, 1, 2], [0, 2, 3], [0, 3, 1]]).unwrap();
    (mesh, [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z])
}

fn vertices(ids: &[u32]) -> Set<Vertex> {
    ids.iter().copied().map(Vertex::new).collect()
}

for_both! {
    #[test]
    fn subsets_and_sets_of_other_kinds() {
        let (mesh, x) = fan();
        let numbers = Set::from([0.5, 2.0, 2.0]);
        let cellular = CellularSet {
            vertices: vertices(&[3]),
            edges: Set::from([Edge::new(0)]),
            faces: Set::from([Face::new(1), Face::new(2)]),
            ..CellularSet::default()
        };
        let (s, set) = (Vertex::new(1), vertices(&[2, 3]));
        let mut a = Inputs::new(&mesh, &numbers, x, s, &set, &cellular).unwrap();
        assert_eq!((a.count(), a.largest(), a.part_of_D()), (2, 2.0, 2));
        assert_eq!((a.touched(), a.here()), (vertices(&[3]), x[1]));
        assert_eq!(
            (a.corner(Vertex::new(3)), a.corner_all()),
            (x[3], vec![x[2], x[3]])
        );
        assert_eq!(a.far(&set), x[2] + x[3]);

        a.set_R(Set::from([7.0])).unwrap();
        a.set_D(CellularSet::default()).unwrap();
        a.set_S(vertices(&[1])).unwrap();
        assert_eq!((a.count(), a.largest(), a.part_of_D()), (1, 7.0, 0));
        assert_eq!((a.touched(), a.corner_all()), (Set::new(), vec![x[1]]));
        assert_eq!(
            a.try_corner(Vertex::new(3)).unwrap_err().to_string(),
            "parameter `v` of `corner` is vertex 3, which is not in `S` (1 members)"
        );
        assert_eq!(
            a.try_far(vertices(&[0, 1])).unwrap_err().to_string(),
            "parameter `T` of `far` is vertex 0, which is not in `BoundaryVertices` (3 members)"
        );
        a.set_R(Set::new()).unwrap();
        assert!(matches!(a.try_largest(), Err(Error::Undefined { .. })));
        assert_eq!(a.count(), 0);

        // parameters of the struct that are not in their set
        let new = |s, set: &Set<Vertex>, cells: &CellularSet| {
            Inputs::new(&mesh, &numbers, x, Vertex::new(s), set, cells).err()
        };
        assert_eq!(new(3, &vertices(&[1, 3]), &cellular), None);
        assert!(new(9, &set, &cellular).is_some() && new(1, &vertices(&[9]), &cellular).is_some());
        assert!(
            new(0, &set, &cellular).is_some(),
            "vertex 0 is not on the boundary"
        );
        assert!(
            new(1, &vertices(&[0]), &cellular).is_some(),
            "vertex 0 is not on the boundary"
        );
        let far = CellularSet {
            edges: Set::from([Edge::new(6)]),
            ..CellularSet::default()
        };
        assert!(new(1, &set, &far).is_some(), "there is no edge 6");
        assert!(a.set_D(far).is_err() && a.set_s(Vertex::new(0)).is_err());
        assert!(a.set_S(vertices(&[0])).is_err());
    }

    #[test]
    fn sequences_of_one_letter_have_one_length() {
        let x = [DVec3::X, DVec3::Y];
        let mut p = Pairs::new([1.0, 2.0], x, 0.0).unwrap();
        assert_eq!(p.d(2), 2.0 * DVec3::Y);
        let expected = "`a` has 3 items but `b` has 2: they are declared with the same subscript and must have one length";
        assert_eq!(
            Pairs::new([1.0; 3], x, 0.0).err().unwrap().to_string(),
            expected
        );
        assert_eq!(p.set_a([1.0; 3]).unwrap_err().to_string(), expected);
        let expected = "`b` has 1 items but `a` has 2: they are declared with the same subscript and must have one length";
        assert_eq!(p.set_b([DVec3::X]).unwrap_err().to_string(), expected);
        assert_eq!(p.d(1), DVec3::X);
        assert!(matches!(p.try_d(3), Err(Error::Undefined { .. })));
        assert!(matches!(p.try_d(0), Err(Error::Undefined { .. })));
    }

    #[test]
    fn tuples_and_sets_of_them() {
        let p = Indices::new(Set::from([(1, 2), (3, 4), (1, 2)])).unwrap();
        assert_eq!(p.n(), 2);
        let mut t = Tuple::new((1.5, 2)).unwrap();
        assert_eq!(t.y(), 3.0);
        t.set_t((2.5, -2)).unwrap();
        assert_eq!(t.y(), -5.0);
    }

    #[test]
    fn functions_of_values() {
        let (mesh, _) = fan();
        let total = Total::new(&mesh).unwrap();
        assert_eq!(total.total([1.0, 2.0, 3.0, 4.0]), 10.0);
        assert_eq!(total.total(vec![1.0; 4]), 4.0);
        assert!(total.try_total([1.0; 3]).is_err());
        assert!(total.try_total([1.0; 5]).is_err());
    }

    #[test]
    fn two_meshes() {
        let (mesh, _) = fan();
        let other = FaceMesh::from_triangles(3, &[[0, 1, 2]]).unwrap();
        let two = Two::new(&mesh, &other, [1.0, 2.0, 3.0, 4.0], [5.0, 6.0, 7.0]).unwrap();
        assert_eq!((two.f(Vertex::new(3)), two.g(Vertex::new(2))), (4.0, 7.0));
        assert_eq!(two.f((Vertex::new(3), Vertex::new(2))), -3.0);
        assert_eq!(
            two.try_g(Vertex::new(3)).unwrap_err().to_string(),
            "parameter `v` of `g` is vertex 3, which is not in `A` (3 members)"
        );
    }

    #[test]
    fn a_sequence_that_is_too_short_for_the_elements_that_index_it() {
        let mesh = FaceMesh::from_triangles(4, &[[0, 1, 2], [1, 3, 2]]).unwrap();
        let module = Weights::new(&mesh).unwrap();
        assert_eq!(module.w([1.0, 2.0, 3.0, 4.0]), 10.0);
        let error = module.try_w([1.0, 2.0]).unwrap_err().to_string();
        assert!(
            error.contains("the sequence has no such item in `y_v`"),
            "{error}"
        );
    }
}
