/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* A subsystem written in C99 against tandem/subsystem.h alone: a damped oscillator
 *   m x'' = F - c x' - k x
 * by the classical Runge-Kutta method with a fixed step. Input F [N], start 0; outputs x [m] with two
 * derivatives, v [m/s] with one, a [m/s^2], which follows F at once. Parameters m, c, k, h, x0, v0. */
#ifndef C_OSCILLATOR_H
#define C_OSCILLATOR_H
#include "tandem/subsystem.h"

#ifdef __cplusplus
extern "C" {
#endif

const tandem_subsystem_api* c_oscillator(void);

#ifdef __cplusplus
}
#endif
#endif
