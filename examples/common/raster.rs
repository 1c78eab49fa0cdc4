//! Surfaces in an orthographic view, hidden parts removed with a depth buffer.
//!
//! The few crates that rasterise triangles in software bring matrix libraries and shader traits along;
//! in an orthographic view, where everything interpolates linearly, the loop itself is [`Samples::fill`].

use glam::DVec3;
use tiny_skia::{Pixmap, PremultipliedColorU8};

/// Samples per pixel in each direction; their mean is the pixel, which smooths all edges.
const SAMPLES: u32 = 3;

/// From which side a surface is seen, in degrees; y is up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The angle around the y axis: 0 looks from +z, 90 from +x.
    pub azimuth: f64,
    /// The angle above the horizontal plane.
    pub elevation: f64,
}

impl View {
    /// From the front, the left and a little above.
    pub const THREE_QUARTER: View = View {
        azimuth: -35.0,
        elevation: 20.0,
    };

    /// The unit vectors that point to the right, up, and towards the eye.
    fn axes(self) -> [DVec3; 3] {
        let (azimuth, elevation) = (self.azimuth.to_radians(), self.elevation.to_radians());
        let right = DVec3::new(azimuth.cos(), 0.0, -azimuth.sin());
        let level = DVec3::new(azimuth.sin(), 0.0, azimuth.cos());
        let towards = elevation.cos() * level + elevation.sin() * DVec3::Y;
        [right, towards.cross(right), towards]
    }

    /// A point or a direction in the coordinates of the eye: right, up, towards the eye.
    pub fn turn(self, vector: DVec3) -> DVec3 {
        let [right, up, towards] = self.axes();
        DVec3::new(vector.dot(right), vector.dot(up), vector.dot(towards))
    }
}

/// How the coordinates of the eye become pixels of a panel.
pub struct Framing {
    centre: DVec3,
    pixels: f64,
    middle: DVec3,
}

impl Framing {
    /// The largest framing that shows all points in a panel of so many pixels across and down.
    pub fn new(points: impl Iterator<Item = DVec3>, view: View, size: [u32; 2]) -> Framing {
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for point in points {
            let seen = view.turn(point);
            if seen.is_finite() {
                (low, high) = (low.min(seen), high.max(seen));
            }
        }
        let extent = (high - low).max(DVec3::splat(f64::MIN_POSITIVE));
        let [width, height] = size.map(f64::from);
        Framing {
            centre: 0.5 * (low + high),
            pixels: 0.95 * (width / extent.x).min(height / extent.y),
            middle: DVec3::new(0.5 * width, 0.5 * height, 0.0),
        }
    }

    /// The pixel of a point in the coordinates of the eye.
    pub fn pixel(&self, seen: DVec3) -> DVec3 {
        (seen - self.centre) * self.pixels * DVec3::new(1.0, -1.0, 1.0) + self.middle
    }
}

/// One covered sample of a triangle, as a shader sees it.
pub struct Fragment {
    /// How much each corner of the triangle counts here; the sum is 1.
    pub weights: DVec3,
    /// The gradients of `weights` from pixel to pixel, in x and in y.
    pub gradients: [DVec3; 2],
    /// Whether the triangle turns its front, the side from which it runs counterclockwise, to the eye.
    pub front: bool,
}

impl Fragment {
    /// Whether a point lies within half a line's width of one of the given sides; side k is opposite to
    /// corner k.
    pub fn is_on_side(&self, sides: [bool; 3]) -> bool {
        let [in_x, in_y] = self.gradients;
        let slopes = (in_x * in_x + in_y * in_y).map(f64::sqrt);
        let distances = (self.weights / slopes).to_array();
        distances
            .into_iter()
            .zip(sides)
            .any(|(distance, side)| side && distance < 0.5)
    }

    /// Whether a point lies within half a line's width of one whose value is `low` plus a multiple of
    /// `step`, where `values` are those of the corners.
    pub fn is_on_contour(&self, values: DVec3, low: f64, step: f64) -> bool {
        let [in_x, in_y] = self.gradients.map(|gradient| gradient.dot(values));
        let steps = (values.dot(self.weights) - low) / step;
        (steps - steps.round()).abs() * step < 0.6 * in_x.hypot(in_y)
    }
}

/// How bright a surface is whose normal, in the coordinates of the eye, is `normal`: a lamp above the
/// left shoulder, a weak one from the right, the sky, and half as much on the back of the surface.
pub fn brightness(normal: DVec3, front: bool) -> f64 {
    let normal = if front { normal } else { -normal }.normalize_or_zero();
    let lamp = normal.dot(DVec3::new(-0.43, 0.60, 0.67)).max(0.0);
    let second = normal.dot(DVec3::new(0.80, -0.10, 0.59)).max(0.0);
    let sky = 0.5 + 0.5 * normal.y;
    let light = 0.44 + 0.50 * lamp + 0.12 * second + 0.08 * sky;
    if front { light } else { 0.55 * light }
}

/// A rectangle of samples with their depths.
pub struct Samples {
    width: u32,
    height: u32,
    depths: Vec<f32>,
    /// Red, green, blue; meaningful where the depth is finite.
    colours: Vec<[u8; 3]>,
}

