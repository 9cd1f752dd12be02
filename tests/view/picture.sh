#!/usr/bin/env bash
# The picture of docs/view.md: picture.sh TANDEM FILE.png
set -euo pipefail

here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
tandem=$(readlink -f -- "$1") picture=$(readlink -m -- "$2")
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cd -- "$folder"
scene=$here/../../scenarios/split_pendulum/split_pendulum.toml

"$tandem" --quiet run "$scene" --set record.animate=true --output cubic
"$tandem" --quiet run "$scene" --set record.animate=true --set connections.reconstruction=lagrange0 --output held
"$tandem" --quiet view cubic --with held --output page.html
python3 "$here/picture.py" page.html "$picture" "tandem.clock.set(0.62)"
