//! Cell meshes: every accessor and matrix against a definition that is slow and obvious.

use std::collections::BTreeMap;

use iheartmesh_runtime::{BoundaryMatrix, Cell, CellMesh, Edge, Face, Set, Vertex};

#[path = "../../tests/support/random.rs"]
#[allow(dead_code)]
mod random;
#[path = "../../tests/support/solids.rs"]
#[allow(dead_code)]
mod solids;

use solids::Solid;

fn entries(matrix: &BoundaryMatrix) -> BTreeMap<(usize, usize), i8> {
    matrix
        .iter()
        .map(|(&value, (row, column))| ((row as usize, column as usize), value))
        .collect()
}

fn check_matrix(
    name: &str,
    mesh: &CellMesh,
    k: usize,
    shape: (usize, usize),
    sign: impl Fn(u32, u32) -> i8,
) {
    let mut expected = BTreeMap::new();
    for row in 0..shape.0 {
        for column in 0..shape.1 {
            let entry = sign(row as u32, column as u32);
            assert_eq!(
                mesh.complex().boundary_entry(k, row, column),
                entry,
                "{name} {k}"
            );
            if entry != 0 {
                expected.insert((row, column), entry);
            }
        }
    }
    let transposed = |entries: &BTreeMap<(usize, usize), i8>| -> BTreeMap<(usize, usize), i8> {
        entries
            .iter()
            .map(|(&(r, c), &sign)| ((c, r), sign))
            .collect()
    };
    let ones = |entries: &BTreeMap<(usize, usize), i8>| -> BTreeMap<(usize, usize), i8> {
        entries.keys().map(|&place| (place, 1)).collect()
    };
    assert_eq!(mesh.boundary(k).shape(), shape, "{name} {k}");
    assert_eq!(
        mesh.boundary_transpose(k).shape(),
        (shape.1, shape.0),
        "{name} {k}"
    );
    assert_eq!(entries(mesh.boundary(k)), expected, "{name} {k}");
    assert_eq!(
        entries(mesh.boundary_transpose(k)),
        transposed(&expected),
        "{name} {k}"
    );
    assert_eq!(
        entries(mesh.unsigned_boundary(k)),
        ones(&expected),
        "{name} {k}"
    );
    assert_eq!(
        entries(mesh.unsigned_boundary_transpose(k)),
        transposed(&ones(&expected)),
        "{name} {k}"
    );
}

/// Compares all of a mesh but the order of the vertices of its cells with the lists of sides.
fn check(solid: &Solid, mesh: &CellMesh) {
    let name = &solid.name;
    let [n, n_edges, n_faces, n_cells] = solid.sizes().map(|n| n as usize);
    assert_eq!(
        [
            mesh.n_vertices(),
            mesh.n_edges(),
            mesh.n_faces(),
            mesh.n_cells()
        ],
        [n, n_edges, n_faces, n_cells],
        "{name}"
    );
    let vertex_sign = |v: u32, e: u32| match solid.edges[e as usize] {
        [tail, _] if tail == v => -1,
        [_, head] if head == v => 1,
        _ => 0,
    };
    check_matrix(name, mesh, 1, (n, n_edges), vertex_sign);
    check_matrix(name, mesh, 2, (n_edges, n_faces), |e, f| {
        solid.edge_sign(e, f)
    });
    check_matrix(name, mesh, 3, (n_faces, n_cells), |f, c| {
        solid.face_sign(f, c)
    });
    for k in [2, 3] {
        if mesh.boundary(k).nnz() > 0 {
            let product = &mesh.boundary(k - 1).map(|&sign| i32::from(sign))
                * &mesh.boundary(k).map(|&sign| i32::from(sign));
            assert!(product.data().iter().all(|&entry| entry == 0), "{name} {k}");
        }
    }
    for v in mesh.vertices() {
        assert_eq!(
            mesh.vertex_edges(v).ids(),
            solid.touching(0, &[v.id()], 1),
            "{name}"
        );
    }
    for e in mesh.edges() {
        assert_eq!(
            mesh.edge_vertices(e).map(Vertex::id),
            solid.edges[e.index()],
            "{name}"
        );
        assert_eq!(
            mesh.edge_faces(e).ids(),
            solid.touching(1, &[e.id()], 2),
            "{name}"
        );
    }
    for f in mesh.faces() {
        assert_eq!(
            mesh.face_vertices(f).ids(),
            solid.faces[f.index()],
            "{name}"
        );
        assert_eq!(
            mesh.face_boundary(f).0.ids(),
            solid.touching(2, &[f.id()], 1),
            "{name}"
        );
        assert_eq!(
            mesh.face_cells(f).ids(),
            solid.touching(2, &[f.id()], 3),
            "{name}"
        );
    }
    for c in mesh.cells() {
        assert_eq!(
            mesh.cell_boundary(c).0.ids(),
            solid.touching(3, &[c.id()], 2),
            "{name}"
        );
        let mut vertices = mesh.cell_vertices(c).ids().to_vec();
        vertices.sort_unstable();
        assert_eq!(vertices, solid.touching(3, &[c.id()], 0), "{name}");
    }
    let characteristic = n as i64 - n_edges as i64 + n_faces as i64 - n_cells as i64;
    assert_eq!(mesh.euler_characteristic(), characteristic, "{name}");
    let mut n_components = 0;
    let mut reached: Vec<u32> = Vec::new();
    for v in 0..solid.n {
        if !reached.contains(&v) {
            n_components += 1;
            reached.extend(solid.k_ring(&[v], solid.n.into()));
        }
    }
    assert_eq!(mesh.n_components(), n_components, "{name}");
    let consistent = |f: u32| {
        let signs = (0..n_cells as u32).map(|c| solid.face_sign(f, c));
        let signs: Vec<i8> = signs.filter(|&sign| sign != 0).collect();
        signs.len() == 1 || (signs.len() == 2 && signs[0] + signs[1] == 0)
    };
    assert_eq!(
        mesh.is_consistently_oriented(),
        (0..n_faces as u32).all(consistent),
        "{name}"
    );
    check_boundary_mesh(solid, mesh);
    check_tetrahedra(solid, mesh);
}

