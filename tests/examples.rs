//! The programs of the examples: against other libraries on the reference set, and against what is known without it.

#[allow(dead_code)]
mod support;
#[path = "../examples/common/tetrahedra.rs"]
mod tetrahedra;
#[path = "../examples/common/wave.rs"]
mod wave;

use std::collections::BTreeSet;
use std::f64::consts::PI;
use std::path::Path;

use iheartmesh::glam::DVec3;
use iheartmesh::{Face, FaceMesh, Set, Vertex, io};

use support::json::Json;
use support::reference_mesh::{ReferenceMesh, Tolerance, components};
use support::soups::Ids;

both_ways! {
    Winding, PlainWinding = "examples/winding_number.hlang";
    Bilateral, PlainBilateral = "examples/bilateral_filter.hlang";
    Geodesic, PlainGeodesic = "examples/geodesic_distance.hlang";
}

iheartmesh::iheartmesh! {
    /// The listing of section 4.3.4 of the paper.
    pub struct Close = r#"
        ElementSets from MeshConnectivity
        VertexOneRing from Neighborhoods(M)
        M: FaceMesh
        V, E, F = ElementSets( M )
        x_i ∈ ℝ³
        i ∈ V
        d ∈ ℝ
        S = {j for j ∈ VertexOneRing(i) if ||x_i - x_j||² < d}
    "#;
}

#[test]
fn vertices_of_a_ring_that_are_close() {
    let (mesh, x) = bundled("bob_small");
    let d = 0.03;
    let (mut some, mut all) = (0, 0);
    for i in mesh.vertices() {
        let ends = |e| mesh.edge_vertices(e).into_iter().find(|j| *j != i).unwrap();
        let ring: Vec<Vertex> = mesh.vertex_edges(i).iter().map(ends).collect();
        let is_close = |j: &&Vertex| x[i.index()].distance_squared(x[j.index()]) < d;
        let expected: Set<Vertex> = ring.iter().filter(is_close).copied().collect();
        all += ring.len();
        some += expected.len();
        assert_eq!(Close::new(&mesh, &x, i, d).unwrap().S(), expected);
    }
    assert!(0 < some && some < all, "{some} of {all}");
}

fn bundled(name: &str) -> (FaceMesh, Vec<DVec3>) {
    let file = io::read(support::workspace().join(format!("meshes/{name}.ply"))).unwrap();
    (file.face_mesh().unwrap(), file.positions)
}

/// The rows of a table of numbers, and the places of some of its columns.
fn table<const N: usize>(file: &Path, columns: [&str; N]) -> Vec<[f64; N]> {
    let text = std::fs::read_to_string(file).unwrap();
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    let places = columns.map(|c| header.iter().position(|h| *h == c).unwrap());
    let row = |line: &str| {
        let cells: Vec<f64> = line.split(',').map(|x| x.parse().unwrap()).collect();
        places.map(|place| cells[place])
    };
    lines.map(row).collect()
}

// Winding numbers

#[test]
fn solid_angles_of_a_cube() {
    let corners = [0, 1, 2, 3, 4, 5, 6, 7]
        .map(|k| DVec3::new((k & 1).into(), (k >> 1 & 1).into(), (k >> 2).into()));
    let sides = [
        [0u32, 4, 6, 2],
        [1, 3, 7, 5],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 2, 3, 1],
        [4, 5, 7, 6],
    ];
    let halves = sides.map(|[a, b, c, d]| [[a, b, c], [a, c, d]]);
    for n_sides in 1..=6 {
        let triangles: Vec<[u32; 3]> = halves[..n_sides].iter().flatten().copied().collect();
        let mesh = FaceMesh::from_triangles(8, &triangles).unwrap();
        let a = Winding::new(&mesh, corners).unwrap();
        let b = PlainWinding::new(&mesh, corners).unwrap();
        let middle = DVec3::splat(0.5);
        for w in [a.w(middle), b.w(middle)] {
            assert!((w - n_sides as f64 / 6.0).abs() < 1e-14, "{w}");
        }
        for f in mesh.faces() {
            assert!((a.Omega(f, middle) - PI / 3.0).abs() < 1e-14);
            assert!((b.Omega(f, middle) - PI / 3.0).abs() < 1e-14);
        }
    }
}

