#!/usr/bin/env python3
# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Faults on sockets, each made by a second process, on the side that calls and on the side that serves.

  faults.py TANDEM FILE.csv [--programs SERVER CALLER] [TRANSPORT...]

Transports are tcp unix tls zmq:tcp zmq:ipc zmq:curve; without a word all that TANDEM was built with.

SERVER and CALLER serve and call in place of TANDEM: `SERVER --listen URI ...`, `CALLER URI`.
A call has to end within its deadline in one sentence that names the address, with what was recorded kept; a server has to
live on, and to hold no more files, threads and children than before. Writes kind,transport,side,outcome,seconds; the status
is 1 if a row is not as it has to be."""

import concurrent.futures
import csv
import os
import signal
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "transports", "python"))
from fault_calling import Caller  # noqa: E402
from fault_peers import all_transports  # noqa: E402
from fault_serving import Served  # noqa: E402


def rows_of(command, folder, transport, server, program):
    caller = Caller(command, folder, transport, program)
    caller.all()
    served = Served(command, transport, folder, server)
    try:
        served.all()
    finally:
        served.process.kill()
        served.process.wait()
    return caller.rows + served.rows


def write(output, rows):
    os.makedirs(os.path.dirname(os.path.abspath(output)), exist_ok=True)
    with open(output, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["kind", "transport", "side", "outcome", "seconds"])
        table.writerows((*row[:4], f"{row[4]:.3f}") for row in rows)


def main(command, output, *names):
    signal.signal(signal.SIGPIPE, signal.SIG_IGN)
    command = os.path.abspath(command)
    server = program = None
    if names[:1] == ("--programs",):
        server, program, names = *names[1:3], names[3:]
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        found = all_transports(command, folder)
        unknown = set(names) - {transport.name for transport in found}
        if unknown:
            sys.exit(f"faults.py: transport {unknown.pop()} is not there; allowed are "
                     + ", ".join(transport.name for transport in found))
        asked = [transport for transport in found if not names or transport.name in names]
        with concurrent.futures.ProcessPoolExecutor(len(asked)) as pool:  # most of the time is spent waiting
            for some in pool.map(rows_of, *zip(*((command, folder, transport, server, program) for transport in asked))):
                rows += some
    write(output, rows)
    wrong = [row for row in rows if not row[5]]
    for row in wrong:
        print("not as it has to be:", *row, sep=" | ")
    print(f"{len(rows)} faults, {len(wrong)} not as they have to be; {output}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
