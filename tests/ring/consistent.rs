//! Columns that agree with one another almost everywhere, and are no mesh: what changes made at random do not find.
use onering::columns::{FromColumns, Invalid, Source};
use onering::storage::{Borrowed, Element};
use onering::{CheL2, CheL3, DirectedEdgesSmall, FromFaces, HalfEdgeMesh, MateFace};
use std::collections::BTreeMap;

type Words = BTreeMap<&'static str, Vec<u32>>;

/// Columns of words.
struct Columns<'a>(&'a Words, (usize, usize));

impl<'a> Source<Borrowed<'a>> for Columns<'a> {
    fn vertex_count(&self) -> usize {
        self.1.0
    }

    fn face_count(&self) -> usize {
        self.1.1
    }

    fn column<T: Element>(&self, column: &'static str, length: Option<usize>) -> Result<&'a [T], Invalid> {
        let cells: &[T] = bytemuck::cast_slice(&self.0[column]);
        assert!(length.is_none_or(|length| length == cells.len()), "{column}");
        Ok(cells)
    }
}

/// What is said of the columns of a mesh after they were changed.
fn said<M: FromColumns + FromFaces>(n: usize, faces: &[[u32; 3]], change: impl FnOnce(&mut Words)) -> String {
    let mesh = M::from_faces(n, faces).unwrap();
    let words = |bytes| bytemuck::pod_collect_to_vec::<u8, u32>(bytes);
    let mut columns: Words = mesh.columns().iter().map(|c| (c.name, words(c.bytes))).collect();
    change(&mut columns);
    let mesh = M::from_columns::<Borrowed<'_>>(&Columns(&columns, mesh.counts())).unwrap();
    onering::columns::Columns::validate(&mesh).unwrap_err().to_string()
}

const NONE: u32 = u32::MAX;

/// Two faces on the same three vertices, open along one edge: a disc, but for the two edges between two vertices.
#[test]
fn two_edges_between_two_vertices() {
    let pillow = [[0, 1, 2], [0, 2, 1]];
    // The links across half-edges 1 and 4; of directed edges they are in the cells of the next ones.
    let open = |words: &mut Words, (column, [i, j]): (&'static str, [usize; 2])| {
        let links = words.get_mut(column).unwrap();
        (links[i], links[j]) = (NONE, NONE);
        let outgoing = words.get_mut("outgoing").unwrap();
        (outgoing[1], outgoing[2]) = (1, 4);
    };
    let twice = "two edges lead to the same neighbour";
    let turned = |words: &mut Words| open(words, ("rotate_ccw", [2, 5]));
    assert!(said::<DirectedEdgesSmall>(3, &pillow, turned).contains(twice));
    let with_list = |words: &mut Words| {
        open(words, ("opposite", [1, 4]));
        words.insert("edge_list", vec![0, 1, 2, 4]);
    };
    assert!(said::<CheL2>(3, &pillow, with_list).contains(twice));
    let cells = |words: &mut Words| {
        // The mates of both across the side opposite vertex 0.
        let cells = words.get_mut("cells").unwrap();
        (cells[3], cells[9]) = (NONE, NONE);
    };
    assert!(said::<MateFace>(3, &pillow, cells).contains(twice));
    let records = |words: &mut Words| {
        let records = words.get_mut("records").unwrap();
        (records[5 + 3], records[4 * 5 + 3]) = (NONE, NONE);
        words.insert("outgoing", vec![0, 1, 4]);
    };
    assert!(said::<HalfEdgeMesh>(3, &pillow, records).contains(twice));
}

/// One fan is named twice, from its end and from its middle, and as many half-edges are in the one left out.
#[test]
fn an_open_fan_from_its_middle() {
    let faces = [[0, 1, 2], [0, 2, 3], [0, 4, 5]];
    let said = said::<DirectedEdgesSmall>(6, &faces, |words| {
        assert_eq!(words["vertex_records"], [2, 0, 6]);
        words.insert("vertex_records", vec![2, 0, 3]);
    });
    assert!(said.contains("does not start at its clockwise end"), "{said}");
}

/// The same of two closed fans of three.
#[test]
fn a_closed_fan_twice() {
    let tetrahedron = |a, b, c| [[0, a, b], [0, b, c], [0, c, a], [a, c, b]];
    let faces = [tetrahedron(1, 2, 3), tetrahedron(4, 5, 6)].concat();
    let twice = said::<DirectedEdgesSmall>(7, &faces, |words| {
        assert_eq!(words["vertex_records"], [2, 0, 12]);
        words.insert("vertex_records", vec![2, 0, 3]);
    });
    assert!(twice.contains("does not start at its least half-edge"), "{twice}");
    let same = said::<DirectedEdgesSmall>(7, &faces, |words| {
        words.insert("vertex_records", vec![2, 0, 0]);
    });
    assert!(same.contains("one is there twice"), "{same}");
    let cells = said::<MateFace>(7, &faces, |words| {
        assert_eq!(words["records"], [2, 0, 4]);
        words.insert("records", vec![2, 0, 1]);
    });
    assert!(cells.contains("does not start where it should"), "{cells}");
}

#[test]
fn a_curve_that_is_left_out() {
    let faces = [[0, 1, 2], [3, 4, 5]];
    let said = said::<CheL3>(6, &faces, |words| {
        assert_eq!(words["curve_list"], [0, 3]);
        words.insert("curve_list", vec![0]);
        words.get_mut("opposite").unwrap().fill(-2_i32 as u32);
    });
    assert!(said.contains("a curve is left out"), "{said}");
}
