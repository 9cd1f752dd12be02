// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// tandem_serve(model): serves a model to tandem until the run ends (docs/scilab.md). `model` is a struct:
//   name, states             its name, and how many numbers its state has
//   inputs                   name and unit, a row each, as texts
//   outputs                  name, unit and number of time derivatives, likewise
//   parameters               name, unit, what stands otherwise ("": it is needed), a sentence, likewise
//   own_step                 h = own_step(p): the own step [s]
//   start                    x = start(p, t, u): the state at the start, a column
//   step                     x = step(p, t, h, u, x): at t + h; columns of u: inputs at t, t + h/2, t + h
//   give                     y = give(p, x): a column: the outputs, then the first derivatives of all, and so on to the
//                            highest that one has; 0 where another has none
// p are the parameters in the order of their rows.

function tandem_serve_declare(model, to)
  mfprintf(to, "name\t%s\nstates\t%d\n", model.name, model.states);
  for k = 1:size(model.inputs, 1)
    mfprintf(to, "input\t%s\t%s\n", model.inputs(k, 1), model.inputs(k, 2));
  end
  for k = 1:size(model.outputs, 1)
    mfprintf(to, "output\t%s\t%s\t%s\n", model.outputs(k, 1), model.outputs(k, 2), model.outputs(k, 3));
  end
  for k = 1:size(model.parameters, 1)
    mfprintf(to, "parameter\t%s\t%s\t%s\t%s\n", model.parameters(k, 1), model.parameters(k, 2), ..
             model.parameters(k, 3), model.parameters(k, 4));
  end
  mfprintf(to, "end\n");
  mseek(0, to, "cur"); // which writes what waits
endfunction

function tandem_serve_check(numbers, what)
  if type(numbers) <> 1 | ~isreal(numbers) then
    error("tandem_serve: " + what + " gives no real numbers");
  end
endfunction

// One answer: 0 own step, 1 start, 2 step.
function answer = tandem_serve_answer(model, what, numbers)
  n = size(model.parameters, 1);
  m = size(model.inputs, 1);
  p = numbers(1:n);
  if what == 0 then
    answer = model.own_step(p);
    tandem_serve_check(answer, "own_step");
    return
  end
  t = numbers(n + 1);
  if what == 1 then
    x = model.start(p, t, numbers(n + 2:$));
  else
    u = matrix(numbers(n + 3:n + 2 + 3 * m), m, 3);
    x = model.step(p, t, numbers(n + 2), u, numbers(n + 3 + 3 * m:$));
  end
  tandem_serve_check(x, "start or step");
  y = model.give(p, x);
  tandem_serve_check(y, "give");
  answer = [x(:); y(:)];
endfunction

function tandem_serve(model)
  folder = getenv("TANDEM_SCILAB_FOLDER");
  to = mopen(folder + "/answers", "wb");
  from = mopen(folder + "/requests", "rb");
  tandem_serve_declare(model, to);
  while %t
    head = mget(2, "dl", from);
    if size(head, "*") < 2 then
      break
    end
    numbers = [];
    if head(2) > 0 then
      numbers = mget(head(2), "dl", from)';
    end
    failed = execstr("answer = tandem_serve_answer(model, head(1), numbers)", "errcatch");
    if failed <> 0 then
      answer = ascii(strcat(lasterror(), " "))';
    end
    mput([failed; size(answer, "*"); answer(:)], "dl", to);
    mseek(0, to, "cur");
  end
  exit(0);
endfunction
