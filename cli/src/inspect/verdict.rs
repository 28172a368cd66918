//! What a mesh is, in one line.

use onering::defects::Defects;
use std::fmt::Write;

/// `closed manifold`, `open manifold: 2 boundary loops`, or `needs repair: ` and what for; and what it would be with
/// vertices at equal positions welded, where that is another thing.
pub(crate) fn of(as_loaded: &Defects, welded: Option<&Defects>) -> String {
    let mut text = one(as_loaded);
    if let Some(welded) = welded.map(one).filter(|welded| *welded != text) {
        let _ = write!(text, "; welded: {welded}");
    }
    text
}

fn one(defects: &Defects) -> String {
    if !defects.is_clean() {
        // Its own words are the obstacles.
        return format!("needs repair: {defects}");
    }
    match (defects.components, defects.boundary_edges) {
        (0, _) => "no faces".into(),
        (_, 0) => "closed manifold".into(),
        (_, edges) => format!("open manifold: {}", boundary(edges, defects.boundary_loops)),
    }
}

fn boundary(edges: usize, loops: Option<usize>) -> String {
    let s = |count: usize| if count == 1 { "" } else { "s" };
    match loops {
        Some(loops) => format!("{edges} boundary edge{} in {loops} loop{}", s(edges), s(loops)),
        None => format!("{edges} boundary edge{}", s(edges)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_verdict() {
        let one = |vertices, faces: &[[u32; 3]]| one(&Defects::of(vertices, faces).unwrap());
        assert_eq!(one(3, &[]), "no faces");
        assert_eq!(one(4, &[[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]), "closed manifold");
        assert_eq!(one(4, &[[0, 1, 2], [0, 2, 3]]), "open manifold: 4 boundary edges in 1 loop");
        let fan = [[0, 1, 2], [1, 0, 3], [0, 1, 4], [4, 4, 0]];
        assert_eq!(one(5, &fan), "needs repair: 1 degenerate face, 1 non-manifold edge");
    }

    #[test]
    fn welding_is_spoken_of_where_it_matters() {
        let square = Defects::of(4, &[[0, 1, 2], [0, 2, 3]]).unwrap();
        let apart = Defects::of(6, &[[0, 1, 2], [3, 4, 5]]).unwrap();
        let line = of(&apart, Some(&square));
        assert_eq!(
            line,
            "open manifold: 6 boundary edges in 2 loops; welded: open manifold: 4 boundary edges in 1 loop"
        );
        assert_eq!(of(&square, Some(&square)), of(&square, None));
    }
}
