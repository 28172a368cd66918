//! How many vertices have how many neighbours.
use crate::{BuildError, Handle, memory, neighbours::Neighbours};
use alloc::vec::Vec;
use core::fmt;

/// A histogram of vertex degrees: what [`degrees`] gives. Displayed, it is the table of Figueiredo et al.
/// (2014), Table 6: seven lines, percentages of the vertices that have neighbours.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Degrees {
    counts: Vec<usize>,
}

impl Degrees {
    /// The degrees that each bucket of the paper's table stands for.
    pub const BUCKETS: [&'static str; 7] = ["<=3", "4", "5", "6", "7", "8", ">=9"];

    /// Number of vertices that have just `degree` neighbours; 0 stands for the isolated ones.
    pub fn count(&self, degree: usize) -> usize {
        self.counts.get(degree).copied().unwrap_or(0)
    }

    /// Counts vertices by their degrees, and so many isolated ones beside.
    pub(crate) fn of(isolated: usize, degrees: impl Iterator<Item = usize>) -> Result<Self, BuildError> {
        let mut counts = Vec::new();
        if isolated > 0 {
            memory::push(&mut counts, isolated)?;
        }
        for degree in degrees {
            if counts.len() <= degree {
                let missing = degree + 1 - counts.len();
                memory::reserve(&mut counts, missing)?;
                counts.resize(degree + 1, 0);
            }
            counts[degree] += 1;
        }
        Ok(Self { counts })
    }

    /// Every degree that some vertex has, ascending, with the number of such vertices; 0 stands for the
    /// isolated ones.
    pub fn iter(&self) -> impl Iterator<Item = (usize, usize)> {
        self.counts.iter().copied().enumerate().filter(|&(_, n)| n > 0)
    }

    /// Number of vertices that have neighbours.
    pub fn used(&self) -> usize {
        self.counts.iter().skip(1).sum()
    }

    /// The least degree of a vertex that has neighbours. O(largest degree), as for all below.
    pub fn min(&self) -> Option<usize> {
        (1..self.counts.len()).find(|&degree| self.counts[degree] > 0)
    }

    /// The largest degree of a vertex that has neighbours.
    pub fn max(&self) -> Option<usize> {
        (1..self.counts.len()).rfind(|&degree| self.counts[degree] > 0)
    }

    /// The mean degree of the vertices that have neighbours: twice the edges by these vertices.
    pub fn mean(&self) -> Option<f64> {
        let sum: usize = self.counts.iter().enumerate().map(|(degree, n)| degree * n).sum();
        (sum > 0).then(|| sum as f64 / self.used() as f64)
    }

    /// Number of vertices in each of the [`BUCKETS`](Self::BUCKETS), isolated vertices in none.
    ///
    /// That is the reading which gives the paper's column for the Stanford bunny (0.12 % of degree 3 or less):
    /// a degree is a number of neighbours, not of faces, and its 1,113 isolated vertices are left out of the
    /// first bucket and of the total.
    pub fn buckets(&self) -> [usize; 7] {
        let mut buckets = [0; 7];
        for (degree, n) in self.counts.iter().enumerate().skip(1) {
            buckets[degree.clamp(3, 9) - 3] += n;
        }
        buckets
    }

    /// The [`buckets`](Self::buckets) in percent of the vertices that have neighbours; 0 where none has.
    pub fn percentages(&self) -> [f64; 7] {
        self.buckets().map(|n| 100.0 * n as f64 / self.used().max(1) as f64)
    }
}

impl fmt::Display for Degrees {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut lines = Self::BUCKETS.iter().zip(self.percentages());
        lines.try_for_each(|(bucket, percentage)| writeln!(f, "{bucket:<3} {percentage:6.2} %"))
    }
}

/// The degree of each vertex, counted: a degree is the number of neighbours, each once. O(vertices + edges).
///
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, degrees};
/// let mesh = Mesh::from_faces(5, &[[0, 1, 2], [2, 1, 3]])?;
/// let degrees = degrees::degrees(&mesh);
/// assert_eq!([0, 1, 2, 3].map(|degree| degrees.count(degree)), [1, 0, 2, 2]);
/// assert_eq!(degrees.percentages()[0], 100.0);
/// assert_eq!(degrees.mean(), Some(2.5));
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Panics
/// If memory does not suffice.
pub fn degrees<G: Neighbours + ?Sized>(graph: &G) -> Degrees {
    let degrees = (0..graph.node_count()).map(|v| graph.neighbours(G::Node::new(v)).count());
    Degrees::of(0, degrees).unwrap_or_else(|error| panic!("{error}"))
}
