//! Surfaces that carry a checkerboard from the plane, as PNG files.

use std::path::Path;

use glam::{DVec2, DVec3};
use tiny_skia::{Pixmap, PixmapPaint, Transform};

use super::lettering::{Anchor, write};
use super::picture::{fill, rgb};
use super::raster::{Framing, Samples, View, brightness};

const WIDTH: u32 = 1200;
const HEIGHT: u32 = 1000;
const TITLE_HEIGHT: u32 = 110;
const CAPTION_HEIGHT: u32 = 50;
const MARGIN: u32 = 40;
/// The colours of the squares.
const COLOURS: [[u8; 3]; 2] = [[240, 236, 228], [66, 110, 160]];

/// A map of a surface to the plane, with what is said of it.
pub struct Map<'a> {
    /// Where each vertex is in the plane.
    pub plane: &'a [DVec2],
    /// A line below the pictures.
    pub caption: String,
}

/// Draws maps of one surface one below the other: the surface on the left, the plane on the right. The squares are of one
/// size in all maps: `cells` of them have the area of the surface.
///
/// # Errors
/// If the file cannot be written.
pub fn write_maps(
    path: &Path,
    (title, subtitle): (&str, &str),
    (surface, view): (&[DVec3], View),
    triangles: &[[u32; 3]],
    maps: &[Map],
    cells: f64,
) -> std::io::Result<()> {
    let mut pixmap = Pixmap::new(WIDTH, HEIGHT).expect("the size is a valid size");
    let whole = (0.0, 0.0, WIDTH as f32, HEIGHT as f32);
    fill(&mut pixmap, whole, &[rgb([255; 3]), rgb([231, 235, 241])]);
    let ink = rgb([34, 38, 46]);
    let (above, below) = ((48.0, 62.0), (48.0, 94.0));
    write(&mut pixmap, title, above, Anchor::Left, 32.0, ink);
    let grey = rgb([104, 110, 122]);
    write(&mut pixmap, subtitle, below, Anchor::Left, 18.0, grey);

    let area: f64 = triangles
        .iter()
        .map(|t| {
            let [a, b, c] = t.map(|v| surface[v as usize]);
            0.5 * (b - a).cross(c - a).length()
        })
        .sum();
    let side = (area / cells).sqrt();
    let width = (WIDTH - 2 * MARGIN) / 2;
    let row = (HEIGHT - TITLE_HEIGHT) / maps.len().max(1) as u32;
    let height = row - CAPTION_HEIGHT;
    let from_above = View {
        azimuth: 0.0,
        elevation: 0.0,
    };
    for (number, map) in maps.iter().enumerate() {
        let top = TITLE_HEIGHT + number as u32 * row;
        let flat: Vec<DVec3> = map.plane.iter().map(|x| x.extend(0.0)).collect();
        let panels = [(surface, view, true), (&flat, from_above, false)];
        for (column, (positions, view, lit)) in panels.into_iter().enumerate() {
            let framing = Framing::new(positions.iter().copied(), view, [width, height]);
            let mut samples = Samples::new(width, height);
            let seen: Vec<DVec3> = positions.iter().map(|x| view.turn(*x)).collect();
            for triangle in triangles {
                let corners = triangle.map(|v| seen[v as usize]);
                let in_plane = triangle.map(|v| map.plane[v as usize]);
                let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
                samples.fill(corners.map(|x| framing.pixel(x)), |fragment| {
                    let weights = fragment.weights;
                    let [a, b, c] = in_plane;
                    let place = (weights.x * a + weights.y * b + weights.z * c) / side;
                    let number = place.x.floor() + place.y.floor();
                    let colour = COLOURS[usize::from(number.rem_euclid(2.0) == 1.0)];
                    let light = match lit {
                        true => brightness(normal, fragment.front),
                        false => 1.0,
                    };
                    colour.map(|channel| (f64::from(channel) * light).min(255.0) as u8)
                });
            }
            let left = (MARGIN + column as u32 * width) as i32;
            pixmap.draw_pixmap(
                left,
                top as i32,
                samples.to_pixmap().as_ref(),
                &PixmapPaint::default(),
                Transform::identity(),
                None,
            );
        }
        let below = (0.5 * WIDTH as f32, (top + row) as f32 - 18.0);
        write(&mut pixmap, &map.caption, below, Anchor::Middle, 20.0, ink);
    }
    if let Some(directory) = path.parent() {
        std::fs::create_dir_all(directory)?;
    }
    let bytes = pixmap.encode_png().map_err(std::io::Error::other)?;
    std::fs::write(path, bytes)
}
