//! Tetrahedra that fill the convex hull of a surface, with its triangles among their faces where that is possible.

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;

use glam::DVec3;
use simple_delaunay_lib::delaunay_3d::delaunay_struct_3d::DelaunayStructure3D;
use simple_delaunay_lib::delaunay_3d::simplicial_struct_3d::Node;

/// How often the surface is refined at most. What is not found by then lies at small angles between triangles, where
/// points in the middle of edges only get into each other's way.
const MOST_ROUNDS: usize = 8;

/// Tetrahedra with the surface that they contain.
pub struct Tetrahedra {
    /// The vertices of the surface, and behind them those that refine it.
    pub points: Vec<DVec3>,
    /// Corners of the tetrahedra, oriented so that their volumes are positive.
    pub tetrahedra: Vec<[u32; 4]>,
    /// The triangles of the surface, split where they had to be, oriented as they were.
    pub triangles: Vec<[u32; 3]>,
    /// How many of these triangles are not faces of tetrahedra.
    pub missing: usize,
}

/// The Delaunay tetrahedra of the vertices of a surface. Where a triangle is not a face of one of them, an edge of it is
/// split in its middle, which leaves the surface as a set of points what it was, and so on until all triangles are
/// faces, or after some rounds as many as in the best of them.
///
/// # Errors
/// If the points are all in one plane.
pub fn conforming(
    positions: &[DVec3],
    triangles: &[[u32; 3]],
) -> Result<Tetrahedra, Box<dyn Error>> {
    let (mut points, mut triangles) = (positions.to_vec(), triangles.to_vec());
    let mut best: Option<Tetrahedra> = None;
    for _ in 0..=MOST_ROUNDS {
        let tetrahedra = delaunay(&points)?;
        let faces: BTreeSet<[u32; 3]> = tetrahedra
            .iter()
            .flat_map(|t| faces(*t).map(sorted))
            .collect();
        let edges: BTreeSet<[u32; 2]> = faces.iter().flat_map(|f| sides(*f)).collect();
        let is_missing = |t: &&[u32; 3]| !faces.contains(&sorted(**t));
        let missing: Vec<[u32; 3]> = triangles.iter().filter(is_missing).copied().collect();
        if best
            .as_ref()
            .is_none_or(|best| missing.len() < best.missing)
        {
            best = Some(Tetrahedra {
                points: points.clone(),
                tetrahedra,
                triangles: triangles.clone(),
                missing: missing.len(),
            });
        }
        // the longest edge that is missing itself, or else the longest one
        let mut middles = BTreeMap::new();
        for triangle in missing {
            let place = |i: u32| points[i as usize];
            let key = |[i, j]: [u32; 2]| (!edges.contains(&[i, j]), place(i).distance(place(j)));
            let [i, j] = sides(triangle)
                .into_iter()
                .max_by(|a, b| {
                    let ((a_missing, a), (b_missing, b)) = (key(*a), key(*b));
                    a_missing.cmp(&b_missing).then(a.total_cmp(&b))
                })
                .expect("a triangle has sides");
            middles.entry([i, j]).or_insert_with(|| {
                points.push(points[i as usize].midpoint(points[j as usize]));
                points.len() as u32 - 1
            });
        }
        if middles.is_empty() {
            break;
        }
        triangles = triangles
            .iter()
            .flat_map(|triangle| refined(*triangle, &middles))
            .collect();
    }
    Ok(best.expect("there is at least one round"))
}

/// The boundary of some of the tetrahedra, oriented outward.
pub fn boundary(tetrahedra: &[[u32; 4]], is_inside: &[bool]) -> Vec<[u32; 3]> {
    let inside = || {
        tetrahedra
            .iter()
            .zip(is_inside)
            .filter(|(_, inside)| **inside)
    };
    let mut around: BTreeMap<[u32; 3], usize> = BTreeMap::new();
    for (t, _) in inside() {
        for face in faces(*t) {
            *around.entry(sorted(face)).or_insert(0) += 1;
        }
    }
    inside()
        .flat_map(|(t, _)| faces(*t))
        .filter(|face| around[&sorted(*face)] == 1)
        .collect()
}

