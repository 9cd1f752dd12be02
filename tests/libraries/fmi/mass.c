/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* m x'' = k (u - x) - s x - d v + f: a mass on a spring to another, which is at u. F = k (u - x) follows u at
 * once. */
#include <math.h>

#include "fmu.h"

enum { t, x, v, a, u, force, mass, k, s, d, f };
const fmu_model model = {"mass-1", 2, 0, {x, v}, {v, a}, 0, 4, 0};

void set_start(fmu_values* m) {
  m->v[mass] = 1, m->v[k] = 1, m->v[s] = 1, m->v[x] = 1, m->next_event = INFINITY;
}
void compute(fmu_values* m) {
  m->v[force] = m->v[k] * (m->v[u] - m->v[x]);
  m->v[a] = (m->v[force] - m->v[s] * m->v[x] - m->v[d] * m->v[v] + m->v[f]) / m->v[mass];
}
void read_indicators(const fmu_values* m, double* z) { (void)m, (void)z; }
int act(fmu_values* m) {
  (void)m;
  return 0;
}
