/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* One that brings a function which the program has, too: whether it gets its own. */
#include <math.h>

#include "fmu.h"

enum { own };
const fmu_model model = {"symbols-1", 0, 0, {0}, {0}, 0, 1, 0};

const char* zlibVersion(void); /* symbols_own.c */

void set_start(fmu_values* m) { m->next_event = INFINITY; }
void compute(fmu_values* m) { m->w[own] = zlibVersion()[0] == 'o'; }
void read_indicators(const fmu_values* m, double* z) { (void)m, (void)z; }
int act(fmu_values* m) {
  (void)m;
  return 0;
}
