# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""What a server is told."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import List, Optional

from .contract import Error

MOST_SESSIONS = 10000
_WITH_VALUE = ("--listen", "--sessions", "--deadline", "--idle")
_NAMES = (*_WITH_VALUE, "--once")


@dataclass
class Options:
    """address: None for the session of the program that started this one. deadline: seconds for the first request of a
    session, for a frame to come whole, and for a reply to be taken; idle: from one request to the next; sessions: the
    most at a time."""

    address: Optional[str] = None
    once: bool = False
    deadline: float = 5.0
    idle: float = 3600.0
    sessions: int = 64

    def check(self) -> None:
        for name, seconds in (("deadline", self.deadline), ("idle", self.idle)):
            if not 0.0 < seconds < math.inf:
                raise Error(f"{name} is {seconds} s; allowed is a number above 0")
        if not 1 <= self.sessions <= MOST_SESSIONS:
            raise Error(f"sessions is {self.sessions}; allowed are 1 to {MOST_SESSIONS}")

    def read(self, words: List[str]) -> None:
        """Words of a command line: those before the first of these options are the program's own."""
        left = list(words)
        while left and left[0] not in _NAMES:
            left.pop(0)
        while left:
            self._take(left.pop(0), left)

    def _take(self, name: str, left: List[str]) -> None:
        if name not in _NAMES:
            raise Error(f"'{name}' is no option; allowed are --listen URI, --once, --sessions N, --deadline S, --idle S")
        if name == "--once":
            self.once = True
            return
        if not left:
            raise Error(f"{name} has no value")
        text = left.pop(0)
        if name == "--listen":
            self.address = text
            return
        try:
            setattr(self, name[2:], int(text) if name == "--sessions" else float(text))
        except ValueError:
            raise Error(f"{name} has '{text}'; allowed is a number above 0") from None
