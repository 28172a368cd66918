//! Normals of a surface as the camera sees it.

use onering::vector::{self, Vector};

/// Twice the area vector of the face: its length is twice the area, and it points to where the corners are
/// counter-clockwise.
pub(crate) fn of_face([a, b, c]: [[f32; 3]; 3]) -> Vector {
    let [a, b, c] = [a, b, c].map(vector::of);
    vector::cross(vector::minus(b, a), vector::minus(c, a))
}

/// For each vertex the sum of the area vectors of its faces. A vertex at which they cancel has none to speak of.
pub(crate) fn of(positions: &[[f32; 3]], faces: &[[u32; 3]]) -> Vec<[f32; 3]> {
    let mut normals = vec![[0.0_f32; 3]; positions.len()];
    for &face in faces {
        let normal = vector::rounded(of_face(face.map(|v| positions[v as usize])));
        for v in face {
            (0..3).for_each(|i| normals[v as usize][i] += normal[i]);
        }
    }
    normals
}