/// The boundary is made of the faces with one cell, as that cell has them.
fn check_boundary_mesh(solid: &Solid, mesh: &CellMesh) {
    let all: Vec<u32> = (0..solid.cells.len() as u32).collect();
    let (boundary, faces) = mesh.boundary_mesh().unwrap();
    let ids: Vec<u32> = faces.iter().map(|f| f.id()).collect();
    assert_eq!(ids, solid.boundary_faces(&all), "{}", solid.name);
    assert_eq!(boundary.n_vertices(), mesh.n_vertices());
    for (side, &f) in boundary.faces().zip(&ids) {
        let corners = boundary.face_vertices(side);
        let outward = |side: &[u32]| {
            let mut found = corners.ids().to_vec();
            (0..found.len()).any(|_| {
                found.rotate_left(1);
                found == side
            })
        };
        let sides = solid
            .cells
            .iter()
            .flatten()
            .filter(|s| solid.face_of(s).0 == f);
        assert!(sides.into_iter().all(|s| outward(s)), "{}", solid.name);
    }
}

/// Where all cells are tetrahedra, their vertices are listed, positively oriented where the cells are.
fn check_tetrahedra(solid: &Solid, mesh: &CellMesh) {
    let triangles = |cell: &Vec<Vec<u32>>| cell.len() == 4 && cell.iter().all(|s| s.len() == 3);
    let Some(tetrahedra) = mesh.tetrahedra() else {
        assert!(!solid.cells.iter().all(triangles), "{}", solid.name);
        return;
    };
    for (cell, tetrahedron) in solid.cells.iter().zip(tetrahedra) {
        let mut expected: Vec<(u32, i8)> = cell.iter().map(|side| solid.face_of(side)).collect();
        let mut found: Vec<(u32, i8)> = solids::tetrahedron(*tetrahedron)
            .iter()
            .map(|side| solid.face_of(side))
            .collect();
        expected.sort_unstable();
        found.sort_unstable();
        assert_eq!(found, expected, "{}", solid.name);
    }
}

/// The mesh from its sides, and again from its matrices.
fn check_polyhedra(solid: &Solid) {
    let mesh = CellMesh::from_polyhedra(solid.n as usize, &solid.cells).unwrap();
    check(solid, &mesh);
    let [d1, d2, d3] = [1, 2, 3].map(|k| mesh.boundary(k));
    check(
        solid,
        &CellMesh::from_boundary_matrices(d1, d2, d3).unwrap(),
    );
    let [d1, d2, d3] = [d1, d2, d3].map(|matrix| matrix.to_csr());
    check(
        solid,
        &CellMesh::from_boundary_matrices(&d1, &d2, &d3).unwrap(),
    );
}

