//! Which points are neighbours.

use std::cmp::Ordering;

use glam::{DVec2, DVec3, DVec4};
use kdtree::KdTree;
use kdtree::distance::squared_euclidean;
use rayon::prelude::*;

use super::MeshError;
use super::edge::check_count;
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
        let mut tree = KdTree::with_capacity(P::DIMENSION, 32);
        for (place, &index) in members.iter().enumerate() {
            let is_new = place
                .checked_sub(1)
                .is_none_or(|before| coordinates(members[before]) != coordinates(index));
            if is_new {
                tree.add(coordinates(index), starts.len() as u32)
                    .map_err(|_| MeshError::NotFinite {
                        point: index as usize,
                    })?;
                starts.push(place as u32);
            }
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
    let radius = radius * cloud.scale;
    let pairs_of = |index: usize| -> Vec<[u32; 2]> {
        let point = scaled(points[index], cloud.scale);
        // a little more than the square, which may be rounded; the distance decides
        let bound = radius * radius * (1.0 + 1e-12);
        let mut pairs: Vec<[u32; 2]> = cloud
            .tree
            .within(point.as_ref(), bound, &squared_euclidean)
            .unwrap_or_default()
            .into_iter()
            .filter(|(squared, _)| squared.sqrt() <= radius)
            .flat_map(|(_, &group)| cloud.group(group))
            .filter(|other| **other as usize > index)
            .map(|&other| pair(index, other))
            .collect();
        pairs.sort_unstable();
        pairs
    };
    Ok((0..points.len())
        .into_par_iter()
        .flat_map_iter(pairs_of)
        .collect())
}

fn pair(index: usize, other: u32) -> [u32; 2] {
    let index = index as u32;
    [index.min(other), index.max(other)]
}
