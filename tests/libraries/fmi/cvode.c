/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* x' = -k x, and in Co-Simulation steps by a CVODE of its own, whose symbols are visible to all. */
#include <cvode/cvode.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include "fmu.h"

enum { t, x, dx, k };
const fmu_model model = {"cvode-1", 1, 0, {x}, {dx}, 0, 1, 0};

void set_start(fmu_values* m) { m->v[x] = 1, m->v[k] = 1, m->next_event = INFINITY; }
void compute(fmu_values* m) { m->v[dx] = -m->v[k] * m->v[x]; }
void read_indicators(const fmu_values* m, double* z) { (void)m, (void)z; }
int act(fmu_values* m) {
  (void)m;
  return 0;
}

static int rate(realtype time, N_Vector y, N_Vector dy, void* of) {
  (void)time;
  NV_Ith_S(dy, 0) = -((fmu_values*)of)->v[k] * NV_Ith_S(y, 0);
  return 0;
}

void take_step(fmu_values* m, double begin, double h, void (*at_stage)(void* of, double t), void* of) {
  SUNContext context;
  N_Vector y;
  SUNMatrix matrix;
  SUNLinearSolver solver;
  void* cvode;
  realtype reached;
  (void)at_stage, (void)of;
  SUNContext_Create(NULL, &context);
  y = N_VNew_Serial(1, context), matrix = SUNDenseMatrix(1, 1, context);
  solver = SUNLinSol_Dense(y, matrix, context), cvode = CVodeCreate(CV_BDF, context);
  NV_Ith_S(y, 0) = m->v[x];
  CVodeInit(cvode, rate, begin, y), CVodeSStolerances(cvode, 1e-10, 1e-12);
  CVodeSetUserData(cvode, m), CVodeSetLinearSolver(cvode, solver, matrix);
  CVodeSetStopTime(cvode, begin + h);
  CVode(cvode, begin + h, y, &reached, CV_NORMAL);
  m->v[x] = NV_Ith_S(y, 0), m->v[0] = begin + h;
  CVodeFree(&cvode), SUNLinSolFree(solver), SUNMatDestroy(matrix), N_VDestroy(y), SUNContext_Free(&context);
  compute(m);
}
