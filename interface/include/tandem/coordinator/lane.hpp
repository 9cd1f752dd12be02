// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tandem {

/// One scalar output on its way to one scalar input of the reader: gain * output + offset.
struct Lane {
  int output;  ///< flattened index in the source
  int slot;    ///< where the reader's Signal is written
  double gain = 1.0, offset = 0.0;
  bool held = false;  ///< the output is
};

}  // namespace tandem
