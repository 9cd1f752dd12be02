/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* A peer of tandem in C99 with POSIX sockets: serves a subsystem to others, or drives one that others serve,
 * by the protocol of docs/wire_protocol.md. Compile peer.c into the program; beside it only the headers of
 * the contract are needed (tandem/subsystem.h, tandem/signal.h). */
#ifndef TANDEM_PEER_H
#define TANDEM_PEER_H
#include "tandem/subsystem.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Serves instances of the subsystem; made to be the whole of a program's main. Arguments, from argv[1] on:
 * - `--listen URI`: at tcp://HOST:PORT (port 0: a free one) or unix:PATH; prints "serving at URI"
 * - `--once`: ends after one session, of a client that has said hello
 * - `--sessions N`: most sessions at a time (16)
 * - `--deadline S`: seconds for a frame to come, or to be taken, whole (5)
 * - `--idle S`: seconds to wait for the next request (3600)
 * - `--allow-plaintext`: also beyond this machine
 *
 * Without --listen it serves one session on the socket whose number the variable TANDEM_FD holds, as the URI
 * spawn:PROGRAM has it. With --listen each session is a process of its own (fork) with an instance of its
 * own; SIGTERM and SIGINT end the sessions and the server. Returns the program's exit status: 0; 1 if the
 * session of --once or TANDEM_FD broke; 2 if an argument is wrong or nothing can listen there. Errors are
 * told on standard error. */
int tandem_serve(const tandem_subsystem_api* api, int argc, char* const argv[]);

/* A subsystem elsewhere, by the same table of functions as one in this process. `create` takes a URI in place
 * of the parameters: tcp://HOST:PORT, unix:PATH or spawn:COMMAND, then, after a '?', key=value pairs joined
 * by '&'. The key deadline is its own (seconds to connect, and for each reply; 5), all others go to the
 * subsystem. Each call is one request and one reply. last_error names the address, the call and the time in
 * the run. An error of the connection ends its use: every later call gives TANDEM_WRONG_STATE. Samples are
 * checked: sizes, times that rise up to the limit, finite values, a clock of the newest row. destroy ends the
 * program of spawn:. */
const tandem_subsystem_api* tandem_remote(void);

/* What its `create` does. allow_plaintext: connect beyond this machine, where others may read and change. */
tandem_status tandem_connect(const char* uri, int allow_plaintext, void** self);

/* Doubles in a row of samples, tandem_samples.stride: time, jump flag, outputs and their derivatives. */
int64_t tandem_row_size(const tandem_info* info);

#ifdef __cplusplus
}
#endif
#endif
