//! Pictures of surfaces with values on them, as PNG files.

use std::path::Path;

use glam::DVec3;
use tiny_skia::{
    Color, GradientStop, LinearGradient, Paint, PathBuilder, Pixmap, PixmapPaint, Point, Rect,
    Shader, SpreadMode, Stroke, Transform,
};

use super::colour::{ColourScale, NOT_FINITE};
use super::lettering::{Anchor, readable, write};
use super::raster::{Framing, Samples, brightness};

pub use super::raster::View;

const WIDTH: u32 = 1200;
const HEIGHT: u32 = 900;
/// The band above the surfaces, for the title.
const TITLE_HEIGHT: u32 = 110;
/// The band below the surfaces, for their captions.
const CAPTION_HEIGHT: u32 = 60;
/// The band to the right of the surfaces, for the colour bar.
const BAR_WIDTH: u32 = 190;
const MARGIN: u32 = 40;

/// The colour of surfaces without values.
const PLAIN: [u8; 3] = [222, 206, 178];

/// A picture of one or several surfaces side by side, all seen from the same side, with one scale of
/// colours for all of them.
pub struct Picture {
    title: String,
    subtitle: String,
    view: View,
    flat: bool,
    edges: bool,
    sequential: bool,
    limit: Option<f64>,
    contours: u32,
    /// What is to fit beside the surfaces.
    around: Vec<DVec3>,
    panels: Vec<Panel>,
}

/// One surface.
struct Panel {
    caption: String,
    positions: Vec<DVec3>,
    triangles: Vec<Triangle>,
    /// One for each vertex; none if the surface is plain.
    values: Vec<f64>,
    /// Without light and edges.
    is_chart: bool,
}

/// A triangle of a polygon.
struct Triangle {
    vertices: [usize; 3],
    /// Whether the side opposite to each vertex is a side of the polygon.
    sides: [bool; 3],
}

impl Picture {
    /// An empty picture with the given title, seen from [`View::THREE_QUARTER`].
    pub fn new(title: &str) -> Picture {
        Picture {
            title: title.to_owned(),
            subtitle: String::new(),
            view: View::THREE_QUARTER,
            flat: false,
            edges: false,
            sequential: false,
            limit: None,
            contours: 0,
            around: Vec::new(),
            panels: Vec::new(),
        }
    }

    /// A smaller line below the title.
    pub fn subtitle(mut self, subtitle: &str) -> Picture {
        self.subtitle = subtitle.to_owned();
        self
    }

    /// From which side the surfaces are seen, in degrees: see [`View`].
    pub fn view(mut self, azimuth: f64, elevation: f64) -> Picture {
        self.view = View { azimuth, elevation };
        self
    }

    /// Shades each face by its own normal instead of smoothly, as polyhedra look best.
    pub fn flat(mut self) -> Picture {
        self.flat = true;
        self
    }

    /// Draws the edges of the mesh as thin lines.
    pub fn edges(mut self) -> Picture {
        self.edges = true;
        self
    }

    /// Colours from dark to bright between the smallest and the largest value, as for distances, instead
    /// of from blue to red around 0.
    pub fn sequential(mut self) -> Picture {
        self.sequential = true;
        self
    }

    /// Draws thin lines along which the values are equal, at `count` values that divide the scale evenly.
    pub fn contours(mut self, count: u32) -> Picture {
        self.contours = count;
        self
    }

    /// Limits the scale to ±`limit`, or to `limit` above if it is sequential, instead of taking the limits from the
    /// values, so that several pictures can be compared.
    pub fn limit(mut self, limit: f64) -> Picture {
        self.limit = Some(limit);
        self
    }

    /// Leaves room for these points.
    pub fn around(mut self, points: &[DVec3]) -> Picture {
        self.around = points.to_vec();
        self
    }

    /// Adds a surface of one colour. `faces` are polygons, counterclockwise as seen from outside.
    pub fn surface<Face: AsRef<[u32]>>(
        self,
        positions: &[DVec3],
        faces: impl IntoIterator<Item = Face>,
    ) -> Picture {
        self.add(positions, faces, &[])
    }

    /// Adds a surface coloured by one value for each vertex; values that are not finite are grey.
    ///
    /// # Panics
    /// If there are not as many values as positions.
    pub fn scalar_field<Face: AsRef<[u32]>>(
        self,
        positions: &[DVec3],
        faces: impl IntoIterator<Item = Face>,
        values: &[f64],
    ) -> Picture {
        assert_eq!(
            values.len(),
            positions.len(),
            "a scalar field has one value for each vertex"
        );
        self.add(positions, faces, values)
    }

    /// Writes a line below the surface that was added last.
    pub fn caption(mut self, caption: &str) -> Picture {
        if let Some(panel) = self.panels.last_mut() {
            panel.caption = caption.to_owned();
        }
        self
    }

    /// Draws the surface that was added last as a chart: without light, shadow and edges.
    pub fn chart(mut self) -> Picture {
        if let Some(panel) = self.panels.last_mut() {
            panel.is_chart = true;
        }
        self
    }

