//! Sizes of parameters that one index ties together, and sizes that empty sequences do not say: compared in `new` and in the
//! setters, with and without optimisations.

use iheartmesh::FaceMesh;
use nalgebra::{DMatrix, DVector, dmatrix, dvector};

#[macro_use]
#[path = "support/twice.rs"]
mod twice;

programs! {
    Tied, PlainTied = r#"
        x ∈ ℝ^n
        y_i ∈ ℝ
        z_j ∈ ℝ
        s = ∑_i x_i y_i
        t(a) = a ∑_k y_k z_k where a ∈ ℝ
    "#;

    Numbered, PlainNumbered = r#"
        u ∈ ℝ³
        y_i ∈ ℝ
        w_i = u_i y_i
    "#;

    Guarded, PlainGuarded = r#"
        x ∈ ℝ^n
        y_i ∈ ℝ
        s = { ∑_k x_k y_k if n = |y|
              -1 otherwise
    "#;

    OfMesh, PlainOfMesh = r#"
        ElementSets from MeshConnectivity
        M : FaceMesh
        V, E, F = ElementSets(M)
        m : V → ℝ
        u ∈ ℝ^n
        s = ∑_v m_v u_v
    "#;

    Items, PlainItems = r#"
        x_i ∈ ℝ^n
        A ∈ ℝ^(n×n)
        B = A + I_n
        c = ∑_i x_i
        f(p, M) = ∑_i p_i + M_*,1 where p_i ∈ ℝ^q, M ∈ ℝ^(q×q)
        d = f(x, A)
    "#;

    OnlyItems, PlainOnlyItems = r#"
        x_i ∈ ℝ^n
        y_j ∈ ℝ^n
        c = ∑_i x_i + 1_n
    "#;

    NoSize, PlainNoSize = r#"
        x_i ∈ ℝ^n
        l = ∑_i ‖x_i‖
    "#;
}

fn error<T>(result: Result<T, iheartmesh::Error>) -> String {
    match result {
        Ok(_) => panic!("no error"),
        Err(error) => error.to_string(),
    }
}

for_both! {
    #[test]
    fn sizes_that_an_index_ties() {
        let (x, two, three) = (dvector![1.0, 2.0], [3.0, 4.0], [1.0, 2.0, 3.0]);
        let module = Tied::new(&x, &two[..], &two[..]).expect("valid");
        assert_eq!(module.s(), 11.0);
        assert_eq!(module.t(2.0), 50.0);
        assert_eq!(
            error(Tied::new(&x, &three[..], &three[..])),
            "the length of `y` is 3 but the length of `x` is 2: the index `i` runs over both"
        );
        assert_eq!(
            error(Tied::new(&x, &two[..], &three[..])),
            "the length of `z` is 3 but the length of `y` is 2: the index `k` runs over both"
        );
    }

    #[test]
    fn setters_compare_tied_sizes() {
        let x = dvector![1.0, 2.0];
        let mut module = Tied::new(&x, &[3.0, 4.0][..], &[0.0, 1.0][..]).expect("valid");
        assert_eq!(
            error(module.set_x(dvector![1.0])),
            "the length of `x` is 1 but the length of `y` is 2: the index `i` runs over both"
        );
        assert_eq!(
            error(module.set_y(&[1.0][..])),
            "the length of `y` is 1 but the length of `x` is 2: the index `i` runs over both"
        );
        assert_eq!(module.s(), 11.0);
        module.set_y(&[1.0, 1.0][..]).expect("the same size");
        assert_eq!(module.s(), 3.0);
    }

    #[test]
    fn a_size_that_is_a_number() {
        let u = [1.0, 2.0, 3.0];
        let module = Numbered::new(u.into(), &u[..]).expect("valid");
        assert_eq!(module.w()[2], 9.0);
        assert_eq!(
            error(Numbered::new(u.into(), &u[..2])),
            "the length of `y` is 2 but should be 3"
        );
    }

    #[test]
    fn a_case_that_does_not_hold_asks_for_nothing() {
        let module = Guarded::new(dvector![1.0, 2.0], &[3.0][..]).expect("valid");
        assert_eq!(module.s(), -1.0);
        let module = Guarded::new(dvector![1.0, 2.0], &[3.0, 4.0][..]).expect("valid");
        assert_eq!(module.s(), 11.0);
    }

    #[test]
    fn a_vector_beside_values_of_vertices() {
        let mesh = FaceMesh::from_triangles(3, &[[0, 1, 2]]).expect("a mesh");
        let m = [1.0, 2.0, 3.0];
        let module = OfMesh::new(&mesh, &m[..], dvector![1.0, 1.0, 2.0]).expect("valid");
        assert_eq!(module.s(), 9.0);
        assert_eq!(
            error(OfMesh::new(&mesh, &m[..], DVector::zeros(4))),
            "the length of `u` is 4 but the number of vertices of `M` is 3: the index `v` runs over both"
        );
    }

    #[test]
    fn empty_sequences_do_not_say_a_size() {
        let a = DMatrix::from_element(3, 3, 1.0);
        let none: [DVector<f64>; 0] = [];
        let mut module = Items::new(&none[..], &a).expect("valid");
        assert_eq!(module.B(), &a + DMatrix::identity(3, 3));
        assert_eq!(module.c(), DVector::zeros(3));
        assert_eq!(module.d(), dvector![1.0, 1.0, 1.0]);
        assert_eq!(module.f(&none[..], dmatrix![2.0, 1.0; 1.0, 2.0]), dvector![2.0, 1.0]);
        module.set_x(vec![dvector![1.0, 2.0, 3.0]]).expect("the same size");
        assert_eq!(module.c(), dvector![1.0, 2.0, 3.0]);
        assert_eq!(module.d(), dvector![2.0, 3.0, 4.0]);
        assert!(module.set_x(vec![dvector![1.0]]).is_err());
    }

    #[test]
    fn a_size_that_nothing_says() {
        let none: [DVector<f64>; 0] = [];
        let one = [dvector![1.0, 2.0]];
        let module = OnlyItems::new(&none[..], &one[..]).expect("the other says it");
        assert_eq!(module.c(), dvector![1.0, 1.0]);
        assert_eq!(
            error(OnlyItems::new(&none[..], &none[..])),
            "the size `n` is not known: `x` and `y` have no items, and nothing else says it"
        );
        assert_eq!(NoSize::new(&none[..]).expect("not needed").l(), 0.0);
    }
}
