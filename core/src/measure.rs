//! Areas, volume, bounding box, length of edges.
