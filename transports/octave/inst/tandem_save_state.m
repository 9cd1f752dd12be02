## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause

## state = tandem_save_state (s): keeps the state of a subsystem that has the ability, until tandem_release_state.
function state = tandem_save_state (s)
  state = __tandem__ ("save", s);
endfunction
