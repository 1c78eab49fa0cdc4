//! What the pass `steps` finds without sets is the first member of these sets, by the interpreter: on a mesh with an edge of
//! three faces, faces that are not oriented alike, a boundary, a polygon and vertices without edges.

#[allow(dead_code, unused_imports, reason = "a part of the tests")]
#[path = "../generate/mod.rs"]
mod generate;

use generate::{Datum, Form, Generated, Polygons, compile, deep, interpret};
use iheartmesh_compiler::interpret::Value;
use iheartmesh_compiler::optimize::Optimizations;

const SOURCE: &str = "
ElementSets, BoundaryMatrices from MeshConnectivity
Edges, Faces, Vertices from Neighborhoods(M)
M : FaceMesh
V, E, F = ElementSets(M)
`∂⁰`, `∂¹` = BoundaryMatrices(M)

between(i, j) = S_1 where i, j ∈ V, S = Edges(i) ∩ Edges(j)
after(f, v) = S_1 where f ∈ F, v ∈ V,
    S = Vertices({ e for e ∈ Edges(f) if `∂¹`_e,f `∂⁰`_v,e = -1 }) - {v}
before(f, v) = S_1 where f ∈ F, v ∈ V,
    S = Vertices({ e for e ∈ Edges(f) if `∂⁰`_v,e `∂¹`_e,f = 1 }) - {v}
left(e, v) = S_1 where e ∈ E, v ∈ V, S = { f for f ∈ Faces(e) if `∂¹`_e,f `∂⁰`_v,e = -1 }
right(e, v) = S_1 where e ∈ E, v ∈ V, S = { f for f ∈ Faces(e) if 1 = `∂¹`_e,f `∂⁰`_v,e }
`not left`(e, v) = S_1 where e ∈ E, v ∈ V, s = Faces(e),
    S = s - { f for f ∈ s if `∂¹`_e,f `∂⁰`_v,e = -1 }
`not right`(e, v) = S_1 where e ∈ E, v ∈ V, s = Faces(e),
    S = s - { f for f ∈ s if `∂⁰`_v,e `∂¹`_e,f = 1 }
";

fn element(id: u32) -> Datum {
    Datum {
        value: Value::Element(id),
        rust: String::new(),
        is_function: false,
    }
}

fn compare() {
    let faces: [&[u32]; 6] = [
        &[0, 1, 2],
        &[1, 0, 3],
        &[0, 1, 4],
        &[5, 6, 0],
        &[6, 5, 1, 7],
        &[2, 1, 8],
    ];
    let counts = [11, 15, faces.len()];
    let mut calls = Vec::new();
    for (name, first) in [
        ("between", 0),
        ("after", 2),
        ("before", 2),
        ("left", 1),
        ("right", 1),
        ("not left", 1),
        ("not right", 1),
    ] {
        for a in 0..counts[first] as u32 {
            for v in 0..counts[0] as u32 {
                calls.push((name.to_owned(), vec![element(a), element(v)]));
            }
        }
    }
    let generated = Generated {
        source: SOURCE.to_owned(),
        mesh: Some(Polygons {
            vertices: counts[0],
            faces: faces.map(<[u32]>::to_vec).to_vec(),
            counts,
        }),
        inputs: Vec::new(),
        definitions: vec!["E".to_owned()],
        calls,
        fields: Vec::new(),
    };
    let outcomes = |optimizations, form| {
        let stages = compile(&generated, optimizations).unwrap_or_else(|e| panic!("{e}"));
        let text = iheartmesh_compiler::ir::program(&stages.staged.as_ref().unwrap().program);
        (interpret(&generated, &stages, form), text)
    };
    let (expected, _) = outcomes(Optimizations::NONE, Form::Checked);
    let (found, text) = outcomes(Optimizations::ALL, Form::Rewritten);
    assert_eq!(expected, found);
    let some = expected.iter().filter(|(_, value)| value != "fault");
    assert!(some.count() > 50);
    // each is found in this way
    for step in [
        "edge between[M](i.",
        "vertex in face -1[M](f.",
        "vertex in face +1[M](f.",
        "face with -1[M](e.",
        "face with +1[M](e.",
        "face without -1[M](e.",
        "face without +1[M](e.",
    ] {
        assert!(text.contains(step), "{step}\n{text}");
    }
}

#[test]
fn neighbors_are_the_first_members_of_their_sets() {
    deep(compare);
}
