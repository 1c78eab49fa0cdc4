//! What the standard neighbourhoods say where a neighbour is missing.

#[allow(dead_code)]
mod support;

use iheartmesh::neighborhoods::Neighborhoods;
use iheartmesh::{CellularSet, Edge, Face, FaceMesh, Set, Vertex};

both_ways! {
    Program, PlainProgram = "tests/programs/neighborhoods.hlang";
}

/// What functions say that have no value on two triangles of a square; the place is in the source of the library.
#[test]
fn what_is_missing_is_said() {
    let mesh = FaceMesh::from_triangles(4, &[[0, 1, 2], [0, 2, 3]]).unwrap();
    let rust = Neighborhoods::new(&mesh).unwrap();
    let program = Program::new(&mesh).unwrap();
    let plain = PlainProgram::new(&mesh).unwrap();
    let (v, f, e) = (Vertex::new, Face::new(0), Edge::new(0));
    let source = Neighborhoods::SOURCE;
    let place = |definition: &str, what: &str| {
        let start = source.find(&format!("\n{definition} =")).unwrap() + 1;
        let at = start + source[start..].find(what).unwrap();
        let line_start = source[..at].rfind('\n').map_or(0, |k| k + 1);
        let line = source[..at].matches('\n').count() + 1;
        let column = source[line_start..at].chars().count() + 1;
        format!(
            "the set has no member 1 in `{what}` (neighborhoods/src/Neighborhoods.hlang:{line}:{column})"
        )
    };
    let edge = place("EdgeIndex(i, j)", "S_1");
    let face = place("FaceIndex(i, j, k)", "S_1");
    let next = place("NextVertexAroundFace(f, v)", "vset_1");
    let previous = place("PreviousVertexAroundFace(f, v)", "vset_1");
    let opposite = place("OppositeFaces(e)", "T_1");
    let sides = place("OrientedOppositeFaces(i, j)", "T_1");
    let back = place("OrientedOppositeFaces(i, j)", "S_1");
    // a program tells the place in its own text
    let own = |call: &str, name: &str, place: &str| {
        format!("`{name}` has no value in `{call}` (tests/programs/neighborhoods.hlang:{place})")
    };
    let in_face = own(
        "NeighborVerticesInFace(f, v)",
        "NeighborVerticesInFace",
        "40:14",
    );
    let beside = own(
        "OrientedOppositeFaces(i, j)",
        "OrientedOppositeFaces",
        "45:15",
    );
    for (error, call, reason) in [
        (
            rust.try_EdgeIndex(v(1), v(3)).err(),
            "EdgeIndex(vertex 1, vertex 3)",
            &edge,
        ),
        (
            rust.try_FaceIndex(v(0), v(1), v(3)).err(),
            "FaceIndex(vertex 0, vertex 1, vertex 3)",
            &face,
        ),
        (
            rust.try_NextVertexAroundFace(f, v(3)).err(),
            "NextVertexAroundFace(face 0, vertex 3)",
            &next,
        ),
        (
            rust.try_PreviousVertexAroundFace(f, v(3)).err(),
            "PreviousVertexAroundFace(face 0, vertex 3)",
            &previous,
        ),
        (
            rust.try_NeighborVerticesInFace(f, v(3)).err(),
            "NeighborVerticesInFace(face 0, vertex 3)",
            &next,
        ),
        (
            rust.try_OrientedVertices((v(0), v(1), v(3))).err(),
            "OrientedVertices(vertex 0, vertex 1, vertex 3)",
            &face,
        ),
        (
            rust.try_OppositeFaces(e).err(),
            "OppositeFaces(edge 0)",
            &opposite,
        ),
        (
            rust.try_OppositeFaces_all().err(),
            "OppositeFaces(edge 0)",
            &opposite,
        ),
        (
            rust.try_OrientedOppositeFaces(v(0), v(1)).err(),
            "OrientedOppositeFaces(vertex 0, vertex 1)",
            &sides,
        ),
        (
            rust.try_OrientedOppositeFaces(v(1), v(0)).err(),
            "OrientedOppositeFaces(vertex 1, vertex 0)",
            &back,
        ),
        (
            rust.try_OppositeVertices(e).err(),
            "OppositeVertices(edge 0)",
            &opposite,
        ),
        (
            rust.try_OppositeVertices((v(0), v(1))).err(),
            "OppositeVertices(vertex 0, vertex 1)",
            &sides,
        ),
        (
            program.try_both(f, v(3)).err(),
            "both(face 0, vertex 3)",
            &in_face,
        ),
        (
            plain.try_both(f, v(3)).err(),
            "both(face 0, vertex 3)",
            &in_face,
        ),
        (
            program.try_sides(v(0), v(1)).err(),
            "sides(vertex 0, vertex 1)",
            &beside,
        ),
        (
            plain.try_sides(v(0), v(1)).err(),
            "sides(vertex 0, vertex 1)",
            &beside,
        ),
    ] {
        assert_eq!(
            error.unwrap().to_string(),
            format!("`{call}` has no value: {reason}")
        );
    }
    for (error, expected) in [
        (
            rust.try_Faces(v(4)).err(),
            "parameter `v` of `Faces` is vertex 4, which is not in `V` (4 members)",
        ),
        (
            rust.try_Edges(Set::from([v(1), v(9)])).err(),
            "parameter `S` of `Edges` is vertex 9, which is not in `V` (4 members)",
        ),
        (
            rust.try_Faces(CellularSet {
                faces: Set::from([Face::new(7)]),
                ..CellularSet::default()
            })
            .err(),
            "parameter `S` of `Faces` is face 7, which is not in `M` (2 members)",
        ),
    ] {
        assert_eq!(error.unwrap().to_string(), expected);
    }
}
