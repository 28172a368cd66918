//! [`Simulation`]: its state, and what can be asked of it.
use super::{Options, SpringError, rows::Rows};
use crate::{
    Handle, Incidence, Map, not_finite,
    vector::{self, Vector},
};

/// A mesh of springs with the displacement, the velocity and the load of each vertex, in `f64`.
///
/// Each ring is walked once, when it is made: from then on the springs lie in rows of their own.
/// ([`step_walking`](Self::step_walking) walks them in the mesh.) Fixed vertices keep their displacement, and take any force.
/// The parts of a mesh that no springs join move each on its own.
///
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Handle, Map, VertexId, spring::{Options, Simulation}};
/// let mesh = Mesh::from_faces(3, &[[0, 1, 2]])?;
/// let positions = Map::from(vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
/// let fixed = [0, 1].map(VertexId::new).to_vec();
/// let mut sim = Simulation::new(&mesh, &positions, &Options { fixed, ..Options::default() })?;
/// sim.push(VertexId::new(2), [0.0, 0.0, -1.0], 0)?;
/// sim.solve(1e-12, 10)?;
/// assert_eq!(sim.displacements()[VertexId::new(2)], [0.0, 0.0, -0.5]); // two springs of stiffness 1
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Simulation<'a, M: Incidence> {
    pub(super) mesh: &'a M,
    pub(super) rows: Rows<M::Vertex>,
    pub(super) mass: f64,
    pub(super) damping: f64,
    pub(super) is_fixed: Map<M::Vertex, bool>,
    rest: Map<M::Vertex, [f32; 3]>,
    pub(super) displacement: Map<M::Vertex, Vector>,
    pub(super) velocity: Map<M::Vertex, Vector>,
    pub(super) load: Map<M::Vertex, Vector>,
}

impl<'a, M: Incidence> Simulation<'a, M> {
    /// The mesh at rest, without loads.
    ///
    /// # Arguments
    /// `positions` are those at rest.
    ///
    /// # Complexity
    /// O(half-edges), which is the only time that they are walked; 24 bytes for each edge and 93 for each vertex are kept.
    ///
    /// # Errors
    /// A position or an option that is no number to calculate with, an edge of length zero, and a fixed vertex that does
    /// not exist: see [`SpringError`].
    ///
    /// # Panics
    /// Where `positions`, or the stiffness of each edge, ends before the elements of the mesh do.
    ///
    /// # Source
    /// Biscaro et al. (2016), Eqs. (8) and (9).
    pub fn new(
        mesh: &'a M,
        positions: &Map<M::Vertex, [f32; 3]>,
        options: &Options<M::Vertex, M::HalfEdge>,
    ) -> Result<Self, SpringError> {
        let &Options { mass, damping, .. } = options;
        if !(mass > 0.0 && mass.is_finite()) {
            return Err(SpringError::Mass { value: mass });
        }
        if !(damping >= 0.0 && damping.is_finite()) {
            return Err(SpringError::Damping { value: damping });
        }
        not_finite::positions(positions)?;
        let count = mesh.vertex_count();
        let mut is_fixed = Map::filled(count, false);
        for &v in &options.fixed {
            exists(v, count)?;
            is_fixed[v] = true;
        }
        Ok(Self {
            rows: Rows::new(mesh, positions, &options.stiffness)?,
            mesh,
            mass,
            damping,
            is_fixed,
            rest: mesh.vertices().map(|v| positions[v]).collect(),
            displacement: Map::filled(count, [0.0; 3]),
            velocity: Map::filled(count, [0.0; 3]),
            load: Map::filled(count, [0.0; 3]),
        })
    }

    /// Where the vertices are: at rest plus displacement, rounded. O(vertices).
    pub fn positions(&self) -> Map<M::Vertex, [f32; 3]> {
        let moved = |(v, &p): (M::Vertex, &[f32; 3])| vector::plus(vector::of(p), self.displacement[v]);
        self.rest.iter().map(|cell| vector::rounded(moved(cell))).collect()
    }

    /// How far each vertex is from where it is at rest.
    pub fn displacements(&self) -> &Map<M::Vertex, Vector> {
        &self.displacement
    }

    /// The velocity of each vertex.
    pub fn velocities(&self) -> &Map<M::Vertex, Vector> {
        &self.velocity
    }

    /// The sum of the forces that [`push`](Self::push) laid on each vertex.
    pub fn loads(&self) -> &Map<M::Vertex, Vector> {
        &self.load
    }

    /// Moves a vertex to this displacement, with the velocity that it has; a fixed one is held there.
    ///
    /// # Errors
    /// [`SpringError::NoSuchVertex`], and [`SpringError::Vector`] where a coordinate is no number to calculate with.
    pub fn displace(&mut self, v: M::Vertex, displacement: Vector) -> Result<(), SpringError> {
        self.checked(v, displacement)?;
        self.displacement[v] = displacement;
        Ok(())
    }

    /// Gives a vertex this velocity. A fixed one stays at rest.
    ///
    /// # Errors
    /// As [`displace`](Self::displace).
    pub fn throw(&mut self, v: M::Vertex, velocity: Vector) -> Result<(), SpringError> {
        self.checked(v, velocity)?;
        if !self.is_fixed[v] {
            self.velocity[v] = velocity;
        }
        Ok(())
    }

    /// The force that holds a fixed vertex where it is, against springs and loads. A free one is held by none.
    /// O(degree).
    ///
    /// # Panics
    /// Where `v` is out of range.
    pub fn reaction(&self, v: M::Vertex) -> Vector {
        if self.is_fixed[v] {
            vector::times(-1.0, vector::plus(self.spring_force(v), self.load[v]))
        } else {
            [0.0; 3]
        }
    }

    /// Kinetic energy, energy of the springs, and that of the loads in their displacement (`-f δ`). O(edges).
    ///
    /// Without damping [`step`](Self::step) keeps it up to a bounded error.
    pub fn energy(&self) -> f64 {
        let twice = |v| {
            let d = self.displacement[v];
            // Each spring is in the rows of both its ends; so half of `-δ f` summed is its energy.
            let springs = -vector::dot(d, self.spring_force(v));
            self.mass * vector::dot(self.velocity[v], self.velocity[v]) + springs
                - 2.0 * vector::dot(d, self.load[v])
        };
        self.mesh.vertices().map(twice).sum::<f64>() / 2.0
    }

    /// Mass times velocity, summed: constant where nothing is fixed, loaded or damped. O(vertices).
    pub fn momentum(&self) -> Vector {
        let sum = self.velocity.as_slice().iter().fold([0.0; 3], |sum, &v| vector::plus(sum, v));
        vector::times(self.mass, sum)
    }

    /// The force of the springs on `v`.
    #[inline]
    pub(super) fn spring_force(&self, v: M::Vertex) -> Vector {
        self.rows.force(v, self.rows.neighbours(v), self.displacement.as_slice())
    }

    /// Checks that `v` exists and that the vector for it is finite.
    pub(super) fn checked(&self, v: M::Vertex, vector: Vector) -> Result<(), SpringError> {
        exists(v, self.rest.len())?;
        if vector.iter().all(|x| x.is_finite()) {
            Ok(())
        } else {
            Err(SpringError::Vector { vertex: v.index() })
        }
    }
}

fn exists<V: Handle>(v: V, vertex_count: usize) -> Result<(), SpringError> {
    if v.index() < vertex_count {
        return Ok(());
    }
    Err(SpringError::NoSuchVertex { vertex: v.index(), vertex_count })
}
