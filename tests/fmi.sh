#!/bin/bash
# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
# FMUs made elsewhere: tests/fmi.sh DIR [SCHEMAS] looks at each *.fmu in DIR. Its description is read and, where it is found,
# compared with the schema in SCHEMAS (fmi2ModelDescription.xsd, fmi3ModelDescription.xsd) by xmllint. They
# are run beside FMPy and fmusim, where these are found. Systems, *.ssp, are compared with the schemas SystemStructure*.xsd
# and looked at. TANDEM is the command; without it that of build/release.
set -u
here=$(cd "$(dirname "$0")/.." && pwd)
tandem=${TANDEM:-$here/build/release/bin/tandem}
folder=$(cd "${1:?a folder with FMUs}" && pwd) || exit 1
schemas=${2:+$(cd "$2" && pwd)} || exit 1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
status=0

for fmu in "$folder"/*.fmu; do
  [ -e "$fmu" ] || continue
  python3 -c 'import sys, zipfile; zipfile.ZipFile(sys.argv[1]).extract("modelDescription.xml", sys.argv[2])' "$fmu" "$scratch" || {
    echo "$(basename "$fmu"): no description"
    continue
  }
  version=$(sed -n 's/.*fmiVersion="\([0-9]\).*/\1/p' "$scratch/modelDescription.xml" | head -1)
  schema=$schemas/fmi${version}ModelDescription.xsd
  if [ -n "$schemas" ] && [ -e "$schema" ] && ! xmllint --noout --schema "$schema" "$scratch/modelDescription.xml" 2> "$scratch/said"; then
    echo "$(basename "$fmu"): $(head -1 "$scratch/said")" && status=1
  fi
done

# One schema of all: that of descriptions looks into no set of parameters.
standard=http://ssp-standard.org/SSP1
{
  echo '<xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema">'
  for part in Common Description ParameterValues ParameterMapping; do
    echo "<xs:import namespace=\"$standard/SystemStructure$part\" schemaLocation=\"$schemas/SystemStructure$part.xsd\"/>"
  done
  echo '</xs:schema>'
} > "$scratch/system.xsd"
for system in "$folder"/*.ssp; do
  [ -e "$system" ] || continue
  python3 -c 'import sys, zipfile; zipfile.ZipFile(sys.argv[1]).extract("SystemStructure.ssd", sys.argv[2])' "$system" "$scratch" || continue
  if [ -e "$schemas/SystemStructureDescription.xsd" ] &&
    ! xmllint --noout --schema "$scratch/system.xsd" "$scratch/SystemStructure.ssd" 2> "$scratch/said"; then
    echo "$(basename "$system"): $(head -1 "$scratch/said")" && status=1
  fi
  "$tandem" info "$system" > /dev/null 2> "$scratch/said" && echo "$(basename "$system"): read" ||
    echo "$(basename "$system"): $(head -1 "$scratch/said")"
done

fmus=("$folder"/*.fmu)
[ -e "${fmus[0]}" ] || exit $status
python3 "$here/tests/fmi/against_others.py" "$tandem" "${fmus[@]}" || status=1
exit $status
