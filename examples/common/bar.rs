//! A bar of tetrahedra that is twisted and stretched.

use glam::{DMat3, DVec3};

/// The positions and tetrahedra of a bar of `n` × `length` × `n` cubes, each divided into six tetrahedra (Kuhn 1960). It stands
/// along y around the origin; its width is 1.
pub fn bar(n: usize, length: usize) -> (Vec<DVec3>, Vec<[u32; 4]>) {
    let sizes = [n + 1, length + 1, n + 1];
    let number = |[i, j, k]: [usize; 3]| (i + sizes[0] * (j + sizes[1] * k)) as u32;
    let side = 1.0 / n as f64;
    let half = 0.5 * DVec3::new(1.0, side * length as f64, 1.0);
    let mut positions = Vec::new();
    let mut tetrahedra = Vec::new();
    for k in 0..sizes[2] {
        for j in 0..sizes[1] {
            for i in 0..sizes[0] {
                positions.push(side * DVec3::new(i as f64, j as f64, k as f64) - half);
                if i == n || j == length || k == n {
                    continue;
                }
                // from one corner to the opposite one, along the axes in any order
                for (axes, is_even) in [
                    ([0, 1, 2], true),
                    ([1, 2, 0], true),
                    ([2, 0, 1], true),
                    ([0, 2, 1], false),
                    ([1, 0, 2], false),
                    ([2, 1, 0], false),
                ] {
                    let mut corner = [i, j, k];
                    let mut path = vec![number(corner)];
                    for axis in axes {
                        corner[axis] += 1;
                        path.push(number(corner));
                    }
                    let [a, b, c, d] = [path[0], path[1], path[2], path[3]];
                    tetrahedra.push(if is_even { [a, b, c, d] } else { [a, b, d, c] });
                }
            }
        }
    }
    (positions, tetrahedra)
}

/// A bar whose ends are turned against each other by an angle, evenly over its length, and pulled apart.
pub fn twisted(x: &[DVec3], angle: f64, stretch: f64) -> Vec<DVec3> {
    let half = x.iter().fold(0.0, |most: f64, x| most.max(x.y));
    let moved = |x: &DVec3| {
        let turned = DMat3::from_rotation_y(0.5 * angle * x.y / half) * *x;
        DVec3::new(turned.x, stretch * turned.y, turned.z)
    };
    x.iter().map(moved).collect()
}

/// The vertices at both ends of a bar.
pub fn ends(x: &[DVec3]) -> Vec<u32> {
    let half = x.iter().fold(0.0, |most: f64, x| most.max(x.y));
    let at_end = |v: &u32| x[*v as usize].y.abs() > half * (1.0 - 1e-9);
    (0..x.len() as u32).filter(at_end).collect()
}

/// Six times the volume of each tetrahedron.
pub fn volumes(x: &[DVec3], tetrahedra: &[[u32; 4]]) -> Vec<f64> {
    let volume = |t: &[u32; 4]| {
        let [a, b, c, d] = t.map(|v| x[v as usize]);
        (b - a).cross(c - a).dot(d - a)
    };
    tetrahedra.iter().map(volume).collect()
}