/// The faces of a tetrahedron of positive volume, oriented outward.
fn faces([a, b, c, d]: [u32; 4]) -> [[u32; 3]; 4] {
    [[b, c, d], [a, d, c], [a, b, d], [a, c, b]]
}

/// The vertices of a triangle in the order of their numbers.
pub fn sorted(mut triangle: [u32; 3]) -> [u32; 3] {
    triangle.sort_unstable();
    triangle
}

fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]].map(|[i, j]| [i.min(j), i.max(j)])
}

/// The parts of a triangle whose edges with a middle are split there.
fn refined(triangle: [u32; 3], middles: &BTreeMap<[u32; 2], u32>) -> Vec<[u32; 3]> {
    for k in 0..3 {
        let [a, b, c] = [0, 1, 2].map(|corner| triangle[(k + corner) % 3]);
        if let Some(&m) = middles.get(&[a.min(b), a.max(b)]) {
            let halves = [[a, m, c], [m, b, c]];
            return halves
                .into_iter()
                .flat_map(|half| refined(half, middles))
                .collect();
        }
    }
    vec![triangle]
}

fn delaunay(points: &[DVec3]) -> Result<Vec<[u32; 4]>, Box<dyn Error>> {
    let coordinates = points.iter().map(|point| point.to_array()).collect();
    let mut structure = DelaunayStructure3D::new();
    structure.insert_vertices(&coordinates, true)?;
    let simplices = structure.get_simplicial();
    let mut tetrahedra = Vec::new();
    for number in 0..simplices.get_nb_tetrahedra() {
        let nodes = simplices.get_tetrahedron(number)?.nodes();
        // the library also has tetrahedra with a corner at infinity, behind the faces of the hull
        let corners = nodes.map(|node| match node {
            Node::Value(vertex) => Some(vertex as u32),
            Node::Infinity => None,
        });
        if let [Some(a), Some(b), Some(c), Some(d)] = corners {
            let [x, y, z, w] = [a, b, c, d].map(|vertex| points[vertex as usize]);
            let volume = (y - x).cross(z - x).dot(w - x);
            tetrahedra.push(if volume < 0.0 {
                [a, b, d, c]
            } else {
                [a, b, c, d]
            });
        }
    }
    Ok(tetrahedra)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tetrahedra_fill_the_hull_and_contain_the_surface() {
        // a box that is longer than wide, whose lid is divided another way than its floor
        let corners = [0, 1, 2, 3, 4, 5, 6, 7].map(|k| {
            DVec3::new(
                f64::from(k & 1),
                2.0 * f64::from(k >> 1 & 1),
                3.0 * f64::from(k >> 2),
            )
        });
        let triangles = [
            [0, 2, 1],
            [1, 2, 3],
            [4, 5, 6],
            [5, 7, 6],
            [0, 1, 4],
            [1, 5, 4],
        ];
        let filled = conforming(&corners, &triangles).unwrap();
        assert_eq!(filled.missing, 0);
        let place = |vertex: u32| filled.points[vertex as usize];
        let volume = |[a, b, c, d]: [u32; 4]| {
            let a = place(a);
            (place(b) - a).cross(place(c) - a).dot(place(d) - a) / 6.0
        };
        let volumes: Vec<f64> = filled.tetrahedra.iter().map(|t| volume(*t)).collect();
        assert!(volumes.iter().all(|volume| *volume >= 0.0));
        assert!((volumes.iter().sum::<f64>() - 6.0).abs() < 1e-12);

        let hull = boundary(&filled.tetrahedra, &vec![true; filled.tetrahedra.len()]);
        let under = |[a, b, c]: [u32; 3]| place(a).dot(place(b).cross(place(c))) / 6.0;
        assert!((hull.iter().map(|t| under(*t)).sum::<f64>() - 6.0).abs() < 1e-12);
        assert!(
            filled
                .triangles
                .iter()
                .all(|t| hull.iter().any(|f| sorted(*f) == sorted(*t)))
        );
    }
}
