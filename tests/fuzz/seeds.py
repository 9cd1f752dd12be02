#!/usr/bin/env python3
# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""seeds.py FOLDER: what the fuzzing starts from: the sessions of docs/wire_protocol.md, either side, whole and up to
each of their messages; the project's own TOML files, each for the reader of its kind, with their words (FOLDER/words); descriptions of FMUs, alone and packed, and a
system of SSP."""

import pathlib
import re
import struct
import sys
import zipfile

TREE = pathlib.Path(__file__).resolve().parents[2]


def sessions():
    """The text of each; the second begins as the first, up to the reply of info."""
    page = (TREE / "docs" / "wire_protocol.md").read_text(encoding="utf-8")
    first, second = page.split("## A session with a sampled subsystem")
    return first, first[first.index("### hello, request"):first.index("### info, reply")] + second


def messages(page, side):
    """The bytes of each example of that side, in the order of the page."""
    for block in re.findall(rf"### [a-z]+, {side}\n\n```hex\n(.*?)```", page, re.DOTALL):
        yield bytes.fromhex(" ".join(line.partition("#")[0] for line in block.splitlines()))


def with_small_payloads(message):
    """Of 64 MiB each session would take memory for as many rows, and three of four seconds would go into that. A hello
    (type 1) tells it."""
    if message[8:12] != (1).to_bytes(4, "little"):
        return message
    return message.replace((1 << 26).to_bytes(8, "little"), (1 << 12).to_bytes(8, "little"))


def with_reaction(message):
    """Its input reacts by one state: z' = x + 0, u has half of z besides. Of a request to advance (type 4)."""
    if message[8:12] != (4).to_bytes(4, "little"):
        return message
    more = struct.pack("<Idd", 1, 0.0, 0.5) + struct.pack("<Iiidd", 1, 0, 1, 1.0, 0.0)
    more += struct.pack("<Iiidddd", 1, 0, 0, 0.0, 0.0, 0.0, 0.0) + struct.pack("<Iiid", 1, 0, 0, 0.5)
    return (len(message) - 16 + len(more)).to_bytes(8, "little") + message[8:] + more


def kind(text):
    """As scenario::kind_alone has it, and studies."""
    if re.search(r"^\[*blocks\b", text, re.MULTILINE):
        return "diagram"
    if re.search(r"^\[*(tables|search|charts)\b", text, re.MULTILINE):
        return "study"
    return "mechanism" if re.search(r"^dimension\b", text, re.MULTILINE) else "scenario"


def toml_files(folder):
    words = set()
    for file in sorted((TREE / "scenarios").rglob("*.toml")):
        text = file.read_text(encoding="utf-8")
        place = folder / kind(text)
        place.mkdir(parents=True, exist_ok=True)
        (place / "_".join(file.relative_to(TREE / "scenarios").parts)).write_text(text, encoding="utf-8")
        words |= set(re.findall(r"[A-Za-z_][A-Za-z_0-9]{2,}", re.sub(r"#.*", "", text)))
    (folder / "words").write_text("".join(f'"{word}"\n' for word in sorted(words)), encoding="ascii")


def systems(folder):
    """What the tests of systems say of one, with all that a reader knows."""
    (folder / "system").mkdir(parents=True, exist_ok=True)
    (folder / "system" / "all.ssd").write_bytes((TREE / "tests" / "fmi" / "all.ssd").read_bytes())


def fmus(folder):
    for target in ("archive", "description"):
        (folder / target).mkdir(parents=True, exist_ok=True)
    for file in sorted((TREE / "tests" / "libraries" / "fmi").glob("*.xml")):
        text = file.read_bytes()
        (folder / "description" / file.name).write_bytes(text)
        for method in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
            with zipfile.ZipFile(folder / "archive" / f"{file.stem}{method}", "w", method) as archive:
                archive.writestr("modelDescription.xml", text)
                archive.writestr("binaries/linux64/x.so", b"x")


def main(folder):
    toml_files(folder)
    systems(folder)
    fmus(folder)
    for side, target in (("request", "server"), ("reply", "client")):
        place = folder / target
        place.mkdir(parents=True, exist_ok=True)
        for which, page in enumerate(sessions()):
            session = reacting = b""
            for number, message in enumerate(messages(page, side)):
                session += with_small_payloads(message)
                reacting += with_reaction(with_small_payloads(message))
                (place / f"{which}{number:02}").write_bytes(session)
                (place / f"{which}{number:02}r").write_bytes(reacting)
            assert session, f"docs/wire_protocol.md has no example of a {side}"


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