    /// Draws the picture and writes it, with the directories on the way to `path`.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write_png(&self, path: impl AsRef<Path>) -> std::io::Result<()> {
        let path = path.as_ref();
        if let Some(directory) = path.parent() {
            std::fs::create_dir_all(directory)?;
        }
        let bytes = self.draw().encode_png().map_err(std::io::Error::other)?;
        std::fs::write(path, bytes)
    }

    fn add<Face: AsRef<[u32]>>(
        mut self,
        positions: &[DVec3],
        faces: impl IntoIterator<Item = Face>,
        values: &[f64],
    ) -> Picture {
        let mut triangles = Vec::new();
        for face in faces {
            let face = face.as_ref();
            for k in 2..face.len() {
                let vertices = [face[0], face[k - 1], face[k]].map(|vertex| vertex as usize);
                triangles.push(Triangle {
                    vertices,
                    sides: [true, k == face.len() - 1, k == 2],
                });
            }
        }
        let (positions, values) = (positions.to_vec(), values.to_vec());
        self.panels.push(Panel {
            caption: String::new(),
            positions,
            triangles,
            values,
            is_chart: false,
        });
        self
    }

    /// The pixels of the picture.
    pub fn draw(&self) -> Pixmap {
        let mut pixmap = Pixmap::new(WIDTH, HEIGHT).expect("the size is a valid size");
        fill(
            &mut pixmap,
            (0.0, 0.0, WIDTH as f32, HEIGHT as f32),
            &[rgb([255; 3]), rgb([231, 235, 241])],
        );

        let scale = self.scale();
        let bar_width = if scale.is_some() { BAR_WIDTH } else { MARGIN };
        let count = self.panels.len().max(1) as u32;
        let width = (WIDTH - MARGIN - bar_width) / count;
        let height = HEIGHT - TITLE_HEIGHT - CAPTION_HEIGHT;
        let framing = self.framing(width, height);
        let ink = rgb([34, 38, 46]);
        for (number, panel) in self.panels.iter().enumerate() {
            let mut samples = Samples::new(width, height);
            self.draw_panel(&mut samples, panel, scale, &framing);
            let left = (MARGIN + number as u32 * width) as i32;
            let (paint, unmoved) = (PixmapPaint::default(), Transform::identity());
            pixmap.draw_pixmap(
                left,
                TITLE_HEIGHT as i32,
                samples.to_pixmap().as_ref(),
                &paint,
                unmoved,
                None,
            );
            let below = (left as f32 + 0.5 * width as f32, (HEIGHT - 28) as f32);
            write(
                &mut pixmap,
                &panel.caption,
                below,
                Anchor::Middle,
                20.0,
                ink,
            );
        }

        write(
            &mut pixmap,
            &self.title,
            (48.0, 62.0),
            Anchor::Left,
            32.0,
            ink,
        );
        write(
            &mut pixmap,
            &self.subtitle,
            (48.0, 94.0),
            Anchor::Left,
            18.0,
            rgb([104, 110, 122]),
        );
        if let Some(scale) = scale {
            self.draw_bar(&mut pixmap, scale);
        }
        pixmap
    }

    /// The scale for the values of all surfaces; none if there are no values.
    fn scale(&self) -> Option<ColourScale> {
        let values: Vec<f64> = self
            .panels
            .iter()
            .flat_map(|panel| panel.values.iter().copied())
            .collect();
        if values.is_empty() {
            None
        } else if self.sequential {
            let mut scale = ColourScale::sequential(&values);
            scale.high = self.limit.unwrap_or(scale.high);
            Some(scale)
        } else {
            Some(self.limit.map_or_else(
                || ColourScale::diverging(&values),
                ColourScale::diverging_within,
            ))
        }
    }

    /// The largest framing that shows every surface whole in a panel of `width` times `height` pixels.
    fn framing(&self, width: u32, height: u32) -> Framing {
        let points = self.panels.iter().flat_map(|panel| {
            let corners = panel
                .triangles
                .iter()
                .flat_map(|triangle| triangle.vertices);
            corners.map(|vertex| panel.positions[vertex])
        });
        Framing::new(
            points.chain(self.around.iter().copied()),
            self.view,
            [width, height],
        )
    }

    fn draw_panel(
        &self,
        samples: &mut Samples,
        panel: &Panel,
        scale: Option<ColourScale>,
        framing: &Framing,
    ) {
        let seen: Vec<DVec3> = panel.positions.iter().map(|&x| self.view.turn(x)).collect();
        let mut normals = vec![DVec3::ZERO; seen.len()];
        for triangle in &panel.triangles {
            let [i, j, k] = triangle.vertices;
            let normal = (seen[j] - seen[i]).cross(seen[k] - seen[i]);
            triangle
                .vertices
                .into_iter()
                .for_each(|vertex| normals[vertex] += normal);
        }
        normals
            .iter_mut()
            .for_each(|normal| *normal = normal.normalize_or_zero());

        let step = scale.map_or(0.0, |scale| {
            (scale.high - scale.low) / f64::from(self.contours + 1)
        });
        for triangle in &panel.triangles {
            let corners = triangle.vertices.map(|vertex| seen[vertex]);
            let flat = (corners[1] - corners[0])
                .cross(corners[2] - corners[0])
                .normalize_or_zero();
            let smooth = triangle.vertices.map(|vertex| normals[vertex]);
            let values = panel.values.as_slice();
            let values = (!values.is_empty())
                .then(|| DVec3::from(triangle.vertices.map(|vertex| values[vertex])));
            samples.fill(corners.map(|corner| framing.pixel(corner)), |fragment| {
                let weights = fragment.weights;
                let [a, b, c] = smooth;
                let normal = if self.flat {
                    flat
                } else {
                    weights.x * a + weights.y * b + weights.z * c
                };
                let colour = match (values, scale) {
                    (Some(values), Some(scale)) => scale.colour(values.dot(weights)),
                    _ => PLAIN,
                };
                let mut light = match panel.is_chart {
                    true => 1.0,
                    false => brightness(normal, fragment.front),
                };
                if self.edges && !panel.is_chart && fragment.is_on_side(triangle.sides) {
                    light *= 0.55;
                }
                if let (Some(values), Some(scale), 1..) = (values, scale, self.contours)
                    && fragment.is_on_contour(values, scale.low, step)
                {
                    light *= 0.45;
                }
                colour.map(|channel| (f64::from(channel) * light).min(255.0) as u8)
            });
        }
    }

    fn draw_bar(&self, pixmap: &mut Pixmap, scale: ColourScale) {
        let (left, top, width, height) = ((WIDTH - BAR_WIDTH + 34) as f32, 250.0, 24.0, 400.0);
        let stops = 65;
        let at = |number: u16| {
            let place = f64::from(number) / f64::from(stops - 1);
            rgb(scale.colour(scale.high + place * (scale.low - scale.high)))
        };
        let colours: Vec<Color> = (0..stops).map(at).collect();
        fill(pixmap, (left, top, width, height), &colours);

        let ink = rgb([34, 38, 46]);
        let outline = Rect::from_xywh(left, top, width, height).expect("the bar is a rectangle");
        let path = PathBuilder::from_rect(outline);
        let mut paint = Paint::default();
        paint.set_color(rgb([90, 96, 108]));
        pixmap.stroke_path(
            &path,
            &paint,
            &Stroke::default(),
            Transform::identity(),
            None,
        );
        let values = || self.panels.iter().flat_map(|panel| &panel.values).copied();
        let above = values().any(|value| value.is_finite() && value > scale.high);
        let below = values().any(|value| value.is_finite() && value < scale.low);
        for (place, sign, value) in [
            (0.0, if above { "≥ " } else { "" }, scale.high),
            (0.5, "", scale.middle()),
            (1.0, if below { "≤ " } else { "" }, scale.low),
        ] {
            let y = top + place * height;
            fill(pixmap, (left + width, y - 0.5, 7.0, 1.0), &[ink]);
            let beside = (left + width + 13.0, y + 6.5);
            let label = format!("{sign}{}", readable(value));
            write(pixmap, &label, beside, Anchor::Left, 18.0, ink);
        }
        if values().any(|value| !value.is_finite()) {
            let y = top + height + 36.0;
            fill(pixmap, (left, y, width, width), &[rgb(NOT_FINITE)]);
            let beside = (left + width + 13.0, y + 18.5);
            write(pixmap, "not finite", beside, Anchor::Left, 18.0, ink);
        }
    }
}

