//! Turns of tables that own their columns do not check bounds at each step, so what they rely on has to be seen before
//! there is a table, whoever the columns come from. Tables that borrow them are made of any columns, and check.
use onering::columns::{Columns, FromColumns, Invalid, Source};
use onering::storage::{Borrowed, Element, Owned};
use onering::{CheL1, CheL2, CheL3, DirectedEdgesFull, DirectedEdgesMedium, DirectedEdgesSmall, FromFaces};
use onering::{Handle, Incidence, VertexId};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Columns of words, given as they are, however long they should be.
struct Words {
    columns: Vec<(&'static str, Vec<u32>)>,
    counts: (usize, usize),
}

impl Words {
    fn of(mesh: &impl Columns) -> Self {
        let words = |bytes| bytemuck::pod_collect_to_vec::<u8, u32>(bytes);
        let columns = mesh.columns().iter().map(|column| (column.name, words(column.bytes))).collect();
        Self { columns, counts: mesh.counts() }
    }

    fn column_mut(&mut self, name: &str) -> &mut Vec<u32> {
        &mut self.columns.iter_mut().find(|column| column.0 == name).expect(name).1
    }
}

impl Source<Owned> for Words {
    fn vertex_count(&self) -> usize {
        self.counts.0
    }

    fn face_count(&self) -> usize {
        self.counts.1
    }

    fn column<T: Element>(&self, name: &'static str, _: Option<usize>) -> Result<Box<[T]>, Invalid> {
        let column = self.columns.iter().find(|column| column.0 == name);
        let (_, words) = column.ok_or(Invalid::Missing { column: name })?;
        Ok(bytemuck::cast_slice::<u32, T>(words).into())
    }
}

fn is_refused<M: FromColumns + FromFaces>(vertices: &str, links: &str) {
    let mesh = M::from_faces(4, &[[0, 1, 2], [2, 1, 3]]).unwrap();
    let made = |change: &dyn Fn(&mut Words)| {
        let mut words = Words::of(&mesh);
        change(&mut words);
        M::from_columns::<Owned>(&words)
    };
    assert!(made(&|_| ()).is_ok());
    for cell in 0..6 {
        assert!(made(&|words| words.column_mut(links)[cell] = 6).is_err(), "{links} {cell}");
    }
    for column in [vertices, links] {
        assert!(made(&|words| words.column_mut(column).truncate(5)).is_err(), "{column} is short");
        assert!(made(&|words| words.column_mut(column).push(0)).is_err(), "{column} is long");
    }
}

#[test]
fn tables_are_not_made_of_what_turns_would_read_out_of_bounds_by() {
    is_refused::<CheL1>("origin", "opposite");
    is_refused::<CheL2>("origin", "opposite");
    is_refused::<CheL3>("origin", "opposite");
    is_refused::<DirectedEdgesSmall>("target", "rotate_ccw");
    is_refused::<DirectedEdgesMedium>("target", "rotate_ccw");
    is_refused::<DirectedEdgesFull>("target", "rotate_ccw");
}

/// Columns do not say whether vertices start at half-edges that exist: a turn asks, each time.
fn begins_with_none_that_exists<
    M: FromColumns<Over<Owned> = M> + FromFaces + Incidence<Vertex = VertexId>,
>() {
    let mut words = Words::of(&M::from_faces(3, &[[0, 1, 2]]).unwrap());
    words.column_mut("outgoing")[0] = 3;
    let mesh = M::from_columns::<Owned>(&words).unwrap();
    let v = VertexId::new(0);
    let turns: [fn(&M, VertexId) -> usize; 3] = [
        |mesh, v| mesh.one_ring(v).count(),
        |mesh, v| mesh.star(v).count(),
        |mesh, v| mesh.neighbours(v).count(),
    ];
    for turn in turns {
        let made = catch_unwind(AssertUnwindSafe(|| turn(&mesh, v)));
        let message = made.expect_err("h3 of three");
        let message = message.downcast_ref::<String>().expect("a message");
        assert!(message.starts_with("h3 is no half-edge of"), "{message}");
    }
}

#[test]
fn turns_begin_with_a_half_edge_that_exists() {
    begins_with_none_that_exists::<CheL2>();
    begins_with_none_that_exists::<DirectedEdgesSmall>();
}

/// Columns that are parts of longer lists: what a turn reads beyond one is no link, and nothing that ends the process.
struct Parts(Words);

impl Parts {
    fn of(mesh: &impl Columns) -> Self {
        let mut words = Words::of(mesh);
        words.columns.iter_mut().for_each(|(_, column)| column.extend([u32::MAX; 12]));
        Self(words)
    }
}

impl<'a> Source<Borrowed<'a>> for &'a Parts {
    fn vertex_count(&self) -> usize {
        self.0.counts.0
    }

    fn face_count(&self) -> usize {
        self.0.counts.1
    }

    fn column<T: Element>(&self, name: &'static str, length: Option<usize>) -> Result<&'a [T], Invalid> {
        let column = self.0.columns.iter().find(|column| column.0 == name);
        let (_, words) = column.ok_or(Invalid::Missing { column: name })?;
        Ok(bytemuck::cast_slice(&words[..length.unwrap_or(words.len() - 12)]))
    }
}

/// Each link in turn leads to each half-edge of a face that is not there: the first turn that comes by panics.
fn checks_each_step<M: FromColumns + FromFaces>(links: &str)
where
    for<'a> M::Over<Borrowed<'a>>: Incidence<Vertex = VertexId>,
{
    let mesh = M::from_faces(4, &[[0, 1, 2], [2, 1, 3]]).unwrap();
    for (cell, half_edge) in (0..6).flat_map(|cell| [6, 7, 8].map(|half_edge| (cell, half_edge))) {
        let mut parts = Parts::of(&mesh);
        panics_in_turns(&M::from_columns(&&parts).unwrap(), None);
        parts.0.column_mut(links)[cell] = half_edge;
        panics_in_turns(&M::from_columns(&&parts).unwrap(), Some((links, cell)));
    }
}

/// Whether each kind of turn panics around some vertex, which it shall only where a cell is bad.
fn panics_in_turns<M: Incidence<Vertex = VertexId>>(mesh: &M, bad: Option<(&str, usize)>) {
    let turns: [fn(&M, VertexId) -> usize; 3] = [
        |mesh, v| mesh.one_ring(v).count(),
        |mesh, v| mesh.star(v).count(),
        |mesh, v| mesh.neighbours(v).count(),
    ];
    for turn in turns {
        let around = |v| catch_unwind(AssertUnwindSafe(|| turn(mesh, v)));
        let messages: Vec<_> = mesh.vertices().filter_map(|v| around(v).err()).collect();
        assert_eq!(!messages.is_empty(), bad.is_some(), "{bad:?}");
        for message in messages {
            let message = message.downcast_ref::<String>().expect("a message");
            assert!(message.starts_with("index out of bounds: the len is 6"), "{bad:?}: {message}");
        }
    }
}

#[test]
fn turns_of_borrowed_tables_check_each_step() {
    checks_each_step::<CheL2>("opposite");
    checks_each_step::<CheL3>("opposite");
    checks_each_step::<DirectedEdgesSmall>("rotate_ccw");
    checks_each_step::<DirectedEdgesMedium>("rotate_ccw");
    checks_each_step::<DirectedEdgesFull>("rotate_ccw");
}
