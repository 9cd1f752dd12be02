# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Takes payloads of docs/wire_protocol.md apart."""

from __future__ import annotations

import array
import struct
import sys
from typing import Tuple

from .contract import Error
from .printable import printable

LONGEST_NAME = 4096  # bytes


def put_text(text: str) -> bytes:
    data = text.encode("utf-8", "surrogateescape")
    return struct.pack("<I", len(data)) + data


class Reader:
    """Takes a payload apart; what is not there is refused before memory is taken for it."""

    def __init__(self, data: memoryview, what: str) -> None:
        self._data, self._what, self._place = data, what, 0

    def left(self) -> int:
        return len(self._data) - self._place

    def take(self, form: str) -> Tuple:
        size = struct.calcsize("<" + form)
        if size > self.left():
            self.refuse(f"ends after {len(self._data)} bytes; at byte {self._place} {size} more were to follow")
        values = struct.unpack_from("<" + form, self._data, self._place)
        self._place += size
        return values

    def take_doubles(self, count: int) -> array.array:
        """They take no more memory than their bytes did."""
        if 8 * count > self.left():
            self.refuse(f"ends after {len(self._data)} bytes, within {count} numbers")
        values = array.array("d")
        values.frombytes(self._data[self._place:self._place + 8 * count])
        self._place += 8 * count
        if sys.byteorder == "big":
            values.byteswap()
        return values

    def text(self, longest: int) -> str:
        (length,) = self.take("I")
        if length > min(longest, self.left()):
            self.refuse(f"has a text of {length} bytes; allowed are up to {min(longest, self.left())}")
        data = bytes(self._data[self._place:self._place + length])
        self._place += length
        return data.decode("utf-8", "surrogateescape")

    def name(self) -> str:
        """A name or a unit, to be shown."""
        return printable(self.text(LONGEST_NAME), LONGEST_NAME)

    def count(self, bytes_each: int) -> int:
        (count,) = self.take("I")
        if count * bytes_each > self.left():
            self.refuse(f"announces {count} things, but only {self.left()} bytes follow")
        return count

    def end(self) -> None:
        if self.left():
            self.refuse(f"has {self.left()} bytes more than it should")

    def refuse(self, sentence: str) -> None:
        raise Error(f"the message '{self._what}' {sentence}")
