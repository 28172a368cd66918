//! What is refused, and parts without support.
use onering::spring::{Options, Simulation, SpringError, Stiffness};
use onering::{CheL2 as Mesh, FromFaces, HalfEdgeId, Handle, Map, VertexId};

type Settings = Options<VertexId, HalfEdgeId>;

fn v(i: usize) -> VertexId {
    VertexId::new(i)
}

/// Two triangles apart, and an isolated vertex.
fn parts() -> (Mesh, Map<VertexId, [f32; 3]>) {
    let mesh = Mesh::from_faces(7, &[[0, 1, 2], [3, 4, 5]]).unwrap();
    (mesh, Map::from_fn(7, |v: VertexId| [v.index() as f32, (v.index() % 2) as f32, 0.0]))
}

fn refused(change: impl FnOnce(&mut Map<VertexId, [f32; 3]>, &mut Settings)) -> SpringError {
    let (mesh, mut positions) = parts();
    let mut options = Options::default();
    change(&mut positions, &mut options);
    Simulation::new(&mesh, &positions, &options).expect_err("an error")
}

#[test]
fn bad_meshes_and_options_are_refused() {
    let error = refused(|positions, _| positions[v(4)][1] = f32::NAN);
    assert_eq!(error.to_string(), "vertex 4 has a coordinate or a value that is infinite or no number");
    let error = refused(|positions, _| positions[v(5)] = positions[v(3)]);
    assert_eq!(error, SpringError::ZeroLength { vertices: [3, 5] });
    assert_eq!(error.to_string(), "the edge 3-5 has length zero: both vertices have the same position");
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        let error = refused(|_, options| options.stiffness = Stiffness::Same(bad));
        assert!(matches!(error, SpringError::Stiffness { vertices: [0, 1], .. }));
        let error = refused(|_, options| {
            options.stiffness = Stiffness::Each(vec![1.0, 1.0, 1.0, 1.0, bad, 1.0].into())
        });
        assert!(matches!(error, SpringError::Stiffness { vertices: [4, 5], .. }), "{error}");
        assert!(matches!(refused(|_, options| options.mass = bad), SpringError::Mass { .. }));
        assert!(matches!(refused(|_, options| options.damping = bad), SpringError::Damping { .. }));
    }
    assert!(matches!(refused(|_, options| options.mass = 0.0), SpringError::Mass { .. }));
    assert!(matches!(
        refused(|_, options| options.stiffness = Stiffness::Same(f64::MAX)),
        SpringError::Stiffness { .. }
    ));
    let error = refused(|_, options| options.fixed = vec![v(7)]);
    assert_eq!(error, SpringError::NoSuchVertex { vertex: 7, vertex_count: 7 });
}

#[test]
fn bad_vectors_are_refused_and_change_nothing() {
    let (mesh, positions) = parts();
    let mut sim = Simulation::new(&mesh, &positions, &Options::default()).unwrap();
    for bad in [[f64::NAN, 0.0, 0.0], [0.0, f64::INFINITY, 0.0]] {
        let error = Err(SpringError::Vector { vertex: 2 });
        assert_eq!(
            [sim.push(v(2), bad, 1), sim.displace(v(2), bad), sim.throw(v(2), bad)],
            [error.clone(), error.clone(), error]
        );
    }
    assert_eq!(sim.push(v(9), [1.0; 3], 1), Err(SpringError::NoSuchVertex { vertex: 9, vertex_count: 7 }));
    assert_eq!((sim.energy(), sim.positions()), (0.0, positions));
}

#[test]
fn parts_without_support_stay_unless_pushed() {
    let (mesh, positions) = parts();
    let mut sim =
        Simulation::new(&mesh, &positions, &Options { fixed: vec![v(1)], ..Options::default() }).unwrap();
    sim.push(v(0), [0.0, 0.0, 1.0], 5).unwrap();
    assert_eq!(sim.loads()[v(3)], [0.0; 3]);
    sim.displace(v(3), [0.0, 1.0, 0.0]).unwrap();
    sim.solve(1e-12, 10).unwrap();
    assert_eq!(sim.displacements()[v(3)], [0.0, 1.0, 0.0]);
    assert!(sim.displacements()[v(2)][2] > 0.1 && sim.displacements()[v(1)] == [0.0; 3]);
    let before = sim.displacements().clone();
    sim.push(v(6), [1.0, 0.0, 0.0], 0).unwrap();
    sim.push(v(5), [1.0, 0.0, 0.0], 0).unwrap();
    let error = sim.solve(1e-12, 10).unwrap_err();
    assert_eq!(
        error.to_string(),
        "a force acts on vertex 5, and no springs lead from there to a fixed vertex"
    );
    assert_eq!(sim.displacements(), &before);
}

#[test]
fn springs_without_stiffness_support_nothing() {
    let (mesh, positions) = parts();
    let options = Options { stiffness: Stiffness::Same(0.0), fixed: vec![v(1)], ..Options::default() };
    let mut sim = Simulation::new(&mesh, &positions, &options).unwrap();
    sim.push(v(2), [1.0, 0.0, 0.0], 0).unwrap();
    assert_eq!(sim.solve(1e-12, 10), Err(SpringError::Unsupported { vertex: 2 }));
}

#[test]
fn too_few_iterations_say_how_far_they_came() {
    let (n, faces) = super::shapes::grid(20, 20, [false, false], false);
    let mesh = Mesh::from_faces(n, &faces).unwrap();
    let positions = Map::from_fn(n, |v: VertexId| [(v.index() / 21) as f32, (v.index() % 21) as f32, 0.0]);
    let mut sim =
        Simulation::new(&mesh, &positions, &Options { fixed: vec![v(0)], ..Options::default() }).unwrap();
    sim.push(v(440), [0.0, 0.0, 1.0], 0).unwrap();
    let Err(SpringError::NotConverged { iterations: 5, residual }) = sim.solve(1e-10, 5) else { panic!() };
    assert!(residual > 1e-10 && residual.is_finite());
    assert!(matches!(sim.solve(f64::NAN, 50), Err(SpringError::NotConverged { .. })));
    assert!(matches!(sim.solve(0.0, 500), Err(SpringError::NotConverged { iterations: 500, .. })));
    // It goes on from where it stopped, or from anywhere.
    sim.displace(v(7), [f64::MAX; 3]).unwrap();
    sim.solve(1e-10, 500).unwrap();
    sim.push(v(440), [1e200, 0.0, 0.0], 0).unwrap();
    assert!(matches!(sim.solve(1e-10, 50), Err(SpringError::NotConverged { .. })));
}
