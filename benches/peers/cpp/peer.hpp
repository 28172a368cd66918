// What the programs share: the arrays, the counted heap, the clock, and the answer as a line of JSON.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
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
    // The vertices whose 4-rings are asked for.
    std::vector<uint32_t> queries;
    size_t edge_count = 0;
};

[[noreturn]] inline void refuse(const char* reason) {
    fprintf(stderr, "%s\n", reason);
    exit(1);
}

inline Mesh read_mesh(const char* path) {
    FILE* file = fopen(path, "rb");
    if (!file) refuse("the file cannot be opened");
    uint64_t counts[4];
    Mesh mesh;
    if (fread(counts, 8, 4, file) != 4) refuse("the file ends within its counts");
    mesh.positions.resize(counts[0]);
    mesh.faces.resize(counts[1]);
    mesh.edge_count = counts[2];
    mesh.queries.resize(counts[3]);
    if (fread(mesh.positions.data(), 12, counts[0], file) != counts[0]) refuse("the file ends within its positions");
    if (fread(mesh.faces.data(), 12, counts[1], file) != counts[1]) refuse("the file ends within its faces");
    if (fread(mesh.queries.data(), 4, counts[3], file) != counts[3]) refuse("the file ends within its queries");
    fclose(file);
    return mesh;
}

// One neighbour in a sum that does not depend on the order, as in `mesh.rs`.
inline uint64_t mixed(uint32_t v, uint32_t u) { return (uint64_t(v) * 0x9E3779B97F4A7C15) ^ u; }

// Processor time of all threads.
inline double seconds() {
    timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + double(time.tv_nsec) * 1e-9;
}

// A structure that can be walked calls `visit` with every neighbour of a vertex: `ring(vertex, visit)`.

// The one-rings of all vertices, as one sum.
template <class Structure> uint64_t sweep(const Structure& structure, const Mesh& mesh) {
    uint64_t sum = 0;
    for (uint32_t v = 0; v < uint32_t(mesh.positions.size()); v++)
        structure.ring(v, [&](uint32_t u) { sum += mixed(v, u); });
    return sum;
}

// The vertices within four edges of each query, as one sum, level by level as in `peer/walk.rs`.
template <class Structure> uint64_t four_rings(const Structure& structure, const Mesh& mesh) {
    std::vector<uint32_t> stamps(mesh.positions.size()), reached;
    uint64_t sum = 0;
    uint32_t search = 0;
    for (uint32_t query : mesh.queries) {
        stamps[query] = ++search;
        reached.assign(1, query);
        size_t begin = 0;
        for (int level = 0; level < 4; level++) {
            size_t end = reached.size();
            for (size_t i = begin; i < end; i++)
                structure.ring(reached[i], [&](uint32_t u) {
                    if (stamps[u] == search) return;
                    stamps[u] = search;
                    reached.push_back(u);
                });
            begin = end;
        }
        for (size_t i = 1; i < reached.size(); i++) sum += mixed(query, reached[i]);
    }
    return sum;
}

// As in `peer/mod.rs`: a task is repeated until it has run so often, or for so many seconds, and the least time counts.
constexpr int runs = 5;
constexpr double is_long = 1.0;

// The least of the times that `run` gives.
template <class Run> double least(Run run) {
    double least = HUGE_VAL, all = 0;
    for (int i = 0; i < runs && all <= is_long; i++) {
        double time = run();
        least = std::min(least, time);
        all += time;
    }
    return least;
}

// The time of a task and its answer.
template <class Work> void print_task(const char* task, Work work) {
    std::optional<uint64_t> answer;
    double time = least([&] {
        double start = seconds();
        uint64_t found = work();
        double time = seconds() - start;
        if (answer.value_or(found) != found) refuse("two sweeps found different rings");
        answer = found;
        return time;
    });
    printf(",{\"task\":\"%s\",\"seconds\":%.9g,\"answer\":%llu}", task, time, (unsigned long long)*answer);
}

template <class Structure> int measure(int count, char** arguments) {
    if (count != 2) refuse("usage: PROGRAM MESH");
    Mesh mesh = read_mesh(arguments[1]);
    std::optional<Structure> structure;
    size_t live = 0, peak = 0;
    double time = least([&] {
        structure.reset();
        size_t before = heap.live;
        heap.peak = before;
        double start = seconds();
        structure.emplace(mesh);
        double time = seconds() - start;
        live = heap.live - before;
        peak = heap.peak - before;
        return time;
    });
    printf("{\"tasks\":[{\"task\":\"build\",\"seconds\":%.9g,\"answer\":null}", time);
    if constexpr (Structure::has_rings) {
        print_task("ring", [&] { return sweep(*structure, mesh); });
        print_task("four_ring", [&] { return four_rings(*structure, mesh); });
    }
    printf("],\"live_bytes\":%zu,\"peak_bytes\":%zu}\n", live, peak);
    return 0;
}
