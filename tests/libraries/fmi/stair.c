/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* A count that rises by one each second, to its end at 4; `seen` is what u was at the last rise. */
#include <math.h>

#include "fmu.h"

enum { t, u, seen };
enum { count, last };
const fmu_model model = {"stair-1", 0, 0, {0}, {0}, 0, 1, 0};

void set_start(fmu_values* m) { m->w[last] = 4, m->next_event = 1; }
void compute(fmu_values* m) { (void)m; }
void read_indicators(const fmu_values* m, double* z) { (void)m, (void)z; }
int act(fmu_values* m) {
  while (m->v[t] >= m->next_event - 1e-9) ++m->w[count], m->next_event += 1, m->v[seen] = m->v[u];
  m->ended = m->w[count] >= m->w[last];
  return 0;
}
