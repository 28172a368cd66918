//! Times the pairing strategies beside one another, on meshes in order and shuffled, in and out of the cache.
#[path = "../meshes/mod.rs"]
mod meshes;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use meshes::{shuffled, sphere, torus};
use onering::{Pairing, pairing};

fn strategies(c: &mut Criterion) {
    let meshes = [
        ("torus 65k", torus(128, 256)),
        ("torus 2.1M", torus(1024, 1024)),
        ("icosphere 82k", sphere(6)),
        ("icosphere 1.3M", sphere(8)),
        ("icosphere 82k shuffled", shuffled(&sphere(6))),
        ("icosphere 1.3M shuffled", shuffled(&sphere(8))),
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
