//! Filling triangles: which face is seen at which sample.

/// Steps between two samples to which corners are rounded, so that the edge of two faces is the same line for both, and
/// each sample on it belongs to exactly one.
const STEPS: i64 = 256;

const NO_FACE: u32 = u32::MAX;

/// A depth buffer with the face that is nearest at each sample. 8 bytes a sample.
#[derive(Clone, Debug)]
pub(crate) struct Samples {
    width: usize,
    height: usize,
    depths: Vec<f32>,
    faces: Vec<u32>,
}

/// Where a row of samples lies within a triangle, the half-open range of columns.
type Span = std::ops::Range<i64>;

impl Samples {
    pub(crate) fn new(width: usize, height: usize) -> Self {
        let count = width * height;
        Self { width, height, depths: vec![f32::NEG_INFINITY; count], faces: vec![NO_FACE; count] }
    }

    /// The face that is seen at a sample.
    pub(crate) fn face(&self, x: usize, y: usize) -> Option<usize> {
        let face = self.faces[y * self.width + x];
        (face != NO_FACE).then_some(face as usize)
    }

    /// Where a sample is: from the middle, y up.
    pub(crate) fn centre(&self, x: usize, y: usize) -> [f32; 2] {
        let [width, height] = [self.width, self.height].map(|size| size as f32 / 2.0);
        [x as f32 + 0.5 - width, height - y as f32 - 0.5]
    }

    /// Fills a triangle, whichever way round. Corners are from the middle, y up, z to who looks; what lies outside is
    /// cut off. O(rows + samples covered): a long thin triangle costs no more than its rows.
    pub(crate) fn fill(&mut self, face: u32, corners: [[f32; 3]; 3]) {
        let triangle = self.rounded(corners);
        let [a, mut b, mut c] = triangle.map(|(point, _)| point);
        let [za, mut zb, mut zc] = triangle.map(|(_, z)| z);
        let mut area = side(a, b, c);
        if area == 0 {
            return;
        }
        if area < 0 {
            (b, c, zb, zc, area) = (c, b, zc, zb, -area);
        }
        let [top, bottom] = [a[1].min(b[1]).min(c[1]), a[1].max(b[1]).max(c[1])];
        let first = first_at_or_after(top).max(0);
        let end = first_at_or_after(bottom + 1).min(self.height as i64);
        for y in first..end {
            let span = [[a, b], [b, c], [c, a]].into_iter().fold(0..self.width as i64, |span, edge| {
                let row = within(edge, y);
                span.start.max(row.start)..span.end.min(row.end)
            });
            // The weights of b and c, which change by the same step from sample to sample.
            let depth = |x: i64| {
                let p = sample(x, y);
                let [wb, wc] = [side(c, a, p), side(a, b, p)].map(|w| w as f64 / area as f64);
                za + wb * (zb - za) + wc * (zc - za)
            };
            self.fill_row(face, y, span, depth);
        }
    }

    fn fill_row(&mut self, face: u32, y: i64, span: Span, depth: impl Fn(i64) -> f64) {
        if span.is_empty() {
            return;
        }
        let (start, step) = (depth(span.start), depth(span.start + 1) - depth(span.start));
        let row = y as usize * self.width;
        for (i, x) in (row + span.start as usize..row + span.end as usize).enumerate() {
            let depth = (start + i as f64 * step) as f32;
            if depth > self.depths[x] {
                (self.depths[x], self.faces[x]) = (depth, face);
            }
        }
    }

    /// Corners from the upper left, y down, in steps, with their depths.
    fn rounded(&self, corners: [[f32; 3]; 3]) -> [([i64; 2], f64); 3] {
        let [width, height] = [self.width, self.height].map(|size| size as f64 / 2.0);
        let steps = |x: f64| (x * STEPS as f64).round() as i64;
        corners.map(|p| {
            let [x, y, z] = p.map(f64::from);
            ([steps(x + width), steps(height - y)], z)
        })
    }
}

