#!/usr/bin/env python3
"""prose.py: whether documents, cards and public headers keep docs' rules of prose: sentences of 35 words at most, none
with "was asked" or "that which", no link to a heading of the same page (Doxygen finds none)."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
MOST_WORDS = 35
BANNED = re.compile(r"\b(was asked|were asked|is asked|that which)\b", re.I)


def markdown_blocks(text):
    """(line, text) of paragraphs, items of lists and cells of tables; no code, no headings."""
    block, begun, fenced = [], 0, False
    for number, line in enumerate([*text.splitlines(), ""], 1):
        if line.lstrip().startswith("```"):
            fenced = not fenced
        stripped = line.strip()
        ends = not stripped or fenced or stripped.startswith(("```", "#", "|", "- ", "* ", "    ")) or re.match(r"\d+\. ", stripped)
        if ends and block:
            yield begun, " ".join(block)
            block = []
        if fenced or stripped.startswith(("```", "#")) or (line.startswith("    ") and not block):
            continue
        if stripped.startswith("|"):
            for cell in stripped.strip("|").split("|"):
                yield number, cell
        elif stripped:
            if not block:
                begun = number
            block.append(re.sub(r"^([-*]|\d+\.) ", "", stripped))


def comment_blocks(text):
    """(line, text) of the comments of documentation in a header."""
    block, begun = [], 0
    for number, line in enumerate([*text.splitlines(), ""], 1):
        found = re.match(r"\s*///?(.*)", line) or re.match(r"\s*\*(?!/)(.*)", line)
        inline = re.search(r"///<(.*)", line)
        of_code = bool(inline) and not line.lstrip().startswith("///")
        if of_code:
            found = inline
        words = found.group(1).strip("< ") if found else ""
        if block and (not words or of_code or words.startswith(("- ", "* "))):
            yield begun, " ".join(block)
            block = []
        if words and "SPDX" not in words:
            if not block:
                begun = number
            block.append(re.sub(r"^[-*] ", "", words))


def plain(text):
    text = re.sub(r"`[^`]*`", "CODE", text)
    text = re.sub(r"CODE(, CODE)+", "CODE", text)  # a list of names
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text)
    text = re.sub(r"<[^>]*>", "", text)
    return re.sub(r"\b(e\.g|i\.e|cf|Fig|fig|eq|Sect|vol|no|ed|al|etc|vs|J|Ph)\.", r"\1", re.sub(r"\b([A-Z])\.", r"\1", text))


def sentences(text):
    return re.split(r"(?<=[.!?])[)\"*]* +(?=[\"(*A-Z0-9α-ωΦ])", plain(text))


def words_of(sentence):
    return [word for word in sentence.split() if re.search(r"[A-Za-z]{2}|^[AaI]$", word)]


def wrong(file):
    blocks = markdown_blocks if file.suffix == ".md" else comment_blocks
    for line, text in blocks(file.read_text()):
        if "](#" in text:
            yield line, "a link within the page, which Doxygen does not find"
        for sentence in sentences(text):
            count = len(words_of(sentence))
            if count > MOST_WORDS:
                yield line, f"{count} words: {sentence[:70]}.."
            if found := BANNED.search(sentence):
                yield line, f"'{found.group()}': {sentence[:70]}.."


def files():
    yield ROOT / "README.md"
    yield from sorted((ROOT / "docs").rglob("*.md"))
    yield from sorted((ROOT / "scenarios").rglob("*.md"))
    for top in ("interface", "mbs", "engine_sub", "transports", "scenarios"):
        for folder in sorted((ROOT / top).rglob("include")):
            yield from sorted(p for p in folder.rglob("*") if p.suffix in (".h", ".hpp"))


def main():
    count = 0
    for file in files():
        for line, what in wrong(file):
            print(f"{file.relative_to(ROOT)}:{line}: {what}")
            count += 1
    return count > 0


if __name__ == "__main__":
    sys.exit(main())
