//! What is particular to each hand-written backend. The laws that all backends obey are elsewhere.
mod adjacency_graph;
mod half_edge;
mod mate_face;
mod meshes;
mod soups;
mod vertex_graph;
mod winged_edge;