/// The area of a spherical triangle is the sum of its angles without π (A. Girard, 1629).
#[test]
fn solid_angles_are_areas_on_the_sphere() {
    let (mesh, x) = bundled("fox");
    let winding = Winding::new(&mesh, &x).unwrap();
    let p = DVec3::new(3.0, -10.0, 30.0);
    let (mut total, mut largest) = (0.0, 0.0f64);
    for f in mesh.faces() {
        let d: Vec<DVec3> = mesh
            .face_vertices(f)
            .iter()
            .map(|v| x[v.index()] - p)
            .collect();
        let angle = |k: usize| {
            let [a, b, c] = [0, 1, 2].map(|step| d[(k + step) % 3]);
            a.cross(b).angle_between(a.cross(c))
        };
        let excess = (0..3).map(angle).sum::<f64>() - PI;
        let expected = excess * d[0].dot(d[1].cross(d[2])).signum();
        let found = winding.Omega(f, p);
        assert!((found - expected).abs() < 1e-6, "{f}: {found} {expected}");
        total += found;
        largest = largest.max(found.abs());
    }
    assert!(largest > 0.1);
    assert!((total / (4.0 * PI) - winding.w(p)).abs() < 1e-12);
}

#[test]
fn one_inside_zero_outside() {
    let (mesh, x) = bundled("sphere_small");
    let a = Winding::new(&mesh, &x).unwrap();
    let b = PlainWinding::new(&mesh, &x).unwrap();
    for k in 0..200 {
        let k = f64::from(k);
        let direction = DVec3::new(k.sin(), (2.3 * k).cos(), (0.7 * k).sin()).normalize();
        for (radius, expected) in [(0.9, 1.0), (1.1, 0.0)] {
            let (x, y) = (a.w(radius * direction), b.w(radius * direction));
            assert!((x - expected).abs() < 1e-12, "{x}");
            assert!((x - y).abs() < 1e-14);
        }
    }
}

#[test]
fn holes_of_a_bundled_mesh_are_filled() {
    let (mesh, x) = bundled("bob_small");
    let whole = mesh.triangles().unwrap();
    let is_kept = |t: &&[u32; 3]| !t.iter().any(|v| [0, 100, 200].contains(v));
    let open: Vec<[u32; 3]> = whole.iter().filter(is_kept).copied().collect();
    assert!(open.len() < whole.len());
    let filling = tetrahedra::conforming(&x, &open).unwrap();
    assert_eq!(filling.missing, 0);
    let open = FaceMesh::from_triangles(x.len(), &open).unwrap();
    let winding = Winding::new(&open, &x).unwrap();
    let place = |v: &u32| filling.points[*v as usize];
    let inside = filling
        .tetrahedra
        .iter()
        .map(|t| winding.w(0.25 * t.iter().map(place).sum::<DVec3>()) > 0.5);
    let inside: Vec<bool> = inside.collect();
    let filled = tetrahedra::boundary(&filling.tetrahedra, &inside);
    let surface = FaceMesh::from_triangles(filling.points.len(), &filled).unwrap();
    assert!(surface.is_closed() && surface.is_consistently_oriented());
    let found: BTreeSet<_> = filled.iter().map(|t| tetrahedra::sorted(*t)).collect();
    let kept = filling
        .triangles
        .iter()
        .filter(|t| found.contains(&tetrahedra::sorted(**t)));
    assert!(kept.count() * 100 > filling.triangles.len() * 99);

    // the volume is nearly that of the surface before the holes were cut
    let under = |points: &[DVec3], t: &[u32; 3]| {
        let [a, b, c] = t.map(|v| points[v as usize]);
        a.dot(b.cross(c)) / 6.0
    };
    let before: f64 = whole.iter().map(|t| under(&x, t)).sum();
    let after: f64 = filled.iter().map(|t| under(&filling.points, t)).sum();
    assert!((after / before - 1.0).abs() < 0.02, "{before} {after}");
}

