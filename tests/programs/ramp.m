## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
## A ramp, x = t with steps of 0.1 s, as a server in Octave.
1;

function model = make (parameters)
  if (numfields (parameters) > 0)
    error ("the ramp has no parameter; there are %s", strjoin (fieldnames (parameters)', ", "));
  endif
  model.name = "ramp";
  model.inputs = {"u", "m", 0};
  model.outputs = {"x", "m"};
  model.h = 0.1;
  model.start = @(t, u0) t;
  model.step = @(state, t, t_end, h, u) t_end;
  model.values = @(state) state;
endfunction

exit (tandem_serve (@make));
