//! Runs one kernel a given number of times, for `benches/instructions/count`, which has callgrind count the
//! instructions of a sweep: exact where times are noise. Without arguments it lists the kernels.
#[path = "../ring_walk/by_hand.rs"]
mod by_hand;
#[path = "../ring_walk/kernels.rs"]
mod kernels;
#[path = "../meshes/mod.rs"]
mod meshes;

fn main() {
    let (vertex_count, faces) = meshes::torus(64, 128);
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
