#!/bin/bash
# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
# FMUs made elsewhere: tests/fmi.sh DIR [SCHEMAS] looks at each *.fmu in DIR. Its description is read and, where it is found,
# compared with the schema in SCHEMAS (fmi2ModelDescription.xsd, fmi3ModelDescription.xsd) by xmllint. Those of Co-Simulation
# are run beside FMPy and fmusim, where these are found. TANDEM is the command; without it that of build/release.
set -u
here=$(cd "$(dirname "$0")/.." && pwd)
tandem=${TANDEM:-$here/build/release/bin/tandem}
folder=$(cd "${1:?a folder with FMUs}" && pwd) || exit 1
schemas=${2:-}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
status=0

for fmu in "$folder"/*.fmu; do
  [ -e "$fmu" ] || { echo "no *.fmu in $folder"; exit 1; }
  python3 -c 'import sys, zipfile; zipfile.ZipFile(sys.argv[1]).extract("modelDescription.xml", sys.argv[2])' "$fmu" "$scratch" || {
    echo "$(basename "$fmu"): no description"
    continue
  }
  version=$(sed -n 's/.*fmiVersion="\([0-9]\).*/\1/p' "$scratch/modelDescription.xml" | head -1)
  schema=$schemas/fmi${version}ModelDescription.xsd
  if [ -n "$schemas" ] && [ -e "$schema" ] && ! xmllint --noout --schema "$schema" "$scratch/modelDescription.xml" 2> "$scratch/said"; then
    echo "$(basename "$fmu"): $(head -1 "$scratch/said")"
  fi
done

python3 "$here/tests/fmi/against_others.py" "$tandem" "$folder"/*.fmu || status=1
exit $status
