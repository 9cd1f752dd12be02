# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""calls.py URI: as calls.c, in Python."""

import sys

import tandem


def drive(uri):
    with tandem.connect(uri) as far:
        info = far.info()
        print(info.name, *(f"{port.name} [{port.unit}]" for port in (*info.inputs, *info.outputs)))
        far.initialize(0.0, 10.0, [0.0])
        for k in range(1, 21):
            far.advance(0.5 * k, [tandem.constant(1.0)])


if __name__ == "__main__":
    try:
        drive(sys.argv[1])
    except tandem.Error as error:
        print(error, file=sys.stderr)
        sys.exit(1)
