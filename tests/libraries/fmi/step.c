/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
#include <string.h>

#include "fmu.h"

/* At `dt` after the step's begin, where inputs were `begin`. */
static void rates_at(fmu_values* m, const double* begin, double t, double dt, double* dx) {
  int k;
  for (k = 0; k < most_reals; ++k)
    if (m->input_rates[k][0] != 0 || m->input_rates[k][1] != 0)
      m->v[k] = begin[k] + dt * (m->input_rates[k][0] + 0.5 * dt * m->input_rates[k][1]);
  m->v[0] = t + dt;
  compute(m);
  for (k = 0; k < model.states; ++k) dx[k] = m->v[model.rate[k]];
}

void take_step(fmu_values* m, double t, double h, void (*at_stage)(void* of, double t), void* of) {
  static const double at[] = {0, 0.5, 0.5, 1};
  double begin[most_reals], k[4][most_states], x[most_states];
  int stage, i;
  memcpy(begin, m->v, sizeof begin);
  for (i = 0; i < model.states; ++i) x[i] = m->v[model.state[i]];
  for (stage = 0; stage < model.stages; ++stage) {
    for (i = 0; i < model.states; ++i)
      m->v[model.state[i]] = x[i] + (stage > 0 ? at[stage] * h * k[stage - 1][i] : 0);
    if (at_stage) at_stage(of, t + at[stage] * h);
    rates_at(m, begin, t, at[stage] * h, k[stage]);
  }
  for (i = 0; i < model.states; ++i)
    m->v[model.state[i]] =
        x[i] + (model.stages == 1 ? h * k[0][i] : h / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]));
  for (i = 0; i < most_reals; ++i)
    if (m->input_rates[i][0] != 0 || m->input_rates[i][1] != 0) m->v[i] = begin[i];
  m->v[0] = t + h;
  compute(m);
}
