#!/usr/bin/env bash
# consumer.sh BUILD_DIR: installs that build to a scratch prefix, and builds and runs tests/consumer against it, with
# nothing of the source tree in sight.
set -euo pipefail

build_dir=$1
consumer=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/consumer" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT

cmake --install "$build_dir" --prefix "$scratch/prefix"
cp -r -- "$consumer" "$scratch/consumer"
cmake -G Ninja -S "$scratch/consumer" -B "$scratch/build" \
  -DCMAKE_PREFIX_PATH="$scratch/prefix" -DCMAKE_BUILD_TYPE=Release
cmake --build "$scratch/build"
"$scratch/build/consumer"
if [[ -x $scratch/build/pendulum ]]; then "$scratch/build/pendulum"; fi
if [[ -x $scratch/build/load_pendulum ]]; then "$scratch/build/load_pendulum" "$scratch/build/pendulum_library.so"; fi
if [[ -x $scratch/build/run_scenario ]]; then
  cd -- "$scratch"
  build/run_scenario consumer/scene.toml subsystems.filter.parameters.T=0.2
  status=0
  build/run_scenario consumer/scene.toml span.stopp=1 || status=$?
  [[ $status -eq 2 ]]
fi
