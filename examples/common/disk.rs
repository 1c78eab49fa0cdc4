//! Surfaces that are disks: their boundary on a circle, and a disk cut out of a larger surface.

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::TAU;

use glam::{DVec2, DVec3};
use iheartmesh::FaceMesh;

/// The angle of each vertex of the boundary on a circle, which it is laid around counter-clockwise by its length, from the
/// vertex with the smallest number; 0 for all others.
///
/// # Errors
/// If the surface is not a disk of triangles.
pub fn around_a_circle(mesh: &FaceMesh, x: &[DVec3]) -> Result<Vec<f64>, String> {
    let Some(triangles) = mesh.triangles() else {
        return Err("some faces are not triangles".to_owned());
    };
    if mesh.n_components() != 1 || mesh.euler_characteristic() != 1 {
        return Err(format!(
            "the surface is not a disk: {} components, Euler characteristic {}",
            mesh.n_components(),
            mesh.euler_characteristic()
        ));
    }
    let mut sides = BTreeSet::new();
    for [a, b, c] in triangles {
        for side in [(*a, *b), (*b, *c), (*c, *a)] {
            if !sides.insert(side) {
                return Err(
                    "the surface is not manifold, or not oriented alike everywhere".to_owned(),
                );
            }
        }
    }
    let open = sides.iter().filter(|(a, b)| !sides.contains(&(*b, *a)));
    let next: BTreeMap<u32, u32> = open.copied().collect();
    let Some((&start, _)) = next.first_key_value() else {
        return Err("the surface has no boundary".to_owned());
    };
    let mut lengths = vec![(start, 0.0)];
    let (mut vertex, mut length) = (start, 0.0);
    loop {
        let following = *next.get(&vertex).ok_or("the boundary is not closed")?;
        length += x[vertex as usize].distance(x[following as usize]);
        if following == start || lengths.len() > next.len() {
            break;
        }
        lengths.push((following, length));
        vertex = following;
    }
    if lengths.len() != mesh.boundary_edges().len() {
        return Err("the boundary is not one loop".to_owned());
    }
    let mut angles = vec![0.0; x.len()];
    for (vertex, part) in lengths {
        angles[vertex as usize] = TAU * part / length;
    }
    Ok(angles)
}

/// Positions and triangles.
pub type Triangles = (Vec<DVec3>, Vec<[u32; 3]>);

/// The triangles whose centres are on the side of a plane that `normal` points to, without vertices that none of them has.
pub fn cut(x: &[DVec3], triangles: &[[u32; 3]], normal: DVec3) -> Triangles {
    let mut numbers = BTreeMap::new();
    let mut positions = Vec::new();
    let mut kept = Vec::new();
    for t in triangles {
        if normal.dot(t.iter().map(|v| x[*v as usize]).sum()) > 0.0 {
            kept.push(t.map(|v| {
                *numbers.entry(v).or_insert_with(|| {
                    positions.push(x[v as usize]);
                    positions.len() as u32 - 1
                })
            }));
        }
    }
    (positions, kept)
}

/// Each triangle divided into four at the middles of its sides.
pub fn subdivided(x: &[DVec3], triangles: &[[u32; 3]]) -> Triangles {
    let mut positions = x.to_vec();
    let mut middles = BTreeMap::new();
    let mut middle = |a: u32, b: u32| {
        *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
            positions.push(0.5 * (x[a as usize] + x[b as usize]));
            positions.len() as u32 - 1
        })
    };
    let mut parts = Vec::new();
    for &[a, b, c] in triangles {
        let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
        parts.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
    }
    (positions, parts)
}

/// How many triangles are not counter-clockwise in the plane.
pub fn flipped(plane: &[DVec2], triangles: &[[u32; 3]]) -> usize {
    let is_flipped = |t: &&[u32; 3]| {
        let [a, b, c] = t.map(|v| plane[v as usize]);
        (b - a).perp_dot(c - a).is_nan() || (b - a).perp_dot(c - a) <= 0.0
    };
    triangles.iter().filter(is_flipped).count()
}
