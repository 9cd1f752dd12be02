/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* A ball that falls from 1 m and keeps the part e of its speed at each bounce. */
#include <float.h>
#include <math.h>

#include "fmu.h"

enum { t, h, v, dv, e, g };
const fmu_model model = {"ball-1", 2, 1, {h, v}, {v, dv}, 0.01, 1, 0};

void set_start(fmu_values* m) {
  m->v[h] = 1, m->v[v] = 0, m->v[e] = 0.7, m->v[g] = -9.81, m->next_event = INFINITY;
}
void compute(fmu_values* m) { m->v[dv] = m->v[g]; }
void read_indicators(const fmu_values* m, double* z) { z[0] = m->v[h]; }
int act(fmu_values* m) {
  if (m->v[h] > 0 || m->v[v] > 0) return 0;
  m->v[h] = DBL_MIN;
  m->v[v] *= -m->v[e];
  return 1;
}
