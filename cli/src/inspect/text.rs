//! Figures for people to read.

use super::figures::{Inspection, Topology, Welded};
use onering_io::one_line;
use std::collections::BTreeMap;
use std::fmt::{Display, Write};

/// All that is said of a file: the verdict, then a figure a line.
pub(crate) fn lines(of: &Inspection) -> String {
    let mut text = format!("{}: {}\n", one_line(&of.file), of.verdict);
    let mut line = |name: &str, value: &dyn Display| {
        let _ = writeln!(text, "  {name:<34}{value}");
    };
    line("format", &of.format);
    line("bytes", &of.bytes);
    line("sha256", &of.sha256);
    if let (Some(primitives), Some(buffers)) = (of.primitives, &of.gltf_buffers) {
        line("primitives", &primitives);
        line("gltf_buffers", &buffers.join(", "));
    }
    line("vertices", &of.vertices);
    line("polygons", &of.polygons);
    line("polygon_sizes", &counts(&of.polygon_sizes));
    line("triangles", &of.triangles);
    line("finite_coordinates", &of.finite_coordinates);
    line("bbox_min", &or_none(of.bbox_min.map(point)));
    line("bbox_max", &or_none(of.bbox_max.map(point)));
    line("area", &or_none(of.area));
    line("signed_volume", &or_none(of.signed_volume));
    line("degree_histogram", &counts(&of.degree_histogram));
    line("tri_sha256", &of.tri_sha256);
    line("tri_canonical_sha256", &of.tri_canonical_sha256);
    of.notes.iter().for_each(|note| line("note", note));
    text + &table(of) + "\n"
}

/// The figures of the topology, as loaded and welded side by side.
fn table(of: &Inspection) -> String {
    let welded = match &of.welded {
        Welded::Same(_) => None,
        Welded::Other(topology) => Some(topology),
    };
    let mut text = match welded {
        None => format!("  {:<34}{:>12}   welded: the same\n", "topology", "as loaded"),
        Some(_) => format!("  {:<34}{:>12}{:>12}\n", "topology", "as loaded", "welded"),
    };
    let vertices = |topology: &Topology| topology.vertices.unwrap_or(of.vertices);
    let _ = write!(text, "  {:<34}{:>12}", "vertices", vertices(&of.topology));
    let _ = writeln!(text, "{}", right(welded.map(vertices)));
    for (i, (name, figure)) in of.topology.figures.iter().enumerate() {
        let other = welded.map(|topology| topology.figures[i].1);
        let _ = writeln!(text, "  {name:<34}{:>12}{}", figure.to_string(), right(other));
    }
    text
}

fn right(value: Option<impl Display>) -> String {
    value.map_or(String::new(), |value| format!("{:>12}", value.to_string()))
}

fn or_none(value: Option<impl Display>) -> String {
    value.map_or("-".into(), |value| value.to_string())
}

fn point([x, y, z]: [f64; 3]) -> String {
    format!("{x} {y} {z}")
}

/// `3: 32, 4: 468`
fn counts(of: &BTreeMap<usize, usize>) -> String {
    let items: Vec<String> = of.iter().map(|(size, count)| format!("{size}: {count}")).collect();
    items.join(", ")
}
