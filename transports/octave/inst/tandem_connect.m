## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause

## s = tandem_connect (uri)
## s = tandem_connect (uri, allow_plaintext)
##
## Opens a subsystem elsewhere, so that Octave drives it: "tcp://HOST:PORT", "unix:PATH" or "spawn:COMMAND", then, after a
## '?', key=value pairs joined by '&'. The key deadline (seconds to connect, and for each reply; 5) is its own, all
## others go to the subsystem. s is a number, for tandem_info, tandem_initialize, tandem_advance,
## tandem_save_state, tandem_restore_state, tandem_release_state and tandem_close.
function s = tandem_connect (uri, allow_plaintext = false)
  if (nargin < 1 || ! ischar (uri))
    error ("tandem_connect: the URI is no text");
  endif
  s = __tandem__ ("connect", uri, double (allow_plaintext));
endfunction
