#!/usr/bin/env python3
# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Faults on sockets, each made by a second process, on the side that calls and on the side that serves.

  faults.py TANDEM FILE.csv [SERVER CALLER]

SERVER and CALLER are programs that serve and call in place of TANDEM: `SERVER --listen URI ...`, `CALLER URI`.
A call has to end within its deadline in one sentence that names the address, with what was recorded kept; a server has to
live on, and to hold no more files and threads than before. Writes kind,transport,side,outcome,seconds; the status is 1 if a
row is not as it has to be."""

import csv
import os
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "transports", "python"))
import tandem  # noqa: E402
from tandem import serving, wire  # noqa: E402

DEADLINE = 0.5
SLACK = 3.0  # the starting of processes on a busy machine
REPLIES = {"hello": 1, "info": 2, "initialize": 3, "advance": 6}  # requests before them answered soundly
NAN, INFINITY = float("nan"), float("inf")


class Ramp:
    """x = t, with a step of 0.1 s."""

    def info(self):
        return tandem.Info("ramp", [tandem.Port("u", "m", start=0.0)], [tandem.Port("x", "m")])

    def own_step(self):
        return 0.1

    def start(self, t, u0):
        self.t = t

    def step(self, begin, end, h, u):
        self.t = end

    def outputs(self):
        return [self.t]


class Faulty(wire.Channel):
    """Answers soundly up to request `at`, and then does `fault(channel, frame)`."""

    def __init__(self, sock, at, fault):
        super().__init__(sock, "faulty")
        self.raw, self._at, self._fault, self.last = sock, at, fault, b""

    def send(self, kind, number, payload, deadline):
        frame = wire.HEADER.pack(len(payload), kind, number) + payload
        if number == self._at:
            return self._fault(self, frame)
        self.last = frame
        return self.raw.sendall(frame)


def gone(channel):
    channel.raw.shutdown(socket.SHUT_RDWR)


def sending(change):
    return lambda channel, frame: channel.raw.sendall(change(frame))


def dribble(channel, frame):
    for byte in frame[:8]:
        channel.raw.sendall(bytes([byte]))
        time.sleep(1.0)


def drop_within(channel, frame):
    channel.raw.sendall(frame[: len(frame) // 2])
    gone(channel)


def drop_after(channel, frame):
    channel.raw.sendall(frame)
    gone(channel)


def put(place, form, value):
    return lambda f: f[:place] + struct.pack("<" + form, value) + f[place + struct.calcsize("<" + form):]


def silent(channel, frame):
    time.sleep(5.0)


def calling_faults():
    """(kind, request, fault) of a server that answers."""
    faults = []
    for phase, at in REPLIES.items():
        faults += [(f"dropped_before_{phase}", at, lambda c, f: gone(c)), (f"dropped_within_{phase}", at, drop_within),
                   (f"dropped_after_{phase}", at, drop_after), (f"silent_at_{phase}", at, silent),
                   (f"killed_at_{phase}", at, lambda c, f: os.kill(os.getpid(), signal.SIGKILL)),
                   (f"stopped_at_{phase}", at, lambda c, f: os.kill(os.getpid(), signal.SIGSTOP))]
    sample = 16 + 32  # where the first row stands
    last = REPLIES["advance"]
    changes = [
        ("truncated_payload", last, lambda f: put(0, "Q", len(f) - 24)(f)[:-8]),
        ("length_one_more", last, lambda f: put(0, "Q", len(f) - 15)(f)),
        ("length_2_to_the_40", last, put(0, "Q", 1 << 40)),
        ("length_2_to_the_64_less_1", last, put(0, "Q", (1 << 64) - 1)),
        ("unknown_type", last, put(8, "I", 99)),
        ("type_of_another_reply", last, put(8, "I", 7)),
        ("number_of_another_request", last, put(12, "I", 5)),
        ("twice_the_same_reply", last - 1, lambda f: f + f),
        ("wrong_version", 1, put(24, "Q", (7 << 32) | 7)),
        ("text_protocol", 1, lambda f: b"HTTP/1.1 400 Bad Request\r\n\r\n"),
        ("no_magic", 1, put(16, "8s", b"GARBAGE!")),
        ("counts_of_ports", 2, put(16 + 12, "I", 0xFFFFFFFF)),
        ("wrong_row_size", last, put(16 + 20, "I", 17)),
        ("too_many_rows", last, put(16 + 24, "Q", 1 << 60)),
        ("unknown_stop", last, put(16 + 16, "I", 9)),
        ("value_not_a_number", last, put(sample + 16, "d", NAN)),
        ("value_infinite", last, put(sample + 16, "d", INFINITY)),
        ("time_not_a_number", last, put(sample, "d", NAN)),
        ("time_backward", last, lambda f: put(sample, "d", 0.05)(put(16, "d", 0.05)(f))),
        ("time_past_the_limit", last, lambda f: put(sample, "d", 50.0)(put(16, "d", 50.0)(f))),
        ("next_time_backward", last, put(24, "d", -1.0)),
        ("clock_beside_its_sample", last, put(16, "d", 0.25)),
    ]
    faults += [(kind, at, sending(change)) for kind, at, change in changes]
    return faults + [("one_byte_a_second", last, dribble)]


class Address:
    """Where this test listens, or asks to be listened at."""

    def __init__(self, transport, folder):
        self.path = os.path.join(folder, f"socket{time.monotonic_ns()}")
        self.transport = transport
        self.uri = f"unix:{self.path}" if transport == "unix" else "tcp://127.0.0.1:0"

    def listen(self):
        if self.transport == "unix":
            sock = socket.socket(socket.AF_UNIX)
            sock.bind(self.path)
            sock.listen()
        else:
            sock = socket.create_server(("127.0.0.1", 0))
            self.uri = f"tcp://127.0.0.1:{sock.getsockname()[1]}"
        return sock

    def connect(self):
        sock = socket.socket(socket.AF_UNIX if self.transport == "unix" else socket.AF_INET)
        sock.settimeout(DEADLINE + SLACK)
        sock.connect(self.path if self.transport == "unix" else ("127.0.0.1", int(self.uri.rpartition(":")[2])))
        return sock


def in_a_process(work):
    process = os.fork()
    if process == 0:
        try:
            work()
        except (tandem.Error, OSError):
            pass
        os._exit(0)
    return process


class Caller:
    """The side that calls, with a faulty server: `tandem run`, or a program that is given the URI."""

    def __init__(self, command, folder, program=None):
        self.command, self.folder, self.program, self.rows = command, folder, program, []

    def words(self, uri, folder):
        if self.program:
            return [self.program, uri]
        scenario = os.path.join(folder, "run.toml")
        with open(scenario, "w") as file:
            file.write(f'[subsystems.far]\nsource = "{uri}"\n[span]\nstop = 10.0\n'
                       '[subsystems.near]\nsource = "builtin:two_mass.fast?frequency_ratio=2"\n'
                       '[[connections]]\nfrom = "near.x1"\nto = "far.u"\nreconstruction = "lagrange0"\n'
                       '[[connections]]\nfrom = "far.x"\nto = "near.x2"\nreconstruction = "lagrange0"\n')
        return [self.command, "run", scenario, "--output", folder]

    def run(self, kind, transport, uri, limit=DEADLINE + SLACK):
        folder = tempfile.mkdtemp(dir=self.folder)
        place = "no-such-host" if kind == "unknown_host" else uri.partition("?")[0]
        begin = time.monotonic()
        try:
            done = subprocess.run(self.words(uri, folder), capture_output=True, text=True, timeout=30)
            status, said = done.returncode, done.stderr
        except subprocess.TimeoutExpired:
            status, said = None, ""
        seconds = time.monotonic() - begin
        outcome = {0: "ok", 1: "error", 2: "error", None: "hang"}.get(status, "crash")
        named = place in said and (self.program or "'far'" in said)
        sound = outcome == "error" and seconds < limit and named and self.whole(folder)
        self.rows.append((kind, transport, "calls", outcome, seconds, sound, said.strip()))

    @staticmethod
    def whole(folder):
        """What is recorded has whole lines of one length."""
        file = os.path.join(folder, "results.csv")
        if not os.path.exists(file):
            return True
        with open(file) as text:
            lines = text.read().split("\n")
        return lines[-1] == "" and len({line.count(",") for line in lines[:-1]}) <= 1

    def against(self, kind, transport, at, fault):
        address = Address(transport, self.folder)
        listener = address.listen()

        def work():
            sock, _ = listener.accept()
            channel = Faulty(sock, at, fault)
            serving.Session(channel, lambda parameters: tandem.FixedStep(Ramp())).serve()

        server = in_a_process(work)
        listener.close()
        self.run(kind, transport, address.uri + f"?deadline={DEADLINE}")
        os.kill(server, signal.SIGKILL)
        os.waitpid(server, 0)

    def all(self, transport):
        for kind, at, fault in calling_faults():
            self.against(kind, transport, at, fault)
        nobody = Address(transport, self.folder)
        nobody.listen().close()
        self.run("refused", transport, nobody.uri)
        if transport == "tcp":
            self.run("unknown_host", transport, "tcp://no-such-host.invalid:1", 15.0)
            self.run("beyond_this_machine", transport, "tcp://192.0.2.1:1")
        mute = Address(transport, self.folder)
        with mute.listen():
            self.run("silent_peer", transport, mute.uri + f"?deadline={DEADLINE}")
        if transport == "unix":
            self.run("spawned_program_aborts", "spawn", "spawn:sh -c 'kill -ABRT $$'")
            self.run("spawned_program_ends", "spawn", "spawn:sh -c 'exit 3'")
            self.run("spawned_program_not_there", "spawn", "spawn:no_such_program")
            self.run("spawned_program_is_silent", "spawn", f"spawn:sleep 100?deadline={DEADLINE}", 3.0 + SLACK)


def frame(kind, number, payload=b""):
    return wire.HEADER.pack(len(payload), kind, number) + payload


HELLO = frame(1, 1, wire.put_hello(""))
INFO = frame(2, 2)
INITIALIZE = frame(3, 3, wire.put_initialize(0.0, 10.0, 1, [0.0]))


def advance(number=4, t_limit=1.0, room=100, value=0.0):
    return frame(4, number, wire.put_advance(t_limit, False, room, [tandem.constant(value)]))


OPEN = [HELLO, INFO, INITIALIZE]


def serving_faults():
    """(kind, frames, what is answered to the last of them: error, ok, or closed)."""
    faults = []
    for k, name in enumerate(["hello", "info", "initialize", "advance"]):
        all_four = OPEN + [advance()]
        faults += [(f"dropped_before_{name}", all_four[:k], "ok"), (f"dropped_after_{name}", all_four[:k + 1], "ok"),
                   (f"dropped_within_{name}", all_four[:k] + [all_four[k][:-3]], "cut")]
    advanced = put(16, "d", 1.0)(advance())
    return faults + [
        ("silent_peer", [], "silent"),
        ("half_a_header", [HELLO[:7]], "error"),
        ("truncated_payload", OPEN + [put(0, "Q", len(advance()) - 24)(advance())[:-8]], "error"),
        ("length_2_to_the_40", OPEN + [put(0, "Q", 1 << 40)(advance())], "error"),
        ("length_2_to_the_64_less_1", OPEN + [put(0, "Q", (1 << 64) - 1)(advance())], "error"),
        ("unknown_type", OPEN + [put(8, "I", 99)(advance())], "error"),
        ("a_reply_as_request", OPEN + [put(8, "I", 5)(advance())], "error"),
        ("wrong_version", [frame(1, 1, put(8, "Q", (9 << 32) | 8)(wire.put_hello("")))], "error"),
        ("text_protocol", [b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n"], "error"),
        ("tls_hello", [bytes.fromhex("16030100c8010000c403030102030405060708")], "error"),
        ("limit_too_small", [frame(1, 1, put(16, "Q", 10)(wire.put_hello("")))], "error"),
        ("unknown_parameter", [frame(1, 1, wire.put_hello("colour=blue"))], "error"),
        ("advance_before_hello", [advance(1)], "error"),
        ("advance_before_initialize", [HELLO, INFO, advance(3)], "error"),
        ("save_before_initialize", [HELLO, INFO, frame(6, 3)], "error"),
        ("hello_twice", [HELLO, frame(1, 2, wire.put_hello(""))], "error"),
        ("duplicate_request", OPEN + [advance(), advance()], "error"),
        ("replayed_request", OPEN + [advance(), INITIALIZE], "error"),
        ("skipped_number", OPEN + [advance(9)], "error"),
        ("wrong_count_of_inputs", OPEN + [frame(4, 4, wire.put_advance(1.0, False, 9, []))], "error"),
        ("input_not_a_number", OPEN + [advance(value=NAN)], "error"),
        ("input_infinite", OPEN + [advance(value=INFINITY)], "error"),
        ("limit_not_a_number", OPEN + [put(16, "d", NAN)(advance())], "error"),
        ("limit_infinite", OPEN + [put(16, "d", INFINITY)(advance())], "error"),
        ("limit_backward", OPEN + [advanced, advance(5, -3.0)], "ok"),
        ("no_room", OPEN + [advance(room=0)], "error"),
        ("room_2_to_the_64_less_1", OPEN + [advance(room=(1 << 64) - 1)], "ok"),
        ("state_never_saved", OPEN + [frame(7, 4, struct.pack("<q", 77))], "error"),
        ("bytes_left_over", OPEN + [frame(6, 4, b"more")], "error"),
    ]


class Served:
    """The side that serves: one server (`tandem serve SOURCE`, or another) for all faults of a transport."""

    def __init__(self, command, transport, folder):
        self.command, self.address, self.rows = command, Address(transport, folder), []
        self.process = subprocess.Popen(
            [*command, "--listen", self.address.uri, "--sessions", "20", "--deadline", str(DEADLINE), "--idle", "1.0"],
            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.address.uri = self.process.stdout.readline().split(" at ")[1].strip()

    def held(self):
        """Open files, threads and processes."""
        place = f"/proc/{self.process.pid}"
        with open(f"{place}/task/{self.process.pid}/children") as children:
            return (len(os.listdir(place + "/fd")), len(os.listdir(place + "/task")), len(children.read().split()))

    def is_alive(self):
        try:
            with tandem.connect(self.address.uri, deadline=10.0) as subsystem:
                clock, _ = subsystem.initialize(0.0, 1.0, [0.0])
                return clock.time == 0.0
        except tandem.Error:
            return False

    def say(self, kind, frames, expected):
        begin = time.monotonic()
        outcome = "ok"
        with self.address.connect() as sock:
            channel = wire.Channel(sock, "served")
            try:
                for request in frames:
                    sock.sendall(request)
                    whole = len(request) >= 16 and len(request) - 16 >= wire.HEADER.unpack(request[:16])[0]
                    if expected == "cut" and not whole:
                        break
                    answer = channel.receive(DEADLINE + SLACK, DEADLINE + SLACK)
                    if answer is None or answer[0] == wire.Type.ERROR:
                        outcome = "error"
                if expected == "silent":
                    answer = channel.receive(1.0 + SLACK, DEADLINE)
                    outcome = "error" if answer is None or answer[0] == wire.Type.ERROR else "ok"
            except (tandem.Error, OSError):
                outcome = "error"
        seconds = time.monotonic() - begin
        wanted = "error" if expected in ("error", "silent") else "ok"
        sound = outcome == wanted and seconds < 1.0 + DEADLINE + SLACK and self.is_alive()
        self.rows.append((kind, self.address.transport, "serves", outcome, seconds, sound, ""))

    def timed(self, kind, work):
        begin = time.monotonic()
        outcome = work()
        seconds = time.monotonic() - begin
        self.rows.append((kind, self.address.transport, "serves", outcome, seconds, self.is_alive(), ""))

    def flood(self):
        """More connections than sessions are allowed, all at once; then they go."""
        socks = [self.address.connect() for _ in range(60)]
        time.sleep(0.3)
        for sock in socks:
            sock.close()
        time.sleep(0.5)
        return "error"

    def slow_reader(self):
        """Asks for megabytes and takes none of them."""
        with self.address.connect() as sock:
            sock.sendall(HELLO)
            try:
                for number in range(2, 40):
                    sock.sendall(frame(9, number, bytes(1 << 20)))
            except OSError:
                return "error"
        return "ok"

    def dribble(self):
        with self.address.connect() as sock:
            try:
                for byte in HELLO[:8]:
                    sock.sendall(bytes([byte]))
                    time.sleep(0.25)
                return "error" if wire.Channel(sock, "").receive(1.0, 1.0)[0] == wire.Type.ERROR else "ok"
            except (OSError, tandem.Error, TypeError):
                return "error"

    def client_dies(self, number, requests):
        def work():
            sock = self.address.connect()
            for request in requests:
                sock.sendall(request)
                wire.Channel(sock, "").receive(3.0, 3.0)
            os.kill(os.getpid(), number)

        client = in_a_process(work)
        os.waitpid(client, os.WUNTRACED)
        if number == signal.SIGSTOP:
            time.sleep(1.5)  # past the idle time
            os.kill(client, signal.SIGKILL)
            os.waitpid(client, 0)
        return "error"

    def all(self):
        assert self.is_alive()
        before = self.held()
        for fault in serving_faults():
            self.say(*fault)
        self.timed("connection_flood", self.flood)
        self.timed("slow_reader", self.slow_reader)
        self.timed("one_byte_at_a_time", self.dribble)
        for k, phase in enumerate(["hello", "info", "initialize", "advance"]):
            self.timed(f"client_killed_after_{phase}", lambda: self.client_dies(signal.SIGKILL, (OPEN + [advance()])[:k + 1]))
        self.timed("client_stopped", lambda: self.client_dies(signal.SIGSTOP, OPEN))
        second = subprocess.run([*self.command, "--listen", self.address.uri], capture_output=True, timeout=30)
        self.rows.append(("address_in_use", self.address.transport, "serves",
                          "error" if second.returncode == 2 else "ok", 0.0, second.returncode == 2, ""))
        for _ in range(100):  # sessions end on their own
            after = self.held()
            if after <= before:
                break
            time.sleep(0.05)
        self.rows.append(("nothing_is_left", self.address.transport, "serves", "ok", 0.0, after <= before,
                          f"files, threads and processes {before}, then {after}"))
        with self.address.connect():  # an open session does not keep it
            self.process.terminate()
            status = self.process.wait(10)
        self.rows.append(("ended_by_sigterm", self.address.transport, "serves", "ok", 0.0, status == 0, str(status)))


def main(command, output, server=None, caller_program=None):
    signal.signal(signal.SIGPIPE, signal.SIG_IGN)
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for transport in ("tcp", "unix"):
            caller = Caller(command, folder, caller_program)
            caller.all(transport)
            served = Served([server] if server else [command, "serve", "builtin:two_mass.fast"], transport, folder)
            try:
                served.all()
            finally:
                served.process.kill()
            rows += caller.rows + served.rows
    os.makedirs(os.path.dirname(os.path.abspath(output)), exist_ok=True)
    with open(output, "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["kind", "transport", "side", "outcome", "seconds"])
        table.writerows((*row[:4], f"{row[4]:.3f}") for row in rows)
    wrong = [row for row in rows if not row[5]]
    for row in wrong:
        print("not as it has to be:", *row, sep=" | ")
    print(f"{len(rows)} faults, {len(wrong)} not as they have to be; {output}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