#[test]
fn winding_numbers_of_the_reference_set() {
    let Some(set) = support::reference_set() else {
        return;
    };
    let mut compared = 0;
    for entry in std::fs::read_dir(set.join("meshes")).unwrap() {
        let path = entry.unwrap().path();
        let is_surface = path.extension().is_some_and(|e| e == "obj" || e == "off");
        let file = set
            .join("ref")
            .join(path.file_stem().unwrap())
            .join("winding.csv");
        if !is_surface || !file.is_file() {
            continue;
        }
        let contents = io::read(&path).unwrap();
        let mesh = contents.face_mesh().unwrap();
        let a = Winding::new(&mesh, &contents.positions).unwrap();
        let b = PlainWinding::new(&mesh, &contents.positions).unwrap();
        let rows = table(&file, ["qx", "qy", "qz", "winding"]);
        // without optimisations it is slow
        let stride = 1 + rows.len() * mesh.n_faces() / 100_000;
        for (k, [x, y, z, expected]) in rows.into_iter().enumerate() {
            let p = DVec3::new(x, y, z);
            let w = a.w(p);
            assert!(
                (w - expected).abs() < 1e-11,
                "{}: {w} {expected}",
                path.display()
            );
            if k % stride == 0 {
                assert!((b.w(p) - w).abs() < 1e-12);
            }
        }
        compared += 1;
    }
    assert!(compared >= 9);
}

#[test]
fn holes_of_the_reference_set_are_filled() {
    let Some(set) = support::reference_set() else {
        return;
    };
    for name in ["holefill_bob_small", "holefill_cat_head"] {
        let folder = set.join("ref").join(name);
        let open = io::read(folder.join("input_with_holes.obj")).unwrap();
        let mesh = open.face_mesh().unwrap();
        let winding = Winding::new(&mesh, &open.positions).unwrap();
        let plain = PlainWinding::new(&mesh, &open.positions).unwrap();
        let (points, cells) = medit(&std::fs::read_to_string(folder.join("cdt.mesh")).unwrap());
        let rows = table(
            &folder.join("winding_barycenters.csv"),
            ["tet", "winding", "inside"],
        );
        assert_eq!(rows.len(), cells.len());
        let mut inside = Vec::new();
        for (k, (cell, [number, expected, is_inside])) in cells.iter().zip(rows).enumerate() {
            assert_eq!(number as usize, k);
            let p = 0.25 * cell.iter().map(|v| points[*v as usize]).sum::<DVec3>();
            let w = winding.w(p);
            assert!((w - expected).abs() < 1e-11, "{name} {k}: {w} {expected}");
            if k % 20 == 0 {
                assert!((plain.w(p) - w).abs() < 1e-12);
            }
            assert_eq!(w > 0.5, is_inside == 1.0);
            inside.push(w > 0.5);
        }
        let filled = tetrahedra::boundary(&cells, &inside);
        let filled: BTreeSet<_> = filled.into_iter().map(tetrahedra::sorted).collect();
        let file = folder.join("filled_surface_faces_sorted.json");
        let expected = Json::parse(&std::fs::read_to_string(file).unwrap());
        let triangle = |t: &Json| <[u32; 3]>::try_from(t.ids()).unwrap();
        assert_eq!(filled, expected.list().iter().map(triangle).collect());
    }
}

