//! Times the pairing strategies beside one another, on meshes in order and shuffled, in and out of the cache.
#[path = "../common/meshes.rs"]
mod meshes;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use meshes::{Mesh, shuffled};
use onering::{Pairing, conformance, pairing};
use std::collections::HashMap;

/// A tetrahedron with every triangle divided into four, so many times.
fn divided(times: u32) -> Mesh {
    let mut faces = vec![[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];
    let mut vertices = 4;
    for _ in 0..times {
        let mut middles = HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                vertices += 1;
                vertices - 1
            })
        };
        let four = |[a, b, c]: [u32; 3]| {
            let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
            [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
        };
        faces = faces.into_iter().flat_map(four).collect();
    }
    (vertices as usize, faces)
}

fn strategies(c: &mut Criterion) {
    let torus = |columns, rows| ((columns * rows) as usize, conformance::torus(columns, rows));
    let meshes = [
        ("torus 65k", torus(128, 256)),
        ("torus 2.1M", torus(1024, 1024)),
        ("divided 65k", divided(7)),
        ("divided 1.0M", divided(9)),
        ("divided 65k shuffled", shuffled(divided(7))),
        ("divided 1.0M shuffled", shuffled(divided(9))),
    ];
    for (name, (vertices, faces)) in meshes {
        println!("{name}: auto takes {}", Pairing::choose(vertices, &faces));
        let mut group = c.benchmark_group(format!("pairing, {name}"));
        group.sample_size(10).throughput(Throughput::Elements(faces.len() as u64));
        for strategy in [Pairing::Chain, Pairing::Partition, Pairing::PaperHash, Pairing::Hash] {
            group.bench_with_input(BenchmarkId::from_parameter(strategy), &strategy, |b, &strategy| {
                b.iter(|| pairing::pair(vertices, &faces, strategy));
            });
        }
    }
}

criterion_group!(benches, strategies);
criterion_main!(benches);
