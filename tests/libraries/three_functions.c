/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* A library of three functions: x' = u - x by Euler's method with steps of 0.01 s, from x = 1; y = (x, u). */
static double x;

void initiate(void);
void step(const double* inputs, double* outputs);
void clean_up(void);

void initiate(void) { x = 1.0; }

void step(const double* inputs, double* outputs) {
  x += 0.01 * (inputs[0] - x);
  outputs[0] = x;
  outputs[1] = inputs[0];
}

void clean_up(void) { x = -1e9; }
