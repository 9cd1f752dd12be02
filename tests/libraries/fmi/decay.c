/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* x' = -k x from 1 (G. Dahlquist's equation); Euler's steps of 0.1 s: 0.9^n. */
#include <math.h>

#include "fmu.h"

enum { t, x, dx, k };
const fmu_model model = {"decay-1", 1, 0, {x}, {dx}, 0.1, 1, 0};

void set_start(fmu_values* m) { m->v[x] = 1, m->v[k] = 1, m->next_event = INFINITY; }
void compute(fmu_values* m) { m->v[dx] = -m->v[k] * m->v[x]; }
void read_indicators(const fmu_values* m, double* z) { (void)m, (void)z; }
int act(fmu_values* m) {
  (void)m;
  return 0;
}
