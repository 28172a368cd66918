//! Files packed with gzip.

use std::io::Write;

use flate2::{Compression, write::GzEncoder};
use onering_io::{Error, Format, MeshRef};

const SQUARE: &[u8] = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

fn packed(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

#[test]
fn a_packed_file_is_what_is_in_it() {
    let plain = onering_io::read(SQUARE).unwrap();
    assert_eq!(onering_io::read(&packed(SQUARE)).unwrap(), plain);
    assert_eq!(onering_io::read_as(&packed(SQUARE), Format::Obj).unwrap(), plain);
    // Two members one after the other are one file.
    let (head, tail) = SQUARE.split_at(20);
    assert_eq!(onering_io::read(&[packed(head), packed(tail)].concat()).unwrap(), plain);
}

#[test]
fn damage_is_an_error_at_every_byte_and_length() {
    let whole = packed(SQUARE);
    for length in 3..whole.len() {
        assert!(matches!(onering_io::read(&whole[..length]), Err(Error::Gzip { .. })), "{length}");
    }
    let mut damaged = whole.clone();
    let middle = whole.len() - 6;
    damaged[middle] ^= 1;
    let error = onering_io::read(&damaged).unwrap_err().to_string();
    assert!(error.starts_with("gzip: "), "{error}");
}

#[test]
fn a_bomb_is_refused() {
    // 64 MiB of line ends in 64 kB.
    let bomb = packed(&vec![b'\n'; 64 << 20]);
    assert!(bomb.len() < 1 << 17);
    let error = onering_io::read_as(&bomb, Format::Obj).unwrap_err().to_string();
    assert_eq!(error, "gzip: it unpacks to more than 16777216 bytes, out of all proportion");
}

#[test]
fn a_name_with_gz_is_written_packed() {
    let path = std::env::temp_dir().join(format!("onering-gzip-{}.obj.gz", std::process::id()));
    let mesh = onering_io::read(SQUARE).unwrap();
    onering_io::save(&path, MeshRef::from(&mesh)).unwrap();
    let bytes = std::fs::read(&path).unwrap();
    let read = onering_io::load(&path);
    std::fs::remove_file(&path).unwrap();
    assert!(bytes.starts_with(&[0x1F, 0x8B]));
    assert_eq!(read.unwrap(), mesh);
}

#[test]
fn what_is_packed_twice_is_refused() {
    let error = onering_io::read(&packed(&packed(SQUARE))).unwrap_err().to_string();
    assert_eq!(error, "gzip: what is packed is itself packed with gzip");
}

/// Sixteen kilobytes that stand for a document of blanks, and that for millions of elements.
#[test]
fn what_is_named_again_and_again_is_measured_by_the_packed_file() {
    let count = 1 << 20;
    let mut document = format!(
        r#"{{"asset":{{"version":"2.0"}},"accessors":[{{"componentType":5126,"type":"VEC3","count":{count}}}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"mode":5}}]}}]}}"#
    );
    document.extend(std::iter::repeat_n(' ', count));
    assert!(onering_io::read(document.as_bytes()).is_ok());
    let error = onering_io::read(&packed(document.as_bytes())).unwrap_err().to_string();
    assert!(error.contains("out of all proportion") || error.contains("far more than"), "{error}");
}
