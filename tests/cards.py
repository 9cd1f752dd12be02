#!/usr/bin/env python3
# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Tables in cards and pages: each stands between

    <!-- table NAME of STUDY.toml -->
    <!-- end -->

and is what `tandem chart STUDY.toml --chart NAME` makes of the CSV files in the folder `measured` beside the study.

    cards.py TANDEM          # says which tables are stale; status 1
    cards.py TANDEM --write  # puts them in
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
BLOCK = re.compile(r"(<!-- table (\w+) of (\S+\.toml) -->\n)(.*?)(<!-- end -->)", re.DOTALL)


def table(program, study, name):
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(study.parent / "measured", folder, dirs_exist_ok=True)
        subprocess.run([program, "chart", study, "--chart", name, "--results", folder], check=True,
                       stdout=subprocess.DEVNULL, cwd=ROOT)
        return (pathlib.Path(folder) / (name + ".md")).read_text()


def main():
    program, write = str(pathlib.Path(sys.argv[1]).resolve()), "--write" in sys.argv
    count, stale = 0, []
    cards = sorted(ROOT.glob("scenarios/**/*.md")) + sorted(ROOT.glob("docs/**/*.md")) + [ROOT / "README.md"]
    for card in cards:
        text = card.read_text()
        new = BLOCK.sub(lambda m: m[1] + table(program, card.parent / m[3], m[2]) + m[5], text)
        count += len(BLOCK.findall(text))
        if new == text:
            continue
        stale.append(card)
        if write:
            card.write_text(new)
    print(f"{count} tables; stale: {', '.join(str(card.relative_to(ROOT)) for card in stale) or 'none'}")
    return 1 if stale and not write or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
