# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""A program that is started for a connection, and ended with it."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
from typing import Optional


GUARD = "trap '' HUP INT TERM; read x; kill -KILL 0"


class Program:
    """COMMAND of spawn:, as `sh -c COMMAND` runs it, in a group of its own. `socket` is this side's end of the one that
    the variable TANDEM_FD tells it. The group ends with this process, however that ends: a shell in it waits for the end
    of its standard input, which only this process holds open, and then kills the group."""

    def __init__(self, command: str) -> None:
        self.command = command
        self._guard = subprocess.Popen(["/bin/sh", "-c", GUARD], stdin=subprocess.PIPE, preexec_fn=os.setpgrp)
        self._group = self._guard.pid
        try:
            self._start(command)
        except BaseException:
            self._end_group()
            raise

    def _start(self, command: str) -> None:
        self.socket, theirs = socket.socketpair()
        with theirs:
            self._process = subprocess.Popen(["/bin/sh", "-c", command], pass_fds=[theirs.fileno()],
                                             env={**os.environ, "TANDEM_FD": str(theirs.fileno())},
                                             preexec_fn=lambda: os.setpgid(0, self._group))

    def fate(self) -> Optional[str]:
        """What became of it; None while it lives."""
        if not self._ended_within(0.2):
            return None
        status = self._process.returncode
        who = f"program '{self.command}' "
        if status < 0:
            return who + f"was ended by signal {-status}"
        return who + f"ended with status {status}" + (f" (signal {status - 128}?)" if status > 128 else "")

    def end(self) -> None:
        """By now its socket is closed: one that reads it ends of its own accord, others are told to. What it has
        started and left goes with it. A second time it does nothing: the group's number may be another's by then."""
        if self._guard.returncode is not None:
            return
        if not self._ended_within(1.0):
            self._tell(signal.SIGTERM)
        if not self._ended_within(1.0):
            self._process.kill()
        self._process.wait()
        self._end_group()

    def _end_group(self) -> None:
        self._tell(signal.SIGKILL)
        assert self._guard.stdin is not None
        self._guard.stdin.close()
        self._guard.wait()

    def _ended_within(self, seconds: float) -> bool:
        try:
            self._process.wait(seconds)
            return True
        except subprocess.TimeoutExpired:
            return False

    def _tell(self, number: int) -> None:
        try:
            os.killpg(self._group, number)
        except OSError:  # nobody is left
            pass
