//! Systems over all elements of a mesh, put together entry by entry: matrices of vertices and of edges by conditions, by their
//! diagonal and in full, right sides by vertex, solved; against loops over the triangles, with and without optimisations.

use iheartmesh::glam::{DVec3, dvec3};
use iheartmesh::sprs::CsMat;
use iheartmesh::{FaceMesh, Vertex};
use nalgebra::{DMatrix, DVector};

#[macro_use]
#[path = "support/twice.rs"]
mod twice;

programs! {
    Poisson, PlainPoisson = r#"
        ElementSets, BoundaryMatrices from MeshConnectivity
        VertexOneRing, Vertices, Faces from Neighborhoods(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        `∂⁰`, `∂¹` = BoundaryMatrices(M)
        x_v ∈ ℝ³
        m : V → ℝ
        h ∈ ℝ

        // the weight of an edge, as a function and as a vector
        l_e = 1/‖x_i - x_j‖ where e ∈ E, i, j = Vertices(e)
        w_e = 2 l_e
        W_ee = w_e
        U ∈ ℝ^(#E×#E)
        U_ee = l_e + w_e

        // three ways to write one matrix
        L = `∂⁰` W `∂⁰`ᵀ
        K ∈ ℝ^(|V|×|V|)
        K_vw = { -2/‖x_v - x_w‖ if w ∈ VertexOneRing(v)
                 ∑_(u ∈ VertexOneRing(v)) 2/‖x_u - x_v‖ if v = w
                 0 otherwise
        J ∈ ℝ^(#V×#V)
        J_vw = { -2/‖x_v - x_w‖ if w ∈ VertexOneRing(v)
        J_vv = -∑_w J_vw

        // masses, and the number of faces around each vertex
        D_vv = m_v
        d ∈ ℝ^(#V)
        d_v = |Faces(v)|
        b_v = m_v d_v
        y = (D + h L)⁻¹ b
        z = (D + h K) \ b
        r = (D + h J) z - b

        // every pair, dense
        A_vw = m_v m_w + (x_v - x_w)⋅(x_v - x_w)
        a = A⁻¹ b
        // rows by edges
        G ∈ ℝ^(#E×#V)
        G_ev = { 1 if v ∈ Vertices(e)
        g = G m
        X_v,* = x_v
        N_vv += 1
        N ∈ ℝ^(#V×#V)
        s = ∑_v b_v m_v + m⋅b
        p = ∑_i i b_i
        at(v) = b_v where v ∈ V
        next_v = x_v + b_v (1, 0, 0)
        most = max(d)
    "#;

    Sensitive, PlainSensitive = r#"
        ElementSets from MeshConnectivity
        VertexOneRing, Faces from Neighborhoods(M)
        M : FaceMesh
        V, E, F = ElementSets(M)
        m : V → ℝ
        y ∈ ℝ^(#V)
        b_v = m_v² |Faces(v)| + ∑_(w ∈ VertexOneRing(v)) m_w m_v
        c = ∑_v b_v y_v
        g = ∂c/∂m
        q = ∂(b⋅b)/∂m
        J = ∂b/∂m
    "#;
}

fn dense(a: &CsMat<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(a.rows(), a.cols(), |i, j| {
        a.get(i, j).copied().unwrap_or(0.0)
    })
}

const TRIANGLES: [[u32; 3]; 4] = [[0, 1, 2], [1, 3, 2], [2, 3, 4], [2, 4, 5]];

fn mesh() -> FaceMesh {
    FaceMesh::from_triangles(6, &TRIANGLES).expect("a mesh")
}

fn positions() -> Vec<DVec3> {
    let at = |k: f64| dvec3(k, (1.7 * k).sin(), 0.3 * k * k);
    (0..6).map(|k| at(f64::from(k))).collect()
}

fn masses() -> Vec<f64> {
    (0..6).map(|k| 1.0 + 0.25 * f64::from(k)).collect()
}

/// The edges, by their vertices, in order.
fn edges() -> Vec<(usize, usize)> {
    let mut all: Vec<(usize, usize)> = TRIANGLES
        .iter()
        .flat_map(|t| [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])])
        .map(|(i, j)| (i.min(j) as usize, i.max(j) as usize))
        .collect();
    all.sort_unstable();
    all.dedup();
    all
}

fn laplacian() -> DMatrix<f64> {
    let x = positions();
    let mut all = DMatrix::zeros(6, 6);
    for (i, j) in edges() {
        let w = 2.0 / x[i].distance(x[j]);
        all[(i, i)] += w;
        all[(j, j)] += w;
        all[(i, j)] -= w;
        all[(j, i)] -= w;
    }
    all
}

fn faces_around() -> DVector<f64> {
    let around = |v: usize, _| {
        let faces = TRIANGLES.iter().filter(|t| t.contains(&(v as u32)));
        faces.count() as f64
    };
    DVector::from_fn(6, around)
}

fn near(a: &DMatrix<f64>, b: &DMatrix<f64>) {
    assert!(
        (a - b).norm() <= 1e-9 * (1.0 + b.norm()),
        "{a} instead of {b}"
    );
}

fn near_vectors(a: &DVector<f64>, b: &DVector<f64>) {
    assert!(
        (a - b).norm() <= 1e-9 * (1.0 + b.norm()),
        "{a} instead of {b}"
    );
}

for_both! {
    #[test]
    fn one_laplacian_in_three_ways() {
        let (mesh, x, m) = (mesh(), positions(), masses());
        let module = Poisson::new(&mesh, &x[..], &m[..], 0.5).expect("valid");
        let expected = laplacian();
        near(&dense(&module.L()), &expected);
        near(&dense(&module.K()), &expected);
        near(&dense(&module.J()), &expected);
        assert_eq!(module.K().nnz(), 6 + 2 * edges().len());
        let lengths: Vec<f64> = edges().iter().map(|&(i, j)| x[i].distance(x[j])).collect();
        let weights = DVector::from_iterator(lengths.len(), lengths.iter().map(|l| 2.0 / l));
        near_vectors(&module.w(), &weights);
        near(&dense(&module.W()), &DMatrix::from_diagonal(&weights));
        near(&dense(&module.U()), &DMatrix::from_diagonal(&(weights * 1.5)));
        assert_eq!(module.U().nnz(), edges().len());
    }

    #[test]
    fn systems_are_solved() {
        let (mesh, x, m) = (mesh(), positions(), masses());
        let module = Poisson::new(&mesh, &x[..], &m[..], 0.5).expect("valid");
        let mass = DVector::from_vec(m.clone());
        let b = mass.component_mul(&faces_around());
        near_vectors(&module.b(), &b);
        near_vectors(&module.d(), &faces_around());
        let system = DMatrix::from_diagonal(&mass) + laplacian() * 0.5;
        let expected = system.lu().solve(&b).expect("regular");
        near_vectors(&module.y(), &expected);
        near_vectors(&module.z(), &expected);
        near_vectors(&module.r(), &DVector::zeros(6));
        let all = DMatrix::from_fn(6, 6, |i, j| m[i] * m[j] + x[i].distance_squared(x[j]));
        near(&module.A(), &all);
        near_vectors(&module.a(), &all.lu().solve(&b).expect("regular"));
    }

    #[test]
    fn arrays_of_other_shapes() {
        let (mesh, x, m) = (mesh(), positions(), masses());
        let module = Poisson::new(&mesh, &x[..], &m[..], 0.5).expect("valid");
        let mass = DVector::from_vec(m.clone());
        let b = mass.component_mul(&faces_around());
        let ends = edges();
        let incident = DMatrix::from_fn(ends.len(), 6, |e, v| {
            f64::from(u8::from(ends[e].0 == v || ends[e].1 == v))
        });
        near(&dense(&module.G()), &incident);
        near_vectors(&module.g(), &(incident * &mass));
        near(&module.X(), &DMatrix::from_fn(6, 3, |i, j| x[i][j]));
        near(&dense(&module.N()), &DMatrix::identity(6, 6));
        assert!((module.s() - 2.0 * b.dot(&mass)).abs() < 1e-9);
        let weighted: f64 = (0..6).map(|k| (k + 1) as f64 * b[k]).sum();
        assert!((module.p() - weighted).abs() < 1e-9);
        assert!((module.at(Vertex::new(2)) - b[2]).abs() < 1e-12);
        assert!(module.next()[3].distance(x[3] + dvec3(b[3], 0.0, 0.0)) < 1e-12);
        assert_eq!(module.most(), 4.0);
    }

    #[test]
    fn derivatives_of_vectors_over_vertices() {
        let (mesh, m) = (mesh(), masses());
        let y = DVector::from_fn(6, |k, _| 0.5 - 0.2 * k as f64);
        let module = Sensitive::new(&mesh, &m[..], &y).expect("valid");
        let faces = faces_around();
        let mut jacobian = DMatrix::zeros(6, 6);
        for v in 0..6 {
            jacobian[(v, v)] += 2.0 * m[v] * faces[v];
        }
        let mut b = DVector::from_fn(6, |v, _| m[v] * m[v] * faces[v]);
        for (i, j) in edges() {
            for (v, w) in [(i, j), (j, i)] {
                b[v] += m[v] * m[w];
                jacobian[(v, v)] += m[w];
                jacobian[(v, w)] += m[v];
            }
        }
        near_vectors(&module.b(), &b);
        near(&dense(&module.J()), &jacobian);
        near_vectors(&module.g(), &(jacobian.transpose() * &y));
        near_vectors(&module.q(), &(jacobian.transpose() * &b * 2.0));
    }
}
