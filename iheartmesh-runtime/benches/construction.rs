//! Time to build a `FaceMesh` of a torus of a million vertices, and a `CellMesh` of as many vertices in cubes of six
//! tetrahedra: all boundary matrices and their transposes.
//!
//! `cargo bench -p iheartmesh-runtime --bench construction [vertices along one side]`. Prints the best of several runs
//! for each vertex, on one thread and on all, for meshes numbered coherently and for the same numbered at random; for tetrahedra beside
//! numbering by sorting as one would write it by hand, and the bytes of both.
//!
//! With files as arguments it builds the meshes of these instead, beside what one would write by hand; `construction.py` in
//! `benches/` does the same with other libraries. `--write FILE` writes the torus.

// as the benches of the facade have it
#[path = "../../benches/baseline/edges.rs"]
#[allow(dead_code)]
mod edges;

use std::time::Instant;

use iheartmesh_runtime::glam::DVec3;
use iheartmesh_runtime::io::{self, Attributes};
use iheartmesh_runtime::{CellMesh, FaceMesh};

/// Triangles of an n × n torus.
fn torus(n: u32) -> Vec<[u32; 3]> {
    let vertex = |i: u32, j: u32| (i % n) * n + j % n;
    let quads = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
    quads
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [
                vertex(i, j),
                vertex(i + 1, j),
                vertex(i + 1, j + 1),
                vertex(i, j + 1),
            ];
            [[a, b, c], [a, c, d]]
        })
        .collect()
}

/// The same elements with vertices renamed and elements reordered by a fixed pseudo-random permutation.
fn shuffled<const N: usize>(n_vertices: usize, elements: &[[u32; N]]) -> Vec<[u32; N]> {
    let mut state = 1_u64;
    let mut below = |n: usize| {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        ((state >> 33) as usize) % n
    };
    let mut names: Vec<u32> = (0..n_vertices as u32).collect();
    (1..n_vertices)
        .rev()
        .for_each(|i| names.swap(i, below(i + 1)));
    let mut elements: Vec<[u32; N]> = elements
        .iter()
        .map(|corners| corners.map(|vertex| names[vertex as usize]))
        .collect();
    (1..elements.len())
        .rev()
        .for_each(|i| elements.swap(i, below(i + 1)));
    elements
}

/// The tetrahedra of n × n × n cubes, six in each (Kuhn's division): one for each order of the axes.
fn cubes(n: u32) -> Vec<[u32; 4]> {
    let steps = [1, n + 1, (n + 1) * (n + 1)];
    let mut tetrahedra = Vec::new();
    for k in 0..n {
        for j in 0..n {
            for i in 0..n {
                let first = i * steps[0] + j * steps[1] + k * steps[2];
                for [a, b, c] in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
                    let far = first + steps[a] + steps[b] + steps[c];
                    let [one, other] = [first + steps[a], first + steps[b]];
                    tetrahedra.push([first, one, one + steps[b], far]);
                    tetrahedra.push([first, other + steps[a], other, far]);
                }
            }
        }
    }
    tetrahedra
}

/// What a person would write: faces and edges by sorting all of them with where they come from, as lists of indices with
/// signs, and the same lists from the other side.
struct ByHand {
    cell_faces: Vec<[u32; 4]>,
    cell_signs: Vec<[i8; 4]>,
    faces: Vec<[u32; 3]>,
    face_edges: Vec<[u32; 3]>,
    edges: Vec<[u32; 2]>,
    vertex_edges: (Vec<u32>, Vec<u32>),
    edge_faces: (Vec<u32>, Vec<u32>),
    face_cells: (Vec<u32>, Vec<u32>),
}

