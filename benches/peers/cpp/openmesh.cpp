// OpenMesh: its triangle mesh with the default traits, all reserved exactly, without its asserts.
#include "peer.hpp"
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

struct Structure {
    OpenMesh::TriMesh_ArrayKernelT<> mesh;

    explicit Structure(const Mesh& arrays) {
        mesh.reserve(arrays.positions.size(), arrays.edge_count, arrays.faces.size());
        for (const auto& [x, y, z] : arrays.positions) mesh.add_vertex({x, y, z});
        for (const auto& [a, b, c] : arrays.faces) {
            auto vertex = [](uint32_t v) { return OpenMesh::VertexHandle(int(v)); };
            if (!mesh.add_face(vertex(a), vertex(b), vertex(c)).is_valid()) refuse("a face is refused");
        }
    }

    static constexpr bool has_rings = true;

    template <class Visit> void ring(uint32_t v, Visit visit) const {
        for (auto u : mesh.vv_range(OpenMesh::VertexHandle(int(v)))) visit(uint32_t(u.idx()));
    }
};

int main(int count, char** arguments) { return measure<Structure>(count, arguments); }
