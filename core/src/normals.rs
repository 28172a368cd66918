//! Normals of faces and vertices.
