// What the programs share: the arrays, the counted heap, the clock, and the answer as a line of JSON.
#pragma once
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <malloc.h>
#include <new>
#include <optional>
#include <vector>

struct Heap {
    size_t live = 0;
    size_t peak = 0;
};
inline Heap heap;

// What the allocator hands out, which may be some bytes more than was asked for.
inline void* counted(void* block) {
    if (!block) throw std::bad_alloc();
    heap.live += malloc_usable_size(block);
    if (heap.live > heap.peak) heap.peak = heap.live;
    return block;
}
inline void uncounted(void* block) {
    heap.live -= malloc_usable_size(block);
    free(block);
}
void* operator new(size_t size) { return counted(malloc(size)); }
void* operator new[](size_t size) { return counted(malloc(size)); }
void* operator new(size_t size, std::align_val_t align) { return counted(memalign(size_t(align), size)); }
void* operator new[](size_t size, std::align_val_t align) { return counted(memalign(size_t(align), size)); }
void operator delete(void* block) noexcept { uncounted(block); }
void operator delete[](void* block) noexcept { uncounted(block); }
void operator delete(void* block, size_t) noexcept { uncounted(block); }
void operator delete[](void* block, size_t) noexcept { uncounted(block); }
void operator delete(void* block, std::align_val_t) noexcept { uncounted(block); }
void operator delete[](void* block, std::align_val_t) noexcept { uncounted(block); }
void operator delete(void* block, size_t, std::align_val_t) noexcept { uncounted(block); }
void operator delete[](void* block, size_t, std::align_val_t) noexcept { uncounted(block); }

struct Mesh {
    std::vector<std::array<float, 3>> positions;
    std::vector<std::array<uint32_t, 3>> faces;
    size_t edge_count = 0;
};

[[noreturn]] inline void refuse(const char* reason) {
    fprintf(stderr, "%s\n", reason);
    exit(1);
}

inline Mesh read_mesh(const char* path) {
    FILE* file = fopen(path, "rb");
    if (!file) refuse("the file cannot be opened");
    uint64_t counts[3];
    Mesh mesh;
    if (fread(counts, 8, 3, file) != 3) refuse("the file ends within its counts");
    mesh.positions.resize(counts[0]);
    mesh.faces.resize(counts[1]);
    mesh.edge_count = counts[2];
    if (fread(mesh.positions.data(), 12, counts[0], file) != counts[0]) refuse("the file ends within its positions");
    if (fread(mesh.faces.data(), 12, counts[1], file) != counts[1]) refuse("the file ends within its faces");
    fclose(file);
    return mesh;
}

// One neighbour in the sum that does not depend on their order, as `ring_sum` does.
inline uint64_t mixed(uint32_t v, uint32_t u) { return (uint64_t(v) * 0x9E3779B97F4A7C15) ^ u; }

// Processor time of all threads.
inline double seconds() {
    timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + double(time.tv_nsec) * 1e-9;
}

struct Run {
    double build_seconds;
    double sweep_seconds;
    std::optional<uint64_t> checksum;
    size_t live_bytes;
    size_t peak_bytes;
};

template <class Structure> Run once(const Mesh& mesh) {
    size_t before = heap.live;
    heap.peak = before;
    double start = seconds();
    Structure structure(mesh);
    double built = seconds();
    size_t live = heap.live - before, peak = heap.peak - before;
    std::optional<uint64_t> first = structure.sweep();
    double warm = seconds();
    std::optional<uint64_t> checksum = structure.sweep();
    double swept = seconds();
    if (first != checksum) refuse("two sweeps found different rings");
    return {built - start, swept - warm, checksum, live, peak};
}

// Runs longer than a second are not repeated, as in `peer/mod.rs`.
template <class Structure> int measure(int count, char** arguments) {
    if (count != 2) refuse("usage: PROGRAM MESH");
    Mesh mesh = read_mesh(arguments[1]);
    Run run = once<Structure>(mesh);
    if (run.build_seconds + run.sweep_seconds <= 1.0) run = once<Structure>(mesh);
    printf("{\"build_seconds\":%.9g,", run.build_seconds);
    if (run.checksum) {
        printf("\"sweep_seconds\":%.9g,\"checksum\":%llu,", run.sweep_seconds, (unsigned long long)*run.checksum);
    } else {
        printf("\"sweep_seconds\":null,\"checksum\":null,");
    }
    printf("\"live_bytes\":%zu,\"peak_bytes\":%zu}\n", run.live_bytes, run.peak_bytes);
    return 0;
}
