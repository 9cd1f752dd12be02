/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* The terms of a multibody model as functions of a shared library, in C99:
 *   M q'' + Phi_q^T lambda = Q(t, q, q'),  Phi(t, q) = 0,  n variables, m constraints, SI units.
 * tandem integrates and asks for values; the library keeps no state but its parameters. A matrix is written
 * by columns. Each function writes all values of its term and returns 0, or a number other than 0, after
 * which last_error gives a sentence, valid until the next call on that instance. Arrays belong to the caller
 * and are valid during the call only; what info points to belongs to the library and lives until destroy.
 * Calls on one instance never overlap. No function may throw or longjmp through its caller. */
#ifndef TANDEM_MODEL_FUNCTIONS_H
#define TANDEM_MODEL_FUNCTIONS_H
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TANDEM_MODEL_ABI_VERSION 1

typedef struct tandem_model_info {
  const char* name;
  int32_t variables, constraints;    /* n >= 1, m >= 0 */
  const char* const* variable_names; /* n */
  const char* const* variable_units; /* n; NULL: "m" for all */
  const double* q;                   /* n: positions and velocities at the start, that satisfy Phi */
  const double* v;
} tandem_model_info;

/* The values of one term at time t, positions q, velocities v. */
typedef int32_t (*tandem_model_term)(void* self, double t, const double* q, const double* v, double* values);

/* The table of functions; new ones are added at its end only. */
typedef struct tandem_model_api {
  uint32_t abi_version; /* TANDEM_MODEL_ABI_VERSION */
  uint32_t table_size;  /* sizeof(tandem_model_api) of the one who built it */

  /* A new instance. On failure *self may still be an instance that last_error can be asked about; it is
   * destroyed in any case if not NULL. */
  int32_t (*create)(void** self);
  void (*destroy)(void* self);
  const tandem_model_info* (*info)(void* self);
  const char* (*last_error)(void* self);

  tandem_model_term mass;                     /* M, n x n; asked for once, with NULL for q and v */
  tandem_model_term constraints;              /* Phi, m; v is NULL */
  tandem_model_term jacobian;                 /* Phi_q, m x n by columns; v is NULL */
  tandem_model_term constraint_accelerations; /* gamma in Phi'' = Phi_q q'' + gamma, m */
  tandem_model_term forces;                   /* Q, n */

  /* NULL where there is none. */
  tandem_model_term constraint_rates; /* dPhi/dt, m; v is NULL. Without it: zero */
  tandem_model_term stiffness;        /* K = -dQ/dq, n x n. Without it Newton's iteration takes longer */
  tandem_model_term damping;          /* C = -dQ/dq', n x n. The same */
  tandem_model_term energy;           /* kinetic and potential, 1 */
} tandem_model_api;

/* The one symbol that the library exports: a function of this type named tandem_model. */
typedef const tandem_model_api* (*tandem_model_entry)(void);

#ifdef __cplusplus
}
#endif
#endif
