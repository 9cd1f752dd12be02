# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""A stranger's text as a terminal, a log and a file can take it."""

from __future__ import annotations

import re
from typing import Union

#: C0, DEL, C1, what turns the direction of writing or ends a line, and what is no UTF-8
_HIDDEN = re.compile("[\x00-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ud800-\udfff]")


def printable(text: Union[str, bytes], longest: int = 2000) -> str:
    """UTF-8 as it is, but control characters (also those that turn the direction of writing) as "\\x1b" or
    "\\u202e", bytes that are no UTF-8 as "\\xff", and what is beyond `longest` bytes as "..."."""
    if isinstance(text, bytes):
        text = text.decode("utf-8", "surrogateescape")
    if 4 * len(text) <= longest and not _HIDDEN.search(text):
        return text
    shown, size = [], 0
    for character in text:
        one = _escaped(character) if _HIDDEN.match(character) else character
        size += len(one.encode())
        if size > longest:
            return "".join(shown) + "..."
        shown.append(one)
    return "".join(shown)


def is_printable(text: str) -> bool:
    """Whether it is shown as it is, however long."""
    return not _HIDDEN.search(text)


def _escaped(character: str) -> str:
    code = ord(character)
    if 0xdc80 <= code <= 0xdcff:  # a byte, as surrogateescape puts it
        return f"\\x{code - 0xdc00:02x}"
    return f"\\x{code:02x}" if code < 0x80 else f"\\u{code:04x}"
