#!/usr/bin/env python3
# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""The most memory that a session takes, whatever its client sends.

  memory.py FILE.csv SAVES NAME[:ROWS]=COMMAND...

Each COMMAND serves the wide subsystem (tests/libraries/wide.c), as spawn: starts it. ROWS are asked for at most (of a server
that takes too long for a whole reply of them). Each of the largest requests goes to a
process of its own, after SAVES requests to save a state (100000 in the long form). Writes
server,request,megabytes,start,peak,taken,outcome: what was sent, the most that the process had before it was
initialized and at its end (VmHWM of Linux) [MiB], and the difference. The status is 1 if one took more than 160 MiB, or
the server is not there any more, or keeps states whose saving failed."""

import csv
import os
import shlex
import socket
import struct
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "transports", "python"))
import tandem  # noqa: E402
from tandem import wire  # noqa: E402

MOST = 160.0  # MiB: a request of 64, a reply of 64, and states of 32
LONGEST = wire.LONGEST
WIDEST = LONGEST // 8 - 16  # scalars of the inputs of one initialize, or of one row
MOST_SEGMENTS = LONGEST // 64 - 1
MOST_IN_PYTHON = wire.MOST_SEGMENTS
STATE = 1 << 15  # bytes: a thousand of them are the most that a session keeps
PATIENCE = 120.0  # s


class Served:
    """A server on a socket pair, asked with what no client of ours would ask."""

    def __init__(self, command, rows, parameters):
        ours, theirs = socket.socketpair()
        with theirs:
            self.process = subprocess.Popen(shlex.split(command), pass_fds=[theirs.fileno()], stderr=subprocess.DEVNULL,
                                            env={**os.environ, "TANDEM_FD": str(theirs.fileno())})
        self.channel, self.rows, self.number = wire.Channel(ours, command), rows, 0
        self.said = ""  # by the last error
        self.ask(wire.Type.HELLO, wire.put_hello(parameters))
        self.info = wire.read_info(self.ask(wire.Type.INFO, b""))

    def ask(self, kind, payload):
        """The reply's payload; None if it is an error."""
        self.number += 1
        self.channel.send(kind, self.number, payload, PATIENCE)
        answer, _, data = self.channel.receive(PATIENCE)
        if answer == wire.Type.ERROR:
            self.said = str(wire.read_error(data, self.info if kind == wire.Type.ADVANCE else None))
        return None if answer == wire.Type.ERROR else data

    def initialize(self, inputs):
        return self.ask(wire.Type.INITIALIZE, struct.pack("<ddQI", 0.0, 1.0, 1, inputs) + bytes(8 * inputs))

    def peak(self):
        """The most memory that it has had [MiB]."""
        with open(f"/proc/{self.process.pid}/status", encoding="ascii") as file:
            fields = dict(line.split(":", 1) for line in file)
        return int(fields["VmHWM"].split()[0]) / 1024.0

    def close(self):
        self.channel.close()
        self.process.wait(PATIENCE)


def advance(signals, rows):
    """signals: the segments of each, and their degree."""
    parts = [struct.pack("<dIIQ", 0.5, 0, len(signals), rows)]
    for segments, degree in signals:
        parts += [struct.pack("<II", segments, degree), bytes(8 * (degree + 3) * segments)]
    return b"".join(parts)


def advances(name, parameters, inputs, *each):
    return name, parameters, inputs, lambda rows: (wire.Type.ADVANCE, advance([each] * inputs, rows))


#: name, parameters, scalars of the inputs, and the request behind the saves
REQUESTS = [
    advances("advance of many segments", "", 1, MOST_SEGMENTS, 5),
    advances("advance of fewer segments", "", 1, MOST_IN_PYTHON, 5),
    advances("advance of many inputs", "inputs=700000", 700000, 1, 0),
    advances("advance of fewer inputs", f"inputs={MOST_IN_PYTHON}", MOST_IN_PYTHON, 1, 0),
    advances("advance to wide rows", f"outputs={WIDEST}", 1, 1, 0),
    ("initialize", f"inputs={WIDEST}&outputs={WIDEST}", WIDEST, None),
    ("deserialize", "", 1, lambda rows: (wire.Type.DESERIALIZE, bytes(LONGEST))),
    ("deserialize before all saves", "", 1, lambda rows: (wire.Type.DESERIALIZE, bytes(LONGEST))),
    ("ping", "", 1, lambda rows: (wire.Type.PING, bytes(LONGEST))),
    ("saves alone", "", 1, None),
    ("saves that fail", "dumb=2", 1, None),
]
FULL = "the session keeps"  # as the refusal of one state too many begins


def measure(command, rows, saves, request):
    name, parameters, inputs, further = request
    served = Served(command, rows, f"bytes={STATE}" + ("&" + parameters if parameters else ""))
    outcomes, sent = [], 8 * inputs

    def save():
        kept = sum(served.ask(wire.Type.SAVE, b"") is not None for _ in range(saves))
        outcomes.append(f"{kept} states kept")
        if "dumb" in parameters and FULL in served.said:
            outcomes.append("and those that failed too")

    def go_further():
        nonlocal sent
        kind, payload = further(served.rows)
        sent = len(payload)
        outcomes.append("done" if served.ask(kind, payload) is not None else "refused")

    try:
        start = served.peak()
        outcomes.append("started" if served.initialize(inputs) is not None else "refused to start")
        if served.info.input_size() == inputs:
            work = [save] + [go_further] * (further is not None)
            for part in reversed(work) if "before" in name else work:
                part()
        peak = served.peak()
    finally:
        served.close()
    return [name, *(f"{size:.1f}" for size in (sent / 2 ** 20, start, peak, peak - start)), ", ".join(outcomes)]


def main(output, saves, *servers):
    rows = []
    for label, command in (server.split("=", 1) for server in servers):
        name, _, most = label.partition(":")
        for request in REQUESTS:
            try:
                rows.append([name, *measure(command, int(most or 1 << 60), int(saves), request)])
            except (tandem.Error, OSError, TypeError) as error:
                rows.append([name, request[0], "", "", "", "inf", f"it ended: {error}"])
            print(*rows[-1], sep=" | ", flush=True)
    os.makedirs(os.path.dirname(os.path.abspath(output)), exist_ok=True)
    with open(output, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["server", "request", "megabytes", "start", "peak", "taken", "outcome"])
        table.writerows(rows)
    return 1 if any(float(row[5]) > MOST or "failed too" in row[6] for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
