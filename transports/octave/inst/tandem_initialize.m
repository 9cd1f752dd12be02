## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause

## [clock, rows] = tandem_initialize (s, t_start, t_stop, u0)
##
## Puts a subsystem at t_start, in s. u0: a number for each input, NaN where it is not known. clock: a struct with time,
## next_time (where its next own step would end) and stop. rows: time, jump flag, outputs, their first derivatives,
## second ones, ... as columns.
function [clock, rows] = tandem_initialize (s, t_start, t_stop, u0)
  [clock, rows] = __tandem__ ("initialize", s, t_start, t_stop, double (u0));
endfunction
