//! For each trait, what there is to check over it. A check has the name that the registry has.
use super::{curvature, distance, measure, normals, smoothing};
use onering::neighbours::Neighbours;
use onering::{Adjacency, FromFaces, Incidence, Topology};

pub fn topology<M: Topology + FromFaces>() {
    measure::areas_and_volumes::<M>();
    measure::real::<M>();
    normals::of_solids::<M>();
    normals::by_definition::<M>();
}

pub fn adjacency<M: Adjacency + FromFaces>() {
    measure::edges_count_once::<M>();
    curvature::gauss_bonnet::<M>();
    curvature::flat::<M>();
    curvature::sphere::<M>();
    curvature::torus::<M>();
    curvature::cylinder_and_cone::<M>();
    smoothing::by_definition::<M>();
    smoothing::plane_stays::<M>();
    smoothing::sphere_shrinks_unless_told_not_to::<M>();
}

pub fn incidence<M: Incidence + FromFaces>() {
    normals::one_by_one::<M>();
    graph::<M>();
}

pub fn graph<M: Neighbours + FromFaces>() {
    distance::by_relaxing_all::<M>();
    distance::on_a_plane::<M>();
    distance::early_end::<M>();
    distance::bad_lengths::<M>();
}