/// The points and tetrahedra of a MEDIT file, these with positive volume.
fn medit(text: &str) -> (Vec<DVec3>, Vec<[u32; 4]>) {
    let mut words = text.split_whitespace();
    let mut section = |name: &str, width: usize| -> Vec<Vec<f64>> {
        words.find(|word| *word == name).unwrap();
        let n: usize = words.next().unwrap().parse().unwrap();
        let mut row = || {
            (0..width)
                .map(|_| words.next().unwrap().parse().unwrap())
                .collect()
        };
        (0..n).map(|_| row()).collect()
    };
    let points = section("Vertices", 4);
    let points: Vec<DVec3> = points
        .iter()
        .map(|p| DVec3::new(p[0], p[1], p[2]))
        .collect();
    let cells = section("Tetrahedra", 5);
    let oriented = |cell: &Vec<f64>| {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| cell[k] as u32 - 1);
        let [x, y, z, w] = [a, b, c, d].map(|v| points[v as usize]);
        match (y - x).cross(z - x).dot(w - x) < 0.0 {
            true => [a, b, d, c],
            false => [a, b, c, d],
        }
    };
    (points.clone(), cells.iter().map(oriented).collect())
}

// Bilateral filtering

/// The filter as a loop over lists: normals by N. Max's weights, neighbours by a search from the vertex.
struct ByHand<'a> {
    mesh: &'a FaceMesh,
    x: &'a [DVec3],
}

impl ByHand<'_> {
    fn normal(&self, v: Vertex) -> DVec3 {
        let mut sum = DVec3::ZERO;
        for f in self.mesh.faces() {
            let corners: Vec<Vertex> = self.mesh.face_vertices(f).iter().collect();
            if let Some(k) = corners.iter().position(|w| *w == v) {
                let [j, k] =
                    [1, 2].map(|step| self.x[corners[(k + step) % 3].index()] - self.x[v.index()]);
                sum += j.cross(k) / (j.length_squared() * k.length_squared());
            }
        }
        sum.normalize()
    }

    fn near(&self, v: Vertex, radius: f64) -> BTreeSet<Vertex> {
        let (mut found, mut open) = (BTreeSet::from([v]), vec![v]);
        while let Some(w) = open.pop() {
            for e in self.mesh.vertex_edges(w).iter() {
                for q in self.mesh.edge_vertices(e) {
                    let distance = self.x[q.index()].distance(self.x[v.index()]);
                    if distance < radius && found.insert(q) {
                        open.push(q);
                    }
                }
            }
        }
        found.remove(&v);
        found
    }

    fn filtered(&self, v: Vertex, along: f64, across: f64) -> DVec3 {
        let (n, x) = (self.normal(v), self.x[v.index()]);
        let (mut sum, mut weights) = (0.0, 0.0);
        for q in self.near(v, 2.0 * along) {
            let offset = self.x[q.index()] - x;
            let height = n.dot(offset);
            let weight = (-offset.length_squared() / (2.0 * along * along)).exp()
                * (-height * height / (2.0 * across * across)).exp();
            sum += weight * height;
            weights += weight;
        }
        x + n * (sum / weights)
    }
}

#[test]
fn bilateral_filter_by_hand() {
    let (mesh, clean) = bundled("sphere_small");
    // every other vertex is a little outside of the sphere
    let shaken = |(k, x): (usize, &DVec3)| *x * (1.0 + 0.02 * (7.3 * k as f64).sin());
    let noisy: Vec<DVec3> = clean.iter().enumerate().map(shaken).collect();
    let (along, across) = (0.3, 0.05);
    let a = Bilateral::new(&mesh, &noisy, along, across).unwrap();
    let b = PlainBilateral::new(&mesh, &noisy, along, across).unwrap();
    let by_hand = ByHand {
        mesh: &mesh,
        x: &noisy,
    };
    let filtered = field!(a, b, mesh.vertices(), B, B_all);
    let mut sizes = BTreeSet::new();
    for v in mesh.vertices() {
        let near: Set<Vertex> = by_hand.near(v, 2.0 * along).into_iter().collect();
        assert_eq!(a.Near(v), near);
        assert_eq!(b.Near(v), near);
        sizes.insert(near.len());
        assert!(a.N(v).distance(by_hand.normal(v)) < 1e-13);
        assert!(filtered[v.index()].distance(by_hand.filtered(v, along, across)) < 1e-13);
    }
    // more than a ring, and not the same everywhere
    assert!(sizes.len() > 1 && sizes.iter().all(|n| *n > 6), "{sizes:?}");
    // the radii of the vertices come closer to each other
    let spread = |x: &[DVec3]| {
        let mean = x.iter().map(|p| p.length()).sum::<f64>() / x.len() as f64;
        x.iter().map(|p| (p.length() - mean).powi(2)).sum::<f64>()
    };
    assert!(
        spread(&filtered) < 0.3 * spread(&noisy),
        "{} {}",
        spread(&noisy),
        spread(&filtered)
    );
}

