//! Runs what callgrind counts the instructions of: exact where times are noise. Without arguments it lists the kernels,
//! each with a number; with that and another number it runs it so many times, for `benches/instructions/count`; with
//! `all` it runs what is counted of every backend once and lists that, for `benches/instructions/check`.
#[path = "../ring_walk/by_hand.rs"]
mod by_hand;
#[path = "../ring_walk/kernels.rs"]
mod kernels;
mod registry;

fn main() {
    if std::env::args().any(|a| a == "all") {
        for counted in registry::counted() {
            collected(&*counted.run);
            println!("{} {}", counted.task, counted.structure);
        }
        return;
    }
    let (vertex_count, faces) = kernels::torus(64, 128);
    let kernels = kernels::kernels(vertex_count, &faces);
    let numbers: Vec<usize> = std::env::args().filter_map(|a| a.parse().ok()).collect();
    let [kernel, times] = numbers[..] else {
        for (i, kernel) in kernels.iter().enumerate() {
            println!("{i}\t{}\t{}\t{vertex_count}", kernel.structure, kernel.way);
        }
        return;
    };
    for _ in 0..times {
        std::hint::black_box((kernels[kernel].run)());
    }
}

/// `check` has callgrind collect in this function alone, by its name, and write what it collected whenever it returns.
#[inline(never)]
fn collected(run: &dyn Fn() -> u64) {
    std::hint::black_box(run());
}
