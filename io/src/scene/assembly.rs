//! Geometry nodes to one mesh.

use super::faces::{Corners, Leftover, fan, strip};
use super::{Coordinates, Field, Geometry, Kind, Scene};
use crate::error::quote;
use crate::memory::{push, reserve};
use crate::number::f32_of;
use crate::polygons::Polygons;
use crate::{Error, Place, Reason, Skipped, Triangles, proportion};

/// The mesh of all geometry nodes, in their order.
pub(super) fn triangles(mut scene: Scene<'_>) -> Result<Triangles, Error> {
    let mut geometries = std::mem::take(&mut scene.geometries);
    for geometry in &mut geometries {
        if let Some(Coordinates::Named(name, at)) = &geometry.coordinates {
            geometry.coordinates = Some(Coordinates::Node(scene.named(name, *at)?));
        }
    }
    let mut assembly = Assembly::new(&scene, &geometries)?;
    for geometry in &geometries {
        assembly.add(geometry)?;
    }
    let Assembly { mut positions, polygons, left_out, .. } = assembly;
    for (what, count, at) in left_out {
        scene.note(what, count, at);
    }
    positions.shrink_to_fit();
    Ok(polygons.into_triangles(positions, scene.notes))
}

struct Assembly<'a> {
    scene: &'a Scene<'a>,
    points: Vec<Points>,
    /// How many positions are still to come from points that were read.
    promised: usize,
    positions: Vec<[f32; 3]>,
    polygons: Polygons,
    /// Kinds, how often, and the first byte.
    left_out: Vec<(Skipped, usize, usize)>,
}

/// The points of a Coordinate node.
#[derive(Clone, Copy, Default)]
struct Points {
    /// How many geometry nodes have them.
    uses: usize,
    /// Where they were put first, and how many they are.
    read: Option<(usize, usize)>,
}

impl<'a> Assembly<'a> {
    fn new(scene: &'a Scene<'a>, geometries: &[Geometry<'_>]) -> Result<Self, Error> {
        let mut points: Vec<Points> = Vec::new();
        reserve(&mut points, scene.points.len())?;
        points.resize(scene.points.len(), Points::default());
        for geometry in geometries {
            if let Some(Coordinates::Node(number)) = geometry.coordinates {
                points[number].uses += 1;
            }
        }
        let (positions, polygons, left_out) = (Vec::new(), Polygons::default(), Vec::new());
        Ok(Self { scene, points, promised: 0, positions, polygons, left_out })
    }

    /// Appends the points of a geometry node, all of them, and its faces.
    fn add(&mut self, geometry: &Geometry<'_>) -> Result<(), Error> {
        let Some(Coordinates::Node(number)) = geometry.coordinates else {
            self.leave_out(Skipped::NoPositions, 1, geometry.at);
            return Ok(());
        };
        let base = self.positions.len();
        self.add_points(number)?;
        let too_many = || Error::malformed(self.scene.format, Place::File, Reason::TooMany);
        let end = u32::try_from(self.positions.len()).map_err(|_| too_many())?;
        self.add_faces(geometry, base as u32, end - base as u32)?;
        if self.polygons.faces().len() > u32::MAX as usize {
            return Err(too_many());
        }
        if geometry.is_clockwise {
            self.leave_out(Skipped::Clockwise, 1, geometry.at);
        }
        self.check_proportion()
    }

    /// Appends the points of a Coordinate node. However often it is named, its numbers are read once.
    fn add_points(&mut self, number: usize) -> Result<(), Error> {
        let Points { uses, read } = self.points[number];
        if let Some((first, count)) = read {
            self.promised -= count;
            reserve(&mut self.positions, count)?;
            self.positions.extend_from_within(first..first + count);
            return Ok(());
        }
        let first = self.positions.len();
        self.read_points(&self.scene.points[number])?;
        let count = self.positions.len() - first;
        self.points[number].read = Some((first, count));
        // Refused before the first of them is appended again.
        self.promised = self.promised.saturating_add(count.saturating_mul(uses - 1));
        self.check_proportion()
    }

    fn read_points(&mut self, field: &Field) -> Result<(), Error> {
        let mut numbers = field.numbers(self.scene);
        let (mut point, mut found) = ([0.0; 3], 0);
        while let Some(word) = numbers.next() {
            let bad = || numbers.malformed(Reason::BadNumber { word: quote(word) });
            point[found] = f32_of(word).ok_or_else(bad)?;
            found += 1;
            if found == 3 {
                push(&mut self.positions, point)?;
                found = 0;
            }
        }
        if found == 0 { Ok(()) } else { Err(numbers.malformed(Reason::TooFewCoordinates { found })) }
    }

    fn add_faces(&mut self, geometry: &Geometry<'_>, base: u32, count: u32) -> Result<(), Error> {
        let corners = Corners::new(geometry.index.numbers(self.scene), base, count);
        let out = &mut self.polygons;
        let (what, Leftover { count, first }) = match geometry.kind {
            Kind::Faces => (Skipped::ShortFaces, corners.polygons(out)?),
            Kind::IndexedTriangles => (Skipped::LooseCorners, corners.triangles(out)?),
            Kind::Strips => (Skipped::LooseCorners, corners.runs(strip, out)?),
            Kind::Fans => (Skipped::LooseCorners, corners.runs(fan, out)?),
            Kind::Triangles => {
                (0..count / 3).try_for_each(|i| out.triangle([0, 1, 2].map(|k| base + 3 * i + k)))?;
                (Skipped::LooseCorners, Leftover { count: count as usize % 3, first: geometry.at })
            }
        };
        if count > 0 {
            self.leave_out(what, count, first);
        }
        Ok(())
    }

    /// Refuses a mesh out of all proportion to the file.
    fn check_proportion(&self) -> Result<(), Error> {
        let read = self.positions.len() + self.polygons.faces().len();
        let elements = read.saturating_add(self.promised) as u64;
        let check = proportion::check(elements, self.scene.input_bytes);
        check.map_err(|reason| Error::malformed(self.scene.format, Place::File, reason))
    }

    fn leave_out(&mut self, what: Skipped, count: usize, at: usize) {
        match self.left_out.iter_mut().find(|(known, ..)| *known == what) {
            Some((_, counted, _)) => *counted += count,
            None => self.left_out.push((what, count, at)),
        }
    }
}
