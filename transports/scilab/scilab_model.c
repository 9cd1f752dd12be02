/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* tandem_scilab SERVE FILE.sce: serves a model that a script of Scilab declares (docs/scilab.md), as spawn: and `command`
 * start it. SERVE is tandem_serve.sci. */
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include "scilab_process.h"
#include "tandem/fixed_step.h"
#include "tandem/peer.h"

enum { most_lines = 200, most_doubles = 4096 };
typedef enum request { own_step_of, start_of, step_of } request;

static scilab_process scilab;
static tandem_model model;
static char lines[most_lines][256];
static int line_count, state_count, row_count;

/* One request and its answer: a status, a count, and as many numbers, in place of those that went. */
static tandem_status ask(tandem_instance* self, request what, double* numbers, int count, int answered) {
  const double head[2] = {(double)what, (double)count};
  double said[2];
  if (scilab_write(&scilab, head, sizeof head) != 0 ||
      scilab_write(&scilab, numbers, (size_t)count * sizeof(double)) != 0 ||
      scilab_read(&scilab, said, sizeof said) != 0)
    return tandem_refuse(self, TANDEM_INTERNAL, "Scilab has ended");
  if (!(said[1] >= 0.0 && said[1] <= most_doubles) ||
      scilab_read(&scilab, numbers, (size_t)said[1] * sizeof(double)) != 0)
    return tandem_refuse(self, TANDEM_INTERNAL, "Scilab gave no answer that can be read");
  if (said[0] != 0.0) {
    const int length = (int)fmin(said[1], (double)sizeof self->error - 1.0);
    for (int k = 0; k < length; ++k) self->error[k] = (char)numbers[k];
    self->error[length] = '\0';
    return TANDEM_NUMERICAL;
  }
  if ((int)said[1] == answered) return TANDEM_OK;
  return tandem_refuse(self, TANDEM_INTERNAL, "Scilab gave %g numbers; allowed are %d", said[1], answered);
}

static int put(double* to, const double* from, int count) {
  memcpy(to, from, (size_t)count * sizeof(double));
  return count;
}

/* The state, then the row that belongs to it. */
static tandem_status keep(tandem_instance* self, request what, double* numbers, int count) {
  const tandem_status status = ask(self, what, numbers, count, state_count + row_count);
  if (status == TANDEM_OK) put(self->state, numbers, state_count + row_count);
  return status;
}

static tandem_status find_own_step(tandem_instance* self, double* h) {
  double numbers[most_doubles];
  const tandem_status status =
      ask(self, own_step_of, numbers, put(numbers, self->p, model.parameter_count), 1);
  *h = numbers[0];
  return status;
}

static double own_step(const tandem_instance* self) {
  double h;
  return find_own_step((tandem_instance*)self, &h) == TANDEM_OK ? h : 0.0;
}

/* An error of it is told when an instance is made. */
static tandem_status check(tandem_instance* self) {
  double h;
  return find_own_step(self, &h);
}

static tandem_status start(tandem_instance* self, double t, const double* u0) {
  double numbers[most_doubles];
  int count = put(numbers, self->p, model.parameter_count);
  numbers[count++] = t;
  count += put(numbers + count, u0, (int)self->input_count);
  return keep(self, start_of, numbers, count);
}

static tandem_status step(tandem_instance* self, tandem_own_step* own, const tandem_signal* u) {
  double numbers[most_doubles];
  int count = put(numbers, self->p, model.parameter_count);
  const double times[3] = {own->begin, own->begin + (own->end - own->begin) / 2.0, own->end};
  numbers[count++] = own->begin;
  numbers[count++] = own->length;
  for (int k = 0; k < 3; ++k)
    for (size_t i = 0; i < self->input_count; ++i) numbers[count++] = tandem_signal_value(u + i, times[k]);
  count += put(numbers + count, self->state, state_count);
  return keep(self, step_of, numbers, count);
}

static void outputs(const tandem_instance* self, double* y) {
  put(y, (const double*)self->state + state_count, row_count);
}

