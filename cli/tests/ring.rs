//! `.ring` files at the shell: any backend in, any out.
#![cfg(target_endian = "little")]

mod common;

use common::{FAN, SQUARE, fresh, inspect, onering, onering_with_input};
use onering::registry::BACKENDS;
use std::fs;
use std::io::Write;

#[test]
fn every_backend_goes_into_a_file_and_comes_out_again() {
    let start = fresh("ring", "square.obj", SQUARE);
    let expected = inspect(&start);
    for backend in BACKENDS.iter().map(|backend| backend.name) {
        let ring = start.with_file_name(format!("{backend}.ring"));
        let run = onering(["convert", start.to_str().unwrap(), ring.to_str().unwrap(), "--backend", backend]);
        assert_eq!(run.code, Some(0), "{run:?}");
        let file = onering::ring::File::read(&ring).unwrap();
        assert_eq!(file.backend(), backend);
        if backend == "vertex-graph" {
            assert!(run.err.contains("no faces"), "{run:?}");
            let run = onering(["inspect".as_ref(), ring.as_os_str()]);
            assert!(run.code == Some(2) && run.err.contains("which has no faces"), "{run:?}");
            continue;
        }
        let found = inspect(&ring);
        for figure in ["vertices", "triangles", "bbox_min", "bbox_max", "verdict", "tri_canonical_sha256"] {
            assert_eq!(found[figure], expected[figure], "{backend}: {figure}");
        }
        assert_eq!(found["format"], "ring");
        let back = start.with_file_name(format!("{backend}.ply"));
        let run = onering(["convert", ring.to_str().unwrap(), back.to_str().unwrap()]);
        assert_eq!((run.code, run.out.as_str()), (Some(0), ""), "{run:?}");
        assert_eq!(inspect(&back)["tri_canonical_sha256"], expected["tri_canonical_sha256"]);
    }
}

#[test]
fn a_backend_that_refuses_the_mesh_leaves_the_old_file() {
    let start = fresh("refused", "fan.obj", FAN);
    let ring = start.with_file_name("out.ring");
    fs::write(&ring, "old").unwrap();
    let arguments = ["convert", start.to_str().unwrap(), ring.to_str().unwrap(), "--backend", "che-l2"];
    let run = onering(arguments);
    assert!(run.code == Some(1) && run.err.contains("--repair"), "{run:?}");
    assert_eq!(fs::read(&ring).unwrap(), b"old");
    let run = onering(arguments.iter().copied().chain(["--repair"]));
    assert_eq!(run.code, Some(0), "{run:?}");
    assert_eq!(inspect(&ring)["topology"]["manifold"], true);
    // Without a name, a backend that takes the mesh as it is.
    let run = onering(["convert", start.to_str().unwrap(), ring.to_str().unwrap()]);
    assert_eq!(run.code, Some(0), "{run:?}");
    assert_eq!(inspect(&ring)["topology"]["nonmanifold_edges"], 1);
}

#[test]
fn through_pipes_and_damaged() {
    let (run, ring) = onering_with_input(
        ["convert", "-", "-", "--from", "obj", "--to", "ring", "--backend", "che-l3"],
        SQUARE.as_bytes(),
    );
    assert_eq!(run.code, Some(0), "{run:?}");
    let (run, obj) = onering_with_input(["convert", "-", "-", "--to", "obj"], &ring);
    assert_eq!(run.code, Some(0), "{run:?}");
    assert_eq!(onering_io::read(&obj).unwrap().faces, onering_io::read(SQUARE.as_bytes()).unwrap().faces);
    let mut damaged = ring;
    *damaged.last_mut().unwrap() ^= 1;
    let (run, _) = onering_with_input(["inspect", "-"], &damaged);
    assert!(run.code == Some(2) && run.err.contains("checksum"), "{run:?}");
}

#[test]
fn what_makes_no_sense_is_refused() {
    let start = fresh("senseless", "square.obj", SQUARE);
    for (out, more) in [("out.ply", "che-l2"), ("out.ring", "no-such"), ("out.ring.gz", "che-l2")] {
        let out = start.with_file_name(out);
        let run = onering(["convert", start.to_str().unwrap(), out.to_str().unwrap(), "--backend", more]);
        assert_eq!(run.code, Some(2), "{run:?}");
        assert!(!out.exists());
    }
}

#[test]
fn a_packed_file_is_unpacked() {
    let start = fresh("packed", "square.obj", SQUARE);
    let ring = start.with_file_name("square.ring");
    assert_eq!(onering(["convert", start.to_str().unwrap(), ring.to_str().unwrap()]).code, Some(0));
    let mut packed = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
    packed.write_all(&fs::read(&ring).unwrap()).unwrap();
    let file = start.with_file_name("square.ring.gz");
    fs::write(&file, packed.finish().unwrap()).unwrap();
    assert_eq!(inspect(&file)["format"], "ring");
    assert_eq!(inspect(&file)["triangles"], 2);
}
