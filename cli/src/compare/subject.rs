//! The backends of the registry as things to measure, their types forgotten.

use super::kernels::Kernels;
use super::measure::{self, Measured, Plan};
use onering::{BuildError, Searched, SharedVertex};

/// A backend by what can be done with it here.
pub(crate) struct Subject {
    /// Its name in the registry, or of the baseline.
    pub(crate) name: &'static str,
    /// Builds it and asks it everything that it can answer.
    pub(crate) measure: fn(&Plan<'_>) -> Result<Measured, BuildError>,
}

macro_rules! subjects {
    ($($module:ident $name:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {
        /// Every backend, in the order of the registry.
        pub(crate) const SUBJECTS: &[Subject] = &[$(Subject {
            name: $name,
            measure: |plan| measure::backend::<$mesh>(plan, &Kernels::new()$(.$has())*),
        }),+];
    };
}
onering::with_backends!(subjects);

/// What the structures are to be better than: the bare list of faces, all of it searched for every answer.
pub(crate) const BASELINE: Subject = Subject {
    name: "no data structure",
    measure: |plan| {
        measure::searched(plan, &Kernels::<Searched<SharedVertex>>::new().topology().adjacency().incidence())
    },
};

#[cfg(test)]
mod tests {
    use super::*;
    use onering::registry::BACKENDS;

    #[test]
    fn places_are_those_of_the_registry() {
        let names = |i: usize| (SUBJECTS[i].name, BACKENDS[i].name);
        assert_eq!(SUBJECTS.len(), BACKENDS.len());
        assert!((0..SUBJECTS.len()).all(|i| names(i).0 == names(i).1));
    }
}
