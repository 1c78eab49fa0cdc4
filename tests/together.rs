//! Definitions that are asked for at once: the same values as by themselves, the same errors, whatever is known before.

#[path = "support/plane.rs"]
mod plane;
#[macro_use]
#[path = "support/twice.rs"]
mod twice;

use iheartmesh::glam::{DVec2, DVec3};
use iheartmesh::nalgebra::{DMatrix, DVector};
use iheartmesh::{CellMesh, Error, FaceMesh, Set, sprs::CsMat};
use plane::{grid, meshes};

programs! {
    #[together(e, g, H)]
    #[together(g, theta, e)]
    #[together(H, theta)]
    #[together(n, g, H, A, R, e, c)]
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
        s(k) = l(x_i, x_j) where k ∈ E, i, j = Vertices(k)
        z(i) = { ∑_(j ∈ VertexOneRing(i)) (x_i⋅x_j)² if ‖x_i‖² > w
                 0 otherwise where i ∈ V
        e = ½ ∑_(f ∈ F) S(f) - (∑_(i ∈ V) r(i))/w + w ∑_(k ∈ E) s(k) + 7 + ∑_(i ∈ V) z(i)
        g = ∂e/∂x
        H = ∂²e/∂x²
        `θ` = ∑_(f ∈ F) psd(∂²S(f)/∂x²)
        A = ∑_(f ∈ F) psd_abs(∂²S(f)/∂x²)
        R = ∑_(i ∈ V) psd(∂²r(i)/∂x²)
        n = |V|
        c = ∑_(f ∈ F) ½ D(f)
    "#;

    // the symmetric Dirichlet energy of tetrahedra, infinite where one is upside down
    #[together(e, g, H)]
    #[together(e, g, P)]
    Solids, PlainSolids = r#"
        ElementSets from MeshConnectivity
        OrientedVertices from TetrahedronNeighborhoods(M)
        psd, inv from linearalgebra
        M : CellMesh
        V, E, F, C = ElementSets(M)
        x_i ∈ ℝ³
        D(c) = [x_j - x_i  x_k - x_i  x_l - x_i] where c ∈ C, i, j, k, l = OrientedVertices(c)
        S(c) = { ‖D(c)‖² + ‖D(c)⁻¹‖² if |D(c)| > 0
                 ∞ otherwise where c ∈ C
        e = ∑_(c ∈ C) S(c)
        g = ∂e/∂x
        H = ∂²e/∂x²
        P = ∑_(c ∈ C) psd(∂²S(c)/∂x²)
    "#;

    // inverses fail where there is none; terms below a condition; several energies
    #[together(e, f, g, G, H)]
    #[together(a, H)]
    Failing, PlainFailing = r#"
        ElementSets from MeshConnectivity
        OrientedVertices from Neighborhoods(M)
        inv from linearalgebra
        M : FaceMesh
        V, E, F = ElementSets(M)
        x_i ∈ ℝ²
        w ∈ ℝ
        D(t) = [x_b - x_a  x_c - x_a] where t ∈ F, a, b, c = OrientedVertices(t)
        q(t) = { ‖D(t)⁻¹‖² if |D(t)| < w
                 0 otherwise where t ∈ F
        e = ∑_(t ∈ F) q(t)
        f = ∑_(t ∈ F) |D(t)|²
        g = ∂e/∂x
        G = ∂f/∂x
        H = ∂²e/∂x²
        a = f + e
    "#;

    #[together(e, g, H)]
    #[together(y, e)]
    #[together(e, k, A)]
    Chain, PlainChain = r#"
        x, w ∈ ℝ^n
        P ∈ {ℤ×ℤ}
        e = ∑_((i, j) ∈ P) (x_i - 2 x_j)⁴ + ∑_(i = 2)^n x_i³ x_(i - 1) - 2 ∑_(i for w_i > 0) w_i exp(x_i)
        g = ∂e/∂x
        H = ∂²e/∂x²
        y_i = 2 x_i
        k = ‖x‖
        A = x xᵀ
    "#;
}

/// Meshes of tetrahedra: none, one and isolated vertices, a row of cubes of five or six.
fn solids() -> Vec<(CellMesh, Vec<DVec3>)> {
    let mut random = fastrand::Rng::with_seed(3);
    let mut mesh = |positions: &[DVec3], tetrahedra: &[[u32; 4]]| {
        let noise = |p: &DVec3| *p + DVec3::from_array(std::array::from_fn(|_| 0.2 * random.f64()));
        let mesh = CellMesh::from_tetrahedra(positions.len(), tetrahedra).unwrap();
        (mesh, positions.iter().map(noise).collect::<Vec<_>>())
    };
    let corner = |k: u32| DVec3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2));
    let cube: Vec<DVec3> = (0..8).map(corner).collect();
    let six = [
        [0, 1, 3, 7],
        [0, 3, 2, 7],
        [0, 2, 6, 7],
        [0, 6, 4, 7],
        [0, 4, 5, 7],
        [0, 5, 1, 7],
    ];
    let five = [
        [0, 1, 2, 4],
        [3, 2, 1, 7],
        [5, 4, 7, 1],
        [6, 7, 4, 2],
        [1, 2, 4, 7],
    ];
    let five_upright = five.map(|[a, b, c, d]| {
        let [p, q, r, s] = [a, b, c, d].map(corner);
        match (q - p).cross(r - p).dot(s - p) > 0.0 {
            true => [a, b, c, d],
            false => [a, c, b, d],
        }
    });
    vec![
        mesh(&[], &[]),
        mesh(&cube, &[]),
        mesh(&cube, &[[0, 1, 2, 4]]),
        mesh(&cube, &six),
        mesh(&cube, &five_upright),
        // one upside down
        mesh(&cube, &[[0, 1, 2, 4], [3, 1, 2, 7]]),
    ]
}

/// What is compared: values whose difference may only be that of rounding.
trait Near {
    fn entries(&self) -> Vec<f64>;
    fn shape_of(&self) -> Vec<usize>;
}

impl Near for f64 {
    fn entries(&self) -> Vec<f64> {
        vec![*self]
    }
    fn shape_of(&self) -> Vec<usize> {
        Vec::new()
    }
}

impl Near for DVector<f64> {
    fn entries(&self) -> Vec<f64> {
        self.as_slice().to_vec()
    }
    fn shape_of(&self) -> Vec<usize> {
        vec![self.len()]
    }
}

impl Near for DMatrix<f64> {
    fn entries(&self) -> Vec<f64> {
        self.as_slice().to_vec()
    }
    fn shape_of(&self) -> Vec<usize> {
        vec![self.nrows(), self.ncols()]
    }
}

impl Near for CsMat<f64> {
    fn entries(&self) -> Vec<f64> {
        self.data().to_vec()
    }
    fn shape_of(&self) -> Vec<usize> {
        // the pattern too
        let mut all = vec![self.rows(), self.cols()];
        all.extend_from_slice(&self.proper_indptr());
        all.extend_from_slice(self.indices());
        all
    }
}

#[track_caller]
fn near(a: &impl Near, b: &impl Near) {
    assert_eq!(a.shape_of(), b.shape_of());
    let (a, b) = (a.entries(), b.entries());
    assert_eq!(a.len(), b.len());
    let finite = b.iter().filter(|x| x.is_finite());
    let scale = finite.fold(1.0, |most: f64, x| most.max(x.abs()));
    for (x, y) in a.iter().zip(&b) {
        assert!(x == y || (x - y).abs() < 1e-12 * scale, "{x} is not {y}");
    }
}

/// A gradient and a Hessian without memory.
fn nothing() -> (DVector<f64>, CsMat<f64>) {
    (DVector::zeros(0), CsMat::zero((0, 0)))
}

for_both! {
    #[test]
    fn energies_of_triangles() {
        for (mesh, x) in meshes(6) {
            for w in [0.3, 2.0, 100.0] {
                let new = || Springs::new(&mesh, &x, w).unwrap();
                let each = new();
                let (e, g, h) = new().e_g_H();
                near(&e, &each.e());
                near(&g, &each.g());
                near(&h, &each.H());
                let (g, theta, e) = new().g_theta_e();
                near(&g, &each.g());
                near(&theta, &each.theta());
                near(&e, &each.e());
                let (h, theta) = new().H_theta();
                near(&h, &each.H());
                near(&theta, &each.theta());
                let (n, g, h, a, r, e, c) = new().n_g_H_A_R_e_c();
                assert_eq!(n, each.n());
                near(&g, &each.g());
                near(&h, &each.H());
                near(&a, &each.A());
                near(&r, &each.R());
                near(&e, &each.e());
                near(&c, &each.c());
                let ((mut g, mut h), (_, mut a), (_, mut r)) = (nothing(), nothing(), nothing());
                // in memory of nothing, then in memory of the same pattern
                for _ in 0..2 {
                    let (n, e, c) = new().n_g_H_A_R_e_c_into(&mut g, &mut h, &mut a, &mut r);
                    assert_eq!(n, each.n());
                    near(&g, &each.g());
                    near(&h, &each.H());
                    near(&a, &each.A());
                    near(&r, &each.R());
                    near(&e, &each.e());
                    near(&c, &each.c());
                }
            }
        }
    }

    #[test]
    fn energies_of_tetrahedra() {
        for (mesh, x) in solids() {
            let new = || Solids::new(&mesh, &x).unwrap();
            let each = new();
            let (e, g, h) = new().e_g_H();
            near(&e, &each.e());
            near(&g, &each.g());
            near(&h, &each.H());
            let (mut g, mut p) = nothing();
            for _ in 0..2 {
                let e = new().e_g_P_into(&mut g, &mut p);
                near(&e, &each.e());
                near(&g, &each.g());
                near(&p, &each.P());
            }
            // a Hessian at hand of the one is at hand for the other
            let before = p.indices().as_ptr();
            new().e_g_H_into(&mut g, &mut p);
            near(&p, &each.H());
            assert_eq!(p.indices().as_ptr(), before);
        }
        assert_eq!(solids().iter().filter(|(mesh, x)| Solids::new(mesh, x).unwrap().e().is_infinite()).count(), 1);
    }

    #[test]
    fn vectors_and_what_is_no_sum_of_blocks() {
        let mut random = fastrand::Rng::with_seed(8);
        for n in [0, 1, 2, 9] {
            let x = DVector::from_fn(n, |_, _| random.f64() - 0.5);
            let pairs: Set<(i64, i64)> = match n {
                0 => Set::from(Vec::new()),
                _ => (0..20).map(|_| (random.i64(1..=n as i64), random.i64(1..=n as i64))).collect::<Vec<_>>().into(),
            };
            let w = DVector::from_fn(n, |_, _| random.f64() - 0.3);
            let new = || Chain::new(&x, &w, &pairs).unwrap();
            let each = new();
            let (e, g, h) = new().e_g_H();
            near(&e, &each.e());
            near(&g, &each.g());
            near(&h, &each.H());
            let (mut y, _) = nothing();
            near(&new().y_e_into(&mut y), &each.e());
            near(&y, &each.y());
            let (e, k, a) = new().e_k_A();
            near(&e, &each.e());
            near(&k, &each.k());
            near(&a, &each.A());
        }
    }

    #[test]
    fn the_first_without_a_value_is_named() {
        // the second triangle has no area
        let x = [DVec2::ZERO, DVec2::X, DVec2::Y, 2.0 * DVec2::X];
        let mesh = FaceMesh::from_triangles(4, &[[0, 1, 2], [0, 1, 3]]).unwrap();
        let module = Failing::new(&mesh, &x[..], 5.0).unwrap();
        let [alone, together, also] = [
            module.try_e().map(drop),
            module.try_e_f_g_G_H().map(drop),
            {
                let ((mut g, mut h), (mut f, _)) = (nothing(), nothing());
                module.try_e_f_g_G_H_into(&mut g, &mut f, &mut h).map(drop)
            },
        ]
        .map(|result| result.unwrap_err().to_string());
        assert_eq!(alone, together);
        assert_eq!(alone, also);
        // `a` comes first, and its fault is that of `e`
        let first = Failing::new(&mesh, &x[..], 5.0).unwrap().try_a_H().unwrap_err();
        let Error::Undefined { call, .. } = first else {
            panic!("{first}");
        };
        assert_eq!(call, "a");
        // where the condition leaves the triangle out, all have values
        let module = Failing::new(&mesh, &x[..], -1.0).unwrap();
        let (e, f, g, slope, h) = module.e_f_g_G_H();
        assert_eq!((e, f), (0.0, 1.0));
        assert_eq!(g.amax(), 0.0);
        assert!(slope.amax() > 0.0 && h.data().iter().all(|x| *x == 0.0));
    }

    #[test]
    fn conditions_that_depend_on_values() {
        for (mesh, x) in meshes(6) {
            for w in [0.3, 0.9, 5.0] {
                let each = Failing::new(&mesh, &x, w).unwrap();
                let (e, f, g, slope, h) = Failing::new(&mesh, &x, w).unwrap().e_f_g_G_H();
                // close to triangles without an area, the terms are large
                near(&e, &each.e());
                near(&f, &each.f());
                near(&g, &each.g());
                near(&slope, &each.G());
                near(&h, &each.H());
            }
        }
    }

    #[test]
    fn what_is_known_is_kept() {
        let (mesh, x) = meshes(6).pop().unwrap();
        let moved: Vec<DVec2> = x.iter().map(|p| 1.1 * *p).collect();
        let mut module = Springs::new(&mesh, &x, 2.0).unwrap();
        let fresh = Springs::new(&mesh, &moved, 2.0).unwrap();
        let first = module.e_g_H();
        assert_eq!(first, (module.e(), module.g(), module.H()));
        assert_eq!(first, module.e_g_H());
        module.set_x(&moved).unwrap();
        // what has been asked for by itself is not computed again
        let e = module.e();
        let (mut g, mut h) = nothing();
        assert_eq!(module.e_g_H_into(&mut g, &mut h), e);
        near(&g, &fresh.g());
        near(&h, &fresh.H());
        let (kept, slope, _) = module.e_g_H();
        assert_eq!(kept, e);
        assert_eq!(module.g_theta_e().0, slope);
        assert_eq!(module.e_g_H_into(&mut g, &mut h), e);
        assert_eq!(g, slope);
        near(&h, &fresh.H());
    }
}

#[test]
fn threads_do_not_matter() {
    let (x, triangles) = grid(30);
    let mesh = FaceMesh::from_triangles(x.len(), &triangles).unwrap();
    let evaluate = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.unwrap().install(|| {
            let module = optimized::Springs::new(&mesh, &x, 2.0).unwrap();
            let new = module.n_g_H_A_R_e_c();
            let (mut g, mut h) = nothing();
            let module = optimized::Springs::new(&mesh, &x, 2.0).unwrap();
            let e = module.e_g_H_into(&mut g, &mut h);
            (new, e, g, h)
        })
    };
    let one = evaluate(1);
    for threads in [2, 3, 8] {
        assert!(evaluate(threads) == one);
    }
}
