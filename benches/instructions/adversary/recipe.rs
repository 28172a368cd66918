//! How a list of faces is made, at any size: pieces, then numbers for vertices, an order for faces, and turned corners.
use crate::meshes::{self, Faces, Random};
use crate::pieces::{self, Piece};
use onering::Pairing;

/// New numbers for vertices.
#[derive(Clone, Copy, Debug)]
enum Numbers {
    Reversed,
    Shuffled,
    /// By their number read backwards, bit by bit: neighbours come far apart.
    BitReversed,
    /// Shuffled within blocks of so many.
    Blocks(usize),
    /// The first ones, where hubs are, to the middle.
    Turned,
    /// So far apart that there are isolated ones between.
    Spread(usize),
    /// Those alone whose bit in the filter of the chain is one of so many of its 56.
    Colliding(u64),
}

/// A new order of faces.
#[derive(Clone, Copy, Debug)]
enum Order {
    Reversed,
    Shuffled,
    BitReversed,
    Blocks(usize),
    /// So many pieces of the list by turns.
    Interleaved(usize),
    /// So many eighths of the list from the front shuffled.
    FrontShuffled(usize),
    /// Shuffled but for the pairs of faces that `is_shuffled` in `core/src/pairing/mod.rs` samples, at its odd step.
    Unsampled,
    ByLeast,
    ByGreatest,
}

/// How corners are turned.
#[derive(Clone, Copy, Debug)]
enum Corners {
    AsMade,
    Rotated,
    /// One face of so many reversed.
    Flipped(usize),
}

#[derive(Clone, Debug)]
pub(crate) struct Recipe {
    pieces: Vec<Piece>,
    /// Whether vertex 0 of all pieces is the same.
    is_joined: bool,
    numbers: Vec<Numbers>,
    orders: Vec<Order>,
    corners: Corners,
    /// For each face so many in sixteen.
    isolated: usize,
    seed: u64,
}

impl Recipe {
    pub(crate) fn random(random: &mut Random) -> Self {
        let some = |random: &mut Random| random.below(3);
        let mut new = Self {
            pieces: (0..1 + random.of(&[0, 0, 0, 1, 1, 2])).map(|_| Piece::random(random)).collect(),
            is_joined: random.below(3) == 0,
            numbers: (0..some(random)).map(|_| Numbers::random(random)).collect(),
            orders: (0..some(random)).map(|_| Order::random(random)).collect(),
            corners: Corners::random(random),
            isolated: random.of(&[0, 0, 0, 0, 1, 16, 64]),
            seed: random.next(),
        };
        // Others behind them would give numbers that collide no more.
        new.numbers.sort_by_key(|numbers| matches!(numbers, Numbers::Colliding(_)));
        new
    }

    /// The same but for one thing.
    pub(crate) fn changed(&self, random: &mut Random) -> Self {
        let (mut new, other) = (self.clone(), Self::random(random));
        match random.below(9) {
            0 => new.pieces = other.pieces,
            1 | 2 => {
                let at = random.below(new.pieces.len());
                new.pieces[at].change(random);
            }
            3 if new.pieces.len() < 4 => new.pieces.push(Piece::random(random)),
            3 | 4 => new.is_joined = !new.is_joined,
            5 => new.numbers = other.numbers,
            6 => new.orders = other.orders,
            7 => new.corners = other.corners,
            _ => new.isolated = other.isolated,
        }
        new
    }

    /// About `n` faces.
    pub(crate) fn faces(&self, n: usize) -> Faces {
        let mut random = Random::new(self.seed);
        let shares: usize = self.pieces.iter().map(|piece| piece.share).sum();
        let (mut vertices, mut faces) = (0, Vec::new());
        for piece in &self.pieces {
            let (count, piece) = piece.faces(n * piece.share / shares, &mut random);
            let new = |v: u32| if self.is_joined && v == 0 { 0 } else { v + vertices as u32 };
            faces.extend(piece.into_iter().map(|face| face.map(new)));
            vertices += count;
        }
        for numbers in &self.numbers {
            let new = numbers.of(vertices, &mut random);
            faces.iter_mut().for_each(|face| *face = face.map(|v| new[v as usize]));
            vertices = new.iter().max().map_or(0, |&v| v as usize + 1);
        }
        for order in &self.orders {
            order.put(&mut faces, &mut random);
        }
        self.corners.turn(&mut faces, &mut random);
        (vertices + n * self.isolated / 16, faces)
    }
}

impl Numbers {
    fn random(random: &mut Random) -> Self {
        let (block, far, places) = (8 << random.below(8), 2 + random.below(6), 1 + random.below(28) as u64);
        random.of(&[
            Self::Reversed,
            Self::Shuffled,
            Self::BitReversed,
            Self::Blocks(block),
            Self::Turned,
            Self::Spread(far),
            Self::Colliding(places),
        ])
    }

