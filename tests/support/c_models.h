/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* Models in C99 by tandem/fixed_step.h and tandem/sampled.h. */
#ifndef C_MODELS_H
#define C_MODELS_H
#include "tandem/subsystem.h"

#ifdef __cplusplus
extern "C" {
#endif

/* x' = gain u by Simpson's rule, or with rule=euler by Euler's. Input u [m/s], outputs x [m] and the number
 * of its steps. It fails where a step ends past `fails_at`. */
const tandem_subsystem_api* c_integral(void);

/* A switch: r [m/s], which holds, is 1, -1 from where its input x rises above `width`, and 1 again from where
 * it falls below -`width`. c [m], the integral of r and r itself, jumps with it. */
const tandem_subsystem_api* c_switch(void);

/* x' = u by the rule of the middle with steps of 0.07 s, and y = x + u, which follows u at once. */
const tandem_subsystem_api* c_follower(void);

/* Sums its input at each of its instants; with a gain the output follows that at once. */
const tandem_subsystem_api* c_sum(void);

#ifdef __cplusplus
}
#endif
#endif
