//! The example of a backend of one's own obeys the laws.
#[path = "../examples/your_own_backend.rs"]
#[expect(dead_code, reason = "its `main`")]
mod example;

use example::Grid;
use onering::conformance::{self as laws, Case};

/// The faces of a terrain as the example describes it, row by row: the lower right, then the upper left of a square.
fn faces(columns: u32, rows: u32) -> Vec<[u32; 3]> {
    let vertex = |column, row| row * (columns + 1) + column;
    let square = |(c, r)| {
        let [a, b, d, e] = [vertex(c, r), vertex(c + 1, r), vertex(c + 1, r + 1), vertex(c, r + 1)];
        [[a, b, d], [a, d, e]]
    };
    (0..rows).flat_map(|r| (0..columns).map(move |c| (c, r))).flat_map(square).collect()
}

#[test]
fn the_example_obeys_the_laws() {
    for (columns, rows) in [(1, 1), (2, 1), (1, 2), (2, 2), (3, 4), (5, 3), (1, 6), (0, 0), (0, 3), (2, 0)] {
        let vertices = (columns as usize + 1) * (rows as usize + 1);
        let case = Case::counted("the example", vertices, faces(columns, rows));
        let terrain = Grid { columns: columns as usize, rows: rows as usize };
        println!("{terrain:?}");
        laws::topology(&case, &terrain);
        laws::adjacency(&case, &terrain);
        laws::incidence(&case, &terrain);
        laws::graph(&case, &terrain);
    }
}
