//! How the masses of the example of masses and springs start.

use iheartmesh::glam::DVec3;

/// Positions and velocities of a body that is stretched, sheared and thrown down, from its positions at rest.
pub fn wobble(rest: &[DVec3]) -> (Vec<DVec3>, Vec<DVec3>) {
    let stretched = rest.iter().map(|p| *p * DVec3::new(1.1, 0.95, 1.05));
    let sheared = stretched.map(|p| p + DVec3::X * (0.1 * p.y));
    let velocity = |i: usize| {
        let i = i as f64;
        DVec3::new(
            0.3 * (0.7 * (i + 1.0)).cos(),
            -1.0 + 0.2 * (0.3 * i).sin(),
            0.1 * (1.3 * i).cos(),
        )
    };
    (sheared.collect(), (0..rest.len()).map(velocity).collect())
}
