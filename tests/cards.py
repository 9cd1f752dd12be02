#!/usr/bin/env python3
# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Tables and pictures of cards and pages, which `tandem chart STUDY.toml --chart NAME` makes of the CSV files in the
folder `measured` beside the study. A table stands between two lines, a picture below one:

    <!-- table NAME of STUDY.toml -->          or: of STUDY.toml where EXPRESSION -->
    <!-- end -->

    <!-- picture NAME of STUDY.toml -->
    ![what it shows](PICTURE.png)

A picture is stale where its drawing (NAME.gp, which holds the data) is not that in docs/images/drawings.sha256.

    cards.py TANDEM          # says which are stale; status 1
    cards.py TANDEM --write  # puts them in; pictures by gnuplot
"""
import hashlib
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
DRAWINGS = ROOT / "docs/images/drawings.sha256"
TABLE = re.compile(r"(<!-- table (\w+) of (\S+\.toml)(?: where (.*?))? -->\n)(.*?)(<!-- end -->)", re.DOTALL)
PICTURE = re.compile(r"<!-- picture (\w+) of (\S+\.toml) -->\n!\[[^\]]*\]\(([^)]+)\)")


class Cards:
    def __init__(self, program, write):
        self.program, self.write = program, write
        self.count, self.stale = 0, []
        lines = DRAWINGS.read_text().splitlines() if DRAWINGS.exists() else []
        self.drawings = {path: digest for digest, path in (line.split("  ") for line in lines)}

    def made(self, study, name, ending, where=None):
        """What becomes of the chart, as bytes."""
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(study.parent / "measured", folder, dirs_exist_ok=True)
            made = pathlib.Path(folder) / (name + ending)
            words = (["--png"] if ending == ".png" else []) + (["--where", where] if where else [])
            told = subprocess.run([self.program, "chart", study, "--chart", name, "--results", folder, *words],
                                  cwd=ROOT, capture_output=True, text=True)
            if not made.exists():
                sys.exit(f"{study}: {name}{ending}: {told.stderr}")
            return made.read_bytes()

    def tell(self, what):
        self.stale.append(str(what.relative_to(ROOT)))

    def tables(self, card):
        text = card.read_text()
        new = TABLE.sub(lambda m: m[1] + self.made(card.parent / m[3], m[2], ".md", m[4]).decode() + m[6], text)
        self.count += len(TABLE.findall(text))
        if new != text:
            self.tell(card)
            if self.write:
                card.write_text(new)

    def pictures(self, card):
        for name, study, path in PICTURE.findall(card.read_text()):
            self.count += 1
            picture = (card.parent / path).resolve()
            digest = hashlib.sha256(self.made(card.parent / study, name, ".gp")).hexdigest()
            if self.drawings.get(picture.name) == digest and picture.exists():
                continue
            self.tell(picture)
            if self.write:
                picture.write_bytes(self.made(card.parent / study, name, ".png"))
                self.drawings[picture.name] = digest

    def finish(self):
        if self.write:
            DRAWINGS.write_text("".join(f"{digest}  {path}\n" for path, digest in sorted(self.drawings.items())))
        print(f"{self.count} tables and pictures; stale: {', '.join(self.stale) or 'none'}")
        return 1 if self.stale and not self.write or self.count == 0 else 0


def main():
    cards = Cards(str(pathlib.Path(sys.argv[1]).resolve()), "--write" in sys.argv)
    for card in sorted(ROOT.glob("scenarios/**/*.md")) + sorted(ROOT.glob("docs/**/*.md")) + [ROOT / "README.md"]:
        cards.tables(card)
        cards.pictures(card)
    return cards.finish()


if __name__ == "__main__":
    sys.exit(main())
