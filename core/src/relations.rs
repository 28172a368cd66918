//! The nine relations between vertices, edges and faces.
