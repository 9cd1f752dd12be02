# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Faults of a server, as `tandem run` finds it."""

import contextlib
import os
import shutil
import signal
import ssl
import struct
import subprocess
import tempfile
import time

import fault_zeromq
import tandem
from fault_peers import DEADLINE, SLACK, STRANGE, STRANGE_SHOWN, Listener, is_plain
from fault_replies import (FAREWELL, REPLIES, changes, phase_faults, put, said_at, say_farewell, sending, strange_info,
                           with_payload)
from ramp import make
from tandem import serving, wire


class Faulty:
    """A channel that hands on soundly up to reply `at`, and then does `fault(raw, frame)`."""

    def __init__(self, channel, at, fault):
        self._channel, self._at, self._fault = channel, at, fault
        self.wait, self.receive, self.close, self.peer = channel.wait, channel.receive, channel.close, channel.peer

    def send(self, kind, number, payload, deadline):
        frame = wire.HEADER.pack(len(payload), kind, number) + payload
        with fault_zeromq.as_error():
            (self._fault if number == self._at else lambda raw, f: raw.sendall(f))(self._channel.raw, frame)


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
            return [*self.program, uri]
        scenario = os.path.join(folder, "run.toml")
        with open(scenario, "w", encoding="utf-8") as file:
            file.write(f'[subsystems.far]\nsource = "{uri}"\n[span]\nstop = 10.0\n'
                       '[subsystems.near]\nsource = "builtin:two_mass.fast?frequency_ratio=2"\n'
                       '[[connections]]\nfrom = "near.x1"\nto = "far.u"\nreconstruction = "lagrange0"\n'
                       '[[connections]]\nfrom = "far.x"\nto = "near.x2"\nreconstruction = "lagrange0"\n')
        return [self.command, "run", scenario, "--output", folder]

    def run(self, kind, uri, limit=DEADLINE + SLACK, name=None, place=None, says=()):
        """place: what has to be named, if it is not the address; says: what has to be said besides."""
        folder = tempfile.mkdtemp(dir=self.folder)
        place = place or uri.partition("?")[0]
        begin = time.monotonic()
        outcome, printed, said = outcome_of(self.words(uri, folder))
        seconds = time.monotonic() - begin
        named = all(part in said for part in (place, *says)) and (self.program or "'far'" in said)
        sound = outcome == "error" and seconds < limit and named and is_plain(printed + said) and self.whole(folder)
        self.rows.append((kind, name or self.transport.name, "calls", outcome, seconds, sound, said.strip()))

    def show(self, kind, uri, says):
        """What is printed of a subsystem."""
        begin = time.monotonic()
        outcome, printed, said = outcome_of([*self.program, uri] if self.program else [self.command, "info", uri])
        sound = outcome == "ok" and all(part in printed for part in says) and is_plain(printed + said)
        self.rows.append((kind, self.transport.name, "calls", outcome, time.monotonic() - begin, sound, printed + said))

    @staticmethod
    def whole(folder):
        """What is recorded has whole lines of one length, and nothing else is left."""
        if not set(os.listdir(folder)) <= {"run.toml", "results.csv", "indicators.csv", "results.json", "machine.json"}:
            return False
        file = os.path.join(folder, "results.csv")
        if not os.path.exists(file):
            return True
        with open(file, encoding="ascii") as text:
            lines = text.read().split("\n")
        return lines[-1] == "" and len({line.count(",") for line in lines[:-1]}) <= 1

    def against(self, kind, listen, at=0, fault=None, says="", call=None):
        """A server of a process of its own, where listen() gives its listener; says: as in run(), which is `call`.
        It serves three, as the first who come may be strangers that look for an earlier owner of the port."""
        place, told = os.pipe()

        def serve_one(listener):
            with contextlib.suppress(tandem.Error, OSError):
                serving.Session(Faulty(listener.accept(), at, fault), make).serve()

        def work():
            listener = listen()
            os.write(told, listener.uri.encode())
            for _ in range(3):
                serve_one(listener)

        server = in_a_process(work)
        os.close(told)
        uri = os.read(place, 200).decode()
        os.close(place)
        (call or self.run)(kind, f"{uri}?{self.transport.query}", says=(says,) if isinstance(says, str) else says)
        os.kill(server, signal.SIGKILL)
        os.waitpid(server, 0)

    def phases(self):
        for kind, at, fault in phase_faults():
            self.against(kind, self.transport.listener, at, fault, said_at(at + kind.startswith("dropped_after")))

    def changed_replies(self):
        for kind, at, change in changes():
            self.against(kind, self.transport.listener, at, sending(change), said_at(at + kind.startswith("twice")))

    def others(self):
        transport = self.transport
        self.against("session_ended_by_the_server", transport.listener, REPLIES["advance"], say_farewell, FAREWELL)
        self.strangers_texts()
        nobody, uri = transport.plain_place()
        with nobody:  # keeps the port from others, and does not listen
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

    def strangers_texts(self):
        """Names, units and sentences with control characters, as our own servers would not send them."""
        listener, at = self.transport.listener, REPLIES["info"]
        self.against("control_characters_in_names_and_units", listener, at, sending(strange_info(1)),
                     ("x" + STRANGE_SHOWN, STRANGE_SHOWN), self.show)
        self.against("control_characters_in_a_name_that_is_refused", listener, at, sending(strange_info(0)),
                     (said_at(at), "x" + STRANGE_SHOWN))
        text = STRANGE.encode("utf-8", "surrogateescape")
        sentence = with_payload(struct.pack("<II", 4, len(text)) + text)
        for phase, request in REPLIES.items():
            self.against(f"control_characters_in_an_error_at_{phase}", listener, request,
                         sending(lambda f: put(8, "I", 10)(sentence(f))), (said_at(request), STRANGE_SHOWN))
        long = with_payload(struct.pack("<II", 4, 1 << 19) + bytes([27]) * (1 << 19))
        self.against("an_error_of_half_a_megabyte", listener, 3, sending(lambda f: put(8, "I", 10)(long(f))), "\\x1b...")

    def programs(self):
        for kind, command, limit in (("aborts", "sh -c 'kill -ABRT $$'", 0.0), ("ends", "sh -c 'exit 3'", 0.0),
                                     ("not_there", "no_such_program", 0.0), ("is_silent", "sleep 100", 2.5)):
            self.run(f"spawned_program_{kind}", f"spawn:{command}?deadline={DEADLINE}", DEADLINE + limit + SLACK, "spawn")

    def own_files(self, uri, key, other):
        """Keys of this side that can't be used: the secret one, and what goes with it."""
        keys, query = self.transport.keys, self.transport.query
        seen = os.path.join(shutil.copytree(os.path.join(keys.folder, "pair"), tempfile.mkdtemp(dir=self.folder),
                                            dirs_exist_ok=True), key)
        os.chmod(seen, 0o640)
        self.run("secret_key_that_others_may_read", f"{uri}?{query.replace(keys.file(key), seen)}", place=seen)
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


def outcome_of(words):
    """What became of a program, and what it printed and said."""
    try:
        done = subprocess.run(words, capture_output=True, encoding="utf-8", errors="surrogateescape", timeout=30,
                              check=False)
    except subprocess.TimeoutExpired:
        return "hang", "", ""
    return {0: "ok", 1: "error", 2: "error"}.get(done.returncode, "crash"), done.stdout, done.stderr


def in_a_process(work):
    process = os.fork()
    if process == 0:
        try:
            work()
        finally:
            os._exit(0)
    return process
