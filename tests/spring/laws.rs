//! Energy, momentum, balance and linearity.
use super::shapes::grid;
use super::slow::{Springs, Vector, agree, dot, forces, springs, sum};
use onering::spring::{Options, Simulation, Stiffness};
use onering::{CheL2 as Mesh, FromFaces, HalfEdgeId, Handle, Map, Topology, VertexId};

type Settings = Options<VertexId, HalfEdgeId>;

fn v(i: usize) -> VertexId {
    VertexId::new(i)
}

/// A sheet of 7 by 7 vertices, and its springs.
fn sheet() -> (Mesh, Map<VertexId, [f32; 3]>, Springs) {
    let (n, faces) = grid(6, 6, [false, false], false);
    let positions = Map::from_fn(n, |v: VertexId| [(v.index() / 7) as f32, (v.index() % 7) as f32, 0.0]);
    (Mesh::from_faces(n, &faces).unwrap(), positions, springs(&faces, |_| 1.0))
}

fn kicked<'a>(
    mesh: &'a Mesh,
    positions: &Map<VertexId, [f32; 3]>,
    options: &Settings,
) -> Simulation<'a, Mesh> {
    let mut sim = Simulation::new(mesh, positions, options).unwrap();
    for v in mesh.vertices() {
        let i = v.index() as f64;
        sim.displace(v, [i.sin(), (2.0 * i).cos(), (i * i).sin()]).unwrap();
        sim.throw(v, [(3.0 * i).sin(), 1.0, -i.cos()]).unwrap();
    }
    sim
}

fn kinetic(sim: &Simulation<'_, Mesh>) -> f64 {
    dot(sim.velocities().as_slice(), sim.velocities().as_slice()) / 2.0
}

/// The energy that steps of this length keep: `H - dt v K x / 2`.
fn kept(sim: &Simulation<'_, Mesh>, springs: &Springs, dt: f64) -> f64 {
    let x = sim.displacements().as_slice();
    let force = forces(springs, x);
    kinetic(sim) - dot(x, &force) / 2.0 + dt * dot(sim.velocities().as_slice(), &force) / 2.0
}

#[test]
fn energy_is_that_of_masses_and_springs() {
    let (mesh, positions, springs) = sheet();
    let mut sim = kicked(&mesh, &positions, &Options::default());
    let x = sim.displacements().as_slice();
    let stretched: f64 =
        springs.iter().map(|&([a, b], k)| k * (0..3).map(|i| (x[a][i] - x[b][i]).powi(2)).sum::<f64>()).sum();
    assert!((sim.energy() - kinetic(&sim) - stretched / 2.0).abs() < 1e-10);
    let (before, height) = (sim.energy(), x[9][2]);
    sim.push(v(9), [0.0, 0.0, 4.0], 0).unwrap();
    assert!((sim.energy() - before + 4.0 * height).abs() < 1e-10);
}

#[test]
fn energy_is_kept_without_damping() {
    let (mesh, positions, springs) = sheet();
    let options = Options { fixed: vec![v(0)], ..Options::default() };
    for part in [0.1, 0.99] {
        let mut sim = kicked(&mesh, &positions, &options);
        sim.displace(v(0), [0.0; 3]).unwrap();
        let dt = part * sim.stable_step();
        let (energy, exact) = (sim.energy(), kept(&sim, &springs, dt));
        for _ in 0..3000 {
            sim.step(dt);
            assert!((kept(&sim, &springs, dt) - exact).abs() < 1e-9 * exact);
            // |dt v K x / 2| is at most `part` of the energy.
            assert!(sim.energy() <= energy * (1.0 + part) / (1.0 - part));
            assert!(sim.energy() >= energy * (1.0 - part) / (1.0 + part));
        }
    }
}

#[test]
fn damping_takes_energy_in_each_step_and_in_the_end_all() {
    let (mesh, positions, springs) = sheet();
    for damping in [0.1, 3.0, 1e4] {
        let mut sim =
            kicked(&mesh, &positions, &Options { damping, fixed: vec![v(3)], ..Options::default() });
        let dt = 0.99 * sim.stable_step();
        let mut before = kept(&sim, &springs, dt);
        let start = before;
        for _ in 0..5000 {
            sim.step(dt);
            let after = kept(&sim, &springs, dt);
            assert!(after <= before + 1e-12 * start, "damping {damping}: {before} to {after}");
            before = after;
        }
        assert!(damping > 1e3 || before < 1e-6 * start + kept_when_held(&sim), "{before}");
    }
}

/// Vertex 3 is held where it was moved to, so what is left is the mesh moved as a whole.
fn kept_when_held(sim: &Simulation<'_, Mesh>) -> f64 {
    let held = sim.displacements()[v(3)];
    assert!(agree(sim.displacements().as_slice(), &[held; 49], 1e-3));
    1e-6
}

