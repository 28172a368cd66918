//! Files cut at every length, and with bytes changed: an error of one line, or a mesh whose corners exist.

use onering_io::{Format, read_as};

use super::{FACES, VERTICES, binary, faces, point_bytes, text};

fn samples() -> Vec<Vec<u8>> {
    let declarations = format!(
        "comment c\n{VERTICES}property uchar red\nelement face 2\nproperty int a\n{FACES}element edge 1\n\
         property list uchar short b\nelement tristrips 1\nproperty list int int vertex_indices\n"
    );
    let rows = point_bytes().chunks(12).flat_map(|point| [point, &[7]].concat()).collect::<Vec<u8>>();
    let ints = |numbers: &[i32]| numbers.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<u8>>();
    let body = [
        rows,
        ints(&[9]),
        vec![3],
        ints(&[0, 1, 2, 9]),
        vec![4],
        ints(&[0, 1, 2, 3]),
        vec![2, 1, 0, 2, 0],
        ints(&[5, 0, 1, 2, -1, 3]),
    ];
    let little = binary(&declarations, &body.concat());
    let words = "0 0 0 7\n1 0 0 7\n1 1 0 7\n0 1 0.5 7\n9 3 0 1 2\n9 4 0 1 2 3\n2 1 2\n5 0 1 2 -1 3\n";
    vec![little, text(&declarations, words).into_bytes(), faces(2, "3 0 1 2\r\n4 0 1 2 3").into_bytes()]
}

fn survives(file: &[u8]) -> bool {
    match read_as(file, Format::Ply) {
        Ok(mesh) => {
            assert!(mesh.faces.iter().flatten().all(|corner| (*corner as usize) < mesh.positions.len()));
            true
        }
        Err(error) => {
            let line = error.to_string();
            assert!(!line.contains(char::is_control), "{line:?}");
            false
        }
    }
}

#[test]
fn cut_at_every_length() {
    for file in samples() {
        assert!(survives(&file));
        // In text, the last index may lose digits, and the line end need not be.
        for length in 0..file.len() - 2 {
            assert!(!survives(&file[..length]), "{}", String::from_utf8_lossy(&file[..length]));
        }
    }
}

#[test]
fn every_byte_changed() {
    for file in samples() {
        let mut outcomes = [0; 2];
        for at in 0..file.len() {
            for byte in (0..8).map(|bit| file[at] ^ 1 << bit).chain([0, b'\n', b'-', b'9', 0xFF]) {
                let mut damaged = file.clone();
                damaged[at] = byte;
                outcomes[usize::from(survives(&damaged))] += 1;
            }
        }
        assert!(outcomes.iter().all(|count| *count > 100), "{outcomes:?}");
    }
}

/// What the header declares is not believed: neither time nor memory is spent on it.
#[test]
fn huge_counts_cost_nothing() {
    for count in ["4000000000", "4294967295", "18446744073709551615"] {
        for file in [&samples()[0], &samples()[1]] {
            for declaration in ["vertex 4", "face 2", "edge 1", "tristrips 1"] {
                let at = file
                    .windows(declaration.len())
                    .position(|bytes| bytes == declaration.as_bytes())
                    .unwrap();
                let (name, _) = declaration.split_once(' ').unwrap();
                let huge =
                    [&file[..at], format!("{name} {count}").as_bytes(), &file[at + declaration.len()..]]
                        .concat();
                assert!(!survives(&huge));
            }
        }
    }
}
