//! The surface that an example works on, and the frame of its program.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use glam::DVec3;
use iheartmesh::{FaceMesh, io};

use super::picture::Picture;
use super::timing::{nanoseconds_per_vertex, time_best_of};

/// Prints a line; where the other end of a pipe has closed, the program goes on and writes its files.
macro_rules! say {
    ($($line:tt)*) => {{
        use std::io::Write;
        let _ = writeln!(std::io::stdout(), $($line)*);
    }};
}
pub(crate) use say;

/// Where examples put their results, in the folder they were started in.
pub const OUTPUT: &str = "out";

/// The surface that is taken when none is named, from the root of the repository.
const SPOT: &str = "meshes/spot.ply";

/// A surface mesh from a file.
pub struct Surface {
    /// Name of the file.
    pub name: String,
    pub positions: Vec<DVec3>,
    pub mesh: FaceMesh,
    /// How long it took to build `mesh` from the faces of the file.
    pub construction: Duration,
    /// From where it is best seen, as azimuth and elevation in degrees.
    view: (f64, f64),
}

/// Runs an example on the file that its argument names, or on Spot the cow. Mistakes of the user and
/// bad files end the program with a message and the exit code 1.
pub fn run(example: &str, study: fn(&Surface) -> Result<(), Box<dyn Error>>) -> ExitCode {
    run_on(example, SPOT, study)
}

