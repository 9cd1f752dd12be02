#!/usr/bin/env bash
# sanitizers.sh [asan|tsan]: builds that preset (without a word: both, one after the other) and runs its quick tests.
# sanitizers.sh short: the address and undefined-behaviour sanitizers over the conformance tests, for every day.
set -euo pipefail

cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

check() { # PRESET LABELS [TARGET [CMAKE_OPTION]]
  cmake --preset "$1" -DTANDEM_WERROR=ON -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=30 ${4:+"$4"}
  cmake --build --preset "$1" ${3:+--target "$3"}
  # Without address randomization: the thread sanitizer refuses the mappings of newer kernels.
  setarch -R ctest --preset "$1" -L "$2" -j "$(nproc)"
}

[[ $# -gt 0 ]] || set -- asan tsan
for word in "$@"; do
  case $word in
    asan | tsan) check "$word" '^(unit|conformance|convergence|scenario)$' ;;
    short) check asan '^conformance$' tandem_conformance_tests -DCMAKE_CXX_FLAGS_DEBUG=-O1 ;; # no -g: less to build
    *) echo "sanitizers.sh: unknown word '$word'; allowed: asan, tsan, short" >&2 && exit 2 ;;
  esac
done