#[test]
fn meshes_by_property() {
    solids::by_property().iter().for_each(check_polyhedra);
}

#[test]
fn random_polyhedra() {
    (0..80).for_each(|seed| check_polyhedra(&solids::random_polyhedra(seed)));
}

#[test]
fn random_tetrahedra() {
    for seed in 0..120 {
        let (n, cells) = solids::random_tetrahedra(seed);
        let solid = Solid::of_tetrahedra(&format!("tetrahedra {seed}"), n, &cells);
        let mesh = CellMesh::from_tetrahedra(n as usize, &cells).unwrap();
        assert_eq!(mesh.tetrahedra(), Some(&cells[..]));
        check(&solid, &mesh);
        check_polyhedra(&solid);
    }
}

#[test]
fn random_hexahedra() {
    for seed in 0..40 {
        let (n, cells) = solids::random_hexahedra(seed);
        let sides = cells.iter().copied().map(solids::hexahedron).collect();
        let solid = Solid::new(&format!("hexahedra {seed}"), n, sides);
        let mesh = CellMesh::from_hexahedra(n as usize, &cells).unwrap();
        check(&solid, &mesh);
        for (c, corners) in mesh.cells().zip(&cells) {
            assert_eq!(mesh.cell_vertices(c).ids(), corners);
        }
    }
}

/// Numbers and orientations of given matrices are kept: here edges, faces and cells in other orders and directions.
#[test]
fn matrices_keep_their_numbers() {
    let (n, cells) = solids::random_tetrahedra(17);
    let mesh = CellMesh::from_tetrahedra(n as usize, &cells).unwrap();
    // element i becomes element count - 1 - i, every other one turned around
    let turn = |i: usize| if i.is_multiple_of(2) { -1 } else { 1 };
    let changed = |k: usize| {
        let matrix = mesh.boundary(k);
        let (rows, columns) = matrix.shape();
        let mut triplets = sprs::TriMatI::new((rows, columns));
        for (&value, (row, column)) in matrix {
            let (row, column) = (row as usize, column as usize);
            let (sign, row) = match k {
                1 => (turn(column), row),
                _ => (turn(row) * turn(column), rows - 1 - row),
            };
            triplets.add_triplet(row, columns - 1 - column, value * sign);
        }
        triplets.to_csc::<u32>()
    };
    let [d1, d2, d3] = [1, 2, 3].map(changed);
    let other = CellMesh::from_boundary_matrices(&d1, &d2, &d3).unwrap();
    for (k, matrix) in [(1, &d1), (2, &d2), (3, &d3)] {
        assert_eq!(entries(other.boundary(k)), entries(matrix));
    }
    for e in mesh.edges() {
        let [tail, head] = mesh.edge_vertices(e);
        let turned = Edge::new((mesh.n_edges() - 1 - e.index()) as u32);
        let expected = match turn(e.index()) {
            1 => [tail, head],
            _ => [head, tail],
        };
        assert_eq!(other.edge_vertices(turned), expected);
    }
    // every second cell is inside out
    for c in mesh.cells() {
        let turned = Cell::new((mesh.n_cells() - 1 - c.index()) as u32);
        let [expected, found] = [mesh.cell_vertices(c), other.cell_vertices(turned)].map(|cell| {
            let [a, b, c, d] = cell.ids() else {
                panic!("four vertices");
            };
            [*a, *b, *c, *d]
        });
        let inversions = |cell: [u32; 4]| {
            let pairs = (0..4).flat_map(|i| (0..i).map(move |j| (i, j)));
            pairs.filter(|&(i, j)| cell[i] < cell[j]).count()
        };
        let same = inversions(expected) % 2 == inversions(found) % 2;
        assert_eq!(same, turn(c.index()) == 1);
    }
}