/// Fills a rectangle, given as left, top, width and height, with colours from its top to its bottom.
pub(super) fn fill(
    pixmap: &mut Pixmap,
    (left, top, width, height): (f32, f32, f32, f32),
    colours: &[Color],
) {
    let last = (colours.len() - 1).max(1) as f32;
    let stops = colours
        .iter()
        .enumerate()
        .map(|(i, &colour)| GradientStop::new(i as f32 / last, colour));
    let (start, end) = (
        Point::from_xy(left, top),
        Point::from_xy(left, top + height),
    );
    let gradient = LinearGradient::new(
        start,
        end,
        stops.collect(),
        SpreadMode::Pad,
        Transform::identity(),
    );
    let shader = gradient.unwrap_or(Shader::SolidColor(colours[0]));
    let paint = Paint {
        shader,
        ..Paint::default()
    };
    let rectangle = Rect::from_xywh(left, top, width, height).expect("positive width and height");
    pixmap.fill_rect(rectangle, &paint, Transform::identity(), None);
}

pub(super) fn rgb([red, green, blue]: [u8; 3]) -> Color {
    Color::from_rgba8(red, green, blue, 255)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_survive_values_that_are_not_finite_and_missing_surfaces() {
        let positions = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::NAN];
        let faces = [[0u32, 1, 2], [0, 1, 3]];
        let values = [0.0, f64::NAN, f64::INFINITY, 1.0];
        for picture in [
            Picture::new("nothing"),
            Picture::new("values")
                .scalar_field(&positions, faces, &values)
                .surface(&positions, faces)
                .contours(3)
                .edges(),
        ] {
            assert_eq!(
                (picture.draw().width(), picture.draw().height()),
                (WIDTH, HEIGHT)
            );
        }
    }
}
