#!/usr/bin/env python3
# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Makes each call for memory, a thread, a descriptor, a read and a write fail once in turn, in a run, a run with
checkpoints, and a server; and looks each time whether what docs/security.md promises holds.

    injected.py TANDEM INJECT.so SCENARIOS [MOST]

MOST: failures of each kind, spread over the calls there are; without it every one of them."""

import concurrent.futures
import contextlib
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "transports/python"))
import tandem  # noqa: E402

KINDS = ["new", "thread", "descriptor", "read", "write"]
DEADLINE = 60  # s


class Broken(Exception):
    """A promise that was not kept."""


class InLibrary(Exception):
    """A library that can't hand a shortage of memory on has ended the process (docs/security.md lists them)."""


BESIDE = re.compile("tandem: (note: |.* s simulated in )")  # no error

# Eigen frees a matrix that it resizes twice; toml++ and nlohmann-json throw where nothing may be thrown, which the
# command tells in a sentence.
ENDINGS_IN_LIBRARIES = re.compile(r"free\(\): double free|double free or corruption|tandem: there is no memory for it")


def ended_in_library(kind, said):
    if kind == "new" and ENDINGS_IN_LIBRARIES.search(said):
        raise InLibrary


def environment(inject, **words):
    return {**os.environ, "LD_PRELOAD": inject, **words}


def counts_of(text):
    return {kind: int(count) for kind, count in (line.split() for line in text.splitlines())}


def spread(count, most):
    """Numbers from 0 to count - 1, evenly, the first and the last among them."""
    if most is None or count <= most:
        return range(count)
    return sorted({round(k * (count - 1) / (most - 1)) for k in range(most)})


def require(holds, what):
    if not holds:
        raise Broken(what)


class Command:
    """A command that writes results, with the results that are right."""

    def __init__(self, name, command, inject, words):
        self.name, self.command, self.inject, self.words = name, command, inject, words
        with tempfile.TemporaryDirectory() as folder:
            counts = pathlib.Path(folder, "counts")
            done = self.call(folder, TANDEM_FAIL_COUNTS=str(counts))
            require(done.returncode == 0, f"without a failure: {done.stderr}")
            self.counts = counts_of(counts.read_text())
            self.right = self.rows(folder)

    def call(self, folder, **words):
        return subprocess.run([self.command, *self.words, "--output", f"{folder}/o"], cwd=folder, text=True,
                              errors="replace", capture_output=True, timeout=DEADLINE,
                              env=environment(self.inject, **words))

    @staticmethod
    def rows(folder):
        file = pathlib.Path(folder, "o/results.csv")
        return file.read_bytes() if file.exists() else b""

    def fail(self, kind, number):
        with tempfile.TemporaryDirectory() as folder:
            try:
                done = self.call(folder, TANDEM_FAIL=f"{kind}:{number}")
            except subprocess.TimeoutExpired:
                raise Broken(f"it did not end within {DEADLINE} s") from None
            if done.returncode < 0:
                ended_in_library(kind, done.stderr)
            self.check(folder, done)

    def check(self, folder, done):
        require(done.returncode in (0, 1, 2), f"status {done.returncode}: {done.stderr[-300:]}")
        require(not list(pathlib.Path(folder).rglob("*.part")), "a .part file is left")
        rows, file = self.rows(folder), pathlib.Path(folder, "o/results.json")
        require(self.right.startswith(rows), "rows are not those of the run")
        if done.returncode == 0:
            require(rows == self.right, "status 0 without all rows")
            return
        told = [line for line in done.stderr.splitlines() if line.startswith("tandem:") and not BESIDE.match(line)]
        require(len(told) == 1, f"{len(told)} sentences: {done.stderr[-300:]!r}")
        require("std::" not in told[0], f"no sentence of ours: {told[0]}")
        if file.exists() and rows != self.right:
            try:
                status = json.loads(file.read_text())["status"]
            except ValueError:
                raise Broken("results.json is cut") from None
            require(status != "ok", "status ok beside rows that are cut")


class Resumed(Command):
    """The same with checkpoints; a run that failed goes on from its last one, if there is any, to the same rows."""

    def check(self, folder, done):
        super().check(folder, done)
        if done.returncode == 0 or not pathlib.Path(folder, "o/checkpoint").exists():
            return
        again = subprocess.run([self.command, *self.words, "--output", f"{folder}/o", "--resume",
                                f"{folder}/o/checkpoint"], cwd=folder, text=True, capture_output=True,
                               timeout=DEADLINE)
        require(again.returncode == 0, f"it can't be resumed: {again.stderr[-300:]}")
        require(self.rows(folder) == self.right, "resumed, the rows are others")


def drive(subsystem, start=0.0):
    """A session from its start: all that it may be asked."""
    rows = [tuple(row.values) for row in subsystem.initialize(start, 100.0, inputs(subsystem, 0.5))[1]]
    state = subsystem.save_state()
    rows += go_on(subsystem, start + 10.0)
    copy = subsystem.deserialize_state(subsystem.serialize_state(state))
    subsystem.restore_state(copy)
    subsystem.release_state(copy)
    return rows + go_on(subsystem, start + 10.0)


