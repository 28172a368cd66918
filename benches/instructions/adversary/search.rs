//! Tries lists, half of them made anew, half of them what was worst until then but for one change; a quarter of these for
//! another structure or strategy as well.
use crate::Counter;
use crate::meshes::Random;
use crate::recipe::{self, Recipe};
use crate::subjects::Subject;
use std::process::ExitCode;

/// How much more than n log n a count may grow with the list.
const MARGIN: f64 = 1.3;

/// A list is not asked for with more faces: what still grows then is not n log n.
const MOST_FACES: usize = 200_000;

/// Nor where it took so many instructions for each face and vertex at fewer: they are some hundreds, and a few thousands at
/// worst.
const MOST_FOR_EACH: f64 = 50_000.0;

/// So many of the worst are printed.
const PRINTED: usize = 6;

/// A list, what was built from it, and what that took.
#[derive(Clone)]
struct Tried {
    subject: Subject,
    recipe: Recipe,
    /// Growth from one size to the next four times as large, over that of n log n: the least of all times.
    growth: f64,
    /// Instructions for each face and vertex at 4n.
    cost: f64,
    faces: usize,
}

impl Tried {
    fn new(subject: Subject, recipe: Recipe, n: usize, counter: &mut Counter) -> Self {
        let mut asked = 4 * n;
        let (mut before, mut after) =
            (Size::of(&subject, &recipe, n, counter), Size::of(&subject, &recipe, asked, counter));
        let cost = after.cost();
        let mut growth = after.growth(before);
        while growth > MARGIN && 4 * asked <= MOST_FACES && after.cost() < MOST_FOR_EACH {
            asked *= 4;
            (before, after) = (after, Size::of(&subject, &recipe, asked, counter));
            growth = growth.min(after.growth(before));
        }
        Self { subject, recipe, growth, cost, faces: after.faces }
    }

    fn print(&self) {
        let Self { subject, recipe, growth, cost, faces } = self;
        println!("{growth:.2} of n log n up to {faces} faces, {cost:.0} for each: {subject}, {recipe:?}");
    }
}

/// A list at one size.
#[derive(Clone, Copy)]
struct Size {
    faces: usize,
    vertices: usize,
    instructions: u64,
}

impl Size {
    fn of(subject: &Subject, recipe: &Recipe, n: usize, counter: &mut Counter) -> Self {
        let (vertices, faces) = recipe.faces(n);
        let instructions = counter.count(&|| subject.run(vertices, &faces));
        Self { faces: faces.len(), vertices, instructions }
    }

    fn cost(self) -> f64 {
        self.instructions as f64 / (self.faces + self.vertices) as f64
    }

    /// From one size to this, over what n log n grows by.
    fn growth(self, from: Self) -> f64 {
        let each = |size: Self| size.cost() / ((size.faces + size.vertices) as f64).ln();
        each(self) / each(from)
    }
}

/// Keeps the worst of each structure and strategy, by either measure. Fails where one is worse than n log n.
pub(crate) fn search(lists: u64, seed: u64, n: usize, counter: &mut Counter) -> ExitCode {
    let mut random = Random::new(seed);
    let mut worst: [Vec<Tried>; 2] = [Vec::new(), Vec::new()];
    let measures = [|tried: &Tried| tried.growth, |tried: &Tried| tried.cost];
    let mut is_found = false;
    for _ in 0..lists {
        let kept = &worst[random.below(2)];
        let (subject, recipe) = if kept.is_empty() || random.below(2) == 0 {
            (Subject::random(&mut random), Recipe::random(&mut random))
        } else {
            let Tried { subject, recipe, .. } = random.of(kept);
            let subject = if random.below(4) == 0 { Subject::random(&mut random) } else { subject };
            (subject, recipe.changed(&mut random))
        };
        let tried = Tried::new(subject, recipe, n, counter);
        if tried.growth > MARGIN {
            print!("MORE THAN N LOG N: ");
            tried.print();
            is_found = true;
        }
        for (worst, measure) in worst.iter_mut().zip(measures) {
            match worst.iter_mut().find(|other| other.subject == tried.subject) {
                Some(other) if measure(other) >= measure(&tried) => {}
                Some(other) => other.clone_from(&tried),
                None => worst.push(tried.clone()),
            }
        }
    }
    println!("{lists} lists of seed {seed}; those that grow most, and those that take most:");
    for (worst, measure) in worst.iter_mut().zip(measures) {
        worst.sort_by(|a, b| measure(b).total_cmp(&measure(a)));
        worst.iter().take(PRINTED).for_each(Tried::print);
    }
    if is_found { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}

/// As many lists at a small size, to see that they are made and built.
pub(crate) fn try_out(lists: u64) {
    recipe::check();
    let mut random = Random::new(1);
    for _ in 0..lists {
        let (vertices, faces) = Recipe::random(&mut random).changed(&mut random).faces(60);
        Subject::random(&mut random).run(vertices, &faces);
    }
}
