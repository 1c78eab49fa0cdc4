//! Formulas as they stand in papers, against loops written here.

use iheartmesh::glam::DVec3;
use iheartmesh::nalgebra::{DMatrix, DVector};
use iheartmesh::{FaceMesh, Vertex};

#[macro_use]
#[path = "support/twice.rs"]
mod twice;

programs! {
    Nested, NestedPlain = r#"
        ElementSets from MeshConnectivity
        Vertices, Faces from Neighborhoods(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        x_i ∈ ℝ³
        total = ∑_(f ∈ F) ∑_(v ∈ Vertices(f)) x_v
        around(v) = ∑_(f ∈ Faces(v)) ∑_(w ∈ Vertices(f)) x_w where v ∈ V
        centre(f) = 1/|Vertices(f)| ∑_(v ∈ Vertices(f)) x_v where f ∈ F
        area(f) = ½ ∑_(v ∈ Vertices(f)) x_v × x_v where f ∈ F
        s = ∑_(f ∈ F) (∑_(v ∈ Vertices(f)) x_v)⋅centre(f)
    "#;

    OfMesh, OfMeshPlain = r#"
        ElementSets from MeshConnectivity
        M : FaceMesh
        V, E, F = ElementSets(M)
        u ∈ ℝ^(#V)
        L ∈ ℝ^(#V×#F)
        a_i ∈ ℝ^(#V)
        y = ∑_i a_i + u
        z = Lᵀ u
    "#;

    OfSequence, OfSequencePlain = r#"
        y ∈ ℝ^(#x)
        x_i ∈ ℝ^d
        B ∈ ℝ^(d×d)
        z = B ∑_i y_i x_i
    "#;

    Marked, MarkedPlain = r#"
        P ∈ ℝ^(n×n)
        π̂ ∈ ℝ^n
        residual = ‖Pᵀ π̂ - π̂‖ + π - π
    "#;
}

fn square() -> (FaceMesh, Vec<DVec3>) {
    let mesh = FaceMesh::from_triangles(4, &[[0, 1, 2], [0, 2, 3]]).unwrap();
    let x = [[0., 0., 1.], [1., 0., 2.], [1., 1., 4.], [0., 1., 8.]];
    (mesh, x.map(DVec3::from).to_vec())
}

fn message<T>(result: Result<T, iheartmesh::Error>) -> String {
    result.err().unwrap().to_string()
}

for_both! {
    // the inner sums read the elements of their own loop alone, and yet differ from face to face
    #[test]
    fn a_sum_in_a_sum_may_leave_the_outer_element_out() {
        let (mesh, x) = square();
        let nested = Nested::new(&mesh, &x).unwrap();
        let faces = [x[0] + x[1] + x[2], x[0] + x[2] + x[3]];
        assert_eq!(nested.total(), faces[0] + faces[1]);
        assert_eq!(nested.around(Vertex::new(1)), faces[0]);
        assert_eq!(nested.around_all()[2], faces[0] + faces[1]);
        let s: f64 = faces.iter().map(|f| f.length_squared() / 3.0).sum();
        assert!((nested.s() - s).abs() < 1e-12);
    }

    #[test]
    fn sizes_that_are_numbers_of_elements_are_compared_with_the_mesh() {
        let (mesh, _) = square();
        let u = DVector::from_element(4, 1.0);
        let l = DMatrix::from_element(4, 2, 2.0);
        let a = vec![u.clone(), u.clone()];
        let mut fits = OfMesh::new(&mesh, &u, &l, &a).unwrap();
        assert_eq!(fits.y(), DVector::from_element(4, 3.0));
        assert_eq!(fits.z(), DVector::from_element(2, 8.0));
        assert!(OfMesh::new(&mesh, &u, &l, vec![]).is_ok());

        let short = DVector::from_element(3, 1.0);
        let expected = "the length of `u` is 3 but should be 4: it is `|V|`, and `M` says so";
        assert_eq!(message(OfMesh::new(&mesh, &short, &l, &a)), expected);
        assert_eq!(message(fits.set_u(&short)), expected);
        assert_eq!(
            message(OfMesh::new(&mesh, &u, l.transpose(), &a)),
            "the number of rows of `L` is 2 but should be 4: it is `|V|`, and `M` says so"
        );
        assert_eq!(
            message(OfMesh::new(&mesh, &u, &l, vec![u.clone(), short])),
            "the length of `a` is 3 but should be 4: it is `|V|`, and `M` says so"
        );
    }

    #[test]
    fn sizes_that_are_lengths_are_compared_with_the_sequence() {
        let b = DMatrix::identity(2, 2);
        let x = vec![DVector::from_element(2, 1.0); 3];
        let y = DVector::from_element(3, 2.0);
        let mut fits = OfSequence::new(&y, &x, &b).unwrap();
        assert_eq!(fits.z(), DVector::from_element(2, 6.0));

        let expected = "the length of `x` is 2 but should be 3: it is `|i|`, and `y` says so";
        assert_eq!(message(OfSequence::new(&y, &x[..2], &b)), expected);
        assert_eq!(message(fits.set_x(&x[..2])), expected);
        assert!(fits.set_y(DVector::from_element(2, 1.0)).is_err());
    }

    #[test]
    fn pi_with_a_mark_is_a_name() {
        let p = DMatrix::from_row_slice(2, 2, &[0.5, 0.5, 0.25, 0.75]);
        let stationary = DVector::from_vec(vec![1.0 / 3.0, 2.0 / 3.0]);
        assert!(Marked::new(&p, stationary).unwrap().residual() < 1e-15);
    }
}
