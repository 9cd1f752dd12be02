# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""What a subsystem is made with, by the declaration of its parameters; and that on the wire."""

from __future__ import annotations

import math
import struct
from typing import Dict, List, Mapping, Sequence, Union

from .contract import Error, Parameter
from .reader import Reader, put_text

Value = Union[float, str]
MOST_PARAMETERS = 4096


def texts_of(text: str) -> Dict[str, str]:
    """Of "key=value&key=value"."""
    texts: Dict[str, str] = {}
    for pair in filter(None, text.split("&")):
        key, equals, value = pair.partition("=")
        if not equals or not key:
            raise Error(f"the parameters have '{pair}' where key=value is allowed")
        if key in texts:
            raise Error(f"parameter '{key}' is given twice")
        texts[key] = value
    return texts


def values_of(declared: Sequence[Parameter], texts: Mapping[str, str]) -> Dict[str, Value]:
    """Numbers and words: those that are given, and for the others what stands otherwise. The texts themselves where no
    parameters are declared."""
    if not declared:
        return dict(texts)
    names = [parameter.name for parameter in declared]
    for key in texts:
        if key not in names:
            raise Error(f"parameter '{key}' is not there. There are: {', '.join(names)}")
    return {parameter.name: _value_of(parameter, texts.get(parameter.name)) for parameter in declared}


def _value_of(parameter: Parameter, text: Union[str, None]) -> Value:
    value = parameter.otherwise if text is None else text
    if value is None:
        raise Error(f"parameter '{parameter.name}' is needed: {parameter.sentence}")
    if parameter.unit is None:
        return str(value)
    try:
        number = float(value)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise Error(f"parameter '{parameter.name}' is '{value}'; allowed is a finite number")
    return number


def put_declared(declared: Sequence[Parameter]) -> bytes:
    parts = [struct.pack("<I", len(declared))]
    for p in declared:
        parts.append(struct.pack("<I", (p.unit is None) | 2 * (p.otherwise is not None)))
        texts = (p.name, p.unit or "", "" if p.otherwise is None else str(p.otherwise), p.sentence)
        parts += [put_text(text) for text in texts]
    return b"".join(parts)


def read_declared(reader: Reader) -> List[Parameter]:
    count = reader.count(20)
    if count > MOST_PARAMETERS:
        reader.refuse(f"declares {count} parameters; allowed are up to {MOST_PARAMETERS}")
    return [_read_parameter(reader) for _ in range(count)]


def _read_parameter(reader: Reader) -> Parameter:
    (bits,) = reader.take("I")
    if bits > 3:
        reader.refuse(f"gives {bits} for the kind of a parameter; allowed are 0 to 3")
    name, unit, otherwise, sentence = (reader.name() for _ in range(4))
    return Parameter(name, None if bits & 1 else unit, sentence, otherwise if bits & 2 else None)
