#!/usr/bin/env bash
# The code in documents is that of the files which are built and run.
set -euo pipefail

cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

block() { # FILE LANGUAGE NUMBER: the first, second, ... fenced block of that language
  awk -v fence='```' -v open="\`\`\`$2" -v number="$3" \
    '$0 == open {inside = ++count == number; next} $0 == fence && inside {exit} inside' "$1"
}

diff <(block docs/program.md cpp 1) tests/consumer/main.cpp
diff <(block docs/program.md cmake 1) tests/consumer/CMakeLists.txt
diff <(block README.md toml 1) <(tail -n +2 tests/examples/arm/arm.toml)
diff <(block README.md toml 2) <(tail -n +2 tests/examples/arm/motor.toml)
diff <(block README.md toml 3) <(tail -n +2 tests/examples/arm/lift.toml)
[[ $(wc -l < README.md) -le 130 ]]
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
