## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause

## rows = __tandem_declared__ (declared): the parameters that a model takes, checked, with texts where numbers stood.
function rows = __tandem_declared__ (declared)
  rows = declared;
  if (isempty (rows))
    rows = cell (0, 4);
  endif
  if (! iscell (rows) || columns (rows) != 4 || ! iscellstr (rows(:,[1, 4]))
      || ! all (cellfun (@(unit) isempty (unit) || ischar (unit), rows(:,2))))
    error ("tandem_serve: the parameters are not a cell array with a row {name, unit, otherwise, sentence} for each");
  endif
  rows(:,3) = cellfun (@text_of, rows(:,3), "UniformOutput", false);
endfunction

## The shortest that reads back as the same number.
function text = text_of (value)
  text = value;
  digits = 15;
  while (isnumeric (value) && ! isempty (value) && ! (ischar (text) && (str2double (text) == value || digits > 17)))
    text = sprintf ("%.*g", digits++, value);
  endwhile
endfunction
