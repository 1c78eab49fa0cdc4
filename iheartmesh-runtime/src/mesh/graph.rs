//! Which points are neighbours.

use std::cmp::Ordering;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use glam::{DVec2, DVec3, DVec4};
use kdtree::KdTree;
use kdtree::distance::squared_euclidean;
use rayon::prelude::*;

use super::MeshError;
use super::edge::check_count;
use crate::boundary::MAX_EDGES;
use crate::element::ElementKind;

/// A point of ℝ², ℝ³ or ℝ⁴.
pub trait Point: Copy + Sync {
    /// Its coordinates.
    type Coordinates: AsRef<[f64]> + AsMut<[f64]> + PartialEq + Send + Sync;
    /// How many there are.
    const DIMENSION: usize;

    /// The coordinates.
    fn coordinates(self) -> Self::Coordinates;
}

macro_rules! points {
    ($($point:ty, $n:literal, $coordinates:expr;)*) => {
        $(impl Point for $point {
            type Coordinates = [f64; $n];
            const DIMENSION: usize = $n;

            fn coordinates(self) -> [f64; $n] {
                $coordinates(self)
            }
        })*
    };
}

points! {
    DVec2, 2, |point: DVec2| point.to_array();
    DVec3, 3, |point: DVec3| point.to_array();
    DVec4, 4, |point: DVec4| point.to_array();
    [f64; 2], 2, |point| point;
    [f64; 3], 3, |point| point;
    [f64; 4], 4, |point| point;
}

type Tree<P> = KdTree<f64, u32, <P as Point>::Coordinates>;

/// A power of two by which all coordinates are multiplied, so that squares of distances neither overflow nor vanish: 1 for
/// all but extreme ones.
fn scale<P: Point>(points: &[P]) -> f64 {
    let greatest = points
        .iter()
        .map(|point| {
            let coordinates = point.coordinates();
            coordinates
                .as_ref()
                .iter()
                .fold(0.0, |most: f64, x| most.max(x.abs()))
        })
        .fold(0.0, f64::max);
    match greatest == 0.0 || !greatest.is_finite() || (1e-100..1e100).contains(&greatest) {
        true => 1.0,
        false => greatest
            .log2()
            .floor()
            .clamp(-1000.0, 1000.0)
            .exp2()
            .recip(),
    }
}

fn scaled<P: Point>(point: P, scale: f64) -> P::Coordinates {
    let mut coordinates = point.coordinates();
    // adding 0 takes −0 to 0
    let scaled = |x: &mut f64| *x = *x * scale + 0.0;
    coordinates.as_mut().iter_mut().for_each(scaled);
    coordinates
}

/// All numbers below `n`, each once, such that the first ones of them are spread evenly, however many these are: steps of
/// about the golden section of `n`.
fn spread(n: usize) -> impl Iterator<Item = usize> {
    fn divisor(a: usize, b: usize) -> usize {
        if b == 0 { a } else { divisor(b, a % b) }
    }
    let golden = (n as f64 * 0.618_033_988_749_894_8) as usize;
    let step = (golden.max(1)..)
        .find(|&step| divisor(step, n) == 1)
        .unwrap_or(1);
    (0..n).scan(0, move |next, _| {
        let this = *next;
        *next = (this + step) % n;
        Some(this)
    })
}

/// All points, those with the same coordinates together: a cloud may have very many copies of a point.
struct Cloud<P: Point> {
    /// The tree of different points, each with the number of its group.
    tree: Tree<P>,
    scale: f64,
    /// Where the points of each group start.
    starts: Vec<u32>,
    /// The numbers of the points of one group after the other, ascending in each.
    members: Vec<u32>,
}

impl<P: Point> Cloud<P> {
    fn new(points: &[P]) -> Result<Self, MeshError> {
        check_count(ElementKind::Vertex, points.len())?;
        let scale = scale(points);
        let is_finite = |point: &P| point.coordinates().as_ref().iter().all(|x| x.is_finite());
        if let Some(point) = points.iter().position(|point| !is_finite(point)) {
            return Err(MeshError::NotFinite { point });
        }
        let mut members: Vec<u32> = (0..points.len() as u32).collect();
        let coordinates = |index: u32| scaled(points[index as usize], scale);
        // −0 has been taken to 0
        let order = |&a: &u32, &b: &u32| {
            let (p, q) = (coordinates(a), coordinates(b));
            let pairs = p.as_ref().iter().zip(q.as_ref());
            let by_coordinates = pairs.map(|(x, y)| x.total_cmp(y));
            by_coordinates
                .fold(Ordering::Equal, Ordering::then)
                .then(a.cmp(&b))
        };
        members.par_sort_unstable_by(order);
        let mut starts = Vec::new();
        for (place, &index) in members.iter().enumerate() {
            let is_new = place
                .checked_sub(1)
                .is_none_or(|before| coordinates(members[before]) != coordinates(index));
            if is_new {
                starts.push(place as u32);
            }
        }
        let mut tree = KdTree::with_capacity(P::DIMENSION, 32);
        // not in ascending order, for which the tree would become a list
        for group in spread(starts.len()) {
            let index = members[starts[group] as usize];
            tree.add(coordinates(index), group as u32)
                .map_err(|_| MeshError::NotFinite {
                    point: index as usize,
                })?;
        }
        starts.push(members.len() as u32);
        Ok(Cloud {
            tree,
            scale,
            starts,
            members,
        })
    }

