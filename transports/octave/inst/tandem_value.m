## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause

## y = tandem_value (u, t): the value at time t of an input, an element of the array that tandem_signal makes. The order
## of operations is that of tandem/signal.h, so that the bits are the same.
function y = tandem_value (u, t)
  n = numel (u.end);
  k = 1;
  while (k < n && t > u.end(k))
    k++;
  endwhile
  c = u.c(k,:);
  x = t - u.origin(k);
  x2 = x * x;
  y = (c(1) + c(2) * x) + x2 * ((c(3) + c(4) * x) + x2 * (c(5) + c(6) * x));
endfunction
