# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""What a faulty client does in place of a request."""

import struct

import tandem
from fault_peers import STRANGE, STRANGE_SHOWN
from fault_replies import INFINITY, NAN, put
from tandem import wire


def frame(kind, number, payload=b""):
    return wire.HEADER.pack(len(payload), kind, number) + payload


def advance(number=4, t_limit=1.0, room=100, value=0.0):
    return frame(4, number, wire.put_advance(t_limit, False, room, [tandem.constant(value)]))


def sample():
    return frame(14, 4, wire.put_sample(0.1, 3, [0.0]))


HELLO = frame(1, 1, wire.put_hello(""))
INFO = frame(2, 2)
INITIALIZE = frame(3, 3, wire.put_initialize(0.0, 10.0, 1, [0.0]))
OPEN = [HELLO, INFO, INITIALIZE]


def serving_faults():
    """(kind, frames, what is answered to the last of them: error, a sentence, ok, or nothing as it is cut)."""
    faults = []
    for k, name in enumerate(["hello", "info", "initialize", "advance"]):
        all_four = OPEN + [advance()]
        faults += [(f"dropped_before_{name}", all_four[:k], "ok"), (f"dropped_after_{name}", all_four[:k + 1], "ok"),
                   (f"dropped_within_{name}", all_four[:k] + [all_four[k][:-3]], "cut")]
    advanced = put(16, "d", 1.0)(advance())
    return faults + [
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
        ("control_characters_in_hello", [frame(1, 1, wire.put_hello(STRANGE))],
         f"the parameters hold what is no text: '{STRANGE_SHOWN}'"),
        ("line_feed_in_hello", [frame(1, 1, wire.put_hello("m=1\nx"))],
         "the parameters hold what is no text: 'm=1\\x0ax'"),
        ("a_megabyte_of_control_characters", [frame(1, 1, wire.put_hello("\x1b" * (1 << 20)))], "\\x1b...'"),
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
        ("sample_of_what_is_not_sampled", OPEN + [sample()], "error"),
        ("sample_of_no_part", OPEN + [put(24, "I", 0)(sample())], "error"),
        ("sample_of_four_parts", OPEN + [put(24, "I", 4)(sample())], "error"),
        ("sample_at_no_time", OPEN + [put(16, "d", NAN)(sample())], "error"),
        ("sample_of_an_input_that_is_not_finite", OPEN + [put(32, "d", INFINITY)(sample())], "error"),
        ("sample_of_no_input", OPEN + [frame(14, 4, wire.put_sample(0.1, 3, []))], "error"),
        ("sample_before_initialize", [HELLO, INFO, frame(14, 3, wire.put_sample(0.1, 3, [0.0]))], "error"),
        ("state_never_saved", OPEN + [frame(7, 4, struct.pack("<q", 77))], "error"),
        ("bytes_left_over", OPEN + [frame(6, 4, b"more")], "error"),
    ]
