#!/usr/bin/env bash
# minimal.sh [CMAKE_OPTIONS...]: builds the preset minimal in a scratch directory, warnings as errors, with the compiler of
# CC and CXX, and checks that nothing but the standard library and its threads was looked up or included.
set -euo pipefail

source_dir=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT

cd -- "$source_dir" # where the presets are
cmake --preset minimal -B "$scratch/build" -DTANDEM_WERROR=ON \
  --trace-expand --trace-redirect="$scratch/trace" "$@"
cmake --build "$scratch/build"

fail() {
  echo "minimal: $1" >&2
  exit 1
}

lookup='(find_(package|library|path|file)|pkg_(check_modules|search_module)|FetchContent_MakeAvailable)\('
if grep -F "$source_dir/" "$scratch/trace" | grep -vF 'find_package(Threads ' | grep -E "$lookup"; then
  fail "a package was looked up by the commands above; the minimal preset takes the standard library alone"
fi

third_party='/(CLI|benchmark|boost|eigen3|fmt|gtest|nlohmann|spdlog|suitesparse|sundials|toml\+\+|zmq\.h|zmq\.hpp)(/|$)'
if ninja -C "$scratch/build" -t deps | grep -E "$third_party"; then
  fail "the third-party headers above are included; interface and coordinator take the standard library alone"
fi
