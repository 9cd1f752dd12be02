/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* C as the master: drives a subsystem of tandem, and the same model in C (mass2.c) beside it; the samples
 * have to be the same to the last bit. master tcp://HOST:PORT "m=...&k=..."   (served: builtin:two_mass.slow)
 */
#include <stdio.h>
#include <string.h>

#include "tandem/peer.h"

extern const tandem_subsystem_api* tandem_subsystem(void);

enum { stride = 8, most_rows = 2000 };

typedef struct instance {
  const tandem_subsystem_api* api;
  void* self;
  tandem_clock clock;
  double rows[stride * most_rows];
  tandem_samples y;
} instance;

static int ok(instance* s, tandem_status status) {
  if (status != TANDEM_OK) fprintf(stderr, "%s\n", s->self ? s->api->last_error(s->self) : "no memory");
  return status == TANDEM_OK;
}

static int start(instance* s, const tandem_subsystem_api* api, const char* parameters) {
  const double u0 = 0.5;
  memset(s, 0, sizeof *s);
  s->api = api;
  s->y.rows = s->rows;
  s->y.stride = stride;
  s->y.capacity = most_rows;
  if (!ok(s, api->create(parameters, &s->self))) return 0;
  if (tandem_row_size(api->info(s->self)) != stride) return 0;
  return ok(s, api->initialize(s->self, 0.0, 100.0, &u0, &s->y, &s->clock));
}

/* Ten calls with a parabola as the input. */
static int drive(instance* s) {
  int k;
  for (k = 1; k <= 10; ++k) {
    const double t = 1.7 * k;
    const tandem_segment piece = {t, t - 1.0, {0.5, 0.1 * k, -0.02}};
    const tandem_signal u = {&piece, 1, 2, NULL};
    if (!ok(s, s->api->advance(s->self, t, 1, &u, &s->y, &s->clock))) return 0;
  }
  return 1;
}

int main(int argc, char* argv[]) {
  static instance far, near;
  int sound = argc == 3;
  if (!sound) fprintf(stderr, "two words are needed: URI PARAMETERS\n");
  sound = sound && start(&far, tandem_remote(), argv[1]) && start(&near, tandem_subsystem(), argv[2]);
  sound = sound && drive(&far) && drive(&near) && far.y.size == near.y.size;
  sound = sound && memcmp(far.rows, near.rows, sizeof far.rows) == 0;
  if (far.self) far.api->destroy(far.self);
  if (near.self) near.api->destroy(near.self);
  if (sound) printf("%d samples, the same to the last bit\n", (int)near.y.size);
  return sound ? 0 : 1;
}
