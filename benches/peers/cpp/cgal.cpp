// CGAL: Surface_mesh with points of three floats, all reserved exactly, without its asserts.
#include "peer.hpp"
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

struct Structure {
    using Kernel = CGAL::Simple_cartesian<float>;
    using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
    Surface mesh;

    explicit Structure(const Mesh& arrays) {
        mesh.reserve(unsigned(arrays.positions.size()), unsigned(arrays.edge_count), unsigned(arrays.faces.size()));
        for (const auto& [x, y, z] : arrays.positions) mesh.add_vertex({x, y, z});
        for (const auto& [a, b, c] : arrays.faces) {
            auto vertex = [](uint32_t v) { return Surface::Vertex_index(v); };
            if (mesh.add_face(vertex(a), vertex(b), vertex(c)) == Surface::null_face()) refuse("a face is refused");
        }
    }

    std::optional<uint64_t> sweep() const {
        uint64_t sum = 0;
        for (auto v : mesh.vertices()) {
            auto h = mesh.halfedge(v);
            if (h == Surface::null_halfedge()) continue;
            for (auto u : CGAL::vertices_around_target(h, mesh)) sum += mixed(uint32_t(v), uint32_t(u));
        }
        return sum;
    }
};

int main(int count, char** arguments) { return measure<Structure>(count, arguments); }
