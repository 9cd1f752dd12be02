## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
## A PI controller that samples, in Octave, to be served or to be started by spawn:.
##   at t_start + offset + k T:   u = kp e + s,   then   s becomes s + ki T e,   e = r - y
## Input y [m]; output u [N], which holds. Parameters, each of them needed: kp [N/m], ki [N/(m s)], r [m], T [s],
## the offset of the first instant [s], and the latency [s], by which u changes later than the instant.
1;

function model = make (parameters)
  keys = {"kp", "ki", "r", "T", "offset", "latency"};
  if (! isempty (setxor (fieldnames (parameters)', keys)))
    error ("pi: the parameters kp, ki, r, T, offset, latency are needed; there are %s",
           strjoin (fieldnames (parameters)', ", "));
  endif
  p = structfun (@str2double, parameters, "UniformOutput", false);
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

exit (tandem_serve (@make));
