/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* A table of functions (mass2.c, pi.c) as a program: it serves at --listen URI, or the run that has started
 * it by spawn:. */
#include "tandem/peer.h"

extern const tandem_subsystem_api* tandem_subsystem(void);

int main(int argc, char* argv[]) { return tandem_serve(tandem_subsystem(), argc, argv); }
