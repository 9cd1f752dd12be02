## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
## Mass 2 of the two-mass test in Octave, to be served or to be started by spawn:.
##   m x'' = k u - s x,  by the trapezoidal rule, solved exactly; u is read anew at both ends of a step.
## Input x1 [m]; outputs x2 [m] with two time derivatives, v2 [m/s] with one.
1;

function model = make (p)
  model.name = "mass2";
  model.inputs = {"x1", "m"};
  model.outputs = {"x2", "m", 2; "v2", "m/s", 1};
  model.h = p.h;
  model.start = @(t, u0) struct ("x", p.x, "v", p.v, "a", (p.k * u0(1) - p.s * p.x) / p.m);
  model.step = @(state, t, t_end, h, u) step (p, state, t, t_end, h, u);
  model.values = @(state) [state.x, state.v, state.v, state.a, state.a, 0];
endfunction

function state = step (p, state, t, t_end, h, u)
  before = (p.k * tandem_value (u(1), t) - p.s * state.x) / p.m;
  push = p.k * tandem_value (u(1), t_end);
  state.x = (state.x + h * state.v + 0.25 * h * h * (before + push / p.m)) / (1 + 0.25 * h * h * p.s / p.m);
  state.a = (push - p.s * state.x) / p.m;
  state.v += 0.5 * h * (before + state.a);
endfunction

parameters = {"m", "kg", [], "mass"
              "k", "N/m", [], "stiffness of the spring to mass 1"
              "s", "N/m", [], "stiffness of both springs together"
              "x", "m", [], "position at the start"
              "v", "m/s", [], "speed at the start"
              "h", "s", [], "own step"};
exit (tandem_serve (@make, parameters));
