/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* A free mass of 1 kg as a library of functions, with the mistake that MISTAKE names. */
#include "tandem/mbs/functions/model_functions.h"

#define UNUSED(x) (void)(x)
enum {
  none,
  version,
  table,
  lacks_forces,
  no_info,
  create_fails,
  forces_fail,
  not_finite,
  lopsided_mass,
  no_name,
  no_symbol
};

static int32_t mass(void* self, double t, const double* q, const double* v, double* m) {
  UNUSED(self), UNUSED(t), UNUSED(q), UNUSED(v);
  m[0] = m[3] = 1.0;
  m[1] = MISTAKE == lopsided_mass ? 0.5 : 0.0;
  m[2] = 0.0;
  return 0;
}
static int32_t nothing(void* self, double t, const double* q, const double* v, double* none_) {
  UNUSED(self), UNUSED(t), UNUSED(q), UNUSED(v), UNUSED(none_);
  return 0;
}
static int32_t forces(void* self, double t, const double* q, const double* v, double* force) {
  UNUSED(self), UNUSED(t), UNUSED(q), UNUSED(v);
  force[0] = 2.0;
  force[1] = MISTAKE == not_finite ? 1e308 * 10 : 0.0;
  return MISTAKE == forces_fail ? 7 : 0;
}
static int32_t create(void** self) {
  static int nobody;
  *self = &nobody;
  return MISTAKE == create_fails ? 1 : 0;
}
static void destroy(void* self) { UNUSED(self); }
static const char* last_error(void* self) {
  return UNUSED(self), MISTAKE == no_name ? "" : "the sentence of the library";
}
static const tandem_model_info* info(void* self) {
  static const char* const names[] = {"x", MISTAKE == no_name ? 0 : "y"};
  static const char* const units[] = {"m", "cm"};
  static const double q[] = {1.0, 2.0}, v[] = {3.0, 0.0};
  static const tandem_model_info all = {"free_mass", 2, 0, names, units, q, v};
  UNUSED(self);
  return MISTAKE == no_info ? 0 : &all;
}

const tandem_model_api* tandem_model(void) {
  static tandem_model_api api = {.abi_version = TANDEM_MODEL_ABI_VERSION + (MISTAKE == version),
                                 .table_size = sizeof(tandem_model_api) - (MISTAKE == table),
                                 .create = create,
                                 .destroy = destroy,
                                 .info = info,
                                 .last_error = last_error,
                                 .mass = mass,
                                 .constraints = nothing,
                                 .jacobian = nothing,
                                 .constraint_accelerations = nothing};
  if (MISTAKE != lacks_forces) api.forces = forces;
  return &api;
}
