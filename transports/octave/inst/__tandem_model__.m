## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause

## model = __tandem_model__ (make, declared, "key=value&key=value"): the model that make gives, checked and completed.
function model = __tandem_model__ (make, declared, text)
  model = make (values_of (declared, read_parameters (text)));
  if (! isstruct (model) || ! isscalar (model))
    error ("the model is no struct");
  endif
  wanted = {"name", "inputs", "outputs", "h", "start", "step", "values"};
  lacks = wanted(! isfield (model, wanted));
  if (! isempty (lacks))
    error ("the model has no field '%s'; needed are %s", lacks{1}, strjoin (wanted, ", "));
  endif
  known = [wanted, {"feedthrough", "sampled", "offset", "latency"}];
  others = setdiff (fieldnames (model)', known);
  if (! isempty (others))
    error ("the model's field '%s' is not known; allowed are %s", others{1}, strjoin (known, ", "));
  endif
  if (! ischar (model.name))
    error ("the model's name is no text");
  endif
  if (! isreal (model.h) || ! isscalar (model.h) || ! (model.h > 0) || ! isfinite (model.h))
    error ("model '%s': h is no number of seconds above 0", model.name);
  endif
  for field = {"sampled", "offset", "latency"}
    model.(field{1}) = number_of (model, field{1});
  endfor
  if (! model.sampled && (model.offset || model.latency))
    error ("model '%s': it has an offset or a latency, but is not sampled", model.name);
  endif
  for field = {"start", "step", "values"}
    if (! is_function_handle (model.(field{1})))
      error ("model '%s': %s is no function handle", model.name, field{1});
    endif
  endfor
  model.inputs = ports (model, "inputs", {NaN});
  model.outputs = ports (model, "outputs", {0, 1});
  if (! all ([model.outputs{:,4}] > 0) || ! all (isfinite ([model.outputs{:,4}])))
    error ("model '%s': a nominal value of an output is no number above 0", model.name);
  endif
  model.feedthrough = feedthrough (model);
endfunction

## Of a field that may be left out: a number from 0 on.
function x = number_of (model, field)
  x = 0;
  if (isfield (model, field))
    x = double (model.(field));
  endif
  if (! isreal (x) || ! isscalar (x) || ! (x >= 0) || ! isfinite (x))
    error ("model '%s': %s is no number from 0 on", model.name, field);
  endif
endfunction

## Of those that are declared, a row for each; the texts themselves where none are.
function values = values_of (declared, texts)
  for name = setdiff (fieldnames (texts)', declared(:,1)')
    if (! isempty (declared))
      error ("parameter '%s' is not there. There are: %s", name{1}, strjoin (declared(:,1)', ", "));
    endif
  endfor
  values = texts;
  for k = 1 : rows (declared)
    [name, unit, text, sentence] = declared{k,:};
    if (isfield (texts, name))
      text = texts.(name);
    elseif (isnumeric (text))
      error ("parameter '%s' is needed: %s", name, sentence);
    endif
    values.(name) = value_of (name, unit, text);
  endfor
endfunction

function value = value_of (name, unit, text)
  value = text;
  if (ischar (unit))
    value = str2double (text);
    if (! isreal (value) || ! isfinite (value))
      error ("parameter '%s' is '%s'; allowed is a finite number", name, text);
    endif
  endif
endfunction

function parameters = read_parameters (text)
  parameters = struct ();
  for pair = ostrsplit (text, "&", true)
    at = index (pair{1}, "=");
    if (! isempty (pair{1}) && at < 2)
      error ("the parameters have '%s' where key=value is allowed", pair{1});
    elseif (! isempty (pair{1}))
      parameters.(pair{1}(1:at-1)) = pair{1}(at+1:end);
    endif
  endfor
endfunction

## A row for each: name, unit and numbers, of which the last ones may be left out.
function rows = ports (model, field, usual)
  rows = model.(field);
  most = 2 + columns (usual);
  if (isempty (rows))
    rows = cell (0, most);
  endif
  if (! iscell (rows) || columns (rows) < 2 || columns (rows) > most || ! iscellstr (rows(:,1:2))
      || ! all (cellfun (@(x) isnumeric (x) && isscalar (x), rows(:,3:end))(:)))
    error ("model '%s': %s is not a cell array with a row {name, unit} for each, and up to %d numbers behind them",
           model.name, field, most - 2);
  endif
  given = columns (rows);
  rows(:,given+1:most) = repmat (usual(given-1:end), size (rows, 1), 1);
  rows(:,3:end) = cellfun (@double, rows(:,3:end), "UniformOutput", false);
endfunction

function pairs = feedthrough (model)
  pairs = zeros (0, 2);
  if (isfield (model, "feedthrough") && ! isempty (model.feedthrough))
    pairs = double (model.feedthrough);
  endif
  if (columns (pairs) != 2)
    error ("model '%s': feedthrough has %d columns; allowed are 2: output, input", model.name, columns (pairs));
  endif
endfunction