def inputs(subsystem, each):
    return [each] * sum(port.size for port in subsystem.info().inputs)


def go_on(subsystem, limit):
    u = inputs(subsystem, tandem.Signal([tandem.Segment(limit, 0.0, (0.5, 0.1))]))
    return [tuple(row.values) for row in subsystem.advance(limit, u)[1]]


class Server:
    """A server with one session that stands by while the calls of another one fail, and a third one after it."""

    def __init__(self, name, command, inject, words):
        self.name, self.command, self.inject, self.words = name, command, inject, words
        with tempfile.TemporaryDirectory() as folder:
            self.right = None
            self.serve(folder)
            self.counts = counts_of(pathlib.Path(folder, "counts").read_text())

    def fail(self, kind, number):
        with tempfile.TemporaryDirectory() as folder:
            try:
                self.serve(folder, TANDEM_FAIL=f"{kind}:{number}")
            except Broken:
                ended_in_library(kind, pathlib.Path(folder, "err").read_text())
                raise

    def serve(self, folder, **words):
        log = pathlib.Path(folder, "err")
        with log.open("w") as err:
            server = subprocess.Popen([self.command, "serve", *self.words, "--listen", f"unix:{folder}/socket",
                                       "--deadline", "2"], stdout=subprocess.PIPE, stderr=err, text=True,
                                      env=environment(self.inject, TANDEM_FAIL_ON_SIGNAL="1",
                                                      TANDEM_FAIL_COUNTS=f"{folder}/counts",
                                                      TANDEM_FAIL_COUNTING=f"{folder}/counting", **words))
        try:
            uri = server.stdout.readline().split(" at ")[1].strip()
            self.talk(server, uri, log)
            server.terminate()
            require(server.wait(DEADLINE) == 0, f"the server's status is {server.returncode}: {log.read_text()[-300:]}")
        finally:
            server.kill()
            server.wait()
            server.stdout.close()

    def talk(self, server, uri, log):
        with contextlib.suppress(tandem.Error, OSError), tandem.connect(uri) as standing_by:
            first = drive(standing_by)
            self.right = self.right or first
            self.signal(server, log.with_name("counting"))
            lives = [self.lives(lambda: tandem.connect(uri))]
            self.signal(server, log.with_name("counts"))
            require(server.poll() is None, f"the server ended, {server.returncode}: {log.read_text()[-300:]}")
            lives.append(self.lives(lambda: contextlib.nullcontext(standing_by)))
            require(any(lives), "both sessions ended")
        with tandem.connect(uri) as third:
            require(drive(third) == self.right, "a new session is not right")

    @staticmethod
    def signal(server, answer):
        server.send_signal(signal.SIGUSR2)
        end = time.monotonic() + DEADLINE
        while not answer.exists() and server.poll() is None and time.monotonic() < end:
            time.sleep(0.001)

    def lives(self, session):
        """Whether it does all that it is asked; if not, it has ended with a sentence."""
        try:
            with session() as it:
                require(drive(it) == self.right, "the session's values are wrong")
            return True
        except tandem.Error as error:
            require("std::" not in str(error), f"no sentence of ours: {error}")
            return False


def try_all(what, most):
    """How many failures were tried of each kind, and what was broken."""
    jobs = [(kind, number) for kind in KINDS for number in spread(what.counts[kind], most)]

    def one(job):
        try:
            what.fail(*job)
        except InLibrary:
            return job, None
        except Broken as error:
            return job, str(error)
        return None

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        ended = [found for found in pool.map(one, jobs) if found]
    broken = [(job, why) for job, why in ended if why]
    tried = ", ".join(f"{kind} {len(spread(what.counts[kind], most))} of {what.counts[kind]}" for kind in KINDS)
    print(f"{what.name}: {tried}; ended in a library {len(ended) - len(broken)}, broken {len(broken)}", flush=True)
    for (kind, number), why in broken:
        print(f"  {kind}:{number}: {why}")
    return len(broken)


def main():
    command, inject, scenarios = sys.argv[1:4]
    most = int(sys.argv[4]) if len(sys.argv) > 4 else None
    two_mass = ["run", f"{scenarios}/two_mass/two_mass.toml", "--no-reference", "--set", "span.stop=0.5"]
    linkage = ["run", f"{scenarios}/engine_linkage/engine_linkage.toml", "--no-reference", "--set",
               "span.stop=0.01"]
    commands = [
        Command("run two_mass", command, inject, two_mass),
        Resumed("run two_mass with checkpoints", command, inject, [*two_mass, "--checkpoint-every", "0.1"]),
        Command("run engine_linkage", command, inject, linkage),
        Command("run two_mass with threads", command, inject, [*two_mass, "--threads", "4"]),
        Server("serve a model", command, inject, ["builtin:two_mass.slow"]),
        Server("serve a mechanism", command, inject, [f"mechanism:{scenarios}/mechanisms/four_bar/four_bar.toml"]),
        Server("serve a diagram", command, inject, [f"diagram:{scenarios}/engine/governor.toml?step=0.01"]),
    ]
    sys.exit(1 if sum(try_all(what, most) for what in commands) else 0)


if __name__ == "__main__":
    main()
