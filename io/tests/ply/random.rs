//! Any layout that a header can declare gives the same arrays.

use proptest::collection::vec;
use proptest::prelude::*;

use super::read;

const TYPES: [&str; 8] = ["char", "uint8", "short", "uint16", "int", "uint32", "float", "float64"];
const ENCODINGS: [&str; 3] = ["ascii", "binary_little_endian", "binary_big_endian"];

/// What a property is, and where its values come from.
#[derive(Clone)]
enum Property {
    Axis(usize, &'static str),
    Corners(&'static str, &'static str),
    Junk(&'static str),
    JunkList(&'static str, &'static str),
}

/// Chooses a layout, and writes in it.
struct Writer {
    choices: Vec<usize>,
    encoding: usize,
    header: String,
    body: Vec<u8>,
}

impl Writer {
    fn choose(&mut self, bound: usize) -> usize {
        self.choices.rotate_left(1);
        self.choices[0] % bound
    }

    fn shuffle<T>(&mut self, list: &mut [T]) {
        for i in 1..list.len() {
            let j = self.choose(i + 1);
            list.swap(i, j);
        }
    }

    fn number_type(&mut self) -> &'static str {
        TYPES[self.choose(8)]
    }

    fn integer_type(&mut self) -> &'static str {
        TYPES[self.choose(6)]
    }

    /// The value fits every type.
    fn value(&mut self, kind: &str, value: u8) {
        let number = i32::from(value);
        let mut bytes = match kind {
            _ if self.encoding == 0 => {
                let blank = [" ", "\n", "\t \r\n"][self.choose(3)];
                return self.body.extend(format!("{number}{blank}").bytes());
            }
            "char" | "uint8" => vec![value],
            "short" | "uint16" => (number as i16).to_le_bytes().to_vec(),
            "int" | "uint32" => number.to_le_bytes().to_vec(),
            "float" => (number as f32).to_le_bytes().to_vec(),
            _ => f64::from(number).to_le_bytes().to_vec(),
        };
        if self.encoding == 2 {
            bytes.reverse();
        }
        self.body.extend(bytes);
    }

    fn list(&mut self, length: &str, item: &str, values: &[u8]) {
        self.value(length, values.len() as u8);
        values.iter().for_each(|value| self.value(item, *value));
    }

    fn junk(&mut self) -> Vec<Property> {
        (0..self.choose(3))
            .map(|_| match self.choose(2) {
                0 => Property::Junk(self.number_type()),
                _ => Property::JunkList(self.integer_type(), self.number_type()),
            })
            .collect()
    }

    /// An element of these rows, with further properties.
    fn element(&mut self, name: &str, mut properties: Vec<Property>, rows: &[Vec<u8>]) {
        properties.extend(self.junk());
        self.shuffle(&mut properties);
        self.header += &format!("comment c\nelement {name} {}\n", rows.len());
        let corners = ["vertex_indices", "vertex_index"][self.choose(2)];
        for (i, property) in properties.iter().enumerate() {
            self.header += &match property {
                Property::Axis(axis, kind) => format!("property {kind} {}\n", ["x", "y", "z"][*axis]),
                Property::Corners(length, item) => format!("property list {length} {item} {corners}\n"),
                Property::Junk(kind) => format!("property {kind} junk{i}\n"),
                Property::JunkList(length, item) => format!("property list {length} {item} junk{i}\n"),
            };
        }
        for row in rows {
            for property in &properties {
                match property {
                    Property::Axis(axis, kind) => self.value(kind, row[*axis]),
                    Property::Corners(length, item) => self.list(length, item, row),
                    Property::Junk(kind) => self.value(kind, 77),
                    Property::JunkList(length, item) => {
                        let values = vec![3; self.choose(4)];
                        self.list(length, item, &values);
                    }
                }
            }
        }
    }

    fn file(mut self, points: &[Vec<u8>], polygons: &[Vec<u8>]) -> Vec<u8> {
        let mut elements = [0, 1, 2, 3];
        self.shuffle(&mut elements);
        // Half of the files are of the common types, many rows of which are read at once.
        let common = self.choose(2) == 0;
        for element in elements {
            match element {
                0 => {
                    let kinds = [(); 3].map(|()| if common { "float" } else { self.number_type() });
                    let axes = (0..3).map(|axis| Property::Axis(axis, kinds[axis])).collect();
                    self.element("vertex", axes, points);
                }
                1 => {
                    let kinds =
                        if common { ("uint8", "int") } else { (self.integer_type(), self.integer_type()) };
                    self.element("face", vec![Property::Corners(kinds.0, kinds.1)], polygons);
                }
                other => {
                    let rows = vec![vec![]; self.choose(4)];
                    self.element(["edge", "material"][other - 2], vec![], &rows);
                }
            }
        }
        let encoding = ENCODINGS[self.encoding];
        let header = format!("ply\nformat {encoding} 1.0\n{}end_header\n", self.header);
        [header.into_bytes(), self.body].concat()
    }
}

proptest! {
    #[test]
    fn any_layout_gives_the_same_arrays(
        choices in vec(any::<usize>(), 97),
        encoding in 0..3usize,
        points in vec(vec(0..128u8, 3), 1..20),
        corners in vec(vec(any::<u8>(), 3..7), 0..20),
    ) {
        let polygons: Vec<Vec<u8>> =
            corners.iter().map(|row| row.iter().map(|corner| corner % points.len() as u8).collect()).collect();
        let writer = Writer { choices, encoding, header: String::new(), body: Vec::new() };
        let file = writer.file(&points, &polygons);
        let mesh = read(&file);
        let positions: Vec<[f32; 3]> = points.iter().map(|p| [p[0], p[1], p[2]].map(f32::from)).collect();
        let fans = |p: &Vec<u8>| (2..p.len()).map(|k| [p[0], p[k - 1], p[k]].map(u32::from)).collect::<Vec<_>>();
        prop_assert_eq!(mesh.positions, positions);
        prop_assert_eq!(mesh.faces, polygons.iter().flat_map(fans).collect::<Vec<_>>());
        prop_assert_eq!(mesh.polygon_sizes.values().sum::<usize>(), polygons.len());
    }
}
