#!/usr/bin/env bash
# The code in documents is that of the files which are built and run.
set -euo pipefail

cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

block() { # FILE LANGUAGE NUMBER: the first, second, ... fenced block of that language
  awk -v fence='```' -v open="\`\`\`$2" -v number="$3" \
    '$0 == open {inside = ++count == number; next} $0 == fence && inside {exit} inside' "$1"
}

diff <(block README.md cpp 1) tests/consumer/main.cpp
diff <(block README.md toml 1) scenarios/two_mass/two_mass.toml
diff <(block README.md cmake 1) tests/consumer/CMakeLists.txt
diff <(block docs/library.md cpp 1) tests/consumer/run_scenario.cpp
diff <(block docs/models_in_cpp.md cpp 1) tests/examples/pendulum.hpp
diff <(block docs/diagrams.md toml 1) tests/examples/hoist.toml
diff <(block docs/diagrams.md cpp 1) tests/examples/pendulum_block.hpp
diff <(block docs/models_in_cpp.md cpp 2) tests/examples/pendulum_subsystem.hpp
diff <(block docs/functions.md octave 1) scenarios/functions/pendulum.m
diff <(block docs/functions.md toml 1) scenarios/functions/pendulum.toml
diff <(block docs/c.md c 1) transports/examples/mass2.c
diff <(block docs/c.md c 2) <(grep '^int main' transports/examples/server.c)
diff <(block docs/octave.md octave 1) scenarios/engine/governor.m
