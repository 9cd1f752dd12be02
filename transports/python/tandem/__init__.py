# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""Subsystems for tandem in Python: written here, or driven from here. The standard library alone."""

from .contract import (Abilities, Clock, Error, Info, Parameter, Part, Port, Row, Segment, Signal, Stop,
                       constant)
from .models import FixedStep, Sampled, TimeGrid
from .remote import Remote, connect
from .serving import serve

__all__ = ["Abilities", "Clock", "Error", "FixedStep", "Info", "Parameter", "Part", "Port", "Remote", "Row", "Sampled",
           "Segment", "Signal", "Stop", "TimeGrid", "connect", "constant", "serve"]
