//! The tables.

use iheartmesh::{FaceMesh, Vertex, glam::DVec3};
use rayon::prelude::*;

use crate::baseline::vertex_normals::Weight;
use crate::baseline::{Adjacency, Edges, gaussian_curvature, mean_curvature, vertex_normals};
use crate::generate;
use crate::measure::{Contestant, Effort, contest, contestant};
use crate::programs::{Curvature, GaussianCurvature, MeanCurvature, VertexNormals, without};

/// What is measured, and for how long.
#[derive(Clone, Copy, Debug)]
pub struct Setting {
    /// The largest mesh.
    pub largest: usize,
    /// How long each row takes.
    pub effort: Effort,
}

impl Setting {
    /// Numbers of rings of tori with about 10⁴, 10⁵ and 10⁶ vertices, at least one.
    fn tori(self) -> Vec<(usize, usize)> {
        let tori = [(100, 100), (500, 200), (1000, 1000)];
        let fitting = tori.into_iter().filter(|(a, b)| a * b <= self.largest);
        let tori: Vec<_> = fitting.collect();
        if tori.is_empty() { vec![(12, 8)] } else { tori }
    }
}

/// A torus in one of two numberings, with what the hand-written loops need.
struct Input {
    is_shuffled: bool,
    positions: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    mesh: FaceMesh,
    edges: Edges,
    adjacency: Adjacency,
    edges_of_vertices: Vec<u32>,
}

impl Input {
    fn new((around, along): (usize, usize), is_shuffled: bool) -> Self {
        let (mut positions, mut triangles) = generate::torus(around, along);
        if is_shuffled {
            (positions, triangles) = generate::shuffle(&positions, &triangles, 1);
        }
        let n = positions.len();
        let edges = Edges::new(n, &triangles);
        let adjacency = Adjacency::new(n, &triangles, &edges);
        Input {
            is_shuffled,
            mesh: mesh(&positions, &triangles),
            edges_of_vertices: mean_curvature::edges_of_vertices(&edges, &adjacency),
            edges,
            adjacency,
            positions,
            triangles,
        }
    }

    fn n(&self) -> usize {
        self.positions.len()
    }

    fn order(&self) -> &'static str {
        if self.is_shuffled {
            "shuffled"
        } else {
            "coherent"
        }
    }

    fn all(setting: Setting) -> impl Iterator<Item = Input> {
        let tori = setting.tori().into_iter();
        tori.flat_map(|torus| [false, true].map(|is_shuffled| (torus, is_shuffled)))
            .map(|(torus, is_shuffled)| Input::new(torus, is_shuffled))
    }
}

fn mesh(positions: &[DVec3], triangles: &[[u32; 3]]) -> FaceMesh {
    FaceMesh::from_triangles(positions.len(), triangles).expect("a torus is a mesh")
}

/// One thread, then all.
fn pools() -> Vec<rayon::ThreadPool> {
    let all = std::thread::available_parallelism().map_or(1, |n| n.get());
    let mut sizes = vec![1, all];
    sizes.dedup();
    let pool = |n| rayon::ThreadPoolBuilder::new().num_threads(n).build();
    sizes
        .into_iter()
        .map(|n| pool(n).expect("threads can be started"))
        .collect()
}

/// `value` of each vertex, one call each.
fn each<T: Send>(n: usize, value: impl Fn(Vertex) -> T + Sync) -> Vec<T> {
    let at = |v: usize| value(Vertex::new(v as u32));
    if rayon::current_num_threads() == 1 {
        (0..n).map(at).collect()
    } else {
        (0..n).into_par_iter().with_min_len(2048).map(at).collect()
    }
}

