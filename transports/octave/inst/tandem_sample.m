## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause

## [clock, y] = tandem_sample (s, t, u)
## [clock, y] = tandem_sample (s, t, u, part)
##
## Lets a sampled subsystem act at its instant t, the next_time of its clock. u: a number for each input. part: "both" (as
## without it), "outputs" or "states". y: the outputs, [] for the states alone; they hold from t + latency to the next ones.
function [clock, y] = tandem_sample (s, t, u, part = "both")
  parts = find (strcmp (part, {"outputs", "states", "both"}));
  if (isempty (parts))
    error ("tandem_sample: part '%s'; allowed are outputs, states and both", part);
  endif
  [clock, y] = __tandem__ ("sample", s, t, double (u), parts);
endfunction
