//! The backends of the registry as things to measure, their types forgotten.

use super::kernels::Kernels;
use super::measure::{self, Measured, Plan};
use super::renumbered;
use onering::BuildError;
use onering::registry::{BACKENDS, Entry, RENUMBERING};

/// A backend by what can be done with it here.
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
        /// Every backend, in the order of [`entries`].
        pub(crate) const SUBJECTS: &[Subject] = &[
            $(Subject {
                name: $name,
                type_name: stringify!($mesh),
                measure: |plan| measure::backend::<$mesh>(plan, &Kernels::new()$(.$has())*),
            },)+
            Subject { name: "sot", type_name: "Sot", measure: renumbered::sot },
        ];
    };
}
onering::with_backends!(subjects);

/// What the structures are to be better than: the bare list of faces, all of it searched for every answer.
pub(crate) const BASELINE: Subject =
    Subject { name: "no data structure", type_name: "Searched", measure: measure::searched };

/// What the registry says of each of [`SUBJECTS`]: its backends, then the structures that renumber.
pub(crate) fn entries() -> impl Iterator<Item = &'static Entry> {
    BACKENDS.iter().chain(RENUMBERING)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_those_of_the_registry() {
        let names = SUBJECTS.iter().map(|subject| subject.name);
        assert!(names.eq(entries().map(|entry| entry.name)));
    }
}
