# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Subsystems for tandem in Python: written here, or driven from here. The standard library alone."""

from .contract import (Abilities, Clock, Error, FixedStep, Info, Port, Row, Segment, Signal, Stop, TimeGrid,
                       constant)
from .remote import Remote, connect
from .serving import serve

__all__ = ["Abilities", "Clock", "Error", "FixedStep", "Info", "Port", "Remote", "Row", "Segment", "Signal",
           "Stop", "TimeGrid", "connect", "constant", "serve"]