#[test]
fn bilateral_filter_of_the_reference_set() {
    let Some(set) = support::reference_set() else {
        return;
    };
    for name in ["bob_small", "fox", "double_torus"] {
        let folder = set.join(format!("ref/bilateral_{name}"));
        let params = Json::parse(&std::fs::read_to_string(folder.join("params.json")).unwrap());
        let number = |name: &str| params.get(name).unwrap().number();
        let reference = ReferenceMesh::read(&set, &format!("{name}.obj"));
        let (mesh, clean) = (&reference.mesh, &reference.positions);
        let noisy = match params.get("amp") {
            None => io::read(folder.join("noisy.obj")).unwrap().positions,
            Some(amplitude) => shaken(mesh, clean, amplitude.number()),
        };
        let (along, across) = (number("sigma_c"), number("sigma_s"));
        let mut a = Bilateral::new(mesh, noisy.clone(), along, across).unwrap();
        assert!((a.rho() - number("rho")).abs() < 1e-12);
        let b = PlainBilateral::new(mesh, noisy, along, across).unwrap();
        let file = folder.join("result.csv");
        let header = std::fs::read_to_string(&file).unwrap();
        let header = header.lines().next().unwrap();
        if header.contains("n_neighbors_excl") {
            for [v, n] in table(&file, ["idx", "n_neighbors_excl"]) {
                assert_eq!(a.Near(Vertex::new(v as u32)).len(), n as usize);
            }
        }
        for [v] in table(&file, ["idx"]).into_iter().step_by(10) {
            let v = Vertex::new(v as u32);
            assert!(a.B(v).distance(b.B(v)) < 1e-12 * along);
        }
        for step in 1..=10 {
            let moved = a.B_all();
            a.set_x(moved.clone()).unwrap();
            let columns = ["x", "y", "z"].map(|axis| format!("max_conn_excl_it{step}_{axis}"));
            if !header.split(',').any(|c| c == columns[0]) {
                continue;
            }
            let [x, y, z] = &columns;
            let largest = moved
                .iter()
                .fold(0.0f64, |m, p| m.max(p.abs().max_element()));
            let bound = if step == 1 { 1e-9 } else { 1e-7 } * largest;
            for [v, x, y, z] in table(&file, ["idx", x, y, z]) {
                let (found, expected) = (moved[v as usize], DVec3::new(x, y, z));
                assert!(
                    found.distance(expected) <= bound,
                    "{name} {v} after {step}: {found} {expected}"
                );
            }
            if step == 1 {
                let values = components(&moved);
                let checksums = params.get("checksums").unwrap();
                let sums = checksums
                    .get("max_conn_excl_it1")
                    .unwrap()
                    .get("sum")
                    .unwrap();
                for (values, sum) in values.iter().zip(sums.numbers()) {
                    assert!(
                        (values.iter().sum::<f64>() - sum).abs() <= bound * values.len() as f64
                    );
                }
            }
        }
    }
}

