//! What is said of a press.

use super::press::Pressed;
use crate::args;
use onering::vector::Vector;
use onering_io::Triangles;
use serde::Serialize;
use std::fmt;

/// Everything, in the shape of its JSON.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Report {
    mesh: String,
    vertices: usize,
    triangles: usize,
    backend: String,
    at: usize,
    force: Vector,
    rings: usize,
    held: usize,
    /// Steps in time, and not iterations of a solver.
    is_in_time: bool,
    iterations: usize,
    residual: Option<f64>,
    largest_displacement: f64,
    queries_ms: f64,
    total_ms: f64,
    output: Option<String>,
    picture: Option<String>,
    /// What the output could not hold.
    #[serde(skip)]
    is_displacement_lost: bool,
}

impl Report {
    pub(crate) fn of(
        options: &args::Deform,
        name: String,
        mesh: &Triangles,
        at: usize,
        pressed: &Pressed,
    ) -> Self {
        Self {
            mesh: name,
            vertices: mesh.positions.len(),
            triangles: mesh.faces.len(),
            backend: options.mesh.backend.clone(),
            at,
            force: pressed.force,
            rings: options.rings,
            held: pressed.held,
            is_in_time: options.steps.is_some(),
            iterations: pressed.iterations,
            residual: pressed.residual,
            largest_displacement: pressed.largest(),
            queries_ms: pressed.queries.as_secs_f64() * 1e3,
            total_ms: pressed.total.as_secs_f64() * 1e3,
            output: None,
            picture: None,
            is_displacement_lost: false,
        }
    }

    /// The mesh is in a file of this name, and the displacements too where it could hold them.
    pub(crate) fn wrote(&mut self, name: String, with_displacement: bool) {
        self.output = Some(name);
        self.is_displacement_lost = !with_displacement;
    }

    pub(crate) fn drew(&mut self, name: String) {
        self.picture = Some(name);
    }

    /// On a line of its own.
    pub(crate) fn json(&self) -> String {
        // Finite numbers, names and lists of these cannot fail.
        serde_json::to_string(self).unwrap_or_default() + "\n"
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { mesh, vertices, triangles, backend, at, force, rings, held, iterations, .. } = self;
        let [x, y, z] = force;
        writeln!(f, "{mesh}: {vertices} vertices, {triangles} triangles, in {backend}")?;
        writeln!(
            f,
            "  force                {x:.4},{y:.4},{z:.4} on vertex {at} and {rings} rings around it"
        )?;
        writeln!(f, "  held                 {held} vertices")?;
        match self.residual {
            Some(residual) => {
                writeln!(f, "  at rest after        {iterations} iterations, residual {residual:.1e}")?
            }
            None => writeln!(f, "  moved by             {iterations} steps in time")?,
        }
        writeln!(f, "  largest displacement {:.6}", self.largest_displacement)?;
        writeln!(f, "  neighbours of all    {:.3} ms", self.queries_ms)?;
        writeln!(f, "  total                {:.3} ms", self.total_ms)?;
        if let Some(output) = &self.output {
            let lost = if self.is_displacement_lost { " (it holds no displacements)" } else { "" };
            writeln!(f, "  written              {output}{lost}")?;
        }
        self.picture.iter().try_for_each(|picture| writeln!(f, "  drawn                {picture}"))
    }
}
