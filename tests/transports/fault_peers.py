# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""The transports of the faults: how a peer of each is reached, listened for and named.

Each has a name, the options of `tandem serve` and of a URI, and gives channels of tandem.wire whose `raw` takes any bytes."""

import os
import socket
import ssl
import subprocess
import time

import fault_zeromq
from tandem import wire

DEADLINE = 2.0
SLACK = 6.0  # the starting of processes, of which about ten run at once on two processors
STRANGE = "\x1bc\x07\u202e\x9b\x00\udcff"  # a stranger's text, and how it has to be shown
STRANGE_SHOWN = "\\x1bc\\x07\\u202e\\u009b\\x00\\xff"


def is_plain(text):
    """Nothing in it that a terminal obeys, but the ends of lines."""
    return all(character == "\n" or character.isprintable() for character in text)


class Keys:
    """Files of `tandem keys`: of the pair, of strangers, and certificates that have expired."""

    def __init__(self, command, folder):
        self.folder = folder
        for name, days in (("pair", "1"), ("stranger", "1"), ("expired", "1e-5")):
            subprocess.run([command, "keys", os.path.join(folder, name), "--days", days], check=True, stdout=subprocess.DEVNULL)
        time.sleep(2.1)  # a certificate's times are whole seconds

    def file(self, name, owner="pair"):
        return os.path.join(self.folder, owner, name)

    def text(self, name, owner="pair"):
        with open(self.file(name, owner), encoding="ascii") as file:
            return file.read().strip().encode()

    def exists(self, name):
        return os.path.exists(self.file(name))


class StreamChannel(wire.Channel):
    """Frames over a socket that may be written to beside them."""

    def __init__(self, raw):
        super().__init__(raw, "peer")
        self.raw = raw


class Listener:
    """Of streams; `secured` makes of a connection what frames go over."""

    def __init__(self, plain, secured):
        (self._socket, self.uri), self._secured = plain, secured

    def accept(self):
        return StreamChannel(self._secured(self._socket.accept()[0]))


class Stream:
    """tcp and unix. `local`: what stands before the path of a socket's file, in a URI; None of those with a port.
    `layered`: whether there is a handshake beneath the frames."""

    local, layered = None, False

    def __init__(self, name, folder):
        self.name, self._folder, self.remote = name, folder, f"{name}://"
        self.options, self.query = [], f"deadline={DEADLINE}"
        if name == "unix":
            self.local = "unix:"

    def free_address(self):
        path = os.path.join(self._folder, f"socket{os.getpid()}_{time.monotonic_ns()}")
        return self.local + path if self.local else f"{self.remote}127.0.0.1:0"

    def plain_place(self):
        """A socket that has an address and does not listen, with its URI."""
        if self.local:
            uri = self.free_address()
            sock = socket.socket(socket.AF_UNIX)
            sock.bind(uri[len(self.local):])
            return sock, uri
        sock = socket.socket()
        sock.bind(("127.0.0.1", 0))
        return sock, f"{self.remote}127.0.0.1:{sock.getsockname()[1]}"

    def plain_listener(self):
        """An open socket, with its URI."""
        sock, uri = self.plain_place()
        sock.listen()
        return sock, uri

    def listener(self):
        """With the members uri, and accept() for a session's channel."""
        return Listener(self.plain_listener(), lambda sock: self.secured(sock, True))

    def secured(self, sock, server):
        return sock

    def plain(self, uri):
        """A connection in the clear to what listens at a URI."""
        sock = socket.socket(socket.AF_UNIX if self.local else socket.AF_INET)
        sock.settimeout(DEADLINE + SLACK)
        sock.connect(uri[len(self.local):] if self.local else ("127.0.0.1", int(uri.rpartition(":")[2])))
        return sock

    def connect(self, uri):
        return StreamChannel(self.secured(self.plain(uri), False))


class Tls(Stream):
    layered = True

    def __init__(self, folder, keys):
        super().__init__("tls", folder)
        self.keys = keys
        self.options = ["--key", keys.file("server.key"), "--authority", keys.file("authority.crt")]
        self.query += f"&key={keys.file('client.key')}&authority={keys.file('authority.crt')}"

    def context(self, server, side=None, owner="pair", authority="pair"):
        """That of a server or client, with the certificate of `side` (None: none) that `owner` has."""
        context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER if server else ssl.PROTOCOL_TLS_CLIENT)
        context.check_hostname = False
        context.verify_mode = ssl.CERT_REQUIRED
        context.load_verify_locations(self.keys.file("authority.crt", authority))
        if side:
            context.load_cert_chain(self.keys.file(side + ".crt", owner), self.keys.file(side + ".key", owner))
        return context

    def secured(self, sock, server):
        sock.settimeout(DEADLINE + SLACK)
        return self.context(server, "server" if server else "client").wrap_socket(sock, server_side=server)


class ZeroMq(Stream):
    layered = True

    def __init__(self, name, folder, keys):
        super().__init__(name, folder)
        self.keys, self.curve, self.remote = keys, name == "zmq:curve", "zmq:tcp://"
        if name == "zmq:ipc":
            self.local = "zmq:ipc://"
        if self.curve:
            self.options = ["--key", keys.file("server"), "--client-key", keys.file("client.pub")]
            self.query += f"&key={keys.file('client')}&server_key={keys.file('server.pub')}"

    def listener(self, keys=None):
        address = self.free_address()[4:] if self.local else "tcp://127.0.0.1:*"
        return fault_zeromq.Listener(address, self.server_keys() if keys is None else keys)

    def server_keys(self, owner="pair"):
        if not self.curve:
            return []
        return [(fault_zeromq.CURVE_SERVER, 1), (fault_zeromq.CURVE_SECRET, self.keys.text("server", owner))]

    def client_keys(self, owner="pair", server_owner="pair"):
        if not self.curve:
            return []
        return [(fault_zeromq.CURVE_SERVER_KEY, self.keys.text("server.pub", server_owner)),
                (fault_zeromq.CURVE_PUBLIC, self.keys.text("client.pub", owner)),
                (fault_zeromq.CURVE_SECRET, self.keys.text("client", owner))]

    def connect(self, uri, keys=None):
        found = self.client_keys() if keys is None else keys
        return fault_zeromq.Channel(fault_zeromq.connect(uri[4:], found, DEADLINE + SLACK), "peer")


def all_transports(command, folder):
    """Those that the command was built with."""
    keys = Keys(command, folder)
    found = [Stream("tcp", folder), Stream("unix", folder)]
    if keys.exists("server.key"):
        found.append(Tls(folder, keys))
    if keys.exists("server"):
        found += [ZeroMq(name, folder, keys) for name in ("zmq:tcp", "zmq:ipc", "zmq:curve")]
    return found
