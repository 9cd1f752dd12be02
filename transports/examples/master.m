## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
## Octave as the master: drives a subsystem of tandem through ten calls with a parabola as the input, each of them twice
## from a saved state, and prints every row in full.
##   master.m tcp://HOST:PORT   (served: builtin:two_mass.slow)
s = tandem_connect (argv (){end});
[clock, rows] = tandem_initialize (s, 0, 100, 0.5);
for k = 1:10
  t = 1.7 * k;
  u = tandem_signal (t, t - 1, [0.5, 0.1 * k, -0.02]);
  state = tandem_save_state (s);
  [~, first] = tandem_advance (s, t, u, true);
  tandem_restore_state (s, state);
  tandem_release_state (s, state);
  [clock, again] = tandem_advance (s, t, u, true);
  assert (isequal (first, again));
  assert (clock.time, t);
  rows = [rows; again];
endfor
printf ([repmat("%.17g ", 1, columns (rows)), "\n"], rows');
tandem_close (s);