/// The noise of the reference set: along the normals by areas.
fn shaken(mesh: &FaceMesh, clean: &[DVec3], amplitude: f64) -> Vec<DVec3> {
    let mut normals = vec![DVec3::ZERO; clean.len()];
    for triangle in mesh.triangles().unwrap() {
        let [a, b, c] = triangle.map(|v| clean[v as usize]);
        for v in triangle {
            normals[*v as usize] += (b - a).cross(c - a);
        }
    }
    let height = |k: usize| amplitude * (1.7 * ((k + 1) * (k + 1)) as f64).sin();
    let all = clean.iter().zip(normals).enumerate();
    all.map(|(k, (x, n))| x + height(k) * n.normalize())
        .collect()
}

// Geodesic distance

#[test]
fn a_straight_front_stays_straight() {
    // one triangle, and fronts from all sides that are known at two of its vertices
    let mesh = FaceMesh::from_triangles(3, &[[0, 1, 2]]).unwrap();
    let x = [
        DVec3::new(0.2, 1.0, 0.3),
        DVec3::ZERO,
        DVec3::new(1.0, 0.1, 0.4),
    ];
    let a = Geodesic::new(&mesh, x).unwrap();
    let b = PlainGeodesic::new(&mesh, x).unwrap();
    let [i, j, k] = [0, 1, 2].map(Vertex::new);
    let normal = (x[1] - x[0]).cross(x[2] - x[0]).normalize();
    let right = (x[1] - x[0]).normalize();
    let towards = normal.cross(x[2] - x[1]).normalize();
    let (mut across, mut along) = (0, 0);
    for turn in 0..360 {
        let (sin, cos) = f64::from(turn).to_radians().sin_cos();
        let direction = cos * right + sin * normal.cross(right);
        let d: Vec<f64> = x.iter().map(|p| 5.0 + direction.dot(*p)).collect();
        let (found, plain) = (a.UpdateStep(i, j, k, &d), b.UpdateStep(i, j, k, &d));
        assert!((found - plain).abs() < 1e-13);
        // of the two fronts with these distances at j and k, the one that comes to i from there
        let away = direction - 2.0 * direction.dot(towards).min(0.0) * towards;
        let [to_j, to_k] = [x[1] - x[0], x[2] - x[0]];
        // it crosses the triangle to i if it comes from between j and k as seen from i
        let sides = [away.cross(to_j).dot(normal), to_k.cross(away).dot(normal)];
        if sides.iter().all(|side| *side > 1e-9) {
            across += 1;
            let expected = d[1] - away.dot(to_j);
            assert!(
                (found - expected).abs() < 1e-12,
                "{turn}°: {found} {expected}"
            );
            if direction.dot(towards) > 0.0 {
                assert!((found - d[0]).abs() < 1e-12);
            }
        } else if sides.iter().any(|side| *side < -1e-9) {
            along += 1;
            let shorter = (d[1] + to_j.length()).min(d[2] + to_k.length());
            assert!(
                (found - shorter).abs() < 1e-12,
                "{turn}°: {found} {shorter}"
            );
        }
        assert_eq!(a.Across(Face::new(0), i, &d), found);
        assert_eq!(a.Around(i, &d), found.min(d[0]));
    }
    assert!(across > 40 && along > 100, "{across} {along}");
}

#[test]
fn levels_by_hand() {
    for name in ["bob_small", "fox", "sphere_small"] {
        let (mesh, x) = bundled(name);
        let a = Geodesic::new(&mesh, &x).unwrap();
        let b = PlainGeodesic::new(&mesh, &x).unwrap();
        for sources in [&[0][..], &[3, 40, 41]] {
            let sources: Set<Vertex> = sources.iter().copied().map(Vertex::new).collect();
            let (levels, plain) = (a.Levels(&sources), b.Levels(&sources));
            assert_eq!(levels, plain);
            let mut seen: BTreeSet<u32> = sources.ids().into_iter().collect();
            let mut level = seen.clone();
            for found in &levels {
                assert_eq!(found.ids(), level.iter().copied().collect::<Vec<u32>>());
                let ring = level
                    .iter()
                    .flat_map(|v| mesh.vertex_edges(Vertex::new(*v)).iter());
                let ring = ring.flat_map(|e| mesh.edge_vertices(e)).map(|v| v.id());
                level = ring.filter(|v| !seen.contains(v)).collect();
                seen.extend(&level);
            }
            assert!(level.is_empty());
            assert_eq!(seen.len(), mesh.n_vertices());
        }
    }
}

