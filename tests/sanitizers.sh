#!/usr/bin/env bash
# sanitizers.sh [asan|tsan]: builds that preset (without a word: both, one after the other) and runs its quick tests.
# sanitizers.sh short: the address and undefined-behaviour sanitizers over the conformance tests, for every day; without
# the checks of pointers (null, alignment, object-size, vptr), which double the time to build.
set -euo pipefail

cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

build() { # PRESET [TARGET [CMAKE_OPTIONS...]]
  cmake --preset "$1" -DTANDEM_WERROR=ON -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=30 "${@:3}"
  cmake --build --preset "$1" ${2:+--target "$2"}
}

check() { # PRESET
  build "$1"
  export TSAN_OPTIONS="suppressions=$PWD/tests/tsan_suppressions.txt"
  # Without address randomization: the thread sanitizer refuses the mappings of newer kernels.
  setarch -R ctest --preset "$1" -L '^(unit|conformance|convergence|scenario|transports)$' -j "$(nproc)"
}

# All tests in one process for each core: 1500 processes of their own would take four times as long.
check_quickly() { # PROGRAM
  local shard pids=()
  export GTEST_TOTAL_SHARDS
  GTEST_TOTAL_SHARDS=$(nproc)
  for ((shard = 0; shard < GTEST_TOTAL_SHARDS; shard++)); do
    GTEST_SHARD_INDEX=$shard timeout 1200 "$1" --gtest_brief=1 &
    pids+=($!)
  done
  for shard in "${pids[@]}"; do wait "$shard"; done
}

quick_checks=bool,bounds,builtin,enum,integer-divide-by-zero,nonnull-attribute,pointer-overflow,return
quick_checks+=,returns-nonnull-attribute,shift,signed-integer-overflow,unreachable

[[ $# -gt 0 ]] || set -- asan tsan
for word in "$@"; do
  case $word in
    asan | tsan) check "$word" ;;
    short)
      # no -g: less to build
      build asan tandem_conformance_tests -DCMAKE_CXX_FLAGS_DEBUG=-O1 -DTANDEM_SANITIZE="address,$quick_checks"
      check_quickly build/asan/bin/tandem_conformance_tests
      ;;
    *) echo "sanitizers.sh: unknown word '$word'; allowed: asan, tsan, short" >&2 && exit 2 ;;
  esac
done
