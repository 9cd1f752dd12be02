## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause

## [clock, rows] = tandem_advance (s, t_limit, u)
## [clock, rows] = tandem_advance (s, t_limit, u, land)
##
## Takes all own steps of a subsystem that end at or before t_limit, a row for each, as tandem_initialize gives them. u: an
## array of tandem_signal, an element for each input. land: the last step is cut so that it ends at t_limit.
## clock.stop is "limit", "event" or "samples_full" (more than 1000 rows): then call again; or "finished".
function [clock, rows] = tandem_advance (s, t_limit, u, land = false)
  [clock, rows] = __tandem__ ("advance", s, t_limit, u, double (land));
endfunction
