## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause

## info = tandem_info (s)
##
## What a subsystem is: a struct with name, inputs and outputs (struct arrays with name, unit, size, derivatives, start,
## held), feedthrough (pairs [output, input] of numbers from 1), abilities (1 chooses its step, 2 lands, 4 saves its
## state, 8 restarts, 64 is sampled) and, of a sampled one, period and latency, in s.
function info = tandem_info (s)
  info = __tandem__ ("info", s);
endfunction
