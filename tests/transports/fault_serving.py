# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Faults of clients, as `tandem serve` finds them."""

import contextlib
import os
import signal
import ssl
import struct
import subprocess
import tempfile
import time

import fault_zeromq
import tandem
from fault_calling import in_a_process
from fault_peers import DEADLINE, SLACK, is_plain
from fault_requests import HELLO, OPEN, advance, frame, serving_faults
from tandem import wire

IDLE = 1.0


def sentence_of(answer):
    """Of an error as it came; "" of the end of a connection."""
    if answer is None:
        return ""
    length, = struct.unpack_from("<I", answer[2], 4)
    return bytes(answer[2][8:8 + length]).decode("utf-8", "surrogateescape")


class Served:
    """One server (`tandem serve`, or another program) for all faults of a transport."""

    def __init__(self, command, transport, folder, program=None, sessions=20, deadline=DEADLINE, idle=IDLE):
        self.command = program or [command, "serve", "builtin:two_mass.fast"]
        self.transport, self.rows = transport, []
        self.log = tempfile.TemporaryFile("w+", dir=folder, encoding="utf-8", errors="surrogateescape")
        self.process = subprocess.Popen(
            [*self.command, "--listen", transport.free_address(), *transport.options, "--sessions", str(sessions),
             "--deadline", str(deadline), "--idle", str(idle)],
            stdout=subprocess.PIPE, stderr=self.log, text=True)
        self.uri = self.process.stdout.readline().split(" at ")[1].strip()

    def held(self):
        """Open files, threads and children."""
        place = f"/proc/{self.process.pid}"
        children = 0
        for task in os.listdir(place + "/task"):
            with contextlib.suppress(FileNotFoundError, ProcessLookupError):  # a thread that ended meanwhile
                with open(f"{place}/task/{task}/children", encoding="ascii") as file:
                    children += len(file.read().split())
        return len(os.listdir(place + "/fd")), len(os.listdir(place + "/task")), children

    def is_alive(self, patience=10.0):
        """It opens a session and computes."""
        try:
            channel = self.transport.connect(self.uri)
            with channel.raw:
                for request in OPEN:
                    channel.raw.sendall(request)
                    answer = channel.receive(patience)
                return answer is not None and answer[0] == wire.Type.SAMPLES
        except (tandem.Error, OSError):
            return False

    def row(self, kind, outcome, seconds, sound, said=""):
        self.rows.append((kind, self.transport.name, "serves", outcome, seconds, sound, said))

    def say(self, kind, frames, expected):
        begin = time.monotonic()
        outcome, sentence = "ok", ""
        channel = self.transport.connect(self.uri)
        with channel.raw:
            try:
                for request in frames:
                    channel.raw.sendall(request)
                    whole = len(request) >= 16 and len(request) - 16 >= wire.HEADER.unpack(request[:16])[0]
                    if expected == "cut" and not whole:
                        break
                    answer = channel.receive(DEADLINE + SLACK)
                    if answer is None or answer[0] == wire.Type.ERROR:
                        outcome, sentence = "error", sentence_of(answer)
            except (tandem.Error, OSError):
                outcome = "error"
        seconds = time.monotonic() - begin
        wanted = "ok" if expected in ("ok", "cut") else "error"
        said = expected in ("ok", "cut", "error") or expected in sentence and is_plain(sentence)
        self.row(kind, outcome, seconds,
                 outcome == wanted and said and seconds < IDLE + DEADLINE + SLACK and self.is_alive(), sentence)

    def timed(self, kind, work):
        begin = time.monotonic()
        outcome = work()
        seconds = time.monotonic() - begin
        self.row(kind, outcome, seconds, outcome != "hang" and self.is_alive())

    def flood(self):
        """More connections than sessions are allowed, all at once; then they go."""
        socks = [self.transport.plain(self.uri) for _ in range(60)]
        time.sleep(0.3)
        for sock in socks:
            sock.close()
        time.sleep(0.5)
        return "error"

    def slow_reader(self):
        """Asks for megabytes and takes none of them."""
        channel = self.transport.connect(self.uri)
        with channel.raw:
            channel.raw.sendall(HELLO)
            try:
                for number in range(2, 40):
                    channel.raw.sendall(frame(9, number, bytes(1 << 20)))
            except OSError:
                return "error"
        return "ok"

    def dribble(self):
        channel = self.transport.connect(self.uri)
        with channel.raw:
            try:
                for byte in HELLO[:8]:
                    channel.raw.sendall(bytes([byte]))
                    time.sleep(0.25)
                return "error" if channel.receive(1.0)[0] == wire.Type.ERROR else "ok"
            except (OSError, tandem.Error, TypeError):
                return "error"

    def client_dies(self, number, requests):
        def work():
            channel = self.transport.connect(self.uri)
            for request in requests:
                channel.raw.sendall(request)
                channel.receive(3.0)
            os.kill(os.getpid(), number)

        client = in_a_process(work)
        os.waitpid(client, os.WUNTRACED)
        if number == signal.SIGSTOP:
            time.sleep(IDLE + DEADLINE)
            os.kill(client, signal.SIGKILL)
            os.waitpid(client, 0)
        return "error"

    def beneath(self, data):
        """These bytes beneath the transport: the server is to close, at the latest at its deadline."""
        with self.transport.plain(self.uri) as sock:
            sock.sendall(data)
            return "error" if fault_zeromq.wait_for_end(sock, DEADLINE + SLACK) else "hang"

    def handshake(self, context):
        """A client of TLS that has to be refused."""
        try:
            with context.wrap_socket(self.transport.plain(self.uri)) as sock:
                sock.sendall(HELLO)
                return "error" if not sock.recv(1) else "ok"
        except OSError:
            return "error"

    def knock(self, keys):
        """A client of ZeroMQ that is not to be let in."""
        try:
            with self.transport.connect(self.uri, keys).raw:
                return "ok"
        except OSError:
            return "error"

    def refused(self, kind, work):
        begin = time.monotonic()
        outcome = work()
        self.row(kind, outcome, time.monotonic() - begin, outcome == "error" and self.is_alive())

    def tls(self):
        transport = self.transport

        def old(context):
            context.maximum_version = ssl.TLSVersion.TLSv1_2
            return context

        for kind, context in (("unknown_authority", transport.context(False, "client", "stranger")),
                              ("expired_certificate", transport.context(False, "client", "expired")),
                              ("no_certificate", transport.context(False)),
                              ("certificate_of_a_server", transport.context(False, "server")),
                              ("tls_1_2", old(transport.context(False, "client")))):
            self.refused(kind, lambda: self.handshake(context))
        for kind, data in (("plain_text", HELLO), ("silent_in_handshake", b""),
                           ("half_a_record", bytes.fromhex("16030100c8010000")),
                           ("text_protocol_beneath", b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n")):
            self.refused(kind, lambda: self.beneath(data))

    def zeromq(self):
        for kind, data in (("silent_in_handshake", b""), ("half_a_greeting", b"\xff\x00"),
                           ("text_protocol_beneath", b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n"),
                           ("huge_message_beneath", fault_zeromq.huge_message(1 << 62))):
            self.refused(kind, lambda: self.beneath(data))

    def curve(self):
        self.zeromq()
        for kind, keys in (("wrong_key", self.transport.client_keys("stranger")), ("plain_text", []),
                           ("wrong_server_key", self.transport.client_keys("pair", "stranger"))):
            self.refused(kind, lambda: self.knock(keys))

    def second_server(self):
        """At the same address."""
        done = subprocess.run([*self.command, "--listen", self.uri, *self.transport.options],
                              capture_output=True, timeout=30, check=False)
        self.row("address_in_use", "error" if done.returncode == 2 else "ok", 0.0, done.returncode == 2)

    def nothing_is_left(self, before):
        for _ in range(100):  # sessions end on their own
            after = self.held()
            if all(now <= then for now, then in zip(after, before)):
                break
            time.sleep(0.05)
        self.row("nothing_is_left", "ok", 0.0, all(now <= then for now, then in zip(after, before)),
                 f"files, threads and children {before}, then {after}")

    def ends(self):
        """An open session does not keep it, and a socket's file goes with it."""
        with self.transport.connect(self.uri).raw:
            self.process.terminate()
            status = self.process.wait(10)
        local = self.transport.local
        gone = not local or not os.path.exists(self.uri[len(local):])
        self.row("ended_by_sigterm", "ok", 0.0, status == 0 and gone, str(status))

    def said_nothing_strange(self):
        """In its log, which has the sentences of sessions that broke."""
        self.log.seek(0)
        said = self.log.read()
        self.row("log_is_printable", "ok", 0.0, is_plain(said) and "no text" in said, said if not is_plain(said) else "")

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
        {"tls": self.tls, "zmq:tcp": self.zeromq, "zmq:ipc": self.zeromq, "zmq:curve": self.curve}.get(
            self.transport.name, lambda: None)()
        self.second_server()
        self.nothing_is_left(before)
        self.ends()
        self.said_nothing_strange()
