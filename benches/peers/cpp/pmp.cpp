// pmp-library: its SurfaceMesh with the default properties, all reserved exactly, without its asserts. Built with its one
// source file, as a release build of the library has it.
#include "peer.hpp"
#include <pmp/surface_mesh.h>

struct Structure {
    pmp::SurfaceMesh mesh;

    explicit Structure(const Mesh& arrays) {
        mesh.reserve(arrays.positions.size(), arrays.edge_count, arrays.faces.size());
        for (const auto& [x, y, z] : arrays.positions) mesh.add_vertex(pmp::Point(x, y, z));
        try {
            for (const auto& [a, b, c] : arrays.faces) mesh.add_triangle(pmp::Vertex(a), pmp::Vertex(b), pmp::Vertex(c));
        } catch (const pmp::TopologyException&) {
            refuse("a face is refused");
        }
    }

    static constexpr bool has_rings = true;

    template <class Visit> void ring(uint32_t v, Visit visit) const {
        const auto start = mesh.halfedge(pmp::Vertex(v));
        if (!start.is_valid()) return;
        auto h = start;
        do {
            visit(mesh.to_vertex(h).idx());
            h = mesh.cw_rotated_halfedge(h);
        } while (h != start);
    }
};

int main(int count, char** arguments) { return measure<Structure>(count, arguments); }
