/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* The double pendulum of double_pendulum.m as a shared library: it needs this header alone. */
#include "tandem/mbs/functions/model_functions.h"

#define UNUSED(x) (void)(x)

static int32_t mass(void* self, double t, const double* q, const double* v, double* m) {
  static const double rods[2][2] = {{2.0 / 3, 1.0 / 6}, {1.0 / 6, 1.0 / 3}};
  UNUSED(self), UNUSED(t), UNUSED(q), UNUSED(v);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) m[4 * j + i] = i % 2 == j % 2 ? rods[i / 2][j / 2] : 0.0;
  return 0;
}

static int32_t constraints(void* self, double t, const double* q, const double* v, double* phi) {
  const double x = q[2] - q[0], y = q[3] - q[1];
  UNUSED(self), UNUSED(t), UNUSED(v);
  phi[0] = q[0] * q[0] + q[1] * q[1] - 1.0;
  phi[1] = x * x + y * y - 1.0;
  return 0;
}

static int32_t jacobian(void* self, double t, const double* q, const double* v, double* phi_q) {
  const double x = q[2] - q[0], y = q[3] - q[1];
  const double columns[4][2] = {{2 * q[0], -2 * x}, {2 * q[1], -2 * y}, {0.0, 2 * x}, {0.0, 2 * y}};
  UNUSED(self), UNUSED(t), UNUSED(v);
  for (int i = 0; i < 8; ++i) phi_q[i] = columns[i / 2][i % 2];
  return 0;
}

static int32_t accelerations(void* self, double t, const double* q, const double* v, double* gamma) {
  const double x = v[2] - v[0], y = v[3] - v[1];
  UNUSED(self), UNUSED(t), UNUSED(q);
  gamma[0] = 2 * (v[0] * v[0] + v[1] * v[1]);
  gamma[1] = 2 * (x * x + y * y);
  return 0;
}

static int32_t forces(void* self, double t, const double* q, const double* v, double* force) {
  UNUSED(self), UNUSED(t), UNUSED(q), UNUSED(v);
  force[0] = force[2] = 0.0;
  force[1] = -9.81;
  force[3] = -9.81 * 0.5;
  return 0;
}

/* Nothing is kept in an instance; its address must only not be NULL. */
static int32_t create(void** self) {
  static int nothing;
  *self = &nothing;
  return 0;
}
static void destroy(void* self) { UNUSED(self); }
static const char* last_error(void* self) { return UNUSED(self), ""; }

static const tandem_model_info* info(void* self) {
  static const char* const names[] = {"elbow_x", "elbow_y", "tip_x", "tip_y"};
  static const double q[] = {1.0, 0.0, 2.0, 0.0}, v[] = {0.0, 0.0, 0.0, 0.0};
  static const tandem_model_info all = {"double_pendulum", 4, 2, names, 0, q, v};
  return UNUSED(self), &all;
}

const tandem_model_api* tandem_model(void) {
  static const tandem_model_api api = {.abi_version = TANDEM_MODEL_ABI_VERSION,
                                       .table_size = sizeof(tandem_model_api),
                                       .create = create,
                                       .destroy = destroy,
                                       .info = info,
                                       .last_error = last_error,
                                       .mass = mass,
                                       .constraints = constraints,
                                       .jacobian = jacobian,
                                       .constraint_accelerations = accelerations,
                                       .forces = forces};
  return &api;
}
