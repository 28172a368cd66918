#!/usr/bin/env bash
# Builds the programs of the libraries that are installed, and says which are not; `install.sh` installs them. No package
# has pmp-library: `PMP=FOLDER` names its sources.
set -euo pipefail
cd "$(dirname "$0")"
mkdir -p target
compiler=${CXX:-c++}
# OpenMesh and CGAL check every handle where asserts are on, which no user who is in a hurry leaves so.
flags=(-std=c++17 -O3 -march=native -DNDEBUG -DCGAL_NDEBUG)

build() { # PROGRAM HEADER LIBRARIES...
    local program=$1 header=$2
    shift 2
    rm -f "target/$program"
    if echo "#include <$header>" | "$compiler" "${flags[@]}" -fsyntax-only -x c++ - 2>/dev/null; then
        "$compiler" "${flags[@]}" "$program.cpp" -o "target/$program" "$@"
        echo "$program: built by $("$compiler" --version | sed 1q)"
    else
        echo "$program: left out: <$header> is not installed"
    fi
}

build openmesh OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh -lOpenMeshCore
build cgal CGAL/Surface_mesh.h
build meshoptimizer meshoptimizer.h -lmeshoptimizer

if [ -n "${PMP:-}" ]; then
    # Eigen, which its vectors convert from, comes with it.
    eigen=("$PMP"/external/eigen-*)
    flags+=(-std=c++20 -I"$PMP/src" -isystem "${eigen[0]}")
    build pmp pmp/surface_mesh.h "$PMP/src/pmp/surface_mesh.cpp"
else
    rm -f target/pmp
    echo "pmp: left out: PMP names no folder of its sources"
fi
