## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause

## clock = tandem_restore_state (s, state): puts a saved state back.
function clock = tandem_restore_state (s, state)
  clock = __tandem__ ("restore", s, state);
endfunction
