#!/usr/bin/env bash
# The libraries in C++, as Debian packages them; says which are not to be had. Asks for root where it is not.
set -uo pipefail
root=()
[ "$(id -u)" -eq 0 ] || root=(sudo)
"${root[@]}" apt-get update
for package in libopenmesh-dev libcgal-dev libmeshoptimizer-dev; do
    "${root[@]}" apt-get install -y --no-install-recommends "$package" || echo "$package: not to be had here" >&2
done
