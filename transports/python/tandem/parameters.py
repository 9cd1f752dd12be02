# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""What a subsystem is made with, by the declaration of its parameters."""

from __future__ import annotations

import math
from typing import Dict, Mapping, Sequence, Union

from .contract import Error, Parameter

Value = Union[float, str]


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
