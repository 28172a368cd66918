//! Small valid files with bytes flipped, cut, doubled and replaced by what breaks readers: whatever comes
//! of it, no panic. The same mutations every time: a failure names its seed.

mod common;

use std::panic::catch_unwind;

use common::{document, glb, le_bytes};
use onering_io::{Format, read, read_as};

const ROUNDS: u64 = 50_000;

/// A generator of Marsaglia's (xorshift64*): small, and the same on every machine.
struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 33) as usize % bound
    }
}

/// Words that readers stumble over.
const WORDS: [&[u8]; 14] = [
    b"0",
    b"-1",
    b"4294967295",
    b"4294967296",
    b"18446744073709551615",
    b"1e400",
    b"nan",
    b"\"\"",
    b"null",
    b"[]",
    b"{}",
    b"\\\n",
    b"/",
    b"\xFF",
];

fn mutate(file: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = file.to_vec();
    for _ in 0..=random.below(4) {
        let at = random.below(bytes.len() + 1);
        let end = (at + random.below(9)).min(bytes.len());
        match random.below(6) {
            0 => bytes.truncate(at),
            1 => bytes[at..end].iter_mut().for_each(|byte| *byte ^= 1 << random.below(8)),
            2 => drop(bytes.drain(at..end)),
            3 => bytes.extend_from_within(at..end),
            4 => drop(bytes.splice(at..at, [random.below(256) as u8])),
            _ => drop(bytes.splice(at..end, WORDS[random.below(WORDS.len())].iter().copied())),
        }
    }
    bytes
}

fn survive(name: &str, file: &[u8], format: Format) {
    assert!(read_as(file, format).is_ok(), "{name} is to be valid before it is broken");
    let mut outcomes = [0; 2];
    for seed in 1..=ROUNDS {
        let bytes = mutate(file, &mut Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15)));
        let result = catch_unwind(|| {
            let _ = (read(&bytes), Format::of_content(&bytes));
            #[cfg(feature = "tobj")]
            let _ = onering_io::obj_attributes::read(&bytes);
            read_as(&bytes, format)
        });
        let result =
            result.unwrap_or_else(|_| panic!("{name}, seed {seed}: {}", String::from_utf8_lossy(&bytes)));
        if let Ok(mesh) = &result {
            let count = mesh.positions.len() as u32;
            assert!(mesh.faces.iter().flatten().all(|corner| *corner < count), "{name}, seed {seed}");
        }
        outcomes[usize::from(result.is_ok())] += 1;
    }
    // Mutations that always break the file, or never, would test one path only.
    assert!(outcomes.iter().all(|count| *count > ROUNDS / 50), "{name}: {outcomes:?}");
}

#[test]
fn broken_obj() {
    let text = "# a\no b\nmtllib c.mtl\nv 0 0 0\nv 1.5 -2e3 .5 1\nv 1 1 0\nvt 0 1\nvn 0 0 1\nusemtl d\n\
                f 1 2 3\nf 1/1 2/1 \\\n 3/1\r\nf -1//1 -2//1 -3//1\nl 1 2\ns off\nf 1/1/1 2/1/1 3/1/1 1/1/1\n";
    survive("OBJ", text.as_bytes(), Format::Obj);
}

#[test]
fn broken_ascii_stl() {
    let loops = "outer loop\nvertex 0 0 0\nvertex 1.5 -2e3 .5\nvertex nan 1 0\nendloop\nendfacet\n";
    let text =
        format!("solid a b\nfacet normal 0 0 1\n{loops}facet normal -nan(ind) 0 0\r\n{loops}endsolid a b\n");
    survive("ASCII STL", text.as_bytes(), Format::Stl);
}

#[test]
fn broken_binary_stl() {
    let mut file = vec![b' '; 80];
    file.extend(3u32.to_le_bytes());
    file.extend([7; 150]);
    survive("binary STL", &file, Format::Stl);
}

#[test]
fn broken_off() {
    let text = "# a\nCOFF\n4 3 0\n0 0 0 1 1 1 1\n1 0 0 # b\n\n1 1 0\r\n0 1e3 -.5\n3 0 1 2 255 0 0\n4 0 1 2 3\n2 0 1\n";
    survive("OFF", text.as_bytes(), Format::Off);
    survive("plain OFF", text.replace('C', "").replace(" 1 1 1 1", "").as_bytes(), Format::Off);
}

/// A strip, a sparse list and a fan, on 4 positions, 6 indices of 16 bits and 1 replaced position.
fn members(buffer: &str) -> String {
    format!(
        r#""buffers":[{{"byteLength":76{buffer}}}],
        "bufferViews":[{{"buffer":0,"byteLength":48,"byteStride":12}},{{"buffer":0,"byteOffset":48,"byteLength":12}},
          {{"buffer":0,"byteOffset":60,"byteLength":4}},{{"buffer":0,"byteOffset":64,"byteLength":12}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":{{"count":1,
          "indices":{{"bufferView":2,"componentType":5121}},"values":{{"bufferView":3}}}}}},
          {{"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"mode":5}},
          {{"attributes":{{"POSITION":0}},"indices":1}},{{"attributes":{{"POSITION":0}},"mode":6}}]}}]"#
    )
}

fn buffer() -> Vec<u8> {
    let indices = [0u16, 1, 2, 2, 1, 3].map(u16::to_le_bytes).concat();
    [le_bytes(&[0.5; 12]), indices, vec![3, 0, 0, 0], le_bytes(&[1.0, 2.0, 3.0])].concat()
}

#[test]
fn broken_glb() {
    survive("GLB", &glb(&document(&members("")), &buffer()), Format::Glb);
}

#[test]
fn broken_gltf() {
    // 76 bytes are 102 digits of base64: all zero will do.
    let uri = format!(r#","uri":"data:;base64,{}""#, "A".repeat(102));
    survive("glTF", document(&members(&uri)).as_bytes(), Format::Gltf);
}

#[test]
fn broken_x3d() {
    let text = "<?xml version='1.0'?><!DOCTYPE X3D><X3D><Scene><!-- c --><Group DEF='g'>\n<IndexedFaceSet ccw='false' \
                coordIndex='0 1 2 -1, 2 1 0 1'><Coordinate DEF=\"a\" point='0 0 0&#10;1 .5 0 -1e1 1 0'/></IndexedFaceSet></Group>\
                <IndexedTriangleStripSet index='0 1 2 0 -1 1'><Coordinate USE='a'/></IndexedTriangleStripSet><Box/>&lt;\
                <ProtoDeclare><TriangleSet/></ProtoDeclare><IndexedTriangleSet index='0 1 2'><Coordinate USE='a'/>\
                </IndexedTriangleSet></Scene></X3D>";
    survive("X3D", text.as_bytes(), Format::X3d);
}

#[test]
fn broken_vrml() {
    let text = "#VRML V2.0 utf8\nPROTO p [ field SFNode a NULL ] { Box { } }\nWorldInfo { title \"a\\\"}\" }\nShape { geometry\n\
                IndexedFaceSet { ccw FALSE coord DEF a Coordinate { point [ 0 0 0, 1 .5 0 # c\n -1e1 1 0 ] }\n\
                coordIndex [ 0 1 2 -1, 2 1 0 1 ] } }\nGroup { children [ IndexedTriangleFanSet { coord USE a index [ 0 1 2 0\n\
                -1 1 ] } DEF b TriangleSet { coord USE a } USE b ] }\nROUTE a.b TO c.d\n";
    survive("VRML", text.as_bytes(), Format::Vrml);
}
