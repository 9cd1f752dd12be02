#!/usr/bin/env bash
# fuzz.sh [RUNS [FOLDER]]: runs each target of libFuzzer so many times (default 10 000 000), with clang-16, from seeds that
# are taken from docs/wire_protocol.md and from the TOML files of scenarios. Builds in FOLDER (default build/fuzz), where the corpus
# grows and what breaks a target is left. The status is 1 if one breaks.
set -euo pipefail

cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."
runs=${1:-10000000} folder=${2:-build/fuzz}
if [[ ! $runs =~ ^[1-9][0-9]*$ ]]; then
  echo "fuzz.sh: '$runs' is no number of runs; allowed are 1 and more" >&2
  exit 2
fi

mkdir -p "$folder"
CC=clang-16 CXX=clang++-16 cmake -G Ninja -S tests/fuzz -B "$folder" -DCMAKE_BUILD_TYPE=RelWithDebInfo \
  -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -gline-tables-only -DNDEBUG" \
  -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=30 >"$folder/configure.log" 2>&1 ||
  { cat "$folder/configure.log" >&2 && exit 1; }
cmake --build "$folder"
python3 -B tests/fuzz/seeds.py "$folder/seeds"

status=0
for target in server client table mechanism diagram scenario; do
  mkdir -p "$folder/corpus/$target" "$folder/seeds/$target"
  echo "$target: $runs runs"
  # A run may take 20 s and 3 GB; inputs have up to 8 KiB.
  words=()
  [[ $target =~ ^(mechanism|diagram|scenario)$ ]] && words=(-dict="$folder/seeds/words")
  "$folder/${target}_fuzz" "${words[@]}" -runs="$runs" -max_len=8192 -timeout=20 -rss_limit_mb=3000 -verbosity=0 -print_final_stats=1 \
    -artifact_prefix="$folder/$target-" "$folder/corpus/$target" "$folder/seeds/$target" >"$folder/$target.log" 2>&1 ||
    { tail -40 "$folder/$target.log" >&2 && status=1; }
  sed -n 's/^stat::number_of_executed_units: */  executed: /p' "$folder/$target.log"
done
exit "$status"
