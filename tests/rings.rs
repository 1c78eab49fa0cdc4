//! Rings that grow by recursion, against distances in the edge graph that another library computed.

#[allow(dead_code)]
mod support;

use iheartmesh::{Set, Vertex};
use support::reference_mesh::ReferenceMesh;
use support::soups::Ids;

both_ways! {
    Rings, PlainRings = "tests/programs/rings.hlang";
}

fn vertices(ids: &[u32]) -> Set<Vertex> {
    ids.iter().copied().map(Vertex::new).collect()
}

#[test]
fn rings_of_the_reference_set() {
    let Some(set) = support::reference_set() else {
        return;
    };
    for entry in std::fs::read_dir(set.join("meshes")).unwrap() {
        let path = entry.unwrap().path();
        let file = path.file_name().unwrap().to_string_lossy().into_owned();
        let is_surface = file.ends_with(".obj") || file.ends_with(".off");
        if !is_surface || file == "bad_dup_isolated.obj" {
            continue;
        }
        let reference = ReferenceMesh::read(&set, &file);
        if let Some(json) = reference.json("neighborhoods.json")
            && let Some(apexes) = json.get("opposite_vertices_of_edge")
        {
            let a = Rings::new(&reference.mesh).unwrap();
            let b = PlainRings::new(&reference.mesh).unwrap();
            for (e, apexes) in apexes.object() {
                let (i, j) = e.split_once('-').unwrap();
                let e = reference.edge(i.parse().unwrap(), j.parse().unwrap());
                let e = iheartmesh::Edge::new(e as u32);
                assert_eq!(a.Apexes(e).ids(), apexes.ids(), "{file} {e}");
                assert_eq!(b.Apexes(e).ids(), apexes.ids(), "{file} {e}");
            }
        }
        let Some(json) = reference.json("krings.json") else {
            continue;
        };
        let a = Rings::new(&reference.mesh).unwrap();
        let b = PlainRings::new(&reference.mesh).unwrap();
        let check_levels = |sources: &[u32], sizes: &[u32]| {
            let sources = vertices(sources);
            for (k, size) in (0i64..).zip(sizes).take(5) {
                assert_eq!(a.level(&sources, k).len() as u32, *size, "{file} {k}");
                assert_eq!(b.level(&sources, k).len() as u32, *size, "{file} {k}");
            }
            if reference.mesh.n_vertices() > 1000 {
                return;
            }
            // the last level that is not empty
            let k = sizes.len() as i64;
            assert_eq!(
                a.level(&sources, k - 1).len() as u32,
                sizes[sizes.len() - 1]
            );
            assert!(a.level(&sources, k).is_empty(), "{file}");
        };
        for single in json.get("single").unwrap().list() {
            let source = single.get("source").unwrap().number() as u32;
            check_levels(&[source], &single.get("topleset_sizes").unwrap().ids());
            for k in 1..=3 {
                let expected = single.get(&format!("within_{k}_ring_excl_source"));
                let Some(expected) = expected else { continue };
                assert_eq!(
                    a.Ring(Vertex::new(source), k).ids(),
                    expected.ids(),
                    "{file}"
                );
                assert_eq!(
                    b.Ring(Vertex::new(source), k).ids(),
                    expected.ids(),
                    "{file}"
                );
            }
        }
        let multi = json.get("multi").unwrap();
        let sources = multi.get("sources").unwrap().ids();
        check_levels(&sources, &multi.get("topleset_sizes").unwrap().ids());
    }
}
