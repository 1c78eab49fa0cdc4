//! What does not allocate: energies, and gradients and Hessians that are written into memory that is at hand.

#[path = "../examples/common/generate.rs"]
#[allow(dead_code)]
mod generate;

use allocation_counter::measure;
use iheartmesh::glam::DVec2;
use iheartmesh::{FaceMesh, iheartmesh};

iheartmesh! {
    struct Dirichlet = include "tests/programs/symmetric_dirichlet.hlang";
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
    // a new value does allocate
    assert!(measure(|| drop(module.H())).count_total > 0);
}
