/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
#include "subsystem_c_layout.h"

extern const size_t layout_in_c[];
extern const size_t layout_in_c_count;
const size_t layout_in_c[] = LAYOUT;
const size_t layout_in_c_count = sizeof layout_in_c / sizeof layout_in_c[0];
