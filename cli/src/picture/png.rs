//! PNG files.

use super::Picture;
use crate::failure::Failure;
use onering_io::Replacement;
use png::{BitDepth, ColorType, Compression, Encoder, EncodingError};
use std::io::{self, BufWriter, Write};

/// Writes the picture to a file that was opened for it; `name` is what to call that.
pub(crate) fn write(picture: &Picture, name: &str, file: Replacement) -> Result<(), Failure> {
    let failed = |error: &dyn std::fmt::Display| Failure::Output(format!("{name}: {error}"));
    let mut buffered = BufWriter::new(file);
    encode(picture, &mut buffered).map_err(|error| failed(&error))?;
    let file = buffered.into_inner().map_err(|error| failed(&error.into_error()))?;
    file.finish().map_err(|error| failed(&error))
}

/// 8 bits a channel, sRGB.
fn encode(picture: &Picture, out: impl Write) -> Result<(), EncodingError> {
    let size = [picture.width, picture.height].map(u32::try_from);
    let [Ok(width), Ok(height)] = size else {
        return Err(io::Error::from(io::ErrorKind::InvalidInput).into());
    };
    let mut encoder = Encoder::new(out, width, height);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::High);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(picture.pixels.as_flattened())?;
    writer.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_decoder_gives_the_pixels_back() {
        let pixels = (0..6).map(|i| [i, 2 * i, 255 - i]).collect();
        let picture = Picture { width: 3, height: 2, pixels };
        let mut bytes = Vec::new();
        encode(&picture, &mut bytes).unwrap();
        let mut reader = png::Decoder::new(io::Cursor::new(bytes)).read_info().unwrap();
        let mut decoded = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut decoded).unwrap();
        assert_eq!((info.width, info.height, info.color_type), (3, 2, ColorType::Rgb));
        assert_eq!(decoded, picture.pixels.as_flattened());
    }
}
