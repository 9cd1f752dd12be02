/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
__attribute__((visibility("default"))) const char* zlibVersion(void);
const char* zlibVersion(void) { return "own"; }
