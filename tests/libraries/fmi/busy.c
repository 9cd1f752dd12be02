/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* x' = u - x, which takes as long as `work` dependent sums; only where x or u have changed. */
#include <math.h>

#include "fmu.h"

enum { t, x, dx, u, seen_x, seen_u };
enum { work, known };
const fmu_model model = {"busy-1", 1, 0, {x}, {dx}, 0, 1, 0};

void set_start(fmu_values* m) { m->v[x] = 1, m->w[work] = 100, m->next_event = INFINITY; }
void compute(fmu_values* m) {
  double sum = m->v[u] - m->v[x];
  int k;
  if (m->w[known] && m->v[x] == m->v[seen_x] && m->v[u] == m->v[seen_u]) return;
  for (k = 0; k < m->w[work]; ++k) sum = sum * 0.9999999999 + 1e-30;
  m->v[dx] = sum;
  m->v[seen_x] = m->v[x], m->v[seen_u] = m->v[u], m->w[known] = 1;
}
void read_indicators(const fmu_values* m, double* z) { (void)m, (void)z; }
int act(fmu_values* m) {
  (void)m;
  return 0;
}