    fn of(self, count: usize, random: &mut Random) -> Vec<u32> {
        let mut numbers: Vec<u32> = (0..count as u32).collect();
        match self {
            Self::Reversed => numbers.reverse(),
            Self::Shuffled => random.shuffle(&mut numbers),
            Self::BitReversed => numbers.sort_by_key(|v| v.reverse_bits()),
            Self::Blocks(size) => numbers.chunks_mut(size).for_each(|block| random.shuffle(block)),
            Self::Turned => numbers.rotate_left(count / 2),
            Self::Spread(far) => numbers.iter_mut().for_each(|v| *v *= far as u32),
            Self::Colliding(places) => {
                numbers = (0..).filter(|&v| bit(v) < places).take(count).collect();
            }
        }
        numbers
    }
}

/// The bit of a vertex in the filter of the chain, of its 56.
fn bit(v: u32) -> u64 {
    (u64::from(v.wrapping_mul(0x9E37_79B9)) * 56) >> 32
}

impl Order {
    fn random(random: &mut Random) -> Self {
        let (block, pieces, eighths) = (8 << random.below(8), 2 + random.below(63), 1 + random.below(7));
        random.of(&[
            Self::Reversed,
            Self::Shuffled,
            Self::BitReversed,
            Self::Blocks(block),
            Self::Interleaved(pieces),
            Self::FrontShuffled(eighths),
            Self::Unsampled,
            Self::ByLeast,
            Self::ByGreatest,
        ])
    }

    fn put(self, faces: &mut [[u32; 3]], random: &mut Random) {
        let count = faces.len();
        match self {
            Self::Reversed => faces.reverse(),
            Self::Shuffled => random.shuffle(faces),
            Self::BitReversed => {
                let old = faces.to_vec();
                let mut order: Vec<u32> = (0..count as u32).collect();
                order.sort_by_key(|f| f.reverse_bits());
                faces.iter_mut().zip(order).for_each(|(face, f)| *face = old[f as usize]);
            }
            Self::Blocks(size) => faces.chunks_mut(size).for_each(|block| random.shuffle(block)),
            Self::Interleaved(pieces) => {
                let old = faces.to_vec();
                let length = count.div_ceil(pieces);
                let order = (0..length).flat_map(|at| (0..pieces).map(move |piece| piece * length + at));
                let order = order.filter(|&f| f < count);
                faces.iter_mut().zip(order).for_each(|(face, f)| *face = old[f]);
            }
            Self::FrontShuffled(eighths) => random.shuffle(&mut faces[..count * eighths / 8]),
            Self::Unsampled => {
                let step = (count / 256) | 1;
                let unsampled: Vec<usize> = (0..count).filter(|f| f % step > 1).collect();
                for &f in &unsampled {
                    faces.swap(f, unsampled[random.below(unsampled.len())]);
                }
            }
            Self::ByLeast => faces.sort_by_key(|face| face.iter().copied().min()),
            Self::ByGreatest => faces.sort_by_key(|face| face.iter().copied().max()),
        }
    }
}

impl Corners {
    fn random(random: &mut Random) -> Self {
        let one_in = 2 << random.below(10);
        random.of(&[Self::AsMade, Self::AsMade, Self::AsMade, Self::Rotated, Self::Flipped(one_in)])
    }

    fn turn(self, faces: &mut [[u32; 3]], random: &mut Random) {
        match self {
            Self::AsMade => {}
            Self::Rotated => faces.iter_mut().for_each(|face| face.rotate_left(random.below(3))),
            Self::Flipped(one_in) => {
                faces.iter_mut().filter(|_| random.below(one_in) == 0).for_each(|face| face.swap(0, 1));
            }
        }
    }
}

/// Lists are what they are said to be.
pub(crate) fn check() {
    pieces::check();
    let mut random = Random::default();
    let (vertices, faces) = meshes::torus(320, 320);
    let chosen = |order: Order, random: &mut Random| {
        let mut faces = faces.clone();
        order.put(&mut faces, random);
        Pairing::choose(vertices, &faces)
    };
    assert_eq!(chosen(Order::Shuffled, &mut random), Pairing::Partition);
    assert_eq!(chosen(Order::Unsampled, &mut random), Pairing::Chain);
    for _ in 0..300 {
        let recipe = Recipe::random(&mut random).changed(&mut random);
        let is_last = recipe.numbers.is_sorted_by_key(|numbers| matches!(numbers, Numbers::Colliding(_)));
        assert!(is_last, "{recipe:?}");
        if let Some(Numbers::Colliding(places)) = recipe.numbers.last() {
            let (_, faces) = recipe.faces(60);
            assert!(faces.as_flattened().iter().all(|&v| bit(v) < *places), "{recipe:?}");
        }
    }
}
