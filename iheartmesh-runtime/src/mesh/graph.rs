//! Which points are neighbours.

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
    coordinates.as_mut().iter_mut().for_each(|x| *x *= scale);
    coordinates
}

/// The tree of all points, each with its number.
fn tree<P: Point>(points: &[P], scale: f64) -> Result<Tree<P>, MeshError> {
    check_count(ElementKind::Vertex, points.len())?;
    let mut tree = KdTree::with_capacity(P::DIMENSION, 32);
    for (index, point) in points.iter().enumerate() {
        tree.add(scaled(*point, scale), index as u32)
            .map_err(|_| MeshError::NotFinite { point: index })?;
    }
    Ok(tree)
}

/// The pairs (smaller number first, maybe twice) of which one is among the `k` nearest of the other.
pub(super) fn k_nearest<P: Point>(points: &[P], k: usize) -> Result<Vec<[u32; 2]>, MeshError> {
    let scale = scale(points);
    let tree = tree(points, scale)?;
    if k == 0 {
        return Ok(Vec::new());
    }
    let pairs_of = |index: usize| -> Vec<[u32; 2]> {
        let point = scaled(points[index], scale);
        // the point itself is among them, or as many others at distance 0
        let found = tree
            .nearest(point.as_ref(), k.saturating_add(1), &squared_euclidean)
            .unwrap_or_default();
        let farthest = found.last().map_or(0.0, |(distance, _)| *distance);
        // all at the last distance, to choose among them by number
        let mut others: Vec<(f64, u32)> = tree
            .within(point.as_ref(), farthest, &squared_euclidean)
            .unwrap_or_default()
            .into_iter()
            .map(|(distance, &other)| (distance, other))
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
    let scale = scale(points);
    let tree = tree(points, scale)?;
    let radius = radius * scale;
    let pairs_of = |index: usize| -> Vec<[u32; 2]> {
        let point = scaled(points[index], scale);
        // a little more than the square, which may be rounded; the distance decides
        let bound = radius * radius * (1.0 + 1e-12);
        let mut pairs: Vec<[u32; 2]> = tree
            .within(point.as_ref(), bound, &squared_euclidean)
            .unwrap_or_default()
            .into_iter()
            .filter(|(squared, other)| **other as usize > index && squared.sqrt() <= radius)
            .map(|(_, &other)| pair(index, other))
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
