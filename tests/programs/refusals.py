# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""What Python says as the master of subsystems that are not there or break the contract. refusals.py tcp://HOST:PORT
(served: builtin:two_mass.slow). Ends with status 0 if each is refused by its sentence and nothing is left."""

import math
import os
import socket
import struct
import sys
import threading
import time

import tandem
from tandem import serving, wire
from tandem.program import Program


def refused(sentence, call):
    try:
        call()
    except tandem.Error as error:
        assert sentence in str(error), f"'{error}' has no '{sentence}'"
        return
    raise AssertionError(f"it was not refused: {sentence}")


class Broken:
    """Gives these rows for each advance; stands where the last of them says."""

    def __init__(self, rows):
        self.given = rows

    def info(self):
        return tandem.Info("broken", [], [tandem.Port("x", "1")])

    def initialize(self, t_start, t_stop, u0, rows, room):
        rows.append(tandem.Row(t_start, [0.0]))
        return tandem.Clock(t_start, t_start + 1.0, tandem.Stop.LIMIT)

    def advance(self, t_limit, land, u, rows, room):
        rows += self.given
        return tandem.Clock(rows[-1].time if rows else 7.0, 9.0, tandem.Stop.LIMIT)


def advanced(*rows):
    """One advance from 0 s to 1.5 s of a subsystem that gives those."""
    ours, theirs = socket.socketpair()
    session = serving.Session(wire.Channel(theirs, "here"), lambda parameters: Broken(list(rows)))
    thread = threading.Thread(target=session.serve)
    thread.start()
    try:
        with tandem.Remote(wire.Channel(ours, "there")) as far:
            far.initialize(0.0, 10.0, [])
            far.advance(1.5, [])
    finally:
        thread.join()


def refuses_rows():
    where = "there, advance at t = 0 s to 1.5 s: "
    row = tandem.Row
    advanced(row(0.5, [1.0]), row(0.5, [2.0], True), row(1.0, [3.0]))
    for bad, sentence in ((row(1.0, [math.nan]), "gives x not finite at t = 1 s"),
                          (row(0.0, [0.0]), "has a sample at t = 0 s that does not come after t = 0 s"),
                          (row(-1.0, [0.0]), "has a sample at t = -1 s that does not come after t = 0 s"),
                          (row(1.6, [0.0]), "has a sample at t = 1.6 s, past the limit 1.5 s"),
                          (row(math.nan, [0.0]), "has a sample whose time is not finite"),
                          (row(math.inf, [0.0]), "has a sample whose time is not finite")):
        refused(where + "the reply " + sentence, lambda bad=bad: advanced(bad))
    refused(where + "the reply has a sample at t = 0.4 s that does not come after t = 0.5 s",
            lambda: advanced(row(0.5, [0.0]), row(0.4, [0.0])))
    refused(where + "the reply says that it stands at t = 7 s, but its newest sample is of 0 s", advanced)


class ByHand:
    """A peer that gives these replies, of a type and a payload each, whatever it is asked."""

    def __init__(self, *replies):
        self._ours, self._theirs = socket.socketpair()
        self._thread = threading.Thread(target=self._serve, args=(replies,))
        self._thread.start()
        self.channel = wire.Channel(self._ours, "there")

    def _serve(self, replies):
        channel = wire.Channel(self._theirs, "here")
        for kind, payload in replies:
            frame = channel.receive(5.0)
            if frame is None:
                break
            channel.send(kind, frame[1], payload, 5.0)
        channel.receive(5.0)
        channel.close()


def by_hand(*replies, ports=("x",), derivatives=0):
    """The start of what has these outputs, with these replies to what follows hello and info."""
    info = tandem.Info("by hand", [], [tandem.Port(name, "1", derivatives=derivatives) for name in ports],
                       abilities=tandem.Abilities.SAVES_STATE)
    peer = ByHand((wire.Type.HELLO, wire.put_hello("by hand", ())), (wire.Type.INFO, wire.put_info(info)), *replies)
    with tandem.Remote(peer.channel) as far:
        far.initialize(0.0, 10.0, [])
        far.save_state()


def refuses_replies():
    stands = wire.put_clock(tandem.Clock(0.0, 1.0, tandem.Stop.LIMIT)) + struct.pack("<IQ", 3, 1)
    where = "there, initialize at t = 0 s: "
    for flag, text in ((2.0, "2"), (-1.0, "-1"), (math.nan, "nan")):
        refused(f"{where}the reply gives {text} as the jump flag of its sample at t = 0 s; allowed is 0 or 1",
                lambda flag=flag: by_hand((wire.Type.SAMPLES, stands + struct.pack("<3d", 0.0, flag, 5.0))))
    stands_with_derivative = stands[:-12] + struct.pack("<IQ", 4, 1)
    refused(where + "the reply gives x (a derivative) not finite at the start",
            lambda: by_hand((wire.Type.SAMPLES, stands_with_derivative + struct.pack("<4d", 0.0, 0.0, 5.0, math.nan)),
                            derivatives=1))
    sound = (wire.Type.SAMPLES, stands + struct.pack("<3d", 0.0, 1.0, 5.0))
    error = wire.put_error(tandem.Error("so it is", 4))
    rows = struct.pack("<IQ3d", 3, 1, 0.0, 0.0, 5.0)
    refused(where + "so it is", lambda: by_hand((wire.Type.ERROR, error + rows)))
    refused(where + "the message 'error' has 1 bytes more", lambda: by_hand((wire.Type.ERROR, error + rows + b"x")))
    refused(where + "the message 'error' ends after", lambda: by_hand((wire.Type.ERROR, error + b"x")))
    refused("there, save at t = 0 s: so it is", lambda: by_hand(sound, (wire.Type.ERROR, error)))
    refused("there, save at t = 0 s: the message 'error' has 1 bytes more",
            lambda: by_hand(sound, (wire.Type.ERROR, error + b"x")))
    refused("there, info: the info has no sense: a port is there twice", lambda: by_hand(ports=("x", "x")))


def refuses_addresses(address):
    refused("no connection to unix:/none", lambda: tandem.connect("unix:/none"))
    refused("is not of the form", lambda: tandem.connect("nonsense"))
    refused("has the host '*'", lambda: tandem.connect("tcp://*:1"))
    refused("plain text", lambda: tandem.connect("tcp://192.0.2.1:1"))
    refused(address + ", hello: ", lambda: tandem.connect(address + "?colour=blue"))
    for text in ("0", "-1", "soon", "nan", "inf"):
        refused(f"the deadline is '{text}'", lambda text=text: tandem.connect(f"{address}?deadline={text}"))
    refused("spawn:nope, hello: program 'nope' ended with status 127", lambda: tandem.connect("spawn:nope"))
    refused("ended with status 137 (signal 9?)", lambda: tandem.connect("spawn:sh -c 'kill -KILL $$'"))


def ends_its_program():
    program = Program("sh -c 'sleep 1000 & sleep 1000'")
    group = program._group
    refused("here, hello: no frame came whole within 0.1 s",
            lambda: tandem.Remote(wire.Channel(program.socket, "here"), "", 0.1, program))
    until = time.monotonic() + 5.0
    while is_there(group):
        assert time.monotonic() < until, "a process is left"
        time.sleep(0.01)


def ends_it_once(command):
    far = tandem.connect(command)
    far.close()
    told = []
    os.killpg, killpg = lambda *group: told.append(group), os.killpg
    far.close()
    os.killpg = killpg
    assert not told, f"a group that was ended is told {told} again"


def is_there(group):
    try:
        os.killpg(group, 0)
        return True
    except ProcessLookupError:
        return False


if __name__ == "__main__":
    refuses_rows()
    refuses_replies()
    refuses_addresses(sys.argv[1])
    ends_its_program()
    ends_it_once(sys.argv[2])
