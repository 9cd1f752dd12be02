# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""What a reply must hold before it is believed. Each raises Error for what it does not."""

from __future__ import annotations

import math
from typing import List, NoReturn, Sequence, Tuple

from .contract import Abilities, Clock, Error, Info, Port, Row, Stop
from .models import before

MOST_SCALARS = 1 << 24


def check_info(info: Info) -> None:
    """Names, sizes, derivatives and feedthrough that make sense (tandem::check_info)."""
    for ports in (info.inputs, info.outputs):
        for port in ports:
            if not _is_sound(port):
                _refuse_info(f"port '{port.name}' has size {port.size} and {port.derivatives} derivatives; allowed are "
                             "a name without [ ] , \" and blanks, a size from 1, 0 to 3 derivatives")
        if len({port.name for port in ports}) < len(ports):
            _refuse_info("a port is there twice among its inputs or outputs")
        if sum(port.size for port in ports) > MOST_SCALARS:
            _refuse_info(f"its ports have more than {MOST_SCALARS} scalars, the most that are allowed")
    for output, input_ in info.feedthrough:
        if not (0 <= output < info.output_size() and 0 <= input_ < info.input_size()):
            _refuse_info(f"feedthrough from input {input_} to output {output} names a port that is not there")
    for port in info.outputs:
        if not 0.0 < port.nominal < math.inf:
            _refuse_info(f"output '{port.name}' has the nominal value {port.nominal}; allowed is a number above 0")
    _check_sampling(info)


def _check_sampling(info: Info) -> None:
    if Abilities.SAMPLED not in info.abilities:
        return
    if not (0.0 < info.period < math.inf and 0.0 <= info.latency < math.inf):
        _refuse_info(f"it is sampled with a period of {seconds(info.period)} and a latency of {seconds(info.latency)}; "
                     "allowed are a period above 0, a latency of 0 or more")
    if not all(port.held for port in info.outputs):
        _refuse_info("it is sampled, but not all of its outputs are held")


def _is_sound(port: Port) -> bool:
    return bool(port.name) and not set(port.name) & set('[] \t\n",') and port.size >= 1 and 0 <= port.derivatives <= 3


def check_first(info: Info, t_start: float, u0: Sequence[float], reply: Tuple[Clock, List[Row]]) -> None:
    """Of initialize: samples of t_start, of which the newest is finite but for outputs with feedthrough of an input that
    is NaN in u0, and for derivatives where any is; the clock stands there."""
    clock, rows = reply
    if not rows:
        _refuse("has no first sample")
    for row in rows:
        if row.time != t_start:
            _refuse(f"has a sample at t = {seconds(row.time)}; allowed is the start, {seconds(t_start)}")
    unknown = {output for output, input_ in info.feedthrough if math.isnan(u0[input_])}
    all_known = not any(map(math.isnan, u0))
    for k, value in enumerate(rows[-1].values):
        if not math.isfinite(value) and (all_known or k < info.output_size() and k not in unknown):
            _refuse_value(info, k, "the start")
    check_clock(info, clock, t_start)


def check_rows(info: Info, span: Tuple[float, float, float], reply: Tuple[Clock, List[Row]]) -> None:
    """Of an advance: all is finite, each row is later than the one before it (or as late, at a jump), none is past the
    limit, and the clock stands at the last one. span: the run's start, where the call began, and its limit."""
    t_start, last, limit = span
    clock, rows = reply
    for row in rows:
        _check_finite(info, row)
        if not (row.time > last or row.jump and row.time == last):
            _refuse(f"has a sample at t = {seconds(row.time)} that does not come after t = {seconds(last)}")
        if before(limit, row.time, t_start):
            _refuse(f"has a sample at t = {seconds(row.time)}, past the limit {seconds(limit)}")
        last = row.time
    check_clock(info, clock, last)


def check_jump(time: float, flag: float) -> None:
    if flag not in (0.0, 1.0):
        _refuse(f"gives {number_text(flag)} as the jump flag of its sample at t = {seconds(time)}; allowed is 0 or 1")


def check_clock(info: Info, clock: Clock, stands: float) -> None:
    if clock.time != stands:
        _refuse(f"says that it stands at t = {seconds(clock.time)}, but its newest sample is of {seconds(stands)}")
    check_next(info, clock)


def check_next(info: Info, clock: Clock) -> None:
    """What a clock has to be wherever it stands. A sampled subsystem may have its first instant there."""
    if not math.isfinite(clock.time):
        _refuse("gives a time that is not finite")
    if not (Abilities.SAMPLED in info.abilities and clock.next_time == clock.time):
        _check_later(clock)


def check_sample(info: Info, t: float, y: Sequence[float]) -> None:
    """The outputs of a sample at t are finite."""
    for k, value in enumerate(y):
        if not math.isfinite(value):
            _refuse(f"gives {scalar_name(info.outputs, k)} not finite at t = {seconds(t)}")


def check_next_instant(clock: Clock, t: float) -> None:
    """With its states a sampled subsystem stands at t, and its next instant is later."""
    if clock.time != t:
        _refuse(f"says that it stands at t = {seconds(clock.time)}; allowed is that of the sample, {seconds(t)}")
    _check_later(clock)


def _check_later(clock: Clock) -> None:
    if clock.stop != Stop.FINISHED and not clock.next_time > clock.time:
        _refuse(f"gives {seconds(clock.next_time)} as the end of the next own step, which is not later than "
                f"{seconds(clock.time)}")


def _check_finite(info: Info, row: Row) -> None:
    if not math.isfinite(row.time):
        _refuse("has a sample whose time is not finite")
    for k, value in enumerate(row.values):
        if not math.isfinite(value):
            _refuse_value(info, k, f"t = {seconds(row.time)}")


def _refuse_value(info: Info, k: int, when: str) -> NoReturn:
    block, output = divmod(k, info.output_size())
    _refuse(f"gives {scalar_name(info.outputs, output)}{' (a derivative)' if block else ''} not finite at {when}")


def scalar_name(ports: Sequence[Port], k: int) -> str:
    """That of flattened index k, as tandem::scalar_at has it."""
    for port in ports:
        if k < port.size:
            return port.name if port.size == 1 else f"{port.name}[{k}]"
        k -= port.size
    raise IndexError(k)


def seconds(value: float) -> str:
    return number_text(value) + " s"


def number_text(value: float) -> str:
    text = repr(float(value))
    return text[:-2] if text.endswith(".0") else text


def _refuse(what: str) -> NoReturn:
    raise Error("the reply " + what, 4)


def _refuse_info(what: str) -> NoReturn:
    raise Error(f"the info has no sense: {what}")
