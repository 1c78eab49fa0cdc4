//! Meshes of any size, for timing and for tests.

use std::f64::consts::TAU;

use glam::DVec3;

/// A torus around the y axis, radii 1 and 0.4, slightly bumpy so that no two angles are alike.
///
/// `n_around` rings of `n_along` vertices each: `n_around · n_along` vertices, numbered ring by ring, and
/// twice as many triangles, numbered in the same order and all oriented outward. Neighbours in the mesh are
/// close to each other in memory; see [`shuffle`] for the opposite. Both numbers must be at least 3.
pub fn torus(n_around: usize, n_along: usize) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    assert!(
        n_around >= 3 && n_along >= 3,
        "a torus has at least three vertices in each direction"
    );
    let n_vertices = n_around * n_along;
    assert!(
        u32::try_from(n_vertices).is_ok(),
        "too many vertices for 32 bit indices"
    );

    let mut positions = Vec::with_capacity(n_vertices);
    for i in 0..n_around {
        let around = TAU * i as f64 / n_around as f64;
        for j in 0..n_along {
            let along = TAU * j as f64 / n_along as f64;
            let bump = 1.0 + 0.06 * (5.0 * around + 2.0 * along).sin() + 0.03 * (3.0 * along).cos();
            let distance = 1.0 + 0.4 * bump * along.cos();
            let height = 0.4 * bump * along.sin();
            positions.push(DVec3::new(
                distance * around.cos(),
                height,
                distance * around.sin(),
            ));
        }
    }

    let number = |i: usize, j: usize| ((i % n_around) * n_along + j % n_along) as u32;
    let mut triangles = Vec::with_capacity(2 * n_vertices);
    for i in 0..n_around {
        for j in 0..n_along {
            let (here, up) = (number(i, j), number(i, j + 1));
            let (beside, diagonal) = (number(i + 1, j), number(i + 1, j + 1));
            triangles.push([here, up, diagonal]);
            triangles.push([here, diagonal, beside]);
        }
    }
    (positions, triangles)
}

/// The same surface with its vertices renumbered, its faces reordered and each face begun at another of
/// its corners, all at random but the same for the same `seed`. Orientations stay.
pub fn shuffle(
    positions: &[DVec3],
    triangles: &[[u32; 3]],
    seed: u64,
) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut old_number: Vec<u32> = (0..positions.len() as u32).collect();
    random.shuffle(&mut old_number);
    let mut new_number = vec![0u32; positions.len()];
    for (new, &old) in old_number.iter().enumerate() {
        new_number[old as usize] = new as u32;
    }

    let shuffled_positions = old_number
        .iter()
        .map(|&old| positions[old as usize])
        .collect();
    let mut shuffled_triangles = triangles.to_vec();
    random.shuffle(&mut shuffled_triangles);
    for triangle in &mut shuffled_triangles {
        *triangle = triangle.map(|old| new_number[old as usize]);
        triangle.rotate_left(random.usize(..3));
    }
    (shuffled_positions, shuffled_triangles)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Six times the signed volume: positive exactly if a closed surface is oriented outward.
    fn volume(positions: &[DVec3], triangles: &[[u32; 3]]) -> f64 {
        let corner = |v: u32| positions[v as usize];
        triangles
            .iter()
            .map(|&[i, j, k]| corner(i).dot(corner(j).cross(corner(k))))
            .sum()
    }

    #[test]
    fn a_torus_is_closed_and_oriented_outward() {
        let (positions, triangles) = torus(7, 5);
        assert_eq!((positions.len(), triangles.len()), (35, 70));
        let mut sides: Vec<_> = triangles
            .iter()
            .flat_map(|&[i, j, k]| [(i, j), (j, k), (k, i)])
            .collect();
        sides.sort_unstable();
        assert!(sides.windows(2).all(|pair| pair[0] != pair[1]));
        assert!(
            sides
                .iter()
                .all(|&(i, j)| sides.binary_search(&(j, i)).is_ok())
        );
        assert!(volume(&positions, &triangles) > 0.0);
    }

    #[test]
    fn shuffling_keeps_the_surface_and_repeats_itself() {
        let (positions, triangles) = torus(9, 6);
        let shuffled = shuffle(&positions, &triangles, 1);
        assert_eq!(shuffled, shuffle(&positions, &triangles, 1));
        assert_ne!(shuffled, shuffle(&positions, &triangles, 2));
        let difference = volume(&positions, &triangles) - volume(&shuffled.0, &shuffled.1);
        assert!(difference.abs() < 1e-12);
    }
}
