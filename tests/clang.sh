#!/usr/bin/env bash
# clang.sh: builds everything with clang-16 (packages clang-16, libomp-16-dev) into build/clang, warnings as errors, and runs
# the quick tests.
set -euo pipefail

cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."
CC=clang-16 CXX=clang++-16 cmake --preset release -B build/clang -DTANDEM_WERROR=ON
cmake --build build/clang
ctest --test-dir build/clang --output-on-failure -L '^(unit|conformance|convergence|scenario)$' -j "$(nproc)"