    fn group(&self, group: u32) -> &[u32] {
        let group = group as usize;
        &self.members[self.starts[group] as usize..self.starts[group + 1] as usize]
    }
}

/// The pairs (smaller number first, maybe twice) of which one is among the `k` nearest of the other.
pub(super) fn k_nearest<P: Point>(points: &[P], k: usize) -> Result<Vec<[u32; 2]>, MeshError> {
    // each pair is found at most twice
    let n_found = k
        .min(points.len().saturating_sub(1))
        .saturating_mul(points.len());
    check_count(ElementKind::Edge, n_found.div_ceil(2))?;
    let cloud = Cloud::new(points)?;
    if k == 0 {
        return Ok(Vec::new());
    }
    // the point itself is among them, or as many others at distance 0
    let count = k.saturating_add(1);
    let pairs_of = |index: usize| -> Vec<[u32; 2]> {
        let point = scaled(points[index], cloud.scale);
        let found = cloud
            .tree
            .nearest(point.as_ref(), count, &squared_euclidean)
            .unwrap_or_default();
        let mut n_found = 0_usize;
        let enough = found.iter().find(|(_, group)| {
            n_found += cloud.group(**group).len();
            n_found >= count
        });
        let farthest = enough
            .or(found.last())
            .map_or(0.0, |(distance, _)| *distance);
        // all at the last distance, to choose among them by number; of copies only the first ones can be chosen
        let mut others: Vec<(f64, u32)> = cloud
            .tree
            .within(point.as_ref(), farthest, &squared_euclidean)
            .unwrap_or_default()
            .into_iter()
            .flat_map(|(distance, &group)| {
                let group = cloud.group(group);
                let first = &group[..group.len().min(count)];
                first.iter().map(move |&other| (distance, other))
            })
            .filter(|&(_, other)| other as usize != index)
            .collect();
        others.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        others.truncate(k);
        others
            .into_iter()
            .map(|(_, other)| pair(index, other))
            .collect()
    };
    Ok((0..points.len())
        .into_par_iter()
        .flat_map_iter(pairs_of)
        .collect())
}

/// The pairs (smaller number first) at a distance of at most `radius`.
pub(super) fn within_radius<P: Point>(
    points: &[P],
    radius: f64,
) -> Result<Vec<[u32; 2]>, MeshError> {
    if radius.is_nan() || radius < 0.0 {
        return Err(MeshError::InvalidRadius);
    }
    let cloud = Cloud::new(points)?;
    pairs_within(&cloud, points, radius * cloud.scale, KEPT)
}

/// As many pairs within a radius are kept at once; where there are more, all are counted first.
const KEPT: usize = 1 << 27;

fn pairs_within<P: Point>(
    cloud: &Cloud<P>,
    points: &[P],
    radius: f64,
    kept: usize,
) -> Result<Vec<[u32; 2]>, MeshError> {
    let n_pairs = AtomicUsize::new(0);
    let pairs_of = |index: usize| -> Vec<[u32; 2]> {
        if n_pairs.load(Relaxed) > MAX_EDGES {
            return Vec::new();
        }
        let point = scaled(points[index], cloud.scale);
        // a little more than the square, which may be rounded; the distance decides
        let bound = radius * radius * (1.0 + 1e-12);
        let found = cloud
            .tree
            .within(point.as_ref(), bound, &squared_euclidean)
            .unwrap_or_default();
        let others = found
            .into_iter()
            .filter(|(squared, _)| squared.sqrt() <= radius)
            .flat_map(|(_, &group)| cloud.group(group))
            .filter(|other| **other as usize > index);
        if n_pairs.load(Relaxed) > kept {
            n_pairs.fetch_add(others.count(), Relaxed);
            return Vec::new();
        }
        let mut pairs: Vec<[u32; 2]> = others.map(|&other| pair(index, other)).collect();
        n_pairs.fetch_add(pairs.len(), Relaxed);
        pairs.sort_unstable();
        pairs
    };
    let pairs: Vec<[u32; 2]> = (0..points.len())
        .into_par_iter()
        .flat_map_iter(pairs_of)
        .collect();
    let count = n_pairs.into_inner();
    check_count(ElementKind::Edge, count)?;
    match pairs.len() < count {
        // some were counted only
        true => {
            drop(pairs);
            pairs_within(cloud, points, radius, usize::MAX)
        }
        false => Ok(pairs),
    }
}

fn pair(index: usize, other: u32) -> [u32; 2] {
    let index = index as u32;
    [index.min(other), index.max(other)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_of_the_tree_has_each_point_once() {
        for n in (0..200).chain([9_699_690, 1 << 16]) {
            let mut is_there = vec![false; n];
            spread(n).for_each(|k| is_there[k] = true);
            assert!(is_there.iter().all(|is_there| *is_there), "{n}");
        }
    }

    #[test]
    fn pairs_are_the_same_when_they_are_counted_first() {
        let points: Vec<[f64; 2]> = (0..60)
            .map(|k| [f64::from(k % 8), f64::from(k / 8)])
            .collect();
        let cloud = Cloud::new(&points).unwrap();
        for radius in [0.0, 1.0, 2.5, f64::INFINITY] {
            let all = pairs_within(&cloud, &points, radius, usize::MAX).unwrap();
            for kept in [0, 10, 1000] {
                assert_eq!(pairs_within(&cloud, &points, radius, kept).unwrap(), all);
            }
        }
    }
}
