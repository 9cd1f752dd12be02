/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* A small FMU of both kinds: fmu.c makes it one of FMI 2.0, fmu3.c of 3.0. A model has real variables v[],
 * whole ones w[] (integers, booleans, enumerations), and the functions below. Co-Simulation takes whole own
 * steps of `fixed_step` by Euler's or the classical Runge-Kutta method. Variable 0 is time. */
#ifndef TANDEM_TEST_FMU_H
#define TANDEM_TEST_FMU_H

enum { most_reals = 16, most_wholes = 8, most_states = 4, most_indicators = 2 };

typedef struct {
  double v[most_reals];
  int w[most_wholes];
  double input_rates[most_reals][2]; /* first and second derivatives of inputs */
  double next_event;                 /* infinite for none */
  double step_begin;
  int ended;
  char text[32];
} fmu_values;

typedef struct {
  const char* guid;
  int states, indicators;
  int state[most_states], rate[most_states]; /* variables */
  double fixed_step;                         /* of Co-Simulation; 0: steps are taken as they are asked for */
  int stages;                                /* of its method: 1 or 4 */
  int (*size)(const fmu_values*, unsigned reference); /* of arrays in 3.0, of which the size of states is one;
                                                         null: all is scalar */
} fmu_model;

extern const fmu_model model;
void set_start(fmu_values* m);
/* Everything that follows at once from states, inputs and parameters. */
void compute(fmu_values* m);
void read_indicators(const fmu_values* m, double* z);
/* What happens at an event. Whether states have other values. */
int act(fmu_values* m);

/* The derivative of a state that is a variable. 0: there is none. */
static inline int derive_state(fmu_values* m, unsigned reference, int order, double* rate) {
  int k;
  compute(m);
  for (k = 0; k < model.states && order == 1; ++k)
    if ((unsigned)model.state[k] == reference) return *rate = m->v[model.rate[k]], 1;
  return 0;
}

/* Of Co-Simulation, from t on. at_stage(of, t): before rates are computed; null: none. */
void take_step(fmu_values* m, double t, double h, void (*at_stage)(void* of, double t), void* of);

#endif
