/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* Outputs of each type that are the inputs; a count of events; the length of a text. */
#include <math.h>
#include <string.h>

#include "fmu.h"

enum { t, real_in, discrete_in, real_out, discrete_out };
enum { whole_in, flag_in, choice_in, whole_out, flag_out, choice_out, events, length };
const fmu_model model = {"types-1", 0, 0, {0}, {0}, 0, 1, 0};

void set_start(fmu_values* m) { m->w[choice_in] = 1, m->next_event = INFINITY; }
void compute(fmu_values* m) {
  m->v[real_out] = m->v[real_in];
  m->w[length] = (int)strlen(m->text);
}
void read_indicators(const fmu_values* m, double* z) { (void)m, (void)z; }
int act(fmu_values* m) {
  m->v[discrete_out] = m->v[discrete_in];
  m->w[whole_out] = m->w[whole_in], m->w[flag_out] = m->w[flag_in], m->w[choice_out] = m->w[choice_in];
  ++m->w[events];
  return 0;
}
