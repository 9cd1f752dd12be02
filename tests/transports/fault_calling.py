# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Faults of a server, as `tandem run` finds it."""

import os
import signal
import socket
import ssl
import struct
import subprocess
import tempfile
import time

import fault_zeromq
import tandem
from fault_peers import DEADLINE, SLACK, Listener
from tandem import serving, wire

REPLIES = {"hello": 1, "info": 2, "initialize": 3, "advance": 6}  # requests before them answered soundly
NAN, INFINITY = float("nan"), float("inf")
FAREWELL = "no request came within 0.2 s, so the session ends"
WHERE = {1: "hello: ", 2: "info: ", 3: "initialize at t = 0 s: ", 4: " at t = 0 s"}  # by the number of the request


def said_at(request):
    """What an error has to say of the call that it ends, and of the time in the run."""
    return WHERE.get(request, "advance at t = ")


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


class Faulty:
    """A channel that hands on soundly up to reply `at`, and then does `fault(raw, frame)`."""

    def __init__(self, channel, at, fault):
        self._channel, self._at, self._fault = channel, at, fault
        self.receive, self.close, self.peer = channel.receive, channel.close, channel.peer

    def send(self, kind, number, payload, deadline):
        frame = wire.HEADER.pack(len(payload), kind, number) + payload
        (self._fault if number == self._at else lambda raw, f: raw.sendall(f))(self._channel.raw, frame)


def gone(raw):
    raw.shutdown(socket.SHUT_RDWR)


def dribble(raw, frame):
    for byte in frame[:8]:
        raw.sendall(bytes([byte]))
        time.sleep(1.0)


