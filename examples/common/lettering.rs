//! Text in pictures, in DejaVu Sans, which has the letters and signs of mathematics.

use tiny_skia::{Color, FillRule, Paint, Path, PathBuilder, Pixmap, Transform};
use ttf_parser::{Face, OutlineBuilder};

/// Where the given point lies on the line of text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// At its left end.
    Left,
    /// In its middle.
    Middle,
}

/// Writes one line of text with its baseline at the given point; `size` is the height of an em in pixels.
pub fn write(
    pixmap: &mut Pixmap,
    text: &str,
    (x, y): (f32, f32),
    anchor: Anchor,
    size: f32,
    colour: Color,
) {
    let (outline, width) = outline(text, size);
    let Some(path) = outline else { return };
    let left = match anchor {
        Anchor::Left => x,
        Anchor::Middle => x - 0.5 * width,
    };
    let mut paint = Paint::default();
    paint.set_color(colour);
    let place = Transform::from_translate(left, y);
    pixmap.fill_path(&path, &paint, FillRule::Winding, place, None);
}

/// The outline of a line of text that begins at the origin, and its width.
fn outline(text: &str, size: f32) -> (Option<Path>, f32) {
    let face = Face::parse(dejavu::sans::regular(), 0).expect("the built-in font is a font");
    let scale = size / f32::from(face.units_per_em());
    let mut pen = Pen {
        path: PathBuilder::new(),
        x: 0.0,
        scale,
    };
    for character in text.chars() {
        // Glyph 0 is the box that stands for a missing character.
        let glyph = face.glyph_index(character).unwrap_or_default();
        face.outline_glyph(glyph, &mut pen);
        pen.x += scale * f32::from(face.glyph_hor_advance(glyph).unwrap_or(0));
    }
    (pen.path.finish(), pen.x)
}

/// Draws glyphs, in font units with y up, into a path in pixels with y down.
struct Pen {
    path: PathBuilder,
    /// Where the current glyph begins.
    x: f32,
    scale: f32,
}

impl Pen {
    fn pixel(&self, x: f32, y: f32) -> (f32, f32) {
        (self.x + self.scale * x, -self.scale * y)
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.pixel(x, y);
        self.path.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.pixel(x, y);
        self.path.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = (self.pixel(x1, y1), self.pixel(x, y));
        self.path.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2), (x, y)) =
            (self.pixel(x1, y1), self.pixel(x2, y2), self.pixel(x, y));
        self.path.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.path.close();
    }
}

/// A number with three digits, a true minus sign, and powers of ten only where they are needed.
pub fn readable(value: f64) -> String {
    let size = value.abs();
    let text = if size == 0.0 {
        "0".to_owned()
    } else if (1e-3..1e4).contains(&size) {
        let digits = (2 - size.log10().floor() as i32).max(0) as usize;
        format!("{value:.digits$}")
    } else {
        format!("{value:.1e}")
    };
    text.replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_well() {
        let text = [0.0, -0.05126, 12.345, 1234.5, -1e-9].map(readable);
        assert_eq!(text, ["0", "−0.0513", "12.3", "1234", "−1.0e−9"]);
    }
}