impl Samples {
    /// An empty rectangle of `width` times `height` pixels.
    pub fn new(width: u32, height: u32) -> Samples {
        let (width, height) = (width * SAMPLES, height * SAMPLES);
        let count = width as usize * height as usize;
        let (depths, colours) = (vec![f32::NEG_INFINITY; count], vec![[0; 3]; count]);
        Samples {
            width,
            height,
            depths,
            colours,
        }
    }

    /// Draws a triangle where nothing nearer is drawn yet.
    ///
    /// The corners are in pixels, x to the right, y down; z is larger where it is nearer to the eye.
    pub fn fill(&mut self, corners: [DVec3; 3], shade: impl Fn(&Fragment) -> [u8; 3]) {
        let samples = f64::from(SAMPLES);
        let [a, b, c] =
            corners.map(|corner| DVec3::new(corner.x * samples, corner.y * samples, corner.z));
        let area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        if area == 0.0 || !area.is_finite() {
            return;
        }
        // The weights of the corners are linear in x and y; these are their gradients.
        let in_x = DVec3::new(b.y - c.y, c.y - a.y, a.y - b.y) / area;
        let in_y = DVec3::new(c.x - b.x, a.x - c.x, b.x - a.x) / area;
        let depths = DVec3::new(a.z, b.z, c.z);
        let mut fragment = Fragment {
            weights: DVec3::ZERO,
            gradients: [in_x * samples, in_y * samples],
            front: area < 0.0,
        };

        for y in covered(a.y.min(b.y).min(c.y), a.y.max(b.y).max(c.y), self.height) {
            for x in covered(a.x.min(b.x).min(c.x), a.x.max(b.x).max(c.x), self.width) {
                let (dx, dy) = (f64::from(x) + 0.5 - a.x, f64::from(y) + 0.5 - a.y);
                let weights = DVec3::X + dx * in_x + dy * in_y;
                if weights.min_element() < 0.0 {
                    continue;
                }
                let depth = weights.dot(depths) as f32;
                let place = y as usize * self.width as usize + x as usize;
                if depth > self.depths[place] {
                    fragment.weights = weights;
                    self.depths[place] = depth;
                    self.colours[place] = shade(&fragment);
                }
            }
        }
    }

    /// The picture: each pixel is the mean of its samples, transparent where nothing is drawn.
    pub fn to_pixmap(&self) -> Pixmap {
        let (width, height) = (self.width / SAMPLES, self.height / SAMPLES);
        let mut pixmap = Pixmap::new(width, height).expect("pictures are neither empty nor huge");
        for (number, pixel) in pixmap.pixels_mut().iter_mut().enumerate() {
            *pixel = self.mean(number as u32 % width, number as u32 / width);
        }
        pixmap
    }

    fn mean(&self, x: u32, y: u32) -> PremultipliedColorU8 {
        let mut sum = [0u32; 4];
        for row in y * SAMPLES..(y + 1) * SAMPLES {
            for column in x * SAMPLES..(x + 1) * SAMPLES {
                let place = row as usize * self.width as usize + column as usize;
                if self.depths[place].is_finite() {
                    let [red, green, blue] = self.colours[place].map(u32::from);
                    sum = [sum[0] + red, sum[1] + green, sum[2] + blue, sum[3] + 255];
                }
            }
        }
        let [red, green, blue, alpha] = sum.map(|channel| (channel / (SAMPLES * SAMPLES)) as u8);
        PremultipliedColorU8::from_rgba(red, green, blue, alpha).expect("no channel exceeds alpha")
    }
}

/// The samples of a row or column of `count` whose centres may lie between `low` and `high`.
fn covered(low: f64, high: f64, count: u32) -> std::ops::Range<u32> {
    // Casts to integers saturate, so parts outside the rectangle fall away here.
    (low - 0.5).floor() as u32..((high + 0.5).ceil() as u32).min(count)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearer_triangles_hide_others_in_either_order() {
        let triangle = |z| [(0.0, 0.0), (8.0, 0.0), (0.0, 8.0)].map(|(x, y)| DVec3::new(x, y, z));
        for order in [[1.0, 2.0], [2.0, 1.0]] {
            let mut samples = Samples::new(4, 4);
            for z in order {
                samples.fill(triangle(z), |_| [z as u8; 3]);
            }
            assert!(samples.colours[..12].iter().all(|&colour| colour == [2; 3]));
        }
    }

    #[test]
    fn the_axes_of_a_view_are_right_handed_and_level() {
        let [right, up, towards] = View::THREE_QUARTER.axes();
        assert!((right.cross(up) - towards).length() < 1e-15);
        assert!(right.y == 0.0 && up.y > 0.0);
    }

    #[test]
    fn counterclockwise_triangles_show_their_front() {
        let mut samples = Samples::new(4, 4);
        // In pixels y points down, so this runs counterclockwise as one sees it.
        let corners = [(0.0, 4.0), (4.0, 4.0), (0.0, 0.0)].map(|(x, y)| DVec3::new(x, y, 0.0));
        samples.fill(corners, |fragment| [u8::from(fragment.front); 3]);
        assert!(samples.colours.contains(&[1; 3]));
    }
}
