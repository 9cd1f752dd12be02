/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* x' = A x + u of n states, n = 1 or 2, from x0; y = 2 x + u. */
#include <math.h>

#include "fmu.h"

enum { t, A, x0 = A + 4, u = x0 + 2, x = u + 2, dx = x + 2, y = dx + 2 };
enum { n };
static int size(const fmu_values* m, unsigned reference) {
  if (reference == A) return m->w[n] * m->w[n];
  return reference == x0 || reference == u || reference == x || reference == dx || reference == y ? m->w[n]
                                                                                                  : 1;
}
const fmu_model model = {"space-1", 2, 0, {x, x + 1}, {dx, dx + 1}, 0, 4, size};

void set_start(fmu_values* m) { m->w[n] = 2, m->v[A] = m->v[A + 3] = -1, m->next_event = INFINITY; }
void compute(fmu_values* m) {
  int i, j;
  for (i = 0; i < m->w[n]; ++i) {
    m->v[dx + i] = m->v[u + i], m->v[y + i] = 2 * m->v[x + i] + m->v[u + i];
    for (j = 0; j < m->w[n]; ++j) m->v[dx + i] += m->v[A + i * m->w[n] + j] * m->v[x + j];
  }
}
void read_indicators(const fmu_values* m, double* z) { (void)m, (void)z; }
/* Once, at the start. */
int act(fmu_values* m) {
  int i;
  if (m->w[1]) return 0;
  m->w[1] = 1;
  for (i = 0; i < m->w[n]; ++i) m->v[x + i] = m->v[x0 + i];
  return 1;
}
