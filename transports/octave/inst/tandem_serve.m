## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause

## status = tandem_serve (make)
## status = tandem_serve (make, parameters)
## status = tandem_serve (..., "--listen", URI, "--once", ...)
##
## Serves a model to tandem: at "tcp://HOST:PORT" or "unix:PATH", or, without --listen, to the run that has started this
## program by spawn:. Without options here those of the command line are taken, from the first one on: --listen URI,
## --once, --sessions N, --deadline S, --idle S, --allow-plaintext (docs/c.md). Each session has a model of its own,
## model = make (values). `parameters` declares what it takes, a row for each: {"name", "unit", otherwise, "sentence"}.
## The unit is that of a number, [] for a word; otherwise is what stands where none is given, [] if one has to be. Then
## `values` is a struct of numbers and words; without it, of the texts that the client gives. A model is a struct:
##
##   name         its name
##   inputs       a row for each input: {"name", "unit"} or {"name", "unit", start}
##   outputs      a row for each output: {"name", "unit"}, behind it how many time derivatives it gives (0), and its
##                usual magnitude (1)
##   feedthrough  pairs [output, input] of numbers from 1; may be left out
##   h            length of its own step, in s
##   start        state = start (t, u0): the state at the start, any value of Octave; u0 has NaN where nothing is known
##   step         state = step (state, t, t_end, h, u): the state after an own step; tandem_value (u(k), t) is input k
##   values       row = values (state): outputs, then their first derivatives (0 where one has none), second ones, ...
##   sampled      true: it acts only at the instants t_start + offset + k h, where it gives its outputs, which hold, and
##                steps to the next one on inputs that hold; where it has feedthrough, values is values (state, u), with
##                u the inputs at the instant, [] before the first one; may be left out, as the next two
##   offset       of the first instant, in s (0)
##   latency      how long after each instant the outputs change, in s (0)
##
## The package does the grid of steps, landing, and saving of states. An error of the model ends the session with its
## sentence. status is 0, or 1 or 2 after an error.
function status = tandem_serve (make, varargin)
  if (nargin < 1 || ! is_function_handle (make))
    error ("tandem_serve: the first argument is no function handle");
  endif
  words = varargin;
  declared = {};
  if (! isempty (words) && iscell (words{1}))
    declared = words{1};
    words(1) = [];
  endif
  if (isempty (words))
    words = argv ()';
    ours = {"--listen", "--once", "--sessions", "--deadline", "--idle", "--allow-plaintext"};
    words = words(find (ismember (words, ours), 1) : end);
  endif
  if (! iscellstr (words))
    error ("tandem_serve: the options are not texts");
  endif
  status = __tandem__ ("serve", make, __tandem_declared__ (declared), words{:});
endfunction
