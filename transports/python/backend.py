# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Builds the wheel with the standard library alone (PEP 517), so that pip needs neither setuptools nor wheel, nor a
network."""

import base64
import hashlib
import os
import zipfile

NAME, VERSION = "tandem", "0.1.0"
METADATA = f"""Metadata-Version: 2.1
Name: {NAME}
Version: {VERSION}
Summary: Subsystems for the co-simulation middleware tandem, either side in charge
License: BSD-3-Clause
Requires-Python: >=3.9
"""
WHEEL = "Wheel-Version: 1.0\nGenerator: tandem\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
INFO = f"{NAME}-{VERSION}.dist-info"


def contents():
    """Names in the wheel and what stands there."""
    folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), NAME)
    files = {}
    for file in sorted(os.listdir(folder)):
        if file.endswith(".py") or file == "py.typed":
            with open(os.path.join(folder, file), "rb") as source:
                files[f"{NAME}/{file}"] = source.read()
    files[f"{INFO}/METADATA"] = METADATA.encode()
    files[f"{INFO}/WHEEL"] = WHEEL.encode()
    return files


def record(files):
    """The list of all files with their sums."""
    lines = []
    for name, data in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        lines.append(f"{name},sha256={digest},{len(data)}\n")
    return "".join(lines) + f"{INFO}/RECORD,,\n"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    files = contents()
    files[f"{INFO}/RECORD"] = record(files).encode()
    wheel = f"{NAME}-{VERSION}-py3-none-any.whl"
    with zipfile.ZipFile(os.path.join(wheel_directory, wheel), "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            archive.writestr(name, data)
    return wheel
