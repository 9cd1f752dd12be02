#!/usr/bin/env bash
# ten_minutes.sh TANDEM: goes through docs/ten_minutes.md in a fresh folder, with the commands and files as they stand there,
# and looks at what comes out.
set -euo pipefail

tandem=$1
source_dir=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
page=$source_dir/docs/ten_minutes.md
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT

block() { # LANGUAGE NUMBER: the first, second, ... fenced block of that language
  awk -v fence='```' -v open="\`\`\`$1" -v number="$2" \
    '$0 == open {inside = ++count == number; next} $0 == fence && inside {exit} inside' "$page"
}

# In place of the clone: what the page uses of it.
mkdir -p "$scratch/tandem/build/release/bin" "$scratch/tandem/transports" "$scratch/tandem/scenarios"
cp -r -- "$source_dir/transports/python" "$scratch/tandem/transports/"
ln -s -- "$source_dir/scenarios/engine_linkage" "$scratch/tandem/scenarios/"
ln -s -- "$tandem" "$scratch/tandem/build/release/bin/tandem"
cd -- "$scratch"
export PIP_NO_INDEX=1 # no network

run_block() { # NUMBER: as a reader would, who stops at the first error
  block sh "$1" > "$scratch/block.sh"
  [[ -s $scratch/block.sh ]]
  set -x
  # shellcheck disable=SC1091
  source "$scratch/block.sh"
  { set +x; } 2> /dev/null
}

run_block 1
block python 1 > motor.py
block toml 1 > motor.toml
for number in 2 3 4 5; do run_block "$number"; done

mean_speed() { # FILE: of the last 5 s
  awk -F, 'NR == 1 {for (k = 1; k <= NF; ++k) if ($k == "linkage.speed") column = k; next}
    $1 >= 5 {sum += $column; ++count} END {print sum / count}' "$1"
}
close_to() { # VALUE EXPECTED: within 2 %, what the rods' weight makes of it
  awk -v value="$1" -v expected="$2" 'BEGIN {exit !(value > 0.98 * expected && value < 1.02 * expected)}' ||
    { echo "speed $1 rad/s; expected is $2" >&2 && exit 1; }
}
close_to "$(mean_speed results/motor/results.csv)" 20.86 # k V / (R 3.18 + k^2)
close_to "$(mean_speed results/half/results.csv)" 10.43
ls results/motor/*.html

if "$tandem" run motor.toml --set subsystems.motor.parameters.voltag=50 2> mistake.txt; then exit 1; fi
grep -q "motor.toml" mistake.txt && grep -q "did you mean 'voltage'" mistake.txt
sed -i 's|"rad/s"|"rpm"|' motor.py
if "$tandem" run motor.toml 2> mistake.txt; then exit 1; fi
grep -q "motor.toml" mistake.txt && grep -q "linkage.speed" mistake.txt && grep -q "rpm" mistake.txt
