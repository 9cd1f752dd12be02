# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""A model that is a function of time, state and inputs, integrated by SciPy over each own step."""

from __future__ import annotations

from typing import Any, Callable, List, Sequence

from .contract import Error, Info, Signal

Function = Callable[[float, Sequence[float], Sequence[float]], Sequence[float]]


class Ode:
    """state' = rate(t, state, inputs), from `start`, by scipy.integrate.solve_ivp, which chooses its own steps
    within each own step of `step` seconds. outputs(t, state, inputs): what is given (by default the state).
    method, rtol, atol and so on: as solve_ivp has them. To be handed to FixedStep."""

    def __init__(self, info: Info, rate: Function, start: Sequence[float], step: float,
                 outputs: Function = lambda t, state, inputs: state, **settings: Any) -> None:
        self._info, self._rate, self._start, self._h = info, rate, start, step
        self._outputs, self._settings = outputs, settings
        self._t, self._state, self._inputs = 0.0, list(start), [0.0] * info.input_size()

    def info(self) -> Info:
        return self._info

    def own_step(self) -> float:
        return self._h

    def start(self, t: float, u0: Sequence[float]) -> None:
        self._t, self._state, self._inputs = t, list(self._start), list(u0)

    def step(self, begin: float, end: float, h: float, u: Sequence[Signal]) -> None:
        from scipy.integrate import solve_ivp

        def rate(t: float, state: Sequence[float]) -> Sequence[float]:
            return self._rate(t, state, [signal.value(t) for signal in u])

        solution = solve_ivp(rate, (begin, end), self._state, **self._settings)
        if not solution.success:
            raise Error(f"from t = {begin} s to {end} s: {solution.message}", 4)
        self._t, self._state = end, [float(x) for x in solution.y[:, -1]]
        self._inputs = [signal.value(end) for signal in u]

    def state(self) -> List[float]:
        return [self._t, *self._state, *self._inputs]

    def set_state(self, numbers: Sequence[float]) -> None:
        n = len(self._start)
        self._t, self._state, self._inputs = numbers[0], list(numbers[1:n + 1]), list(numbers[n + 1:])

    def outputs(self) -> List[float]:
        return [float(y) for y in self._outputs(self._t, self._state, self._inputs)]
