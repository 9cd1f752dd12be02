/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
#define _DEFAULT_SOURCE /* sigaction, kill */
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "octave_peer.h"
#ifdef __linux__
#include <sys/prctl.h>
#endif

static volatile sig_atomic_t told; /* the signal that has come */
static void note(int number) { told = number; }

/* The status of the process that serves, to which signals are handed on. */
static int wait_for_server(pid_t server) {
  struct sigaction action, terminate, interrupt;
  sigset_t both, before;
  int status = 0;
  memset(&action, 0, sizeof action);
  action.sa_handler = note;
  told = 0;
  sigaction(SIGTERM, &action, &terminate);
  sigaction(SIGINT, &action, &interrupt);
  sigemptyset(&both);
  sigaddset(&both, SIGTERM);
  sigaddset(&both, SIGINT);
  sigprocmask(SIG_UNBLOCK, &both, &before);
  while (waitpid(server, &status, WNOHANG) == 0) {
    if (told) kill(server, told);
    poll(NULL, 0, 10);
  }
  sigaction(SIGTERM, &terminate, NULL);
  sigaction(SIGINT, &interrupt, NULL);
  sigprocmask(SIG_SETMASK, &before, NULL);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

/* Sessions begin and end in a process without Octave's threads: one of them waits for all signals, and where
 * a session's end wakes it, takes the one that is to end the server. */
static int serve_apart(const tandem_subsystem_api* model, int count, char** words) {
  const pid_t parent = getpid();
  pid_t server;
  fflush(NULL);
  server = fork();
  if (server < 0) mexErrMsgTxt("tandem_serve: no process for the server");
  if (server > 0) return wait_for_server(server);
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGTERM); /* ended with this process, also if it is killed */
#endif
  if (getppid() != parent) _exit(0);
  {
    const int status = tandem_serve(model, count, words);
    fflush(NULL);
    _exit(status);
  }
}

/* A session of spawn: is alone, and ends with its socket. */
void serve_model(mxArray** out, int count, const mxArray** in) {
  char* words[18] = {"tandem_serve"};
  const tandem_subsystem_api* model;
  int k;
  if (count > 19) mexErrMsgTxt("tandem_serve: too many arguments");
  for (k = 2; k < count; ++k) words[k - 1] = mxArrayToString(in[k]);
  model = octave_model((mxArray*)in[0], (mxArray*)in[1]);
  out[0] = mxCreateDoubleScalar(getenv("TANDEM_FD") ? tandem_serve(model, count - 1, words)
                                                    : serve_apart(model, count - 1, words));
}
