#!/usr/bin/env python3
# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Faults on sockets, each made by a second process, on the side that calls and on the side that serves.

  faults.py TANDEM FILE.csv [--programs NAME SERVER CALLER]... [TRANSPORT...]

Transports are tcp unix tls zmq:tcp zmq:ipc zmq:curve; without a word all that TANDEM was built with.

SERVER and CALLER, commands, serve and call in place of TANDEM: `SERVER --listen URI ...`, `CALLER URI`; "-" for CALLER
leaves that side out. A call has to end within its deadline in one sentence that names the address, with what was recorded
kept; a server has to live on, and to hold no more files, threads and children than before. Writes
program,kind,transport,side,outcome,seconds; the status is 1 if a row is not as it has to be."""

import concurrent.futures
import csv
import functools
import os
import shlex
import signal
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "..", "transports", "python"), os.path.join(HERE, "..", "programs")]
from fault_calling import Caller  # noqa: E402
from fault_peers import all_transports  # noqa: E402
from fault_serving import Served  # noqa: E402
from fault_silence import silence  # noqa: E402


def calling(command, folder, transport, program, part):
    """program: the name, and the words of its server and caller; None: tandem's own. part: of the faults."""
    caller = Caller(command, folder, transport, program[2])
    part(caller)
    return caller.rows


def serving(command, folder, transport, program):
    served = Served(command, transport, folder, program[1])
    try:
        served.all()
    finally:
        served.process.kill()
        served.process.wait()
    return served.rows


def silent(command, folder, transport, program):
    return silence(command, transport, folder, program[1])


def parts_of(program):
    """Each in a process of its own, as most of the time is spent waiting."""
    if program[2] == ["-"]:
        return [serving, silent]
    of_calls = (Caller.phases, Caller.changed_replies, Caller.others)
    return [serving, silent, *(functools.partial(calling, part=part) for part in of_calls)]


def write(output, rows):
    os.makedirs(os.path.dirname(os.path.abspath(output)), exist_ok=True)
    with open(output, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["program", "kind", "transport", "side", "outcome", "seconds"])
        table.writerows((*row[:5], f"{row[5]:.3f}") for row in rows)


def make_all(command, folder, programs, transports):
    """The rows, in the order of programs and transports."""
    work = [(part, transport, program) for program in programs for transport in transports for part in parts_of(program)]
    with concurrent.futures.ProcessPoolExecutor(len(work)) as pool:
        made = [(program[0], pool.submit(part, command, folder, transport, program)) for part, transport, program in work]
        return [(name, *row) for name, some in made for row in some.result()]


def transports_named(names, found):
    unknown = set(names) - {transport.name for transport in found}
    if unknown:
        sys.exit(f"faults.py: transport {unknown.pop()} is not there; allowed are "
                 + ", ".join(transport.name for transport in found))
    return [transport for transport in found if not names or transport.name in names]


def main(command, output, *names):
    signal.signal(signal.SIGPIPE, signal.SIG_IGN)
    command, programs = os.path.abspath(command), []
    while names[:1] == ("--programs",):
        programs.append((names[1], *map(shlex.split, names[2:4])))
        names = names[4:]
    with tempfile.TemporaryDirectory() as folder:
        transports = transports_named(names, all_transports(command, folder))
        rows = make_all(command, folder, programs or [("tandem", None, None)], transports)
    write(output, rows)
    wrong = [row for row in rows if not row[6]]
    for row in wrong:
        print("not as it has to be:", *row, sep=" | ")
    print(f"{len(rows)} faults, {len(wrong)} not as they have to be; {output}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