def drop_within(raw, frame):
    raw.sendall(frame[: len(frame) // 2])
    gone(raw)


def drop_after(raw, frame):
    raw.sendall(frame)
    gone(raw)


def say_farewell(raw, frame):
    """The reply, and unasked why the session ends."""
    payload = wire.put_error(tandem.Error(FAREWELL, 5))
    raw.sendall(frame)
    raw.sendall(wire.HEADER.pack(len(payload), wire.Type.ERROR, 0) + payload)
    gone(raw)


def put(place, form, value):
    return lambda f: f[:place] + struct.pack("<" + form, value) + f[place + struct.calcsize("<" + form):]


def phase_faults():
    """(kind, reply, fault)."""
    for phase, at in REPLIES.items():
        yield f"dropped_before_{phase}", at, lambda raw, f: gone(raw)
        yield f"dropped_within_{phase}", at, drop_within
        yield f"dropped_after_{phase}", at, drop_after
        yield f"silent_at_{phase}", at, lambda raw, f: time.sleep(5.0)
        yield f"killed_at_{phase}", at, lambda raw, f: os.kill(os.getpid(), signal.SIGKILL)
        yield f"stopped_at_{phase}", at, lambda raw, f: os.kill(os.getpid(), signal.SIGSTOP)
    yield "one_byte_a_second", REPLIES["advance"], dribble


def changes():
    """(kind, reply, what becomes of its bytes)."""
    sample, last = 16 + 32, REPLIES["advance"]  # where the first row stands; the first advance after two more
    return [
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


def sending(change):
    return lambda raw, frame: raw.sendall(change(frame))


def answering(data):
    """What a connection in the clear is answered with, once something came."""
    def secured(sock):
        sock.settimeout(DEADLINE + SLACK)
        sock.recv(1)
        sock.sendall(data)
        time.sleep(DEADLINE)
        raise OSError("that was all")
    return secured


def damaged(transport):
    """TLS with a wrong bit in the first record that carries data."""
    def secured(sock):
        inside, outside = ssl.MemoryBIO(), ssl.MemoryBIO()
        tls = transport.context(True, "server").wrap_bio(inside, outside, server_side=True)

        def pump(call):
            while True:
                try:
                    return call()
                except ssl.SSLWantReadError:
                    sock.sendall(outside.read())
                    inside.write(sock.recv(65536))

        pump(tls.do_handshake)
        sock.sendall(outside.read())
        pump(lambda: tls.read(16))
        tls.write(bytes(64))
        record = outside.read()
        sock.sendall(record[:-1] + bytes([record[-1] ^ 1]))
        time.sleep(DEADLINE)
        raise OSError("that was all")
    return secured


def tls_listeners(transport):
    """(kind, a server's handshake)."""
    def with_context(context):
        return lambda sock: context.wrap_socket(sock, server_side=True)

    def old(context):
        context.maximum_version = ssl.TLSVersion.TLSv1_2
        return context

    yield "unknown_authority", with_context(transport.context(True, "server", "stranger", "pair"))
    yield "expired_certificate", with_context(transport.context(True, "server", "expired", "pair"))
    yield "certificate_of_a_client", with_context(transport.context(True, "client"))
    yield "other_authority_on_this_side", with_context(transport.context(True, "server", "pair", "stranger"))
    yield "tls_1_2", with_context(old(transport.context(True, "server")))
    yield "plain_text_answer", answering(b"TANDEM says hello in the clear\r\n")
    yield "dropped_in_handshake", answering(b"")
    yield "half_a_record", answering(bytes.fromhex("1603030100"))
    yield "damaged_record", damaged(transport)


class Caller:
    """`tandem run`, or a program that is given the URI, with a faulty server."""

    def __init__(self, command, folder, transport, program=None):
        self.command, self.folder, self.transport, self.program, self.rows = command, folder, transport, program, []

    def words(self, uri, folder):
        if self.program:
            return [self.program, uri]
        scenario = os.path.join(folder, "run.toml")
        with open(scenario, "w", encoding="utf-8") as file:
            file.write(f'[subsystems.far]\nsource = "{uri}"\n[span]\nstop = 10.0\n'
                       '[subsystems.near]\nsource = "builtin:two_mass.fast?frequency_ratio=2"\n'
                       '[[connections]]\nfrom = "near.x1"\nto = "far.u"\nreconstruction = "lagrange0"\n'
                       '[[connections]]\nfrom = "far.x"\nto = "near.x2"\nreconstruction = "lagrange0"\n')
        return [self.command, "run", scenario, "--output", folder]

    def run(self, kind, uri, limit=DEADLINE + SLACK, name=None, place=None, says=""):
        """place: what has to be named, if it is not the address; says: what has to be said besides."""
        folder = tempfile.mkdtemp(dir=self.folder)
        place = place or uri.partition("?")[0]
        begin = time.monotonic()
        try:
            done = subprocess.run(self.words(uri, folder), capture_output=True, text=True, timeout=30, check=False)
            status, said = done.returncode, done.stderr
        except subprocess.TimeoutExpired:
            status, said = None, ""
        seconds = time.monotonic() - begin
        outcome = {0: "ok", 1: "error", 2: "error", None: "hang"}.get(status, "crash")
        named = place in said and says in said and (self.program or "'far'" in said)
        sound = outcome == "error" and seconds < limit and named and self.whole(folder)
        self.rows.append((kind, name or self.transport.name, "calls", outcome, seconds, sound, said.strip()))

    @staticmethod
    def whole(folder):
        """What is recorded has whole lines of one length, and nothing else is left."""
        if not set(os.listdir(folder)) <= {"run.toml", "results.csv", "results.json", "machine.json"}:
            return False
        file = os.path.join(folder, "results.csv")
        if not os.path.exists(file):
            return True
        with open(file, encoding="ascii") as text:
            lines = text.read().split("\n")
        return lines[-1] == "" and len({line.count(",") for line in lines[:-1]}) <= 1

    def against(self, kind, listen, at=0, fault=None, says=""):
        """A server of a process of its own, where listen() gives its listener; says: as in run()."""
        place, told = os.pipe()

        def work():
            listener = listen()
            os.write(told, listener.uri.encode())
            channel = Faulty(listener.accept(), at, fault)
            serving.Session(channel, lambda parameters: tandem.FixedStep(Ramp())).serve()

        server = in_a_process(work)
        os.close(told)
        uri = os.read(place, 200).decode()
        os.close(place)
        self.run(kind, f"{uri}?{self.transport.query}", says=says)
        os.kill(server, signal.SIGKILL)
        os.waitpid(server, 0)

    def all(self):
        transport = self.transport
        for kind, at, fault in phase_faults():
            self.against(kind, transport.listener, at, fault, said_at(at + kind.startswith("dropped_after")))
        for kind, at, change in changes():
            self.against(kind, transport.listener, at, sending(change), said_at(at + kind.startswith("twice")))
        self.against("session_ended_by_the_server", transport.listener, REPLIES["advance"], say_farewell, FAREWELL)
        nobody, uri = transport.plain_listener()
        nobody.close()
        self.run("refused", f"{uri}?{transport.query}")
        mute, uri = transport.plain_listener()
        with mute:
            self.run("silent_peer", f"{uri}?{transport.query}")
        if not transport.local:
            self.run("unknown_host", f"{uri.partition('//')[0]}//no-such-host.invalid:1?{transport.query}", 15.0,
                     place="no-such-host")
        if transport.name in ("tcp", "zmq:tcp"):
            self.run("beyond_this_machine", f"{uri.partition('//')[0]}//192.0.2.1:1?{transport.query}")
        {"unix": self.programs, "tls": self.tls, "zmq:tcp": self.zeromq, "zmq:ipc": self.zeromq,
         "zmq:curve": self.curve}.get(transport.name, lambda: None)()

    def programs(self):
        for kind, command, limit in (("aborts", "sh -c 'kill -ABRT $$'", 0.0), ("ends", "sh -c 'exit 3'", 0.0),
                                     ("not_there", "no_such_program", 0.0), ("is_silent", "sleep 100", 2.5)):
            self.run(f"spawned_program_{kind}", f"spawn:{command}?deadline={DEADLINE}", DEADLINE + limit + SLACK, "spawn")

    def own_files(self, uri, key, other):
        """Keys of this side that can't be used: the secret one, and what goes with it."""
        keys, query = self.transport.keys, self.transport.query
        os.chmod(keys.file(key), 0o640)
        self.run("secret_key_that_others_may_read", f"{uri}?{query}", place=keys.file(key))
        os.chmod(keys.file(key), 0o600)
        self.run("secret_key_not_there", f"{uri}?{query.replace(keys.file(key), keys.file('none'))}",
                 place=keys.file("none"))
        self.run("key_file_without_a_key", f"{uri}?{query.replace(keys.file(other), os.devnull)}", place=os.devnull)

    def tls(self):
        for kind, secured in tls_listeners(self.transport):
            self.against(kind, lambda: Listener(self.transport.plain_listener(), secured))
        self.own_files("tls://127.0.0.1:1", "client.key", "authority.crt")
        self.run("no_key_given", "tls://127.0.0.1:1")

    def zeromq(self):
        for kind, data in (("text_protocol_beneath", b"HTTP/1.1 400 Bad Request\r\n\r\n"), ("half_a_greeting", b"\xff\x00"),
                           ("huge_message_beneath", fault_zeromq.huge_message(1 << 62))):
            self.against(kind, lambda: Listener(self.transport.plain_listener(), answering(data)))

    def curve(self):
        transport = self.transport
        self.zeromq()
        self.against("wrong_server_key", lambda: transport.listener(transport.server_keys("stranger")))
        self.against("plain_text_server", lambda: transport.listener([]))
        self.own_files("zmq:tcp://127.0.0.1:1", "client", "server.pub")


def in_a_process(work):
    process = os.fork()
    if process == 0:
        try:
            work()
        except (tandem.Error, OSError):
            pass
        finally:
            os._exit(0)
    return process
