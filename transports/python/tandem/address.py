# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Where peers meet: tcp://HOST:PORT, on this machine unless plain text may go beyond it, and unix:PATH."""

from __future__ import annotations

import errno
import os
import socket
import stat
from typing import Any, List, Tuple

from .contract import Error


def listen(address: str) -> Tuple[socket.socket, str]:
    """A socket that listens there, and the address with the port that was found."""
    try:
        if address.startswith("unix:"):
            return _unix_listener(address[5:]), address
        place = resolve(address, False)[0]
        sock = socket.create_server(place[4][:2], family=place[0])
        return sock, f"{address[:address.rindex(':')]}:{sock.getsockname()[1]}"
    except OSError as error:
        raise Error(f"no listening at {address}: {error}", 5) from None


def _unix_listener(path: str) -> socket.socket:
    if _is_stale(path):
        os.unlink(path)
    sock = socket.socket(socket.AF_UNIX)
    os.fchmod(sock.fileno(), 0o600)  # before there is a file to connect to
    sock.bind(path)
    sock.listen()
    return sock


def _is_stale(path: str) -> bool:
    """A socket that is left of a server which is gone."""
    if not os.path.exists(path) or not stat.S_ISSOCK(os.stat(path).st_mode):
        return False
    with socket.socket(socket.AF_UNIX) as probe:
        return probe.connect_ex(path) == errno.ECONNREFUSED


def split_address(address: str) -> Tuple[str, int]:
    host, colon, port = address[6:].rpartition(":")
    if not address.startswith("tcp://") or not colon or not port.isdigit():
        raise Error(f"address '{address}' is not of the form tcp://HOST:PORT or unix:PATH")
    return host.strip("[]"), int(port)


def resolve(address: str, allow_plaintext: bool) -> List[Any]:
    """What tcp://HOST:PORT stands for, as socket.getaddrinfo gives it; all of it has to be this machine."""
    host, port = split_address(address)
    places = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)
    for place in places:
        if not allow_plaintext and not is_loopback(str(place[4][0])):
            raise Error(f"address '{address}' is beyond this machine ({place[4][0]}), and tcp is plain text", 2)
    return places


def is_loopback(host: str) -> bool:
    return host.startswith("127.") or host == "::1"


def connected(address: str, deadline: float, allow_plaintext: bool) -> socket.socket:
    """To the first of the places that an address stands for which takes a connection."""
    unix = address.startswith("unix:")
    failure = OSError("the address stands for nothing")
    places = [(socket.AF_UNIX, address[5:])] if unix else [(p[0], p[4]) for p in resolve(address, allow_plaintext)]
    for family, place in places:
        sock = socket.socket(family)
        sock.settimeout(deadline)
        try:
            sock.connect(place)
            return sock
        except OSError as error:
            sock.close()
            failure = error
    raise failure
