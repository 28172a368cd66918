//! Times one-ring sweeps through the trait beside the same sweeps by hand.
mod by_hand;
mod kernels;
#[path = "../meshes/mod.rs"]
mod meshes;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};

fn ring_walk(c: &mut Criterion) {
    for (name, columns, rows) in [("in cache", 64, 128), ("out of cache", 1024, 2048)] {
        let (vertex_count, faces) = meshes::torus(columns, rows);
        let mut group = c.benchmark_group(format!("one-ring sweep, torus {name}"));
        group.sample_size(20).throughput(Throughput::Elements(vertex_count as u64));
        for kernel in kernels::kernels(vertex_count, &faces) {
            group.bench_function(format!("{} {}", kernel.structure, kernel.way), |b| b.iter(&kernel.run));
        }
    }
}

criterion_group!(benches, ring_walk);
criterion_main!(benches);
