#!/usr/bin/env bash
# The code in README.md is that of the files which are built and run.
set -euo pipefail

cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

block() { # LANGUAGE: the first fenced block of that language
  awk -v fence='```' -v open="\`\`\`$1" '$0 == open {inside = 1; next} $0 == fence && inside {exit} inside' README.md
}

diff <(block cpp) tests/consumer/main.cpp
diff <(block toml) scenarios/two_mass/two_mass.toml
diff <(block cmake) tests/consumer/CMakeLists.txt
