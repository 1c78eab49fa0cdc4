//! Curves over time, as PNG files.

use std::path::Path;

use tiny_skia::{Color, Paint, PathBuilder, Pixmap, Stroke, Transform};

use super::lettering::{Anchor, readable, write};

const WIDTH: f32 = 1200.0;
const HEIGHT: f32 = 600.0;
const LEFT: f32 = 110.0;
const RIGHT: f32 = 920.0;
const TOP: f32 = 100.0;
const BOTTOM: f32 = 530.0;

/// The colours of the curves.
const COLOURS: [[u8; 3]; 4] = [[196, 62, 60], [58, 110, 178], [70, 140, 84], [34, 38, 46]];

/// Draws curves with their names, all with the same abscissae.
///
/// # Errors
/// If the file cannot be written.
pub fn write_plot(
    path: &Path,
    title: &str,
    across: (&str, &[f64]),
    curves: &[(&str, &[f64])],
) -> std::io::Result<()> {
    let curves: Vec<Curve> = curves
        .iter()
        .map(|(name, values)| {
            let points = across.1.iter().copied().zip(values.iter().copied());
            (*name, points.collect())
        })
        .collect();
    write_curves(path, title, across.0, &curves, false)
}

/// A name and points.
type Curve<'a> = (&'a str, Vec<(f64, f64)>);

/// Draws how curves of positive values fall from step to step, by powers of ten; other values are left out.
///
/// # Errors
/// If the file cannot be written.
pub fn write_convergence(
    path: &Path,
    title: &str,
    curves: &[(&str, &[f64])],
) -> std::io::Result<()> {
    let curves: Vec<Curve> = curves
        .iter()
        .map(|(name, values)| {
            let points = values.iter().enumerate();
            let points = points
                .filter(|(_, value)| **value > 0.0 && value.is_finite())
                .map(|(step, value)| (step as f64, value.log10()));
            (*name, points.collect())
        })
        .collect();
    write_curves(path, title, "step", &curves, true)
}

fn write_curves(
    path: &Path,
    title: &str,
    across: &str,
    curves: &[Curve],
    logarithmic: bool,
) -> std::io::Result<()> {
    if let Some(directory) = path.parent() {
        std::fs::create_dir_all(directory)?;
    }
    let mut pixmap = Pixmap::new(WIDTH as u32, HEIGHT as u32).expect("the size is a valid size");
    pixmap.fill(Color::WHITE);
    let ink = Color::from_rgba8(34, 38, 46, 255);
    write(&mut pixmap, title, (48.0, 56.0), Anchor::Left, 28.0, ink);

    let all = || curves.iter().flat_map(|(_, points)| points);
    let (left, right) = range(all().map(|point| point.0));
    let (low, high) = range(all().map(|point| point.1));
    let (low, high) = match logarithmic {
        true => (low.floor(), high.ceil().max(low.floor() + 1.0)),
        false => (low.min(0.0), high),
    };
    // as many lines as powers of ten, or every second of them, and so on
    let rows = match logarithmic {
        true => {
            let decades = (high - low) as usize;
            decades.div_ceil(decades.div_ceil(10))
        }
        false => 4,
    };
    let high = match logarithmic {
        true => low + rows as f64 * ((high - low) / rows as f64).ceil(),
        false => high,
    };
    let place = |x: f64, y: f64| {
        let u = ((x - left) / (right - left).max(f64::MIN_POSITIVE)) as f32;
        let v = ((y - low) / (high - low).max(f64::MIN_POSITIVE)) as f32;
        (LEFT + u * (RIGHT - LEFT), BOTTOM + v * (TOP - BOTTOM))
    };
    for row in 0..=rows {
        let y = low + row as f64 / rows as f64 * (high - low);
        let ends = [place(left, y), place(right, y)];
        line(&mut pixmap, &ends, [222, 226, 232], 1.0);
        let beside = (LEFT - 60.0, place(left, y).1 + 6.0);
        let label = match logarithmic {
            true => format!("1e{y:.0}").replace('-', "−"),
            false => readable(y),
        };
        write(&mut pixmap, &label, beside, Anchor::Middle, 17.0, ink);
    }
    // whole steps
    let apart = match logarithmic {
        true => (0.25 * right).ceil().max(1.0),
        false => 0.25 * (right - left),
    };
    for column in 0..=4 {
        let x = left + f64::from(column) * apart;
        if logarithmic && x > right {
            break;
        }
        let label = match logarithmic {
            true => format!("{x:.0}"),
            false => readable(x),
        };
        let below = (place(x, low).0, BOTTOM + 28.0);
        write(&mut pixmap, &label, below, Anchor::Middle, 17.0, ink);
    }
    let below = (0.5 * (LEFT + RIGHT), BOTTOM + 56.0);
    write(&mut pixmap, across, below, Anchor::Middle, 18.0, ink);
    for (number, ((name, points), colour)) in curves.iter().zip(COLOURS).enumerate() {
        let points: Vec<(f32, f32)> = points.iter().map(|&(x, y)| place(x, y)).collect();
        line(&mut pixmap, &points, colour, 2.5);
        let y = TOP + 30.0 * number as f32;
        line(
            &mut pixmap,
            &[(RIGHT + 30.0, y), (RIGHT + 60.0, y)],
            colour,
            4.0,
        );
        write(
            &mut pixmap,
            name,
            (RIGHT + 70.0, y + 6.0),
            Anchor::Left,
            18.0,
            ink,
        );
    }
    let bytes = pixmap.encode_png().map_err(std::io::Error::other)?;
    std::fs::write(path, bytes)
}

fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    })
}

fn line(pixmap: &mut Pixmap, points: &[(f32, f32)], [r, g, b]: [u8; 3], width: f32) {
    let mut path = PathBuilder::new();
    for (k, &(x, y)) in points.iter().enumerate() {
        match k {
            0 => path.move_to(x, y),
            _ => path.line_to(x, y),
        }
    }
    let mut paint = Paint::default();
    paint.set_color_rgba8(r, g, b, 255);
    paint.anti_alias = true;
    let stroke = Stroke {
        width,
        ..Stroke::default()
    };
    if let Some(path) = path.finish() {
        pixmap.stroke_path(&path, &paint, &stroke, Transform::identity(), None);
    }
}
