//! Where names go so that none lies over another, nor over a point.

/// A box in pixels: its left upper and its right lower corner.
pub(super) type Box2 = [f64; 4];

const HEIGHT: f64 = 16.0;
/// Of a letter, in the font and the size of labels; rather too much.
const LETTER: f64 = 6.9;
const POINT: f64 = 7.0;

/// About how wide a name is.
pub(super) fn width(name: &str) -> f64 {
    name.chars().count() as f64 * LETTER
}

/// For each named point the box of its name: beside it where there is room, else farther off. `bounds` is where names may
/// be, `lines` are what they should not lie over either.
pub(super) fn beside(points: &[(f64, f64)], names: &[&str], bounds: Box2, lines: Vec<Box2>) -> Vec<Box2> {
    let mut taken = lines;
    taken.extend(points.iter().map(|&(x, y)| around(x, y)));
    let mut places = Vec::new();
    for (&(x, y), name) in points.iter().zip(names) {
        let width = width(name);
        let free =
            |label: &Box2| within(*label, bounds) && taken.iter().all(|other| !overlap(*label, *other));
        let label = candidates(x, y, width).find(free);
        // Nowhere at all: better over another than left out.
        let label = label.unwrap_or_else(|| at(x + POINT, y, width));
        taken.push(label);
        places.push(label);
    }
    places
}

/// To the right, to the left, above and below, then the same in wider and wider circles.
fn candidates(x: f64, y: f64, width: f64) -> impl Iterator<Item = Box2> {
    (0..24).map(f64::from).flat_map(move |circle| {
        let (aside, off) = (POINT + 2.0 + 3.0 * circle, 14.0 + 7.0 * circle);
        let slope = 8.0 * circle;
        [
            at(x + aside, y - slope, width),
            at(x + aside, y + slope, width),
            at(x - aside - width, y - slope, width),
            at(x - aside - width, y + slope, width),
            at(x - width / 2.0, y - off, width),
            at(x - width / 2.0, y + off, width),
        ]
    })
}

fn at(left: f64, middle: f64, width: f64) -> Box2 {
    [left, middle - HEIGHT / 2.0, left + width, middle + HEIGHT / 2.0]
}

fn around(x: f64, y: f64) -> Box2 {
    [x - POINT, y - POINT, x + POINT, y + POINT]
}

fn overlap(a: Box2, b: Box2) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}

fn within(a: Box2, bounds: Box2) -> bool {
    a[0] >= bounds[0] && a[1] >= bounds[1] && a[2] <= bounds[2] && a[3] <= bounds[3]
}

/// Heights near to those that are wished for, in the same order, each far enough from the next, down to `bottom`.
pub(super) fn apart(wished: &[f64], top: f64, bottom: f64) -> Vec<f64> {
    let mut order: Vec<usize> = (0..wished.len()).collect();
    order.sort_by(|&a, &b| wished[a].total_cmp(&wished[b]));
    let mut places = vec![0.0; wished.len()];
    let mut least = top;
    for &i in &order {
        places[i] = wished[i].max(least);
        least = places[i] + HEIGHT;
    }
    // What has been pushed beyond the end is pushed back, from the last up.
    let mut most = bottom;
    for &i in order.iter().rev() {
        places[i] = places[i].min(most);
        most = places[i] - HEIGHT;
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_name_lies_over_another_or_over_a_point() {
        // Nine points in three heaps.
        let points: Vec<(f64, f64)> =
            (0..9).map(|i| (100.0 + 150.0 * f64::from(i / 3), 200.0 + 3.0 * f64::from(i))).collect();
        let names = ["directed-edges-small"; 9];
        let bounds = [0.0, 0.0, 760.0, 440.0];
        let line = [398.0, 0.0, 402.0, 150.0];
        let boxes = beside(&points, &names, bounds, vec![line]);
        for (i, label) in boxes.iter().enumerate() {
            assert!(within(*label, bounds) && !overlap(*label, line));
            assert!(boxes[..i].iter().all(|other| !overlap(*label, *other)), "{i}");
            assert!(points.iter().all(|&(x, y)| !overlap(*label, around(x, y))), "{i}");
        }
    }

    #[test]
    fn heights_keep_their_order_and_their_distance() {
        assert_eq!(apart(&[50.0, 10.0, 12.0], 0.0, 100.0), [50.0, 10.0, 26.0]);
        assert_eq!(apart(&[98.0, 99.0], 0.0, 100.0), [84.0, 100.0]);
        assert_eq!(apart(&[], 0.0, 100.0), [0.0; 0]);
    }
}
