// meshoptimizer: its index buffer with adjacency, the opposite corner over each edge. It has no links from vertices, so
// that there are no rings to walk.
#include "peer.hpp"
#include <meshoptimizer.h>

struct Structure {
    std::vector<uint32_t> corners;

    explicit Structure(const Mesh& arrays) : corners(arrays.faces.size() * 6) {
        meshopt_generateAdjacencyIndexBuffer(corners.data(), arrays.faces.data()->data(), arrays.faces.size() * 3,
                                             arrays.positions.data()->data(), arrays.positions.size(), 12);
    }

    static constexpr bool has_rings = false;
};

int main(int count, char** arguments) { return measure<Structure>(count, arguments); }
