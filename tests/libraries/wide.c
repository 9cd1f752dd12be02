/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* A subsystem as wide as its parameters say, with next to no memory of its own: inputs=N scalars, outputs=N
 * scalars, saved states of bytes=N each, which with dumb=2 can't be given as bytes. Its own step is 1e-9 s;
 * outputs are 1. */
#include <stdlib.h>
#include <string.h>

#include "tandem/subsystem.h"

enum { SAVED = 200000 };

typedef struct wide {
  int32_t inputs, outputs, bytes, dumb;
  tandem_port ports[2];
  tandem_info info;
  double time;
  void* saved[SAVED];
  int count;
} wide;

static const double h = 1e-9;

static int32_t number(const char* parameters, const char* name) {
  const char* const at = strstr(parameters, name);
  return at ? (int32_t)strtol(at + strlen(name), NULL, 10) : 1;
}

static tandem_status create(const char* parameters, void** self) {
  wide* const w = calloc(1, sizeof *w);
  const tandem_port u = {"u", "1", number(parameters, "inputs="), 0, 0.0};
  const tandem_port y = {"y", "1", number(parameters, "outputs="), 0, 0.0};
  if (!(*self = w)) return TANDEM_INTERNAL;
  w->bytes = number(parameters, "bytes=");
  w->dumb = number(parameters, "dumb=") > 1;
  w->ports[0] = u;
  w->ports[1] = y;
  w->info.name = "wide";
  w->info.abilities = TANDEM_SAVES_STATE | TANDEM_SERIALIZES_STATE | TANDEM_RESTARTS;
  w->info.inputs = w->ports;
  w->info.outputs = w->ports + 1;
  w->info.input_count = w->info.output_count = 1;
  return TANDEM_OK;
}

static void destroy(void* self) {
  wide* const w = self;
  while (w->count > 0) free(w->saved[--w->count]);
  free(w);
}
static const tandem_info* info(void* self) { return &((wide*)self)->info; }
static const char* last_error(void* self) { return (void)self, "it is not so wide"; }

static void append(const wide* w, tandem_samples* y) {
  double* const row = y->rows + y->size++ * y->stride;
  int32_t k;
  row[0] = w->time;
  row[1] = 0.0;
  for (k = 0; k < w->ports[1].size; ++k) row[2 + k] = 1.0;
}

static tandem_status stand(const wide* w, tandem_stop stop, tandem_clock* clock) {
  const tandem_clock there = {w->time, w->time + h, stop, 0};
  *clock = there;
  return TANDEM_OK;
}

static tandem_status initialize(void* self, double t_start, double t_stop, const double* u0,
                                tandem_samples* y, tandem_clock* clock) {
  wide* const w = self;
  (void)t_stop, (void)u0;
  w->time = t_start;
  append(w, y);
  return stand(w, TANDEM_STOP_LIMIT, clock);
}

/* Rows for as long as there is room. */
static tandem_status advance(void* self, double t_limit, int32_t land, const tandem_signal* u,
                             tandem_samples* y, tandem_clock* clock) {
  wide* const w = self;
  (void)t_limit, (void)land, (void)u;
  while (y->size < y->capacity) {
    w->time += h;
    append(w, y);
  }
  return stand(w, TANDEM_STOP_SAMPLES_FULL, clock);
}

static tandem_status save_state(void* self, int64_t* id) {
  wide* const w = self;
  if (w->count == SAVED || !(w->saved[w->count] = malloc((size_t)w->bytes))) return TANDEM_INTERNAL;
  memset(w->saved[w->count], 1, (size_t)w->bytes);
  *id = w->count++;
  return TANDEM_OK;
}

static tandem_status restore_state(void* self, int64_t id, tandem_clock* clock) {
  (void)id;
  return stand(self, TANDEM_STOP_LIMIT, clock);
}

/* The last one, of those that are dumb. */
static tandem_status release_state(void* self, int64_t id) {
  wide* const w = self;
  if (w->dumb && id == w->count - 1) free(w->saved[--w->count]);
  return TANDEM_OK;
}

static tandem_status serialize_state(void* self, int64_t id, const void** bytes, int64_t* size) {
  if (((wide*)self)->dumb) return TANDEM_INTERNAL;
  *bytes = ((wide*)self)->saved[id];
  *size = ((wide*)self)->bytes;
  return TANDEM_OK;
}

/* Keeps nothing of them, so that what is measured is not its own. */
static tandem_status deserialize_state(void* self, const void* bytes, int64_t size, int64_t* id) {
  (void)self, (void)bytes, (void)size;
  *id = SAVED;
  return TANDEM_OK;
}

const tandem_subsystem_api* tandem_subsystem(void);
const tandem_subsystem_api* tandem_subsystem(void) {
  static const tandem_subsystem_api api = {
      .abi_version = TANDEM_ABI_VERSION,
      .table_size = sizeof(tandem_subsystem_api),
      .create = create,
      .destroy = destroy,
      .info = info,
      .last_error = last_error,
      .initialize = initialize,
      .advance = advance,
      .save_state = save_state,
      .restore_state = restore_state,
      .release_state = release_state,
      .serialize_state = serialize_state,
      .deserialize_state = deserialize_state,
  };
  return &api;
}
