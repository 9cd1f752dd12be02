# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""The saved states that a session keeps."""

from __future__ import annotations

from typing import Dict

from .contract import Error

MOST_STATES = 1000
MOST_STATE_BYTES = 1 << 25


class States:
    """How many there are, and how many bytes they have, as far as that is known. A peer may leave them for as long as
    it likes, but only so many."""

    def __init__(self) -> None:
        self._sizes: Dict[int, int] = {}
        self._all = 0
        self.usual = 0  #: bytes of one; 0 while that is not known

    def require_room(self, size: int) -> None:
        if not self._sizes:  # one is as large as the model makes it
            return
        if len(self._sizes) >= MOST_STATES or self._all + size > MOST_STATE_BYTES:
            raise Error(f"the session keeps {len(self._sizes)} saved states of {self._all} bytes; allowed are up to "
                        f"{MOST_STATES}, and {MOST_STATE_BYTES} bytes in all: release some", 2)

    def keep(self, state: int, size: int) -> None:
        self.forget(state)
        self._sizes[state] = size
        self._all += size

    def forget(self, state: int) -> None:
        self._all -= self._sizes.pop(state, 0)
