## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause

## u = tandem_signal (value)
## u = tandem_signal (ends, origins, c)
##
## An input as a function of time: a constant, or a piecewise polynomial. Piece k holds up to the time ends(k), the last
## one beyond it too; its value is the sum of c(k,j+1) * (t - origins(k))^j, with up to 6 columns. The inputs of
## a subsystem are an array of them, [tandem_signal(1), tandem_signal(2)].
function u = tandem_signal (ends, origins, c)
  if (nargin == 1)
    c = ends;
    ends = origins = 0;
  elseif (nargin != 3)
    error ("tandem_signal: 1 or 3 arguments are allowed");
  endif
  n = numel (ends);
  if (n < 1 || numel (origins) != n || rows (c) != n || columns (c) < 1 || columns (c) > 6)
    error ("tandem_signal: %d ends, %d origins and c of %d x %d; allowed are as many origins and rows of c as ends, and 1 to 6 columns",
           n, numel (origins), rows (c), columns (c));
  endif
  u = struct ("end", double (ends(:)), "origin", double (origins(:)), "c", [double(c), zeros(n, 6 - columns (c))]);
endfunction
