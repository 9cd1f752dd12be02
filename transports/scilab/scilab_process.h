/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* A Scilab without display that answers requests, over two pipes with names. */
#ifndef TANDEM_SCILAB_PROCESS_H
#define TANDEM_SCILAB_PROCESS_H
#include <stddef.h>
#include <sys/types.h>

typedef struct scilab_process {
  pid_t pid; /* 0: it does not run */
  int requests, answers;
  char folder[200];
} scilab_process;

/* Starts Scilab with a script, in whose environment TANDEM_SCILAB_FOLDER names the folder of the pipes
 * `requests` and `answers`, and TANDEM_SCILAB the script that defines tandem_serve. 0, or -1 with errno. */
int scilab_start(scilab_process* self, const char* script, const char* tandem_serve);

/* All of it. 0, or -1: Scilab has ended. */
int scilab_write(scilab_process* self, const void* bytes, size_t size);
int scilab_read(scilab_process* self, void* bytes, size_t size);

/* Takes the names of the pipes away, which Scilab has opened: nothing is left behind, however this ends. */
void scilab_hide(const scilab_process* self);

/* Ends Scilab: by the end of its requests, or else by force after half a second. */
void scilab_stop(scilab_process* self);

#endif