/// As [`run`], on another surface than Spot; its path is that from the root of the repository.
pub fn run_on(
    example: &str,
    bundled: &str,
    study: fn(&Surface) -> Result<(), Box<dyn Error>>,
) -> ExitCode {
    let usage = format!(
        "usage: cargo run --release --example {example} [-- FILE]\n\
         FILE is a mesh in OBJ, OFF or PLY; without it, {bundled} is taken."
    );
    let arguments: Vec<_> = std::env::args_os().skip(1).collect();
    let path = match &arguments[..] {
        [] => in_repository(bundled),
        [argument] if argument == "--help" || argument == "-h" => {
            say!("{usage}");
            return ExitCode::SUCCESS;
        }
        [argument] if !argument.to_string_lossy().starts_with('-') => PathBuf::from(argument),
        [argument] => {
            eprintln!(
                "error: there is no option `{}`\n{usage}",
                argument.to_string_lossy()
            );
            return ExitCode::FAILURE;
        }
        _ => {
            eprintln!(
                "error: {} arguments instead of one\n{usage}",
                arguments.len()
            );
            return ExitCode::FAILURE;
        }
    };
    match Surface::read(path).and_then(|surface| {
        surface.describe();
        study(&surface)
    }) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

impl Surface {
    fn read(path: PathBuf) -> Result<Surface, Box<dyn Error>> {
        let file = io::read(&path)?;
        if file.polygons.is_empty() {
            return Err(format!("{}: no faces, but a surface needs some", path.display()).into());
        }
        let runs = runs_for(file.positions.len()).min(20);
        let (construction, mesh) = time_best_of(runs, || file.face_mesh());
        // Spot looks along -z, other surfaces in any direction.
        let view = if path == in_repository(SPOT) {
            (218.0, 14.0)
        } else {
            (-35.0, 20.0)
        };
        let mesh = mesh.map_err(|error| format!("{}: {error}", path.display()))?;
        Ok(Surface {
            name: path
                .file_name()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned(),
            positions: file.positions,
            mesh,
            construction,
            view,
        })
    }

    /// Prints sizes and topology.
    fn describe(&self) {
        let mesh = &self.mesh;
        let (v, e, f) = (mesh.n_vertices(), mesh.n_edges(), mesh.n_faces());
        let chi = mesh.euler_characteristic();
        say!("{}", self.name);
        print_fact(
            "sizes",
            &format!("V = {v}, E = {e}, F = {f}, χ = V - E + F = {chi}"),
        );
        for (what, count) in [
            (
                "at the boundary",
                format!(
                    "{} edges, {} vertices",
                    mesh.boundary_edges().len(),
                    mesh.boundary_vertices().len()
                ),
            ),
            (
                "not manifold",
                format!(
                    "{} edges with more than two faces",
                    mesh.non_manifold_edges().len()
                ),
            ),
            (
                "isolated",
                format!("{} vertices without a face", mesh.isolated_vertices().len()),
            ),
        ] {
            if !count.starts_with('0') {
                print_fact(what, &count);
            }
        }
        if !mesh.is_consistently_oriented() {
            print_fact("orientation", "not the same for all faces");
        }
    }

    /// An empty picture of this surface.
    pub fn picture(&self, title: &str) -> Picture {
        let (azimuth, elevation) = self.view;
        Picture::new(title).view(azimuth, elevation)
    }

    /// Writes values at the vertices as `NAME.ply`, with their colours, and as the picture `NAME.png`.
    pub fn write_vertex_scalar(
        &self,
        name: &str,
        title: &str,
        what: &str,
        values: &[f64],
    ) -> Result<(), Box<dyn Error>> {
        let [ply, png] = ["ply", "png"].map(|kind| format!("{OUTPUT}/{name}.{kind}"));
        self.picture(title)
            .subtitle(&format!("{}: {what}", self.name))
            .scalar_field(&self.positions, self.faces(), values)
            .write_png(&png)?;
        let attributes = io::Attributes::new()
            .vertex_scalar(name, values)
            .vertex_colors(super::colour::colours(values));
        io::write(&ply, &self.positions, &self.mesh, &attributes)?;
        say!("wrote {ply} and {png}");
        Ok(())
    }

    /// The faces as lists of vertex numbers.
    pub fn faces(&self) -> Vec<Vec<u32>> {
        let mesh = &self.mesh;
        let corners = |face| {
            mesh.face_vertices(face)
                .iter()
                .map(|v| v.index() as u32)
                .collect()
        };
        mesh.faces().map(corners).collect()
    }

    /// The triangles, if the hand-written loops can run on them: oriented alike, with at most two at an edge.
    pub fn manifold_triangles(&self) -> Option<&[[u32; 3]]> {
        let mesh = &self.mesh;
        let manifold = mesh.is_consistently_oriented() && mesh.non_manifold_edges().is_empty();
        mesh.triangles().filter(|_| manifold)
    }

    /// How often a computation over all vertices runs when it is timed.
    pub fn runs(&self) -> usize {
        runs_for(self.positions.len())
    }
}

fn in_repository(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

fn runs_for(n_vertices: usize) -> usize {
    (1_000_000 / n_vertices.max(1)).clamp(3, 300)
}

/// Prints what something is.
pub fn print_fact(what: &str, fact: &str) {
    say!("  {what:<17}{fact}");
}

/// Prints an explanation below a fact.
pub fn print_why(why: &str) {
    say!("{:19}{why}", "");
}

/// Prints a duration in a column of times.
pub fn print_time(what: &str, duration: Duration, n_vertices: usize) {
    let whole = format!("{duration:.1?}");
    let per_vertex = nanoseconds_per_vertex(duration, n_vertices);
    say!("  {what:<46}{whole:>9}{per_vertex:>9.1} ns per vertex");
}

/// Says which values there are; not finite are those of elements without a value.
pub fn print_range(what: &str, unit: &str, values: &[f64]) {
    let finite = values.iter().copied().filter(|value| value.is_finite());
    let low = finite.clone().fold(f64::INFINITY, f64::min);
    let high = finite.clone().fold(f64::NEG_INFINITY, f64::max);
    if low <= high {
        print_fact(what, &format!("{low:.6} to {high:.6} {unit}"));
    }
    let missing = values.len() - finite.count();
    if missing > 0 {
        print_fact(
            "without a value",
            &format!("{missing} of {} vertices", values.len()),
        );
    }
}

/// The largest difference between two lists of values where both are finite.
pub fn largest_difference(left: &[f64], right: &[f64]) -> f64 {
    let differences = left
        .iter()
        .zip(right)
        .map(|(left, right)| (left - right).abs());
    differences
        .filter(|difference| difference.is_finite())
        .fold(0.0, f64::max)
}

/// `rayon`'s pool of one thread, to time what is parallel on one thread.
pub fn one_thread() -> Result<rayon::ThreadPool, rayon::ThreadPoolBuildError> {
    rayon::ThreadPoolBuilder::new().num_threads(1).build()
}
