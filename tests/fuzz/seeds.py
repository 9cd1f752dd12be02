#!/usr/bin/env python3
# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""seeds.py FOLDER: what the fuzzing starts from: the session of docs/wire_protocol.md, either side of it, whole and up to
each of its messages."""

import pathlib
import re
import sys

TREE = pathlib.Path(__file__).resolve().parents[2]


def messages(side):
    """The bytes of each example of that side, in the order of the page."""
    page = (TREE / "docs" / "wire_protocol.md").read_text(encoding="utf-8")
    for block in re.findall(rf"### [a-z]+, {side}\n\n```hex\n(.*?)```", page, re.DOTALL):
        yield bytes.fromhex(" ".join(line.partition("#")[0] for line in block.splitlines()))


def main(folder):
    for side, target in (("request", "server"), ("reply", "client")):
        place = folder / target
        place.mkdir(parents=True, exist_ok=True)
        session = b""
        for number, message in enumerate(messages(side)):
            session += message
            (place / f"{number:02}").write_bytes(session)
        assert session, f"docs/wire_protocol.md has no example of a {side}"


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
