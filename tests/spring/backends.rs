//! What every backend has to agree on, over the meshes of the conformance corpus that it holds.
use super::shapes::Random;
use super::slow::{Springs, Vector, agree, at_rest, each, forces, springs};
use onering::conformance::{Case, corpus};
use onering::spring::{Options, Simulation, SpringError};
use onering::{FromFaces, Handle, Incidence, Map};

fn held<M: FromFaces>() -> Vec<(Case, M)> {
    let meshes = corpus().into_iter();
    let held: Vec<_> = meshes
        .filter_map(|case| M::from_faces(case.vertices, &case.faces).ok().map(|mesh| (case, mesh)))
        .collect();
    assert!(held.len() >= 5);
    held
}

fn stiffness([a, b]: [usize; 2]) -> f64 {
    (1 + (7 * a + 3 * b) % 5) as f64
}

fn positions<V: Handle>(count: usize) -> Map<V, [f32; 3]> {
    let mut random = Random(5);
    Map::from_fn(count, |v: V| [v.index() as f32, random.below(100) as f32, random.below(100) as f32])
}

fn vectors(count: usize) -> Vec<Vector> {
    let mut random = Random(9);
    (0..count).map(|_| [(); 3].map(|()| random.below(2000) as f64 / 1000.0 - 1.0)).collect()
}

pub fn moves_as_the_edges_say<M: Incidence + FromFaces>() {
    for (case, mesh) in held::<M>() {
        let n = case.vertices;
        let springs = springs(&case.faces, stiffness);
        let options = Options {
            stiffness: each(&mesh, stiffness),
            mass: 2.0,
            damping: 0.5,
            fixed: mesh.vertices().step_by(4).collect(),
        };
        let mut sim = Simulation::new(&mesh, &positions(n), &options).unwrap();
        let mut x = vec![[0.0; 3]; n];
        let mut velocity = vectors(n);
        for v in mesh.vertices() {
            sim.throw(v, velocity[v.index()]).unwrap();
        }
        (0..n).step_by(4).for_each(|v| velocity[v] = [0.0; 3]);
        let mut walking = Simulation::new(&mesh, &positions(n), &options).unwrap();
        mesh.vertices().for_each(|v| walking.throw(v, velocity[v.index()]).unwrap());
        let dt = 0.05;
        for _ in 0..20 {
            sim.step(dt);
            walking.step_walking(dt);
            let force = forces(&springs, &x);
            for v in (0..n).filter(|v| v % 4 != 0) {
                for axis in 0..3 {
                    let old = velocity[v][axis];
                    // m (new - old) / dt = f - c (new + old) / 2
                    let new = (old * (2.0 / dt - 0.25) + force[v][axis]) / (2.0 / dt + 0.25);
                    velocity[v][axis] = new;
                    x[v][axis] += dt * new;
                }
            }
        }
        assert!(agree(sim.displacements().as_slice(), &x, 1e-12), "{}", case.name);
        assert!(agree(sim.velocities().as_slice(), &velocity, 1e-12), "{}", case.name);
        assert_eq!(sim.displacements(), walking.displacements(), "{}", case.name);
    }
}

pub fn rests_where_the_edges_say<M: Incidence + FromFaces>() {
    for (case, mesh) in held::<M>() {
        let n = case.vertices;
        let springs = springs(&case.faces, stiffness);
        let supported = supported(&springs, n);
        let options = Options {
            stiffness: each(&mesh, stiffness),
            fixed: mesh.vertices().take(1).collect(),
            ..Options::default()
        };
        let mut sim = Simulation::new(&mesh, &positions(n), &options).unwrap();
        let mut loads = vectors(n);
        for v in mesh.vertices() {
            if supported[v.index()] {
                sim.push(v, loads[v.index()], 0).unwrap();
            } else {
                loads[v.index()] = [0.0; 3];
            }
        }
        let solved = sim.solve(1e-13, 1000).unwrap_or_else(|error| panic!("{}: {error}", case.name));
        assert!(solved.residual <= 1e-13);
        let moving: Vec<bool> = (0..n).map(|v| supported[v] && v > 0).collect();
        assert!(
            agree(sim.displacements().as_slice(), &at_rest(&springs, &loads, &moving), 1e-10),
            "{}",
            case.name
        );

        if let Some(v) = mesh.vertices().find(|v| !supported[v.index()]) {
            sim.push(v, [1.0, 0.0, 0.0], 0).unwrap();
            assert_eq!(sim.solve(1e-13, 1000), Err(SpringError::Unsupported { vertex: v.index() }));
        }
    }
}

/// Which vertices edges join to vertex 0.
fn supported(springs: &Springs, n: usize) -> Vec<bool> {
    let mut supported: Vec<bool> = (0..n).map(|v| v == 0).collect();
    for _ in 0..n {
        for &([a, b], _) in springs {
            let either = supported[a] || supported[b];
            (supported[a], supported[b]) = (either, either);
        }
    }
    supported
}
