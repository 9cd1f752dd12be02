/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* A stranger's library: to load it runs its code, which leaves the file `started` in the working folder. */
#include <stdio.h>

__attribute__((constructor)) static void tell(void) {
  FILE* const file = fopen("started", "w");
  if (file) fclose(file);
}