impl ByHand {
    fn new(n_vertices: usize, tetrahedra: &[[u32; 4]]) -> ByHand {
        let mut sides: Vec<([u32; 3], u32)> = Vec::with_capacity(4 * tetrahedra.len());
        let mut cell_signs = vec![[0_i8; 4]; tetrahedra.len()];
        for (c, &[i, j, k, l]) in tetrahedra.iter().enumerate() {
            for (place, mut side) in [[j, k, l], [i, l, k], [i, j, l], [i, k, j]]
                .into_iter()
                .enumerate()
            {
                let mut sign = 1;
                for (a, b) in [(0, 1), (1, 2), (0, 1)] {
                    if side[a] > side[b] {
                        side.swap(a, b);
                        sign = -sign;
                    }
                }
                sides.push((side, (4 * c + place) as u32));
                cell_signs[c][place] = sign;
            }
        }
        sides.sort_unstable();
        let mut faces: Vec<[u32; 3]> = Vec::new();
        let mut cell_faces = vec![[0; 4]; tetrahedra.len()];
        for &(side, from) in &sides {
            if faces.last() != Some(&side) {
                faces.push(side);
            }
            cell_faces[from as usize / 4][from as usize % 4] = faces.len() as u32 - 1;
        }
        drop(sides);
        let mut pairs: Vec<([u32; 2], u32)> = Vec::with_capacity(3 * faces.len());
        for (f, &[i, j, k]) in faces.iter().enumerate() {
            for (place, pair) in [[i, j], [j, k], [i, k]].into_iter().enumerate() {
                pairs.push((pair, (3 * f + place) as u32));
            }
        }
        pairs.sort_unstable();
        let mut edges: Vec<[u32; 2]> = Vec::new();
        let mut face_edges = vec![[0; 3]; faces.len()];
        for &(pair, from) in &pairs {
            if edges.last() != Some(&pair) {
                edges.push(pair);
            }
            face_edges[from as usize / 3][from as usize % 3] = edges.len() as u32 - 1;
        }
        drop(pairs);
        ByHand {
            vertex_edges: turned(n_vertices, &edges),
            edge_faces: turned(edges.len(), &face_edges),
            face_cells: turned(faces.len(), &cell_faces),
            cell_faces,
            cell_signs,
            faces,
            face_edges,
            edges,
        }
    }

    fn bytes(&self) -> usize {
        let lists = [&self.vertex_edges, &self.edge_faces, &self.face_cells];
        size_of_val(&self.cell_faces[..])
            + size_of_val(&self.cell_signs[..])
            + size_of_val(&self.faces[..])
            + size_of_val(&self.face_edges[..])
            + size_of_val(&self.edges[..])
            + lists
                .iter()
                .map(|(starts, items)| size_of_val(&starts[..]) + size_of_val(&items[..]))
                .sum::<usize>()
    }
}

/// For each part, where its wholes start, and these.
fn turned<const N: usize>(n_parts: usize, wholes: &[[u32; N]]) -> (Vec<u32>, Vec<u32>) {
    let mut starts = vec![0; n_parts + 1];
    for &part in wholes.as_flattened() {
        starts[part as usize + 1] += 1;
    }
    for part in 0..n_parts {
        starts[part + 1] += starts[part];
    }
    let mut next = starts.clone();
    let mut items = vec![0; N * wholes.len()];
    for (whole, parts) in wholes.iter().enumerate() {
        for &part in parts {
            let place = &mut next[part as usize];
            items[*place as usize] = whole as u32;
            *place += 1;
        }
    }
    (starts, items)
}

/// What a person would write for a surface, and beyond it the lists that a `FaceMesh` has: the edges of each face ascending, the
/// faces of each edge, however many, the edges of each vertex, all with signs; and a copy of the triangles, with the check
/// that their vertices exist and differ.
#[expect(dead_code, reason = "they are made, not read")]
struct SameLists {
    triangles: Vec<[u32; 3]>,
    edges: Vec<[u32; 2]>,
    face_edges: (Vec<[u32; 3]>, Vec<[i8; 3]>),
    edge_faces: (Vec<u32>, Vec<u32>, Vec<i8>),
    vertex_edges: (Vec<u32>, Vec<u32>, Vec<i8>),
}

