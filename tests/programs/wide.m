## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
## The wide subsystem of tests/libraries/wide.c in Octave, which has one input and one output.
1;

function model = make (parameters)
  model.name = "wide";
  model.inputs = {"u", "1", 0};
  model.outputs = {"y", "1"};
  model.h = 1e-9;
  model.start = @(t, u0) u0;
  model.step = @(state, t, t_end, h, u) state;
  model.values = @(state) 1;
endfunction

exit (tandem_serve (@make));
