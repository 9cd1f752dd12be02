#!/usr/bin/env bash
# fuzz.sh [RUNS [FOLDER [SEED]]]: runs each target of libFuzzer so many times (default 10 000 000), with clang-16, from
# inputs that are taken from docs/wire_protocol.md, the TOML files of scenarios and the descriptions of the tests' FMUs.
# Builds in FOLDER (default build/fuzz), where the corpus grows and what breaks a target is left. A SEED gives the same
# runs each time from the same corpus (default 0: by the clock). Eigen's assertions count too. The status is 1 if one breaks; the input is printed.
set -euo pipefail

cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."
runs=${1:-10000000} folder=${2:-build/fuzz} seed=${3:-0}
if [[ ! $runs =~ ^[1-9][0-9]*$ || ! $seed =~ ^[0-9]+$ ]]; then
  echo "fuzz.sh: $runs runs from seed '$seed'; allowed are runs of 1 and more and seeds of 0 and more" >&2
  exit 2
fi

mkdir -p "$folder"
CC=clang-16 CXX=clang++-16 cmake -G Ninja -S tests/fuzz -B "$folder" -DCMAKE_BUILD_TYPE=RelWithDebInfo \
  -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -gline-tables-only" \
  -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=30 >"$folder/configure.log" 2>&1 ||
  { cat "$folder/configure.log" >&2 && exit 1; }
cmake --build "$folder"
python3 -B tests/fuzz/seeds.py "$folder/seeds"
export ASAN_OPTIONS=quarantine_size_mb=16:malloc_context_size=4 # half the time of the defaults
ASAN_SYMBOLIZER_PATH=$(command -v llvm-symbolizer || command -v addr2line || true) # the latter comes with the linker
export ASAN_SYMBOLIZER_PATH

# Tells what broke target $1, and the inputs as text that `base64 -d | gunzip` gives back.
report() {
  tail -60 "$folder/$1.log"
  for input in "$folder/$1"-{crash,timeout,oom,slow-unit,leak}-*; do
    if [[ -f $input ]]; then
      echo "$input:"
      gzip -9c "$input" | base64
    fi
  done
}

status=0
for target in server client table archive description system mechanism diagram scenario study; do
  [[ -x $folder/${target}_fuzz ]] || continue # of FMUs, without what they need
  mkdir -p "$folder/corpus/$target" "$folder/seeds/$target"
  echo "$target: $runs runs"
  # A run may take 20 s and 3 GB; inputs have up to 8 KiB.
  words=()
  [[ $target =~ ^(mechanism|diagram|scenario|study)$ ]] && words=(-dict="$folder/seeds/words")
  "$folder/${target}_fuzz" "${words[@]}" -runs="$runs" -seed="$seed" -max_len=8192 -timeout=20 -rss_limit_mb=3000 \
    -verbosity=0 -print_final_stats=1 -artifact_prefix="$folder/$target-" \
    "$folder/corpus/$target" "$folder/seeds/$target" >"$folder/$target.log" 2>&1 ||
    { report "$target" >&2; status=1; }
  sed -n 's/^stat::number_of_executed_units: */  executed: /p' "$folder/$target.log"
done
exit "$status"
