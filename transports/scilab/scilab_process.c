/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
#define _GNU_SOURCE
#include "scilab_process.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { longest_path = 256 };

/* Open at both ends, so that nobody waits for Scilab to open its own. */
static int make_pipe(const scilab_process* self, const char* name) {
  char path[longest_path];
  snprintf(path, sizeof path, "%s/%s", self->folder, name);
  return mkfifo(path, 0600) == 0 ? open(path, O_RDWR | O_CLOEXEC) : -1;
}

static void become_scilab(const scilab_process* self, const char* script, const char* tandem_serve) {
  const int nothing = open("/dev/null", O_RDONLY);
  setpgid(0, 0); /* scilab-cli is a shell that starts another program */
  setenv("TANDEM_SCILAB_FOLDER", self->folder, 1);
  setenv("TANDEM_SCILAB", tandem_serve, 1);
  unsetenv("DISPLAY");
  unsetenv("TANDEM_FD");
  dup2(nothing, STDIN_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO); /* what it prints is no answer */
  execlp("scilab-cli", "scilab-cli", "-nb", "-f", script, (char*)NULL);
  perror("scilab-cli");
  _exit(127);
}

int scilab_start(scilab_process* self, const char* script, const char* tandem_serve) {
  memset(self, 0, sizeof *self);
  self->requests = self->answers = -1;
  snprintf(self->folder, sizeof self->folder, "%s/tandem_scilab_XXXXXX",
           getenv("TMPDIR") ? getenv("TMPDIR") : "/tmp");
  if (!mkdtemp(self->folder) || (self->requests = make_pipe(self, "requests")) < 0 ||
      (self->answers = make_pipe(self, "answers")) < 0 || (self->pid = fork()) < 0)
    return -1;
  if (self->pid == 0) become_scilab(self, script, tandem_serve);
  return 0;
}

/* Whether it runs; if not, it is no child any more. */
static int runs(scilab_process* self) {
  if (self->pid > 0 && waitpid(self->pid, NULL, WNOHANG) == self->pid) self->pid = 0;
  return self->pid > 0;
}

/* Until the pipe is ready for so many bytes, or Scilab has ended. */
static int ready(scilab_process* self, int pipe, short event) {
  const int milliseconds = 100;
  struct pollfd one = {pipe, event, 0};
  while (poll(&one, 1, milliseconds) <= 0 || !(one.revents & event))
    if (!runs(self)) return 0;
  return 1;
}

int scilab_write(scilab_process* self, const void* bytes, size_t size) {
  const char* next = bytes;
  while (size > 0) {
    ssize_t count;
    if (!runs(self) || !ready(self, self->requests, POLLOUT)) return -1;
    count = write(self->requests, next, size);
    if (count < 0 && errno != EINTR) return -1;
    if (count > 0) next += count, size -= (size_t)count;
  }
  return 0;
}

int scilab_read(scilab_process* self, void* bytes, size_t size) {
  char* next = bytes;
  while (size > 0) {
    ssize_t count;
    if (!ready(self, self->answers, POLLIN)) return -1;
    count = read(self->answers, next, size);
    if (count < 0 && errno != EINTR) return -1;
    if (count > 0) next += count, size -= (size_t)count;
  }
  return 0;
}

void scilab_hide(const scilab_process* self) {
  char path[longest_path];
  snprintf(path, sizeof path, "%s/requests", self->folder);
  unlink(path);
  snprintf(path, sizeof path, "%s/answers", self->folder);
  unlink(path);
  rmdir(self->folder);
}

void scilab_stop(scilab_process* self) {
  const struct timespec moment = {0, 20000000};
  close(self->requests), close(self->answers); /* where it reads, it ends now */
  for (int k = 0; k < 25 && runs(self); ++k) nanosleep(&moment, NULL);
  if (runs(self)) {
    kill(-self->pid, SIGKILL);
    waitpid(self->pid, NULL, 0);
  }
  self->pid = 0;
  scilab_hide(self);
}
