/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* The wide subsystem of tests/libraries as a server in C. */
#include "tandem/peer.h"

const tandem_subsystem_api* tandem_subsystem(void);

int main(int argc, char* argv[]) { return tandem_serve(tandem_subsystem(), argc, argv); }
