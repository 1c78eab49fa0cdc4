//! Animated PNG files.

use std::fs::File;
use std::io::{self, BufWriter};
use std::path::Path;

use tiny_skia::Pixmap;

/// Writes frames of one size as an animation that repeats, each shown for `milliseconds`, at a third of its size.
///
/// # Errors
/// If the file cannot be written.
pub fn write_animation(path: &Path, frames: &[Pixmap], milliseconds: u16) -> io::Result<()> {
    let Some(first) = frames.first() else {
        return Err(io::Error::other("an animation has at least one frame"));
    };
    let (width, height) = (first.width() / 3, first.height() / 3);
    let mut encoder = png::Encoder::new(BufWriter::new(File::create(path)?), width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    encoder.set_animated(frames.len() as u32, 0)?;
    encoder.set_frame_delay(milliseconds, 1000)?;
    let mut writer = encoder.write_header()?;
    for frame in frames {
        writer.write_image_data(&third(frame, width, height))?;
    }
    writer.finish()?;
    Ok(())
}

/// The mean of each 3 × 3 pixels: red, green, blue.
fn third(frame: &Pixmap, width: u32, height: u32) -> Vec<u8> {
    let pixels = frame.pixels();
    let mut bytes = Vec::with_capacity(3 * (width * height) as usize);
    for y in 0..height {
        for x in 0..width {
            let mut sums = [0_u32; 3];
            for place in 0..9 {
                let pixel =
                    pixels[((3 * y + place / 3) * frame.width() + 3 * x + place % 3) as usize];
                let parts = [pixel.red(), pixel.green(), pixel.blue()];
                (0..3).for_each(|k| sums[k] += u32::from(parts[k]));
            }
            bytes.extend(sums.map(|sum| ((sum + 4) / 9) as u8));
        }
    }
    bytes
}