/// Twice the area of the triangle `a b p`: positive where p is on the right of a to b, y down.
fn side(a: [i64; 2], b: [i64; 2], p: [i64; 2]) -> i64 {
    (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
}

fn sample(x: i64, y: i64) -> [i64; 2] {
    [x, y].map(|i| i * STEPS + STEPS / 2)
}

/// The first row or column of samples that is not before this place.
fn first_at_or_after(place: i64) -> i64 {
    (place - STEPS / 2 + STEPS - 1).div_euclid(STEPS)
}

/// The columns of row y that are on the inner side of the edge. A sample on the line itself is inside where the
/// edge is a top or a left one: so of two faces with this edge exactly one has it.
fn within([a, b]: [[i64; 2]; 2], y: i64) -> Span {
    let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    let is_top_or_left = dy < 0 || dy == 0 && dx > 0;
    // Inside is `at - x * step >= 0`.
    let at = side(a, b, sample(0, y)) - i64::from(!is_top_or_left);
    let step = dy * STEPS;
    match step {
        0 if at >= 0 => i64::MIN..i64::MAX,
        0 => 0..0,
        1.. => i64::MIN..at.div_euclid(step) + 1,
        _ => -at.div_euclid(-step)..i64::MAX,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn covered(samples: &Samples) -> Vec<Option<usize>> {
        (0..samples.width * samples.height)
            .map(|i| samples.face(i % samples.width, i / samples.width))
            .collect()
    }

    #[test]
    fn a_known_triangle_covers_what_a_hand_count_gives() {
        // The lower left half of a square of 4 x 4 samples, its long side through sample centres.
        let mut samples = Samples::new(4, 4);
        samples.fill(7, [[-2.0, -2.0, 0.0], [2.0, -2.0, 0.0], [-2.0, 2.0, 0.0]]);
        let rows: Vec<usize> = covered(&samples).chunks(4).map(|row| row.iter().flatten().count()).collect();
        // The long side is a right one: samples on it are outside.
        assert_eq!(rows, [0, 1, 2, 3]);
        // The other half has them.
        samples.fill(8, [[2.0, 2.0, 0.0], [-2.0, 2.0, 0.0], [2.0, -2.0, 0.0]]);
        let faces: Vec<usize> = covered(&samples).into_iter().flatten().collect();
        assert_eq!(faces.iter().filter(|&&face| face == 8).count(), 10);
        assert_eq!(faces.len(), 16);
    }

    #[test]
    fn faces_that_share_edges_cover_each_sample_once() {
        // A fan around a centre that is a sample, to corners of all slopes.
        let rim: Vec<[f32; 3]> = (0..16)
            .map(|i| std::f32::consts::TAU * i as f32 / 16.0)
            .map(|t| [60.0 * t.cos(), 60.0 * t.sin(), 0.0])
            .collect();
        let mut times = vec![0; 101 * 101];
        for i in 0..16 {
            let mut samples = Samples::new(101, 101);
            samples.fill(0, [[0.0; 3], rim[i], rim[(i + 1) % 16]]);
            covered(&samples).iter().zip(&mut times).for_each(|(face, n)| *n += face.iter().count());
        }
        assert_eq!(times.iter().max(), Some(&1));
        let seen = times.iter().filter(|&&n| n == 1).count();
        let near = |i: usize| [i % 101, i / 101].map(|x| (x as f32 - 50.0).powi(2)).iter().sum::<f32>();
        assert!((0..101 * 101).filter(|&i| near(i) < 58.0 * 58.0).all(|i| times[i] == 1), "{seen}");
    }

    #[test]
    fn the_nearer_face_is_seen_whatever_the_order() {
        let at = |z: f32| [[-9.0, -9.0, z], [9.0, -9.0, z], [0.0, 9.0, z]];
        for order in [[1, 2], [2, 1]] {
            let mut samples = Samples::new(8, 8);
            order.iter().for_each(|&f| samples.fill(f, at(f as f32)));
            assert_eq!(samples.face(4, 4), Some(2));
        }
        // Two that pass through each other: each is seen where it is in front.
        let mut samples = Samples::new(8, 8);
        samples.fill(0, [[-9.0, -9.0, -9.0], [9.0, -9.0, 9.0], [0.0, 9.0, 0.0]]);
        samples.fill(1, [[-9.0, -9.0, 9.0], [9.0, -9.0, -9.0], [0.0, 9.0, 0.0]]);
        assert_eq!([samples.face(1, 6), samples.face(6, 6)], [Some(1), Some(0)]);
    }

    #[test]
    fn the_silhouette_of_a_sphere_has_its_area() {
        let (radius, rings) = (100.0_f32, 60_u32);
        let point = |i: u32, j: u32| {
            let [t, p] = [std::f32::consts::PI * i as f32, std::f32::consts::TAU * j as f32]
                .map(|turn| turn / rings as f32);
            [t.sin() * p.cos(), t.cos(), t.sin() * p.sin()].map(|x| x * radius)
        };
        let mut samples = Samples::new(256, 256);
        for (i, j) in (0..rings).flat_map(|i| (0..rings).map(move |j| (i, j))) {
            let [a, b, c, d] = [point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)];
            samples.fill(0, [a, b, c]);
            samples.fill(1, [a, c, d]);
        }
        let area = covered(&samples).iter().flatten().count() as f32;
        let expected = std::f32::consts::PI * radius * radius;
        assert!((area / expected - 1.0).abs() < 0.005, "{area} of {expected}");
    }

    #[test]
    fn degenerate_triangles_and_those_outside_cover_nothing() {
        let mut samples = Samples::new(16, 16);
        samples.fill(0, [[1.0, 1.0, 0.0]; 3]);
        samples.fill(0, [[-5.0, -5.0, 0.0], [0.0, 0.0, 0.0], [5.0, 5.0, 0.0]]);
        samples.fill(0, [[20.0, 20.0, 0.0], [30.0, 20.0, 0.0], [20.0, 30.0, 0.0]]);
        assert!(covered(&samples).iter().all(Option::is_none));
    }
}
