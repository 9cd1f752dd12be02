// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Mass 2 of the two-mass test in Scilab, to be started by transports/scilab/run.
//   m x'' = k u - s x,  by the trapezoidal rule, solved exactly; u is read anew at both ends of a step.
// Input x1 [m]; outputs x2 [m] with two time derivatives, v2 [m/s] with one.
exec(getenv("TANDEM_SCILAB"), -1);

// p: m, k, s, x, v, h
function h = own_step(p)
  h = p(6);
endfunction

function x = start(p, t, u)
  x = [p(4); p(5); (p(2) * u(1) - p(3) * p(4)) / p(1)];
endfunction

function x = step(p, t, h, u, x)
  before = (p(2) * u(1, 1) - p(3) * x(1)) / p(1);
  push = p(2) * u(1, 3);
  x(1) = (x(1) + h * x(2) + 0.25 * h * h * (before + push / p(1))) / (1 + 0.25 * h * h * p(3) / p(1));
  x(3) = (push - p(3) * x(1)) / p(1);
  x(2) = x(2) + 0.5 * h * (before + x(3));
endfunction

function y = give(p, x)
  y = [x(1); x(2); x(2); x(3); x(3); 0];
endfunction

model = struct("name", "mass2", "states", 3);
model.inputs = ["x1", "m"];
model.outputs = ["x2", "m", "2"; "v2", "m/s", "1"];
model.parameters = ["m", "kg", "", "mass"
                    "k", "N/m", "", "stiffness of the spring to mass 1"
                    "s", "N/m", "", "stiffness of both springs together"
                    "x", "m", "", "position at the start"
                    "v", "m/s", "", "speed at the start"
                    "h", "s", "", "own step"];
model.own_step = own_step;
model.start = start;
model.step = step;
model.give = give;
tandem_serve(model);
