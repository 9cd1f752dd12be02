# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Clients that connect and say nothing, as a server finds them: none keeps its place beyond the deadline."""

import contextlib
import time

import tandem
from fault_peers import SLACK
from fault_serving import Served, sentence_of
from tandem import wire

SILENCE = 1.0  # s: the deadline of these servers
LONG = 600  # s: their idle time, which nobody here waits for
CROWD = 70


class Silent(Served):
    """A server of its own, as each of these faults takes its time."""

    def __init__(self, command, transport, folder, program, sessions):
        super().__init__(command, transport, folder, program, sessions, SILENCE, LONG)
        self.sessions = sessions

    def end_of(self, channel):
        """How the server ends a session: the number of the error and its sentence."""
        try:
            answer = channel.receive(SILENCE + SLACK)
        except tandem.Error:
            return None, ""
        return (answer[1] if answer else None), sentence_of(answer)

    def has_place(self):
        """For one that speaks, within the deadline and what a busy machine takes."""
        until = time.monotonic() + SILENCE + SLACK
        while time.monotonic() < until:
            if self.is_alive(SILENCE):
                return True
            time.sleep(0.02)
        return False

    def one_place(self):
        """While somebody is in the only place, others are told so; one that says nothing has it for the deadline."""
        turned_away = (1, f"the server has {self.sessions} sessions open, the most that it allows; try again later")
        begin = time.monotonic()
        for _ in range(5):  # until the second one comes before the first one has gone
            first = self.transport.connect(self.uri)
            with first.raw:
                other = self.transport.connect(self.uri)
                with other.raw:
                    second = self.end_of(other)
                ended = self.end_of(first)
            if second == turned_away:
                break
        silent = f"no hello came within {SILENCE:g} s, so the session ends"
        sound = second == turned_away and ended == (0, silent) and self.has_place()
        self.row("silent_peer", "error", time.monotonic() - begin, sound, f"{second}, {ended}")

    def late_byte(self):
        """Its hello begins just before the deadline, which is that of the hello's end."""
        begin = time.monotonic()
        channel = self.transport.connect(self.uri)
        with channel.raw:
            time.sleep(max(0.0, 0.9 * SILENCE - (time.monotonic() - begin)))
            with contextlib.suppress(tandem.Error, OSError):
                channel.raw.sendall(b"\x23")
                self.end_of(channel)
        seconds = time.monotonic() - begin
        self.row("late_byte_of_hello", "error", seconds, seconds < 1.6 * SILENCE and self.has_place())

    def speaks_once(self):
        """One that has said hello has the idle time."""
        channel = self.transport.connect(self.uri)
        sound = False
        with channel.raw, contextlib.suppress(tandem.Error):
            channel.send(wire.Type.HELLO, 1, wire.put_hello(""), SLACK)
            channel.receive(SLACK)
            time.sleep(SILENCE + 0.3)
            channel.send(wire.Type.PING, 2, b"beat", SLACK)
            answer = channel.receive(SLACK)
            sound = answer is not None and answer[0] == wire.Type.PING
        self.row("silent_after_hello", "ok", 0.0, sound)

    def crowd(self, kind, connect):
        """More than there are places for; then one that works."""
        begin = time.monotonic()
        with contextlib.ExitStack() as all_of_them:
            for _ in range(CROWD):
                with contextlib.suppress(tandem.Error, OSError):  # who is turned away
                    all_of_them.enter_context(connect())
            sound = self.has_place()
        self.row(kind, "error", time.monotonic() - begin, sound)


def silence(command, transport, folder, program):
    """The rows of these faults."""
    rows = []
    for sessions in (1, 64):
        server = Silent(command, transport, folder, program, sessions)
        try:
            if sessions == 1:
                server.one_place()
            else:
                server.late_byte()
                server.speaks_once()
                server.crowd("70_silent_peers", lambda: transport.connect(server.uri).raw)
                if transport.layered:
                    server.crowd("70_silent_connections_beneath", lambda: transport.plain(server.uri))
        finally:
            server.process.terminate()
            server.process.wait(10)
        rows += server.rows
    return rows
