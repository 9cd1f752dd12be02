# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""A program that is started for a connection, and ended with it."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
from typing import Optional


class Program:
    """COMMAND of spawn:, run by the shell in a session of its own. `socket` is this side's end of the one that the
    variable TANDEM_FD tells it."""

    def __init__(self, command: str) -> None:
        self.command = command
        self.socket, theirs = socket.socketpair()
        with theirs:
            self._process = subprocess.Popen(["/bin/sh", "-c", "exec " + command], pass_fds=[theirs.fileno()],
                                             env={**os.environ, "TANDEM_FD": str(theirs.fileno())},
                                             start_new_session=True)

    def fate(self) -> Optional[str]:
        """What became of it; None while it lives."""
        if not self._ended_within(0.2):
            return None
        status = self._process.returncode
        who = f"program '{self.command}' "
        return who + (f"ended with status {status}" if status >= 0 else f"was ended by signal {-status}")

    def end(self) -> None:
        """By now its socket is closed: one that reads it ends of its own accord, others are told to. What it has
        started and left goes with it."""
        if not self._ended_within(1.0):
            self._tell(signal.SIGTERM)
            self._ended_within(1.0)
        self._tell(signal.SIGKILL)
        self._process.wait()

    def _ended_within(self, seconds: float) -> bool:
        try:
            self._process.wait(seconds)
            return True
        except subprocess.TimeoutExpired:
            return False

    def _tell(self, number: int) -> None:
        try:
            os.killpg(self._process.pid, number)
        except OSError:  # nobody is left
            pass
