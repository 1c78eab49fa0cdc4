//! What does not allocate: energies, and gradients and Hessians that are written into memory that is at hand.

#[path = "../examples/common/generate.rs"]
#[allow(dead_code)]
mod generate;

use allocation_counter::measure;
use iheartmesh::glam::DVec2;
use iheartmesh::{FaceMesh, iheartmesh};
use nalgebra::{DMatrix, DVector};

iheartmesh! {
    #[together(e, g, H)]
    #[together(P, g)]
    struct Dirichlet = include "tests/programs/symmetric_dirichlet.hlang";

    struct Products = "
        ElementSets from MeshConnectivity
        OrientedVertices, Vertices from Neighborhoods(M)
        psd, psd_abs from linearalgebra
        M : FaceMesh
        V, E, F = ElementSets(M)
        x : V → ℝ²
        v ∈ ℝ^(2#V)
        Z ∈ ℝ^(2#V×k)
        D(f) = |[x_b - x_a  x_c - x_a]| where f ∈ F, a, b, c = OrientedVertices(f)
        S(f) = { (D(f) - 1)² if D(f) > ½
                 0 otherwise where f ∈ F
        l(k) = (‖x_i - x_j‖² - 1)² where k ∈ E, i, j = Vertices(k)
        H = ∂²(∑_(f ∈ F) S(f) + ∑_(k ∈ E) l(k))/∂x²
        P = ∑_(f ∈ F) psd(∂²S(f)/∂x²) - 2 ∑_(k ∈ E) psd_abs(∂²l(k)/∂x²)
        p = H v
        q = P v
        A = (H + P) Z
        L ∈ ℝ^(2#V×2#V)
        L_ij = { 1/i if i = j
        B = H / 3 - (2 P - L)
    ";

    struct Rings = "
        ElementSets from MeshConnectivity
        VertexOneRing from Neighborhoods(M)
        psd, psd_abs from linearalgebra
        M : FaceMesh
        V, E, F = ElementSets(M)
        x : V → ℝ²
        v ∈ ℝ^(2#V)
        l(p, q) = { (‖p - q‖² - 1)² if ‖p - q‖² > 1
                    0 otherwise where p, q ∈ ℝ²
        S(i) = (∑_(j ∈ VertexOneRing(i)) ‖x_j - x_i‖² - 6)² where i ∈ V
        T(i) = ∑_(j ∈ VertexOneRing(i)) l(x_i, x_j) where i ∈ V
        P = 2 ∑_(i ∈ V) psd(∂²S(i)/∂x²) - ∑_(i ∈ V) psd_abs(∂²T(i)/∂x²)
        q = P v
    ";
}

#[test]
fn values_in_memory_that_is_at_hand() {
    let (positions, triangles) = generate::torus(12, 10);
    let mesh = FaceMesh::from_triangles(positions.len(), &triangles).unwrap();
    // some triangles upside down, some stretched, so that blocks are indefinite
    let at = |t: f64| -> Vec<DVec2> {
        let flat = positions.iter().enumerate();
        flat.map(|(k, p)| DVec2::new(p.x + t * (k as f64).sin(), p.y * t + p.z))
            .collect()
    };
    let maps: Vec<Vec<DVec2>> = [1.0, 0.5, 2.0].map(at).to_vec();
    let mut module = Dirichlet::new(&mesh, &positions, &maps[0]).unwrap();
    let (mut g, mut h, mut p) = (module.g(), module.H(), module.P());
    // the first time finds memory for the terms of a chunk
    module.set_x(&maps[1]).unwrap();
    module.g_into(&mut g);
    module.H_into(&mut h);
    module.P_into(&mut p);
    for x in &maps {
        let mut energy = 0.0;
        let found = measure(|| {
            module.set_x(x).unwrap();
            energy = module.e();
            module.g_into(&mut g);
            module.H_into(&mut h);
            module.P_into(&mut p);
        });
        assert_eq!(found.count_total, 0);
        // and these are the values
        let fresh = Dirichlet::new(&mesh, &positions, x).unwrap();
        assert_eq!(energy.to_bits(), fresh.e().to_bits());
        assert_eq!(h, fresh.H());
        assert_eq!(p, fresh.P());
        assert_eq!(g, fresh.g());
    }
    // asked together
    module.set_x(&maps[1]).unwrap();
    module.e_g_H_into(&mut g, &mut h);
    module.set_x(&maps[1]).unwrap();
    module.P_g_into(&mut p, &mut g);
    for x in &maps {
        let mut energy = 0.0;
        let found = measure(|| {
            module.set_x(x).unwrap();
            module.P_g_into(&mut p, &mut g);
            energy = module.e_g_H_into(&mut g, &mut h);
        });
        assert_eq!(found.count_total, 0);
        let fresh = Dirichlet::new(&mesh, &positions, x).unwrap();
        let (e, slope, second) = fresh.e_g_H();
        assert_eq!(energy.to_bits(), e.to_bits());
        assert_eq!((&g, &h), (&slope, &second));
        assert_eq!(p, fresh.P());
    }
    // a new value does allocate
    assert!(measure(|| drop(module.H())).count_total > 0);
}

#[test]
fn products_in_memory_that_is_at_hand() {
    let (positions, triangles) = generate::torus(12, 10);
    let mesh = FaceMesh::from_triangles(positions.len(), &triangles).unwrap();
    let mut random = fastrand::Rng::with_seed(3);
    let x: Vec<DVec2> = positions.iter().map(|p| DVec2::new(p.x, p.z)).collect();
    let n = 2 * x.len();
    let vectors: Vec<_> = (0..4)
        .map(|_| DVector::from_fn(n, |_, _| random.f64()))
        .collect();
    let matrices: Vec<_> = (0..4)
        .map(|_| DMatrix::from_fn(n, 10, |_, _| random.f64()))
        .collect();
    let mut module = Products::new(&mesh, &x, &vectors[0], &matrices[0]).unwrap();
    let (mut p, mut q, mut a) = (module.p(), module.q(), module.A());
    module.set_v(&vectors[1]).unwrap();
    module.p_into(&mut p);
    module.q_into(&mut q);
    let mut b = module.B();
    let scaled = |t: f64| -> Vec<DVec2> { x.iter().map(|x| *x * t).collect() };
    let maps = [1.0, 0.5, 2.0].map(scaled);
    for x in &maps {
        module.set_x(x).unwrap();
        let (_, _) = (module.H(), module.P());
        let found = measure(|| module.B_into(&mut b));
        assert_eq!(found.count_total, 0);
        let fresh = Products::new(&mesh, x, &vectors[0], &matrices[0]).unwrap();
        assert_eq!(b, fresh.B());
    }
    module.set_x(&x).unwrap();
    for (v, z) in vectors.iter().zip(&matrices) {
        module.set_Z(z).unwrap();
        let found = measure(|| {
            module.set_v(v).unwrap();
            module.p_into(&mut p);
            module.q_into(&mut q);
            module.A_into(&mut a);
        });
        assert_eq!(found.count_total, 0);
        let fresh = Products::new(&mesh, &x, v, z).unwrap();
        assert_eq!((&p, &q, &a), (&fresh.p(), &fresh.q(), &fresh.A()));
    }
}

/// Blocks whose size the mesh decides, with eigenvalues that are replaced.
#[test]
fn sums_around_vertices() {
    let (positions, triangles) = generate::torus(8, 7);
    let mesh = FaceMesh::from_triangles(positions.len(), &triangles).unwrap();
    let at = |t: f64| -> Vec<DVec2> {
        let flat = positions.iter().enumerate();
        flat.map(|(k, p)| DVec2::new(p.x + t * (k as f64).sin(), p.y * t + p.z))
            .collect()
    };
    let maps: Vec<Vec<DVec2>> = [1.0, 0.5, 2.0].map(at).to_vec();
    let v = DVector::from_fn(2 * maps[0].len(), |k, _| (k as f64).cos());
    let mut module = Rings::new(&mesh, &maps[0], &v).unwrap();
    let (mut p, mut q) = (module.P(), module.q());
    module.set_x(&maps[1]).unwrap();
    module.P_into(&mut p);
    module.q_into(&mut q);
    for x in &maps {
        let found = measure(|| {
            module.set_x(x).unwrap();
            module.q_into(&mut q);
            module.P_into(&mut p);
        });
        assert_eq!(found.count_total, 0);
        let fresh = Rings::new(&mesh, x, &v).unwrap();
        assert_eq!((&p, &q), (&fresh.P(), &fresh.q()));
    }
}
