//! Distances by waves that run over a surface: which vertex is updated when. How one is updated is the caller's affair.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use iheartmesh::{Face, FaceMesh, Vertex};

/// Distances from the sources, the nearest vertex first (fast marching): each vertex that the wave has reached updates its
/// neighbours across its faces. One that becomes nearer later, as it may across an obtuse triangle, does so again.
///
/// `update(f, v, d)` is the distance of `v` across the face `f`, from the distances `d` so far; unknown ones are `∞`.
pub fn march(
    mesh: &FaceMesh,
    sources: &[Vertex],
    update: impl Fn(Face, Vertex, &[f64]) -> f64,
) -> Vec<f64> {
    let mut faces_of = vec![Vec::new(); mesh.n_vertices()];
    for face in mesh.faces() {
        for vertex in mesh.face_vertices(face).iter() {
            faces_of[vertex.index()].push(face);
        }
    }
    let mut distances = starting_at(mesh, sources);
    let mut wave: BinaryHeap<Reverse<(Nearness, Vertex)>> = BinaryHeap::new();
    wave.extend(sources.iter().map(|v| Reverse((Nearness(0.0), *v))));
    while let Some(Reverse((Nearness(distance), from))) = wave.pop() {
        if distance > distances[from.index()] {
            // it came nearer since, and is there a second time
            continue;
        }
        for &face in &faces_of[from.index()] {
            for vertex in mesh.face_vertices(face).iter().filter(|v| *v != from) {
                let found = update(face, vertex, &distances);
                if found < distances[vertex.index()] {
                    distances[vertex.index()] = found;
                    wave.push(Reverse((Nearness(found), vertex)));
                }
            }
        }
    }
    distances
}

/// Distances from the first of the levels, each of which holds the neighbours of the one before. In each round all
/// vertices of a level are updated if a distance there or in a level beside it changed in the round before, by more than
/// a part of `tolerance`: a band of levels that runs over the surface, and back where a way around was shorter.
/// Returns the number of rounds, too.
///
/// `update(v, d)` is the distance of `v` from the distances `d` so far.
pub fn propagate<'a, Level>(
    mesh: &FaceMesh,
    levels: &'a [Level],
    tolerance: f64,
    update: impl Fn(Vertex, &[f64]) -> f64,
) -> (Vec<f64>, usize)
where
    &'a Level: IntoIterator<Item = &'a Vertex>,
{
    let sources = levels.iter().take(1).flatten().copied();
    let mut distances = starting_at(mesh, &sources.collect::<Vec<Vertex>>());
    let mut has_changed: Vec<bool> = (0..levels.len()).map(|level| level == 0).collect();
    let mut rounds = 0;
    while has_changed.contains(&true) {
        rounds += 1;
        let is_beside = |level: usize| {
            let beside = level.saturating_sub(1)..levels.len().min(level + 2);
            has_changed[beside].contains(&true)
        };
        let in_band = (1..levels.len()).filter(|level| is_beside(*level));
        let found: Vec<(usize, Vertex, f64)> = in_band
            .flat_map(|level| {
                levels[level]
                    .into_iter()
                    .map(move |vertex| (level, *vertex))
            })
            .map(|(level, vertex)| (level, vertex, update(vertex, &distances)))
            .collect();
        has_changed.fill(false);
        for (level, vertex, distance) in found {
            let before = std::mem::replace(&mut distances[vertex.index()], distance);
            has_changed[level] |= before - distance > tolerance * distance;
        }
    }
    (distances, rounds)
}

fn starting_at(mesh: &FaceMesh, sources: &[Vertex]) -> Vec<f64> {
    let mut distances = vec![f64::INFINITY; mesh.n_vertices()];
    for source in sources {
        distances[source.index()] = 0.0;
    }
    distances
}

/// A distance, by its size.
#[derive(Clone, Copy, PartialEq)]
struct Nearness(f64);

impl Eq for Nearness {}

impl PartialOrd for Nearness {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Nearness {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}