/* The next of the words that tabs part; "" at the end. */
static char* word(char** rest) {
  char* const begin = *rest;
  *rest += strcspn(begin, "\t");
  if (**rest) *(*rest)++ = '\0';
  return begin;
}

/* Reads a line of the declaration. 0: there is none, or it is too long. */
static int read_line(char* to, size_t size) {
  for (size_t length = 0; length < size; ++length) {
    if (scilab_read(&scilab, to + length, 1) != 0) return 0;
    if (to[length] != '\n') continue;
    to[length] = '\0';
    return 1;
  }
  return 0;
}

/* 0: it is a line of a declaration. */
static int declare(char* line, tandem_port* inputs, tandem_port* outs, tandem_parameter* parameters) {
  const char* const kind = word(&line);
  if (strcmp(kind, "name") == 0) {
    model.info.name = word(&line);
  } else if (strcmp(kind, "states") == 0) {
    state_count = atoi(word(&line));
  } else if (strcmp(kind, "parameter") == 0) {
    tandem_parameter* const p = parameters + model.parameter_count++;
    p->name = word(&line), p->unit = word(&line), p->otherwise = word(&line), p->sentence = word(&line);
    if (!*p->otherwise) p->otherwise = NULL;
  } else if (strcmp(kind, "input") != 0 && strcmp(kind, "output") != 0) {
    return -1;
  } else {
    const int is_input = strcmp(kind, "input") == 0;
    tandem_port* const port = is_input ? inputs + model.info.input_count++ : outs + model.info.output_count++;
    const char* const name = word(&line);
    const tandem_port one = {name, word(&line), 1, is_input ? 0 : atoi(word(&line)), NAN};
    memcpy(port, &one, sizeof one);
  }
  return 0;
}

/* 0: the script has declared a model. */
static int read_model(void) {
  static tandem_port inputs[most_lines], outs[most_lines];
  static tandem_parameter parameters[most_lines];
  model.info.inputs = inputs, model.info.outputs = outs, model.parameters = parameters;
  for (; line_count < most_lines; ++line_count) {
    char* const line = lines[line_count];
    if (!read_line(line, sizeof lines[0])) return -1;
    if (strcmp(line, "end") == 0) break;
    if (declare(line, inputs, outs, parameters) != 0) return -1;
  }
  if (line_count == most_lines || !model.info.name || state_count < 0 || state_count > most_doubles)
    return -1;
  row_count = (int)tandem_row_size(&model.info) - 2; /* without time and jump flag */
  model.state_size = (size_t)(state_count + row_count) * sizeof(double);
  model.own_step = own_step, model.start = start, model.step = step, model.outputs = outputs,
  model.check = check;
  return 3 * model.info.input_count + model.parameter_count + state_count + row_count + 8 < most_doubles ? 0
                                                                                                         : -1;
}

TANDEM_EXPORT_FIXED_STEP(scilab_subsystem, model)

static void stop(void) { scilab_stop(&scilab); }

static void leave(int number) {
  scilab_hide(&scilab);
  _exit(128 + number);
}

int main(int count, char* words[]) {
  static char* none[] = {"tandem_scilab", NULL};
  if (count != 3 || !getenv("TANDEM_FD")) {
    fprintf(stderr, "tandem_scilab SERVE FILE.sce: to be started by spawn: or `command` (docs/scilab.md)\n");
    return 2;
  }
  signal(SIGPIPE, SIG_IGN);
  signal(SIGTERM, leave), signal(SIGINT, leave);
  fcntl(atoi(getenv("TANDEM_FD")), F_SETFD, FD_CLOEXEC); /* the session is not Scilab's */
  atexit(stop);
  if (scilab_start(&scilab, words[2], words[1]) != 0 || read_model() != 0) {
    fprintf(
        stderr,
        "tandem_scilab: %s declares no model of at most 197 ports and parameters with rows of at most 255 "
        "bytes; what Scilab says stands above\n",
        words[2]);
    return 1;
  }
  scilab_hide(&scilab);
  return tandem_serve(scilab_subsystem(), 1, none);
}
