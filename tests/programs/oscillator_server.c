/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* The oscillator of the tests as a server in C. */
#include "c_oscillator.h"
#include "tandem/peer.h"

int main(int argc, char* argv[]) { return tandem_serve(c_oscillator(), argc, argv); }