impl SameLists {
    fn new(n_vertices: usize, triangles: &[[u32; 3]]) -> SameLists {
        let is_good = |&[a, b, c]: &[u32; 3]| {
            (a.max(b).max(c) as usize) < n_vertices && a != b && b != c && c != a
        };
        assert!(triangles.iter().all(is_good));
        let edges::Edges {
            ends,
            faces,
            mut of_face,
            mut signs,
        } = edges::Edges::new(n_vertices, triangles);
        for (edges, signs) in of_face.iter_mut().zip(&mut signs) {
            for (a, b) in [(0, 1), (1, 2), (0, 1)] {
                if edges[a] > edges[b] {
                    edges.swap(a, b);
                    signs.swap(a, b);
                }
            }
        }
        let (mut starts, mut items) = (vec![0], Vec::with_capacity(3 * triangles.len()));
        let mut face_signs = Vec::with_capacity(3 * triangles.len());
        for &[along, against] in &faces {
            let first = along.min(against);
            for face in [first, along.max(against)] {
                if face != NONE {
                    items.push(face);
                    face_signs.push(if face == along { 1 } else { -1 });
                }
            }
            starts.push(items.len() as u32);
        }
        let (vertex_starts, vertex_edges) = turned(n_vertices, &ends);
        let mut vertex_signs = Vec::with_capacity(vertex_edges.len());
        for (vertex, range) in vertex_starts.windows(2).enumerate() {
            let around = &vertex_edges[range[0] as usize..range[1] as usize];
            let is_tail = |edge: &u32| ends[*edge as usize][0] == vertex as u32;
            vertex_signs.extend(around.iter().map(|edge| if is_tail(edge) { -1 } else { 1 }));
        }
        SameLists {
            triangles: triangles.to_vec(),
            edges: ends,
            face_edges: (of_face, signs),
            edge_faces: (starts, items, face_signs),
            vertex_edges: (vertex_starts, vertex_edges, vertex_signs),
        }
    }

    /// That the mesh has the same lists.
    fn compare(&self, mesh: &FaceMesh) {
        let complex = mesh.complex();
        let part = |list: &(Vec<u32>, Vec<u32>, Vec<i8>), k: usize| {
            let range = list.0[k] as usize..list.0[k + 1] as usize;
            (list.1[range.clone()].to_vec(), list.2[range].to_vec())
        };
        let owned = |(ids, signs): (&[u32], &[i8])| (ids.to_vec(), signs.to_vec());
        for face in 0..mesh.n_faces() {
            let own = (&self.face_edges.0[face][..], &self.face_edges.1[face][..]);
            assert_eq!(complex.boundary_column(2, face), own);
        }
        for (edge, ends) in self.edges.iter().enumerate() {
            assert_eq!(complex.edge_vertices(edge), *ends);
            let own = part(&self.edge_faces, edge);
            assert_eq!(owned(complex.coboundary_column(2, edge)), own);
        }
        for vertex in 0..mesh.n_vertices() {
            let own = part(&self.vertex_edges, vertex);
            assert_eq!(owned(complex.coboundary_column(1, vertex)), own);
        }
    }
}

/// Bytes of a cell mesh of tetrahedra: its columns, with pointers where their lengths differ, the corners of its faces and those of
/// its cells.
fn bytes(mesh: &CellMesh) -> usize {
    let entries = [2 * mesh.n_edges(), 3 * mesh.n_faces(), 4 * mesh.n_cells()];
    let signed: usize = entries.iter().sum::<usize>() * 2 - entries[0];
    let pointers = mesh.n_vertices() + mesh.n_edges() + mesh.n_faces() + mesh.n_cells();
    let corners = 16 * mesh.n_faces() + 20 * mesh.n_cells();
    8 * entries.iter().sum::<usize>() + signed + 4 * pointers + corners
}

/// Of both: that the numbers are the same.
fn compare(mesh: &CellMesh, by_hand: &ByHand) {
    assert_eq!(mesh.n_edges(), by_hand.edges.len());
    assert_eq!(mesh.n_faces(), by_hand.faces.len());
    let same = mesh
        .faces()
        .zip(&by_hand.faces)
        .all(|(face, corners)| mesh.face_vertices(face).ids() == corners);
    assert!(same, "the faces have the same numbers");
}

fn measure_tetrahedra(label: &str, n_vertices: usize, tetrahedra: &[[u32; 4]]) {
    let build = || CellMesh::from_tetrahedra(n_vertices, tetrahedra).expect("valid");
    measure(&format!("{label}, tetrahedra"), n_vertices, build);
    let build = || ByHand::new(n_vertices, tetrahedra);
    measure(&format!("{label}, tetrahedra by hand"), n_vertices, build);
}

/// No element, in lists by hand.
const NONE: u32 = u32::MAX;

