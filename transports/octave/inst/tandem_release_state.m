## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause

## tandem_release_state (s, state): a saved state is not needed any more.
function tandem_release_state (s, state)
  __tandem__ ("release", s, state);
endfunction
