//! Vertices and faces in an order that keeps neighbours together in memory.
