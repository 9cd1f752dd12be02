## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
## A PI controller that samples, in Octave, to be served or to be started by spawn:.
##   at t_start + offset + k T:   u = kp e + s,   then   s becomes s + ki T e,   e = r - y
## Input y [m]; output u [N], which holds.
1;

function model = make (p)
  model.name = "pi";
  model.inputs = {"y", "m"};
  model.outputs = {"u", "N"};
  model.feedthrough = [1, 1];
  model.sampled = true;
  model.h = p.T;
  model.offset = p.offset;
  model.latency = p.latency;
  model.start = @(t, y0) 0;
  model.values = @(s, y) output (p, s, y);
  model.step = @(s, t, t_end, h, y) s + p.ki * p.T * (p.r - tandem_value (y(1), t));
endfunction

## Before the first instant, where y is not known, the integral part s alone.
function u = output (p, s, y)
  if (isempty (y))
    u = s;
  else
    u = p.kp * (p.r - y(1)) + s;
  endif
endfunction

parameters = {"kp", "N/m", [], "proportional gain"
              "ki", "N/(m s)", [], "integral gain"
              "r", "m", [], "what y is to be"
              "T", "s", [], "period"
              "offset", "s", [], "of the first instant"
              "latency", "s", [], "by which u changes later than the instant"};
exit (tandem_serve (@make, parameters));
