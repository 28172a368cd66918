//! Turns of tables that own their columns do not check bounds at each step, so what they rely on has to be seen before
//! there is a table, whoever the columns come from.
use onering::columns::{Columns, FromColumns, Invalid, Source};
use onering::storage::{Element, Owned};
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
