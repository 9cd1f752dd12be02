## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
## sampler.m URI: as sampler.py, in Octave.
s = tandem_connect (argv (){end});
info = tandem_info (s);
printf ("%.17g %.17g %d\n", info.period, info.latency, info.outputs(1).held);
clock = tandem_initialize (s, 0, 10, 0);
for k = 1:6
  t = clock.next_time;
  [~, first] = tandem_sample (s, t, 0.1 * k, "outputs");
  if (mod (k, 2))
    [clock, y] = tandem_sample (s, t, 0.1 * k);
    assert (y, first);
  else
    [clock, y] = tandem_sample (s, t, 0.1 * k, "states");
    assert (isempty (y));
  endif
  printf ("%.17g %.17g %.17g\n", t, clock.next_time, first);
endfor
tandem_close (s);