/// A row of the first table: hand-written gather and scatter, each vertex, all vertices.
fn whole_row(setting: Setting, input: &Input, quantity: &str, mut runs: [Contestant<'_>; 4]) {
    let times = contest(setting.effort, &mut runs);
    let [gather, scatter, each, all] =
        [0, 1, 2, 3].map(|k| times[k].as_secs_f64() * 1e9 / input.n() as f64);
    println!(
        "| {quantity} | {} | {} | {} | {gather:.1} | {scatter:.1} | {each:.1} | {all:.1} | {:.2} | {:.2} | {:.2} |",
        input.n(),
        input.order(),
        rayon::current_num_threads(),
        each / gather,
        all / gather,
        all / scatter,
    );
}

/// Values at all vertices, ns for each vertex.
pub fn whole(setting: Setting) {
    println!("\n### Values at all vertices, ns a vertex\n");
    println!(
        "| | vertices | numbering | threads | gather | scatter | `K(v)` | `K_all()` | `K(v)` : gather | `K_all` : gather | `K_all` : scatter |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|");
    for input in Input::all(setting) {
        for pool in pools() {
            pool.install(|| whole_rows(setting, &input));
        }
    }
}

fn whole_rows(setting: Setting, input: &Input) {
    let (x, t, a) = (&input.positions[..], &input.triangles[..], &input.adjacency);
    let n = input.n();
    let is_single = rayon::current_num_threads() == 1;

    let k = GaussianCurvature::plan(&input.mesh, x);
    let runs = [
        contestant(|| match is_single {
            true => gaussian_curvature::gather(x, a),
            false => gaussian_curvature::gather_parallel(x, a),
        }),
        contestant(|| match is_single {
            true => gaussian_curvature::scatter(x, t),
            false => gaussian_curvature::scatter_parallel(x, t, a),
        }),
        contestant(|| each(n, |v| k.K(v))),
        contestant(|| k.K_all()),
    ];
    whole_row(setting, input, "Gaussian curvature", runs);
    drop(k);

    let h = MeanCurvature::plan(&input.mesh, x);
    let (e, of_vertices) = (&input.edges, &input.edges_of_vertices);
    let runs = [
        contestant(|| match is_single {
            true => mean_curvature::gather(x, a),
            false => mean_curvature::gather_parallel(x, a),
        }),
        contestant(|| match is_single {
            true => mean_curvature::scatter(x, t, e),
            false => mean_curvature::scatter_parallel(x, t, e, a, of_vertices),
        }),
        contestant(|| each(n, |v| h.H(v))),
        contestant(|| h.H_all()),
    ];
    whole_row(setting, input, "mean curvature", runs);
    drop(h);

    let normals = VertexNormals::new(&input.mesh, x).expect("a torus has a plan");
    let runs = |weight| {
        let gather = contestant(move || match is_single {
            true => vertex_normals::gather(x, a, weight),
            false => vertex_normals::gather_parallel(x, a, weight),
        });
        let scatter = contestant(move || match is_single {
            true => vertex_normals::scatter(x, t, weight),
            false => vertex_normals::scatter_parallel(x, t, a, weight),
        });
        (gather, scatter)
    };
    let (gather, scatter) = runs(Weight::Max);
    let generated = [
        contestant(|| each(n, |v| normals.N(v))),
        contestant(|| normals.N_all()),
    ];
    let [one, all] = generated;
    whole_row(setting, input, "normals (Max)", [gather, scatter, one, all]);
    let (gather, scatter) = runs(Weight::Area);
    let one = contestant(|| each(n, |v| normals.A(v)));
    let all = contestant(|| normals.A_all());
    whole_row(
        setting,
        input,
        "normals (area)",
        [gather, scatter, one, all],
    );
    let (gather, scatter) = runs(Weight::Angle);
    let one = contestant(|| each(n, |v| normals.B(v)));
    let all = contestant(|| normals.B_all());
    whole_row(
        setting,
        input,
        "normals (angle)",
        [gather, scatter, one, all],
    );
}

/// Making the plans, ns for each vertex.
pub fn plan(setting: Setting) {
    println!("\n### `new`, that is the plan, ns a vertex\n");
    println!(
        "| vertices | numbering | threads | Gaussian curvature | mean curvature | all three normals | hand-written adjacency |"
    );
    println!("|---|---|---|---|---|---|---|");
    for input in Input::all(setting) {
        for pool in pools() {
            pool.install(|| {
                let (mesh, x) = (&input.mesh, &input.positions[..]);
                let mut runs = [
                    contestant(|| GaussianCurvature::plan(mesh, x)),
                    contestant(|| MeanCurvature::plan(mesh, x)),
                    contestant(|| VertexNormals::new(mesh, x)),
                    contestant(|| Adjacency::new(input.n(), &input.triangles, &input.edges)),
                ];
                let times = contest(setting.effort, &mut runs)
                    .iter()
                    .map(|t| format!("{:.0} |", t.as_secs_f64() * 1e9 / input.n() as f64))
                    .collect::<Vec<_>>();
                let threads = rayon::current_num_threads();
                println!(
                    "| {} | {} | {threads} | {}",
                    input.n(),
                    input.order(),
                    times.join(" ")
                );
            });
        }
    }
}

/// One value at a time.
pub fn one(setting: Setting) {
    println!("\n### One value at a random vertex, ns\n");
    println!(
        "`warm`: the same 1000 random vertices again and again. `cold`: other random vertices each time.\n"
    );
    println!(
        "| vertices | numbering | `K(v)` warm | hand-written | `K(v)` cold | hand-written | `H(v)` warm |"
    );
    println!("|---|---|---|---|---|---|---|");
    let pool = &pools()[0];
    for input in Input::all(setting) {
        pool.install(|| {
            let x = &input.positions[..];
            let k = GaussianCurvature::plan(&input.mesh, x);
            let h = MeanCurvature::plan(&input.mesh, x);
            let mut random = fastrand::Rng::with_seed(1);
            let n = input.n();
            let mut vertices =
                |count: usize| -> Vec<u32> { (0..count).map(|_| random.u32(..n as u32)).collect() };
            let (warm, cold) = (vertices(1000), vertices(n.max(1000)));
            let k = &k;
            let generated =
                |vertices: &[u32]| -> f64 { vertices.iter().map(|v| k.K(Vertex::new(*v))).sum() };
            let by_hand = |vertices: &[u32]| -> f64 {
                let at = |v: &u32| gaussian_curvature::at_vertex(x, &input.adjacency, *v as usize);
                vertices.iter().map(at).sum()
            };
            let mean =
                |vertices: &[u32]| -> f64 { vertices.iter().map(|v| h.H(Vertex::new(*v))).sum() };
            let mut runs = [
                contestant(|| (0..16).map(|_| generated(&warm)).sum::<f64>()),
                contestant(|| (0..16).map(|_| by_hand(&warm)).sum::<f64>()),
                contestant(|| generated(&cold)),
                contestant(|| by_hand(&cold)),
                contestant(|| (0..16).map(|_| mean(&warm)).sum::<f64>()),
            ];
            let times = contest(setting.effort, &mut runs);
            let counts = [16_000, 16_000, cold.len(), cold.len(), 16_000];
            let times: Vec<String> = times
                .iter()
                .zip(counts)
                .map(|(t, count)| format!("{:.0} |", t.as_secs_f64() * 1e9 / count as f64))
                .collect();
            println!("| {n} | {} | {}", input.order(), times.join(" "));
        });
    }
}

/// Making meshes.
pub fn mesh_table(setting: Setting) {
    println!("\n### Making the mesh, ns a vertex\n");
    println!(
        "| vertices | numbering | threads | `FaceMesh::from_triangles` | hand-written numbering of edges |"
    );
    println!("|---|---|---|---|---|");
    for input in Input::all(setting) {
        for pool in pools() {
            pool.install(|| {
                let (x, t) = (&input.positions[..], &input.triangles[..]);
                let mut runs = [
                    contestant(|| mesh(x, t)),
                    contestant(|| Edges::new(x.len(), t)),
                ];
                let times = contest(setting.effort, &mut runs);
                let [made, by_hand] = [0, 1].map(|k| times[k].as_secs_f64() * 1e9 / x.len() as f64);
                println!(
                    "| {} | {} | {} | {made:.0} | {by_hand:.0} |",
                    x.len(),
                    input.order(),
                    rayon::current_num_threads()
                );
            });
        }
    }
}

/// What each optimisation is worth: everything else on, this one off.
pub fn without(setting: Setting) {
    println!("\n### With one optimisation switched off, ns a vertex, one thread\n");
    println!("| without | `new` K | `K(v)` | `K_all()` | `new` H | `H(v)` | `H_all()` |");
    println!("|---|---|---|---|---|---|---|");
    let torus = if setting.largest == 0 {
        (12, 8)
    } else {
        (100, 100)
    };
    let input = Input::new(torus, false);
    pools()[0].install(|| {
        without_row::<GaussianCurvature<'_>, MeanCurvature<'_>>(setting, &input, "nothing");
        without_row::<without::GaussianTraverse<'_>, without::MeanTraverse<'_>>(
            setting,
            &input,
            "`traverse`",
        );
        without_row::<without::GaussianInline<'_>, without::MeanInline<'_>>(
            setting, &input, "`inline`",
        );
        without_row::<without::GaussianSteps<'_>, without::MeanSteps<'_>>(
            setting, &input, "`steps`",
        );
        without_row::<without::GaussianShare<'_>, without::MeanShare<'_>>(
            setting, &input, "`share`",
        );
        without_row::<without::GaussianPlan<'_>, without::MeanPlan<'_>>(setting, &input, "`plan`");
        without_row::<without::GaussianFields<'_>, without::MeanFields<'_>>(
            setting, &input, "`fields`",
        );
        without_row::<without::GaussianOrbits<'_>, without::MeanOrbits<'_>>(
            setting, &input, "`orbits`",
        );
        without_row::<without::GaussianAll<'_>, without::MeanAll<'_>>(setting, &input, "`all`");
    });
}

fn without_row<'a, K: Curvature<'a> + Sync, H: Curvature<'a> + Sync>(
    setting: Setting,
    input: &'a Input,
    name: &str,
) {
    let (mesh, x) = (&input.mesh, &input.positions[..]);
    let (k, h) = (K::plan(mesh, x), H::plan(mesh, x));
    let n = input.n();
    let mut runs = [
        contestant(|| K::plan(mesh, x)),
        contestant(|| each(n, |v| k.at(v))),
        contestant(|| k.everywhere()),
        contestant(|| H::plan(mesh, x)),
        contestant(|| each(n, |v| h.at(v))),
        contestant(|| h.everywhere()),
    ];
    let times: Vec<String> = contest(setting.effort, &mut runs)
        .iter()
        .map(|t| format!("{:.0} |", t.as_secs_f64() * 1e9 / n as f64))
        .collect();
    println!("| {name} | {}", times.join(" "));
}
