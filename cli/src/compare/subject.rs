//! The structures of the registry as things to measure, their types forgotten.

use super::kernels::Kernels;
use super::measure::{self, Measured, Plan};
use super::renumbered;
use onering::footprint::Bytes;
use onering::registry::{BACKENDS, COMPRESSED, Compressed, Entry, RENUMBERING};
use onering::{BuildError, CheL1, Footprint};

/// A structure by what can be done with it here.
pub(crate) struct Subject {
    /// Its name in the registry, or of the baseline.
    pub(crate) name: &'static str,
    /// Its type in the library.
    pub(crate) type_name: &'static str,
    /// Builds it and asks it everything that it can answer.
    pub(crate) measure: fn(&Plan<'_>) -> Result<Measured, BuildError>,
}

macro_rules! subjects {
    ($($module:ident $name:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {
        /// Every structure, in the order of [`all_known`].
        pub(crate) const SUBJECTS: &[Subject] = &[
            $(Subject {
                name: $name,
                type_name: stringify!($mesh),
                measure: |plan| measure::backend::<$mesh>(plan, &Kernels::new()$(.$has())*),
            },)+
            Subject { name: "sot", type_name: "Sot", measure: renumbered::sot },
            Subject { name: "compact-stars", type_name: "CompactStars", measure: renumbered::compact_stars },
        ];
    };
}
onering::with_backends!(subjects);

/// What the structures are to be better than: the bare list of faces, all of it searched for every answer.
pub(crate) const BASELINE: Subject =
    Subject { name: "no data structure", type_name: "Searched", measure: measure::searched };

/// What the registry says of a structure, in whichever of its lists that is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Known {
    pub(crate) name: &'static str,
    pub(crate) traits: &'static [&'static str],
    pub(crate) holds: &'static [&'static str],
    /// Whether vertices and faces get other numbers, and maps lead to them.
    pub(crate) renumbers: bool,
    pub(crate) memory: Formula,
}

/// What the bytes of a structure are made of.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Formula {
    Counts(Bytes),
    /// In words, for the order of vertices matters as well as counts; and the formula of what it is made from, which
    /// is there meanwhile.
    Words(&'static str, Bytes),
}

/// What the registry says of each of [`SUBJECTS`]: its backends, then the structures that renumber.
pub(crate) fn all_known() -> impl Iterator<Item = Known> {
    let entry = |&Entry { name, traits, holds, bytes }: &Entry, renumbers| Known {
        name,
        traits,
        holds,
        renumbers,
        memory: Formula::Counts(bytes),
    };
    let compressed = |&Compressed { name, traits, formula, .. }: &Compressed| {
        let memory = Formula::Words(formula, CheL1::BYTES);
        Known { name, traits, holds: &[], renumbers: true, memory }
    };
    let backends = BACKENDS.iter().map(move |backend| entry(backend, false));
    let renumbering = RENUMBERING.iter().map(move |one| entry(one, true));
    backends.chain(renumbering).chain(COMPRESSED.iter().map(compressed))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_those_of_the_registry() {
        let names = SUBJECTS.iter().map(|subject| subject.name);
        assert!(names.eq(all_known().map(|known| known.name)));
    }
}
