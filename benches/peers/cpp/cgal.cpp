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

    static constexpr bool has_rings = true;

    template <class Visit> void ring(uint32_t v, Visit visit) const {
        auto h = mesh.halfedge(Surface::Vertex_index(v));
        if (h == Surface::null_halfedge()) return;
        for (auto u : CGAL::vertices_around_target(h, mesh)) visit(uint32_t(u));
    }
};

int main(int count, char** arguments) { return measure<Structure>(count, arguments); }