#[test]
fn items_of_sequences_are_checked() {
    let (mesh, x) = bundled("sphere_small");
    let a = Geodesic::new(&mesh, &x).unwrap();
    let set = |v| Set::from_iter([Vertex::new(v)]);
    assert!(a.try_Next(vec![set(0), set(1)]).is_ok());
    let error = a.try_Next(vec![set(0), set(162)]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "parameter `U` of `Next` is vertex 162, which is not in `V` (162 members)"
    );
}

/// Distances nearest first, with all optimisations and with none, and level by level.
fn distances(mesh: &FaceMesh, x: &[DVec3], source: Vertex) -> [Vec<f64>; 2] {
    let a = Geodesic::new(mesh, x).unwrap();
    let b = PlainGeodesic::new(mesh, x).unwrap();
    let marched = wave::march(mesh, &[source], |f, v, d| a.Across(f, v, d));
    if mesh.n_vertices() < 1000 {
        let plain = wave::march(mesh, &[source], |f, v, d| b.Across(f, v, d));
        for (x, y) in marched.iter().zip(plain) {
            assert!((x - y).abs() <= 1e-12 * x);
        }
    }
    let levels = a.Levels(Set::from_iter([source]));
    let (propagated, rounds) = wave::propagate(mesh, &levels, 1e-3, |v, d| a.Around(v, d));
    assert!(rounds >= levels.len() - 1);
    [marched, propagated]
}

#[test]
fn distances_are_close_to_exact_ones() {
    let file = support::workspace().join("meshes/geodesic_distances.csv");
    let text = std::fs::read_to_string(file).unwrap();
    // the means of the relative errors, a tenth above those of the method on these meshes
    for (name, mean) in [
        ("bob_small", 0.069),
        ("fox", 0.036),
        ("sphere_small", 0.025),
        ("spot", 0.024),
    ] {
        let rows: Vec<(u32, usize, f64)> = text
            .lines()
            .filter_map(|line| line.strip_prefix(name)?.strip_prefix(','))
            .map(|line| {
                let cells: Vec<&str> = line.split(',').collect();
                (
                    cells[0].parse().unwrap(),
                    cells[1].parse().unwrap(),
                    cells[2].parse().unwrap(),
                )
            })
            .collect();
        let (mesh, x) = bundled(name);
        assert!(rows.len() > mesh.n_vertices() / 11);
        for found in distances(&mesh, &x, Vertex::new(rows[0].0)) {
            let errors = rows.iter().map(|(_, v, exact)| found[*v] / exact - 1.0);
            let error = errors.clone().map(f64::abs).sum::<f64>() / rows.len() as f64;
            assert!(error < mean, "{name}: {error}");
            // a path along edges and across triangles is hardly shorter than the shortest
            assert!(errors.clone().all(|e| e > -0.01), "{name}");
        }
    }
}

#[test]
fn distances_of_the_reference_set() {
    let Some(set) = support::reference_set() else {
        return;
    };
    for file in [
        "sphere_small.obj",
        "bob_small.obj",
        "fox.obj",
        "cat_head.obj",
        "spot_tri.obj",
        "double_torus.obj",
    ] {
        let reference = ReferenceMesh::read(&set, file);
        let json = reference.json("geodesic.json").unwrap();
        let source = Vertex::new(json.get("source").unwrap().number() as u32);
        let [marched, propagated] = distances(&reference.mesh, &reference.positions, source);
        let column = ["ptp_fixed_point"];
        reference.check_table(
            "geodesic.csv",
            &column,
            &[marched],
            Tolerance::Relative(1e-9),
        );
        reference.check_table(
            "geodesic.csv",
            &column,
            &[propagated],
            Tolerance::Relative(5e-3),
        );
    }
}
