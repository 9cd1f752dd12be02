// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tandem::mbs::solvers {

/// While one lives, the BLAS that the program runs with uses a single thread: blocks of these sizes are done
/// sooner than threads wake up, and runs in parallel would fight for the processor. Knows OpenBLAS and BLIS,
/// by their functions, if they are loaded; the reference BLAS and ATLAS of Debian have one thread anyway. The
/// number of threads belongs to the process, so another thread that sets it meanwhile is not heard.
class OneBlasThread {
 public:
  OneBlasThread();
  ~OneBlasThread();
  OneBlasThread(const OneBlasThread&) = delete;
  OneBlasThread& operator=(const OneBlasThread&) = delete;

 private:
  int before_;
};

}  // namespace tandem::mbs::solvers