#[test]
fn the_limit_is_sharp() {
    // Two masses with one spring: the highest frequency is the bound of Gershgorin itself.
    let mesh = Mesh::from_faces(3, &[[0, 1, 2]]).unwrap();
    let positions = Map::from(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    let largest = |part: f64, damping| {
        let stiffness = Stiffness::Each(vec![2.0, 0.0, 0.0].into());
        let options = Options { stiffness, mass: 0.5, damping, ..Options::default() };
        let mut sim = Simulation::new(&mesh, &positions, &options).unwrap();
        assert!((sim.stable_step() - 2.0 / 8f64.sqrt()).abs() < 1e-15);
        sim.displace(v(0), [1.0, 0.0, 0.0]).unwrap();
        let dt = part * sim.stable_step();
        (0..2000).for_each(|_| sim.step(dt));
        sim.displacements()[v(0)][0].abs()
    };
    assert!(largest(0.999, 0.0) < 100.0 && largest(0.999, 50.0) < 100.0);
    assert!(largest(1.01, 0.0) > 1e9 && largest(1.01, 0.01) > 1e9);
}

#[test]
fn without_springs_any_step_will_do() {
    let mesh = Mesh::from_faces(2, &[]).unwrap();
    let mut sim = Simulation::new(&mesh, &Map::filled(2, [0.0; 3]), &Options::default()).unwrap();
    assert_eq!(sim.stable_step(), f64::INFINITY);
    sim.push(v(1), [0.0, 0.0, 1.0], 5).unwrap();
    sim.step(1.0);
    assert_eq!(sim.positions().as_slice(), [[0.0; 3], [0.0, 0.0, 1.0]]);
}

#[test]
fn momentum_changes_by_loads_alone() {
    let (mesh, positions, _) = sheet();
    let mut sim = kicked(&mesh, &positions, &Options { mass: 3.0, ..Options::default() });
    let start = sim.momentum();
    let by_hand = sum(sim.velocities().as_slice()).map(|p| 3.0 * p);
    assert!(agree(&[start], &[by_hand], 1e-14));
    let dt = sim.stable_step() / 2.0;
    (0..1000).for_each(|_| sim.step(dt));
    assert!(agree(&[sim.momentum()], &[start], 1e-12));
    sim.push(v(10), [0.0, 5.0, -2.0], 2).unwrap();
    (0..1000).for_each(|_| sim.step(dt));
    let gained = 1000.0 * dt;
    let expected = [start[0], start[1] + 5.0 * gained, start[2] - 2.0 * gained];
    assert!(agree(&[sim.momentum()], &[expected], 1e-12));
}

#[test]
fn damped_motion_ends_in_the_static_solution() {
    let (mesh, positions, _) = sheet();
    let options = Options { damping: 0.5, fixed: vec![v(0), v(6), v(42)], ..Options::default() };
    let mut sim = Simulation::new(&mesh, &positions, &options).unwrap();
    sim.push(v(24), [0.2, 0.0, -1.0], 2).unwrap();
    let mut moved = Simulation::new(&mesh, &positions, &options).unwrap();
    moved.push(v(24), [0.2, 0.0, -1.0], 2).unwrap();
    let dt = 0.9 * moved.stable_step();
    (0..20_000).for_each(|_| moved.step(dt));
    sim.solve(1e-12, 200).unwrap();
    assert!(agree(sim.displacements().as_slice(), moved.displacements().as_slice(), 1e-9));
    // From where it is at rest already, nothing is left to do; without loads it goes back.
    assert_eq!(sim.solve(1e-10, 0).unwrap().iterations, 0);
    sim.release();
    sim.solve(1e-12, 0).unwrap();
    assert_eq!(sim.positions(), positions);
}

fn solved(loads: &[(usize, Vector, usize)]) -> Vec<Vector> {
    let (mesh, positions, _) = sheet();
    let options = Options { fixed: vec![v(0), v(48)], ..Options::default() };
    let mut sim = Simulation::new(&mesh, &positions, &options).unwrap();
    loads.iter().for_each(|&(i, force, rings)| sim.push(v(i), force, rings).unwrap());
    sim.solve(1e-13, 500).unwrap();
    let held = [0, 48].map(|i| sim.reaction(v(i)));
    assert!(agree(&[sum(&held)], &[sum(sim.loads().as_slice()).map(|f| -f)], 1e-11));
    sim.displacements().as_slice().to_vec()
}

#[test]
fn loads_add_up() {
    let (a, b) = ((16, [1.0, 0.0, -3.0], 2), (40, [0.0, 2.0, 0.5], 1));
    let apart: Vec<_> =
        solved(&[a]).into_iter().zip(solved(&[b])).map(|(a, b)| [0, 1, 2].map(|i| a[i] + b[i])).collect();
    assert!(agree(&solved(&[a, b]), &apart, 1e-11));
}

#[test]
fn what_is_symmetric_stays_so() {
    // The sheet is its own mirror image across the diagonal of its quads.
    let moved = solved(&[(24, [0.0, 0.0, -1.0], 2)]);
    let mirrored: Vec<_> = (0..49).map(|i| moved[i % 7 * 7 + i / 7]).collect();
    assert!(agree(&moved, &mirrored, 1e-12));
    assert!(moved[24][2] < moved[8][2] && moved[8][2] < 0.0);
}

#[test]
fn a_force_falls_off_from_ring_to_ring() {
    let (mesh, positions, _) = sheet();
    let mut sim = Simulation::new(&mesh, &positions, &Options::default()).unwrap();
    sim.push(v(24), [0.0, 0.0, -11.0], 1).unwrap();
    // The vertex has 2 of 2 + 6 parts, each of its six neighbours one.
    let bears = |sim: &Simulation<'_, Mesh>, i| sim.loads()[v(i)][2];
    assert_eq!(bears(&sim, 24), -11.0 * 2.0 / 8.0);
    assert_eq!([16, 17, 23, 25, 31, 32].map(|i| bears(&sim, i)), [-11.0 / 8.0; 6]);
    assert_eq!(sim.loads().as_slice().iter().filter(|f| f[2] != 0.0).count(), 7);
    sim.push(v(24), [0.0, 0.0, 11.0], 1).unwrap();
    assert!(sim.loads().as_slice().iter().all(|&f| f == [0.0; 3]));
    for (i, rings) in [(0, 0), (0, 3), (6, 4), (24, usize::MAX)] {
        sim.release();
        sim.push(v(i), [1.0, -2.0, 3.0], rings).unwrap();
        assert!(agree(&[sum(sim.loads().as_slice())], &[[1.0, -2.0, 3.0]], 1e-12));
    }
}
