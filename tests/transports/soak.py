#!/usr/bin/env python3
# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Many exchanges over each transport: memory, open files, threads and latency have to stay as they are.

  soak.py TANDEM FILE.csv [EXCHANGES [TRANSPORT...]]     1 000 000; of tcp unix tls zmq:tcp zmq:ipc zmq:curve

A `tandem run` with one side of the two-mass test at a `tandem serve`. Both processes are looked at 50 times a second: after
a fifth of the exchanges, or after 0.1 s of a run that is too short to show how far it is, they may not grow by more than 4
MB, nor open files or threads. Writes
transport,exchanges,seconds,first_us,last_us,run_kb,serve_kb,files,threads: microseconds of an exchange over the first and
the last fifth (reported, as other work on the machine is in them), what grew. The status is 1 if something grew."""

import csv
import os
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "transports", "python"))
from fault_peers import all_transports  # noqa: E402

TREE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
STEP = 0.02  # s: the own step of the slow side at a frequency ratio of 2, one exchange
MOST_GROWTH = 4096  # kB


def held(process):
    """kB of memory, open files, threads; None once it has ended."""
    try:
        with open(f"/proc/{process.pid}/status", encoding="ascii") as file:
            fields = dict(line.split(":", 1) for line in file)
        return int(fields["VmRSS"].split()[0]), len(os.listdir(f"/proc/{process.pid}/fd")), int(fields["Threads"])
    except (OSError, KeyError):
        return None


def progress(folder):
    """Time in the run that has been recorded [s], by the last whole line."""
    try:
        with open(os.path.join(folder, "results.csv"), "rb") as file:
            file.seek(max(os.fstat(file.fileno()).st_size - 400, 0))
            return float(file.read().split(b"\n")[-2].split(b",")[0])
    except (OSError, ValueError, IndexError):
        return 0.0


class Watch:
    """What two processes hold while they run, and how far they are."""

    def __init__(self, run, serve, folder, stop):
        self.run, self.serve, self.folder, self.stop = run, serve, folder, stop
        self.times, self.growth, self.first, self.settled = [(time.monotonic(), 0.0)], [0, 0, 0, 0], None, False

    def look(self):
        now, done = (held(self.run), held(self.serve)), progress(self.folder)
        if None in now:
            return
        self.times.append((time.monotonic(), done))
        if not self.settled and done >= 0.2 * self.stop:
            self.first, self.growth, self.settled = now, [0, 0, 0, 0], True
        if not self.first and time.monotonic() - self.times[0][0] < 0.1:
            return
        self.first = self.first or now
        grown = [now[0][0] - self.first[0][0], now[1][0] - self.first[1][0],
                 max(now[k][1] - self.first[k][1] for k in (0, 1)), max(now[k][2] - self.first[k][2] for k in (0, 1))]
        self.growth = [max(pair) for pair in zip(self.growth, grown)]

    def microseconds(self, begin, end):
        """Of an exchange between two shares of the run."""
        inside = [(t, done) for t, done in self.times if begin * self.stop <= done <= end * self.stop]
        if len(inside) < 2 or inside[-1][1] <= inside[0][1]:
            return float("nan")
        return 1e6 * (inside[-1][0] - inside[0][0]) * STEP / (inside[-1][1] - inside[0][1])


def soak(command, folder, transport, exchanges):
    place = tempfile.mkdtemp(dir=folder)
    serve = subprocess.Popen(
        [command, "serve", "builtin:two_mass.slow", "--listen", transport.free_address(), *transport.options],
        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    try:
        uri = serve.stdout.readline().split(" at ")[1].strip()
        query = transport.query.replace(transport.query.split("&")[0], "deadline=30")
        stop = exchanges * STEP
        begin = time.monotonic()
        run = subprocess.Popen(
            [command, "--quiet", "run", os.path.join(TREE, "scenarios", "two_mass", "two_mass.toml"), "--no-reference",
             "--output", place, "--set", f"subsystems.slow.source={uri}?{query}", "--set", "parameters.frequency_ratio=2",
             "--set", f"span.stop={stop}", "--set", "record.clock=slow", "--set", "record.ports=[\"slow.x2\"]"], stdout=subprocess.DEVNULL)
        watch = Watch(run, serve, place, stop)
        while run.poll() is None:
            time.sleep(0.02)
            watch.look()
        seconds = time.monotonic() - begin
        sound = (run.returncode == 0 and watch.first is not None and progress(place) >= 0.999 * stop
                 and max(watch.growth[:2]) <= MOST_GROWTH and max(watch.growth[2:]) <= 0)
        row = [transport.name, exchanges, f"{seconds:.1f}", f"{watch.microseconds(0.0, 0.2):.1f}",
               f"{watch.microseconds(0.8, 1.0):.1f}", *watch.growth]
        return row, sound
    finally:
        serve.send_signal(signal.SIGTERM)
        serve.wait()


def main(command, output, exchanges="1000000", *names):
    command = os.path.abspath(command)
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for transport in all_transports(command, folder):
            if not names or transport.name in names:
                rows.append(soak(command, folder, transport, int(exchanges)))
                print(*rows[-1][0], "" if rows[-1][1] else "not as it has to be", flush=True)
    os.makedirs(os.path.dirname(os.path.abspath(output)), exist_ok=True)
    with open(output, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["transport", "exchanges", "seconds", "first_us", "last_us", "run_kb", "serve_kb", "files", "threads"])
        table.writerows(row for row, _ in rows)
    return 0 if rows and all(sound for _, sound in rows) else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
