/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* x'' = mu (1 - x^2) x' - x from 2, 0. */
#include <math.h>

#include "fmu.h"

enum { t, x, v, dv, mu };
const fmu_model model = {"van_der_pol-1", 2, 0, {x, v}, {v, dv}, 0, 4, 0};

void set_start(fmu_values* m) { m->v[x] = 2, m->v[mu] = 1, m->next_event = INFINITY; }
void compute(fmu_values* m) { m->v[dv] = m->v[mu] * (1 - m->v[x] * m->v[x]) * m->v[v] - m->v[x]; }
void read_indicators(const fmu_values* m, double* z) { (void)m, (void)z; }
int act(fmu_values* m) {
  (void)m;
  return 0;
}
