//! Uses both crates: there is one `Mesh`, and it has what each asked for.
#[cfg(test)]
mod tests {
    use onering::{Adjacency, Boundaries, FromFaces, Mesh, Topology};

    #[test]
    fn one_mesh_serves_both() {
        let book = simplifier::book().unwrap();
        assert_eq!(simplifier::most_fans(&book), Some(3));
        let spine = book.half_edges().find(|&h| book.edge_fan(h).count() == 3).unwrap();
        assert_eq!(book.opposite(spine), None);
        assert!(!book.is_boundary(spine));
        assert_eq!(book.curve_of(spine), None);
        // Each page is a boundary curve that ends at the spine.
        assert_eq!(viewer::lines(&book), (3, 7));
        for c in book.curves() {
            assert_eq!(book.curve(c).count(), 2);
            assert!(book.curve(c).all(|h| book.curve_of(h) == Some(c)));
        }
    }

    #[test]
    fn a_square_has_one_curve() {
        let square = Mesh::from_faces(4, &[[0, 1, 2], [0, 2, 3]]).unwrap();
        assert_eq!(viewer::lines(&square), (1, 5));
        assert_eq!(simplifier::most_fans(&square), Some(1));
    }
}