/// Large enough for several threads: the result is the same on any number of them.
#[test]
fn threads_do_not_change_the_mesh() {
    let mut random = random::Random(5);
    let n = 3000;
    let cells: Vec<[u32; 4]> = (0..9000)
        .map(|_| random.distinct(n, 4).try_into().unwrap())
        .collect();
    let mixed: Vec<Vec<Vec<u32>>> = (0..3000)
        .map(|_| {
            let v = random.distinct(n, 6);
            match random.below(2) {
                0 => solids::prism(&v[..3], &v[3..]),
                _ => solids::pyramid(&v[..5], v[5]),
            }
        })
        .collect();
    let on = |n_threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(n_threads)
            .build();
        pool.unwrap().install(|| {
            [
                CellMesh::from_tetrahedra(n as usize, &cells).unwrap(),
                CellMesh::from_polyhedra(n as usize, &mixed).unwrap(),
            ]
        })
    };
    let expected = on(1);
    for n_threads in [2, 3, 7] {
        for (mesh, expected) in on(n_threads).iter().zip(&expected) {
            for k in 1..=3 {
                assert_eq!(mesh.boundary(k), expected.boundary(k));
                assert_eq!(mesh.boundary_transpose(k), expected.boundary_transpose(k));
            }
        }
    }
}

#[test]
fn grids() {
    let grid = CellMesh::grid(3, 2, 4).unwrap();
    assert_eq!((grid.n_vertices(), grid.n_cells()), (4 * 3 * 5, 24));
    assert!(grid.is_consistently_oriented());
    assert_eq!((grid.euler_characteristic(), grid.n_components()), (1, 1));
    let vertex = |i: u32, j: u32, k: u32| i + 4 * (j + 3 * k);
    for (i, j, k) in [(0, 0, 0), (2, 1, 3), (1, 0, 2)] {
        let cube = grid
            .cell_vertices(Cell::new(i + 3 * (j + 2 * k)))
            .ids()
            .to_vec();
        let mut expected = Vec::new();
        for (x, y, z) in [
            (0, 0, 0),
            (1, 0, 0),
            (1, 1, 0),
            (0, 1, 0),
            (0, 0, 1),
            (1, 0, 1),
            (1, 1, 1),
            (0, 1, 1),
        ] {
            expected.push(vertex(i + x, j + y, k + z));
        }
        assert_eq!(cube, expected);
    }
    let (boundary, _) = grid.boundary_mesh().unwrap();
    assert!(boundary.is_closed() && boundary.is_consistently_oriented());
    assert_eq!(boundary.n_faces(), 2 * (3 * 2 + 3 * 4 + 2 * 4));
    assert_eq!(CellMesh::grid(0, 2, 2).unwrap().n_cells(), 0);
    for sizes in [
        [usize::MAX, 1, 1],
        [1 << 20, 1 << 20, 1 << 20],
        [1 << 10, 1 << 10, 1 << 11],
        // 1.6·10⁹ vertices, but 38·10⁹ corners of sides
        [40_000, 40_000, 1],
    ] {
        let [nx, ny, nz] = sizes;
        assert!(CellMesh::grid(nx, ny, nz).is_err());
    }
}

#[test]
fn queries() {
    let ids = |set: &Set<Face>| set.iter().map(|f| f.id()).collect::<Vec<_>>();
    // the second shares a face with the first, and is inverted
    let two = [[0, 1, 2, 3], [1, 2, 3, 4]];
    let mesh = CellMesh::from_tetrahedra(6, &two).unwrap();
    assert_eq!(ids(&mesh.boundary_faces()), [0, 1, 2, 4, 5, 6]);
    assert_eq!(mesh.boundary_edges().len(), 9);
    assert_eq!(mesh.boundary_vertices().len(), 5);
    assert_eq!(mesh.isolated_vertices().as_ref(), [Vertex::new(5)]);
    assert!(mesh.non_manifold_faces().is_empty() && !mesh.is_closed());
    let turned = CellMesh::from_tetrahedra(6, &[two[0], [2, 1, 3, 4]]).unwrap();
    assert_ne!(
        mesh.is_consistently_oriented(),
        turned.is_consistently_oriented()
    );
    assert!(mesh.is_orientable() && turned.is_orientable());
    // three tetrahedra at one face
    let three = CellMesh::from_tetrahedra(6, &[two[0], two[1], [1, 2, 3, 5]]).unwrap();
    assert_eq!(ids(&three.non_manifold_faces()).len(), 1);
    assert!(!three.is_orientable() && !three.is_consistently_oriented());
    // a cell and its mirror image close up
    let closed = CellMesh::from_tetrahedra(4, &[[0, 1, 2, 3], [1, 0, 2, 3]]).unwrap();
    assert!(closed.is_closed() && closed.is_consistently_oriented());
    assert!(closed.boundary_vertices().is_empty());
}