/// The meshes of a file, on one thread and on all.
fn measure_file(path: &str) {
    let file = io::read(path).unwrap_or_else(|error| panic!("{error}"));
    let name = path.rsplit('/').next().unwrap_or(path);
    let n_vertices = file.positions.len();
    for n_threads in [1, 0] {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(n_threads)
            .build()
            .expect("threads");
        pool.install(|| {
            let label = format!("{name}, {} thread(s)", pool.current_num_threads());
            if let Some(triangles) = file.polygons.as_triangles().filter(|all| !all.is_empty()) {
                let build = || FaceMesh::from_triangles(n_vertices, triangles).expect("a mesh");
                measure(&format!("{label}, triangles"), triangles.len(), build);
                let mesh = FaceMesh::from_triangles(n_vertices, triangles).expect("a mesh");
                SameLists::new(n_vertices, triangles).compare(&mesh);
                drop(mesh);
                let build = || SameLists::new(n_vertices, triangles);
                let name = format!("{label}, triangles by hand, the same lists");
                measure(&name, triangles.len(), build);
                let build = || edges::Edges::new(n_vertices, triangles);
                measure(
                    &format!("{label}, triangles by hand"),
                    triangles.len(),
                    build,
                );
            }
            if !file.tetrahedra.is_empty() {
                let build = || CellMesh::from_tetrahedra(n_vertices, &file.tetrahedra);
                measure(
                    &format!("{label}, tetrahedra"),
                    file.tetrahedra.len(),
                    build,
                );
                let build = || ByHand::new(n_vertices, &file.tetrahedra);
                measure(
                    &format!("{label}, tetrahedra by hand"),
                    file.tetrahedra.len(),
                    build,
                );
            }
        });
    }
}

/// Writes a torus of n × n vertices, somewhere in space.
fn write_torus(n: u32, path: &str) {
    let turn = |k: u32| DVec3::new(f64::from(k).cos(), f64::from(k).sin(), f64::from(k % 7));
    let positions: Vec<DVec3> = (0..n * n).map(turn).collect();
    io::write(path, &positions, &torus(n), &Attributes::new())
        .unwrap_or_else(|error| panic!("{error}"));
}

fn measure<T>(label: &str, n_elements: usize, build: impl Fn() -> T) {
    let mut best = f64::INFINITY;
    let begin = Instant::now();
    let mut rounds = 0;
    while rounds < 7 || begin.elapsed().as_secs_f64() < 1.0 {
        rounds += 1;
        let start = Instant::now();
        let mesh = std::hint::black_box(build());
        best = best.min(start.elapsed().as_secs_f64());
        drop(mesh);
    }
    println!(
        "{label:<56} {:10.3} ms {:8.0} ns/element",
        1e3 * best,
        1e9 * best / n_elements as f64
    );
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let side = arguments
        .iter()
        .find_map(|argument| argument.parse().ok())
        .unwrap_or(1000);
    let files: Vec<&String> = arguments
        .iter()
        .filter(|argument| !argument.starts_with("--") && argument.parse::<u32>().is_err())
        .collect();
    if !files.is_empty() {
        match arguments.iter().any(|argument| argument == "--write") {
            true => files.iter().for_each(|path| write_torus(side, path)),
            false => files.iter().for_each(|path| measure_file(path)),
        }
        return;
    }
    let n_vertices = (side * side) as usize;
    let coherent = torus(side);
    let random = shuffled(n_vertices, &coherent);
    let n = (n_vertices as f64).cbrt().round() as u32 - 1;
    let cubes = cubes(n);
    let n_corners = (n as usize + 1).pow(3);
    let shuffled_cubes = shuffled(n_corners, &cubes);
    {
        let mesh = CellMesh::from_tetrahedra(n_corners, &cubes).expect("valid");
        let by_hand = ByHand::new(n_corners, &cubes);
        compare(&mesh, &by_hand);
        println!(
            "{} tetrahedra: {} bytes for each in the mesh, {} in the lists by hand",
            cubes.len(),
            bytes(&mesh) / cubes.len(),
            by_hand.bytes() / cubes.len()
        );
    }
    for n_threads in [1, 0] {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(n_threads)
            .build()
            .expect("threads");
        pool.install(|| {
            let threads = pool.current_num_threads();
            for (order, triangles) in [("coherent", &coherent), ("random", &random)] {
                measure(
                    &format!("{order}, {threads} thread(s), triangles"),
                    n_vertices,
                    || FaceMesh::from_triangles(n_vertices, triangles).expect("valid"),
                );
                measure(
                    &format!("{order}, {threads} thread(s), polygons"),
                    n_vertices,
                    || FaceMesh::from_polygons(n_vertices, triangles).expect("valid"),
                );
            }
            for (order, tetrahedra) in [("coherent", &cubes), ("random", &shuffled_cubes)] {
                let label = format!("{order}, {threads} thread(s)");
                measure_tetrahedra(&label, n_corners, tetrahedra);
            }
        });
    }
}
