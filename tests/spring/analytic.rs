//! A spring and chains of springs, whose answers are known: edges that are no part of them have stiffness 0.
use super::slow::{Vector, each};
use onering::spring::{Options, Simulation};
use onering::{DirectedEdgesSmall as Mesh, FromFaces, HalfEdgeId, Handle, Map, Topology, VertexId};
use std::f64::consts::PI;

fn v(i: usize) -> VertexId {
    VertexId::new(i)
}

fn close(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} is not {b}");
}

/// A strip of triangles over the vertices 0 to `n` in a zigzag.
fn strip(n: u32) -> (Mesh, Map<VertexId, [f32; 3]>) {
    let faces: Vec<_> =
        (0..n - 1).map(|i| if i % 2 == 0 { [i, i + 1, i + 2] } else { [i + 1, i, i + 2] }).collect();
    let mesh = Mesh::from_faces(n as usize + 1, &faces).unwrap();
    (mesh, Map::from_fn(n as usize + 1, |v: VertexId| [v.index() as f32, (v.index() % 2) as f32, 0.0]))
}

/// The springs from each vertex of the strip to the next alone.
fn chain(mesh: &Mesh, stiffness: impl Fn(usize) -> f64, fixed: &[usize]) -> Options<VertexId, HalfEdgeId> {
    let stiffness = each(mesh, |[a, b]| if b == a + 1 { stiffness(a) } else { 0.0 });
    Options { stiffness, fixed: fixed.iter().map(|&i| v(i)).collect(), ..Options::default() }
}

#[test]
fn one_spring_swings_as_a_cosine() {
    let (mesh, positions) = strip(2);
    let (k, mass, dt) = (3.0f64, 2.0, 1e-4);
    let options = Options { mass, ..chain(&mesh, |i| if i == 0 { k } else { 0.0 }, &[0]) };
    let mut sim = Simulation::new(&mesh, &positions, &options).unwrap();
    let start: Vector = [0.5, -0.25, 1.0];
    sim.displace(v(1), start).unwrap();
    for i in 1..=50_000 {
        sim.step(dt);
        if i % 1000 == 0 {
            let cosine = ((k / mass).sqrt() * dt * f64::from(i)).cos();
            (0..3).for_each(|axis| close(sim.displacements()[v(1)][axis], start[axis] * cosine, 1e-4));
        }
    }
    assert_eq!([0, 2].map(|i| sim.displacements()[v(i)]), [[0.0; 3]; 2]);
}

#[test]
fn one_damped_spring_swings_less_and_less() {
    let (mesh, positions) = strip(2);
    let (k, mass, damping, dt) = (3.0f64, 2.0, 0.7, 1e-4);
    let options = Options { mass, damping, ..chain(&mesh, |i| if i == 0 { k } else { 0.0 }, &[0]) };
    let mut sim = Simulation::new(&mesh, &positions, &options).unwrap();
    sim.displace(v(1), [1.0, 0.0, 0.0]).unwrap();
    let rate = damping / mass / 2.0;
    let omega = (k / mass - rate * rate).sqrt();
    for i in 1..=50_000 {
        sim.step(dt);
        let t = dt * f64::from(i);
        let expected = (-rate * t).exp() * ((omega * t).cos() + rate / omega * (omega * t).sin());
        close(sim.displacements()[v(1)][0], expected, 1e-4);
    }
}

#[test]
fn a_pulled_chain_stretches_link_by_link() {
    let n = 40;
    let (mesh, positions) = strip(n);
    let stiffness = |i: usize| (1 + i % 3) as f64;
    let mut sim = Simulation::new(&mesh, &positions, &chain(&mesh, stiffness, &[0])).unwrap();
    sim.push(v(n as usize), [0.0, 2.0, -1.0], 0).unwrap();
    sim.solve(1e-12, 1000).unwrap();
    let mut stretched = 0.0;
    for i in 0..=n as usize {
        close(sim.displacements()[v(i)][1], 2.0 * stretched, 1e-9);
        close(sim.displacements()[v(i)][2], -stretched, 1e-9);
        stretched += 1.0 / stiffness(i);
    }
    let reaction = sim.reaction(v(0));
    (0..3).for_each(|axis| close(reaction[axis], [0.0, -2.0, 1.0][axis], 1e-10));
}

#[test]
fn a_chain_swings_in_its_modes() {
    let n = 12;
    let (mesh, positions) = strip(n);
    let k = 5.0;
    for mode in [1, 2, 7, 11] {
        let mut sim = Simulation::new(&mesh, &positions, &chain(&mesh, |_| k, &[0, n as usize])).unwrap();
        let shape = |i: usize| (PI * f64::from(mode) * i as f64 / f64::from(n)).sin();
        mesh.vertices().take(n as usize).for_each(|v| sim.displace(v, [shape(v.index()), 0.0, 0.0]).unwrap());
        sim.displace(v(0), [0.0; 3]).unwrap();
        let omega = 2.0 * k.sqrt() * (PI * f64::from(mode) / f64::from(2 * n)).sin();
        let dt = 1e-4;
        (0..20_000).for_each(|_| sim.step(dt));
        let cosine = (omega * dt * 20_000.0).cos();
        for i in 1..n as usize {
            close(sim.displacements()[v(i)][0], shape(i) * cosine, 1e-3);
        }
    }
}

#[test]
fn rods_in_a_row_are_as_stiff_as_one_rod() {
    let (mesh, positions) = strip(2);
    let options = Options {
        stiffness: onering::spring::Stiffness::OverLength(6.0),
        fixed: vec![v(0), v(2)],
        ..Options::default()
    };
    let mut sim = Simulation::new(&mesh, &positions, &options).unwrap();
    sim.push(v(1), [1.0, 0.0, 0.0], 0).unwrap();
    sim.solve(1e-13, 10).unwrap();
    // Two rods of length √2 side by side.
    close(sim.displacements()[v(1)][0], 2f64.sqrt() / 12.0, 1e-14);
}

#[test]
fn a_held_end_pulls_the_chain() {
    let (mesh, positions) = strip(4);
    let mut sim = Simulation::new(&mesh, &positions, &chain(&mesh, |_| 1.0, &[0, 4])).unwrap();
    sim.displace(v(4), [4.0, 0.0, 0.0]).unwrap();
    sim.solve(1e-13, 100).unwrap();
    (0..=4).for_each(|i| close(sim.displacements()[v(i)][0], i as f64, 1e-12));
    close(sim.reaction(v(4))[0], 1.0, 1e-12);
}
