#!/usr/bin/env bash
# sanitizers.sh [asan|tsan]: builds that preset (without a word: both, one after the other) and runs its quick tests.
set -euo pipefail

cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."
[[ $# -gt 0 ]] || set -- asan tsan
for preset in "$@"; do
  case $preset in
    asan | tsan) ;;
    *) echo "sanitizers.sh: unknown preset '$preset'; allowed: asan, tsan" >&2 && exit 2 ;;
  esac
done

for preset in "$@"; do
  cmake --preset "$preset" -DTANDEM_WERROR=ON
  cmake --build --preset "$preset"
  # Without address randomization: the thread sanitizer refuses the mappings of newer kernels.
  setarch -R ctest --preset "$preset" -L '^(unit|conformance|convergence)$' -j "$(nproc)"
done
