#!/usr/bin/env bash
# Draws docs/images/sampled_drive.png: one controller in three schedules, stepped as one that integrates itself, and
# sampled.   scenarios/drive/picture.sh [FOLDER FOR RESULTS]
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")"
folder=${1:-$(mktemp -d)}
tandem=../../build/release/bin/tandem
stepped='subsystems.controller.command=["env","PYTHONPATH=../../transports/python","python3","controller_of_steps.py"]'
schedules=(slowest-first fastest-first parallel)

for schedule in "${schedules[@]}"; do
  common=(--no-reference --set "coordination.schedule=$schedule" --set span.stop=0.3)
  "$tandem" run drive.toml "${common[@]}" --set "$stepped" --set 'connections[motor.i_ref].reconstruction=lagrange0' \
    --output "$folder/stepped_$schedule"
  "$tandem" run drive.toml "${common[@]}" --output "$folder/sampled_$schedule"
done

difference() { # RESULTS: time, drum speed less the exact one
  awk -F, 'function at(t) { return sprintf("%.6f", t) }
    FNR == 1 { for (k = 1; k <= NF; ++k) if ($k == "load.drum_speed") c = k; next }
    FNR == NR { exact[at($1)] = $c; next }
    at($1) in exact { print $1, $c - exact[at($1)] }' exact.csv "$1/results.csv"
}
for kind in stepped sampled; do
  for schedule in "${schedules[@]}"; do difference "$folder/${kind}_$schedule" >"$folder/${kind}_$schedule.dat"; done
done

gnuplot <<END
set terminal pngcairo size 1000,420 font "sans,11"
set output "../../docs/images/sampled_drive.png"
set multiplot layout 1,2 title "The drum's speed (12.5 rad/s at most): difference from the exact one [rad/s]"
set xlabel "time [s]"
set grid lc rgb "#dddddd"
set key bottom right
do for [kind in "stepped sampled"] {
  set title kind eq "stepped" ? "controller stepped every 2.5 ms, as if it integrated itself" : "controller sampled every 2.5 ms"
  set format y "%g"
  plot for [k=1:3] sprintf("$folder/%s_%s.dat", kind, word("${schedules[*]}", k)) \\
    with lines lw 4-k/1.5 lc rgb word("#000000 #e69f00 #0072b2", k) dt k title word("${schedules[*]}", k)
}
END
