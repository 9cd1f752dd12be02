## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause

## tandem_close (s): ends a connection; a program that it has started ends too.
function tandem_close (s)
  __tandem__ ("close", s);
endfunction
