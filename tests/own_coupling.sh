#!/usr/bin/env bash
# own_coupling.sh TANDEM: the coupling of the README, with the commands and files as they stand there.
set -euo pipefail

tandem=$1
source_dir=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
mkdir -- "$scratch/lift"
cd -- "$scratch/lift"

number=0
for file in arm motor lift; do
  awk -v fence='```' -v number=$((++number)) \
    '$0 == fence "toml" {inside = ++count == number; next} $0 == fence && inside {exit} inside' \
    "$source_dir/README.md" > $file.toml
done

tandem() { "$tandem" "$@"; }
has_gnuplot=$(command -v gnuplot || true)
sed -n 's/^    \(tandem [^#]*[^# ]\) *#.*/\1/p' "$source_dir/README.md" > commands.sh
[[ $(grep -c '^tandem' commands.sh) == 4 ]]
while read -r command; do
  [[ $command != "tandem chart"* || -n $has_gnuplot ]] || continue
  eval "$command" | tee -a said.txt
done < commands.sh

ls results/lift/results.csv results/lift/lift/schemes.csv
[[ -z $has_gnuplot ]] || ls results/lift/plot.svg results/lift/lift/schemes_work.svg
grep -Eq "^[0-9]+ of [0-9]+ rows that ran are within the tolerance\.$" said.txt
grep -Eq "^Cheapest of these is .*, error 0\.[0-9]+ of the tolerance\.$" said.txt
