//! The nearest vertex, by one pass and by the tree.
use onering::nearest::nearest_vertex;
use onering::{Handle, Map, VertexId};

#[path = "common/shapes.rs"]
mod shapes;

fn nearest(positions: &[[f32; 3]], point: [f64; 3]) -> Option<usize> {
    let positions: Map<VertexId, _> = positions.to_vec().into();
    let found = nearest_vertex(&positions, point).map(Handle::index);
    #[cfg(feature = "kd-tree")]
    assert_eq!(onering::nearest::Tree::new(&positions).nearest(point).map(Handle::index), found);
    found
}

#[test]
fn the_least_of_the_nearest() {
    let square = [[1.0, 1.0, 0.0], [-1.0, 1.0, 0.0], [-1.0, -1.0, 0.0], [1.0, -1.0, 0.0]];
    assert_eq!(nearest(&square, [0.0, 0.0, 5.0]), Some(0));
    assert_eq!(nearest(&square, [-0.5, 0.0, 0.0]), Some(1));
    assert_eq!(nearest(&square, [0.3, -7.0, 0.0]), Some(3));
    assert_eq!(nearest(&[[2.0; 3], [1.0; 3], [1.0; 3]], [0.0; 3]), Some(1));
    assert_eq!(nearest(&[[0.0; 3], [-0.0; 3]], [0.0; 3]), Some(0));
    assert_eq!(nearest(&[[-0.0; 3], [0.0; 3]], [0.0; 3]), Some(0));
}

#[test]
fn what_is_no_number_is_passed_over() {
    let [nan, infinite] = [f32::NAN, f32::INFINITY];
    assert_eq!(nearest(&[[nan, 0.0, 0.0], [9.0; 3], [infinite, 0.0, 0.0]], [0.0; 3]), Some(1));
    assert_eq!(nearest(&[], [0.0; 3]), None);
    assert_eq!(nearest(&[[nan; 3]], [0.0; 3]), None);
    for bad in [f64::NAN, f64::INFINITY, f64::MAX] {
        assert_eq!(nearest(&[[0.0; 3], [1.0; 3]], [0.0, bad, 0.0]), None);
    }
    assert_eq!(nearest(&[[f32::MAX; 3], [f32::MIN; 3]], [1.0; 3]), Some(0));
}

#[cfg(feature = "kd-tree")]
#[test]
fn the_tree_agrees_with_one_pass() {
    use onering::nearest::Tree;
    let mut random = shapes::Random(3);
    // From few different coordinates, with many ties, to many.
    for steps in [1, 2, 3, 10, 1000, 1 << 24] {
        let mut coordinate = || random.below(steps) as f32 / steps as f32;
        let positions: Map<VertexId, _> = (0..2000).map(|_| [(); 3].map(|()| coordinate())).collect();
        let tree = Tree::new(&positions);
        for _ in 0..200 {
            let point =
                [(); 3].map(|()| 2.0 * f64::from(random.below(2 * steps + 1) as u32) / steps as f64 - 1.0);
            assert_eq!(tree.nearest(point), nearest_vertex(&positions, point), "{point:?}");
        }
    }
}

#[cfg(feature = "kd-tree")]
#[test]
fn positions_without_room_between_them_do_no_harm() {
    use onering::nearest::Tree;
    let halves = |i: usize| [2f32.powi(-((i % 150) as i32)), 0.0, (i / 150) as f32 * 1e-30];
    let shapes: [fn(usize) -> [f32; 3]; 3] = [|_| [1.0, 2.0, 3.0], |i| [1.0, i as f32, 0.0], halves];
    for shape in shapes {
        let positions: Map<VertexId, _> = (0..20_000).rev().map(shape).collect();
        let tree = Tree::new(&positions);
        for point in [[0.0; 3], [1.0, 500.5, 0.0], [-1e30, 1e30, 0.0]] {
            assert_eq!(tree.nearest(point), nearest_vertex(&positions, point), "{point:?}");
        }
    }
}
