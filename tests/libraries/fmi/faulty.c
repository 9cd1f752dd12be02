/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* x' = -x, and from 0.5 s on what `how` says: 1 a fault, 2 a step without end, 3 words on stdout, 4 an exit, 5 another
 * way of rounding. At 20 s: 6 a time that is a step ahead, once; 7 one that stays. */
#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "fmu.h"

enum { t, x, dx };
enum { how };
const fmu_model model = {"faulty-1", 1, 0, {x}, {dx}, 0, 1, 0};

void set_start(fmu_values* m) { m->v[x] = 1, m->next_event = INFINITY; }
void compute(fmu_values* m) {
  m->v[dx] = -m->v[x];
  if (m->v[t] < 0.5) return;
  if (m->w[how] == 1) *(volatile int*)NULL = 1;
  while (m->w[how] == 2) m->w[how] = m->w[how] == 2 ? 2 : 0;
  if (m->w[how] == 3) puts("a word of the FMU");
  if (m->w[how] == 4) exit(0);
  if (m->w[how] == 5) fesetround(FE_DOWNWARD);
}
void read_indicators(const fmu_values* m, double* z) { (void)m, (void)z; }
int act(fmu_values* m) {
  if (m->w[how] == 6 && fabs(m->v[t] - 20) < 1e-6) m->v[t] += 0.1;
  if (m->w[how] == 7 && m->v[t] > 20) m->v[t] = 20;
  return 0;
}
