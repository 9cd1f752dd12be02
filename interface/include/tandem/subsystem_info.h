/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* What a subsystem says of itself, in C99: its ports, feedthrough and abilities, and the parameters of its
 * kind. */
#ifndef TANDEM_SUBSYSTEM_INFO_H
#define TANDEM_SUBSYSTEM_INFO_H
#include <stdint.h>

/* A port of `size` >= 1 scalars (an array port is flattened in place). `name` is not NULL; `unit` is "1" for
 * none, "" where it is not said, which fits all. `start` is the value an input takes when nothing else is
 * known, NaN for none. `derivatives`: how many time derivatives an output gives with each sample, 0 to 3. */
typedef struct tandem_port {
  const char* name;
  const char* unit;
  int32_t size;
  int32_t derivatives;
  double start;
} tandem_port;

/* The scalar output (flattened index) at time t depends on that scalar input at the same t. */
typedef struct tandem_feedthrough {
  int32_t output;
  int32_t input;
} tandem_feedthrough;

enum {
  TANDEM_CHOOSES_STEP = 1, /* own steps vary */
  TANDEM_LANDS = 2,        /* can cut a step so that it ends at t_limit */
  TANDEM_SAVES_STATE = 4,
  TANDEM_RESTARTS = 8, /* may be initialized again after an advance */
  TANDEM_REACTIVE_INPUTS = 16,
  TANDEM_SERIALIZES_STATE = 32, /* gives saved states as bytes, and takes them */
  TANDEM_SAMPLED = 64,          /* acts at instants of its own only, and all its outputs are held */
  TANDEM_HOLDS = 128,           /* some outputs are held */
  /* returns where its outputs jump (TANDEM_STOP_EVENT), with two rows there, the second marked as a jump;
   * needs room for two rows in each call */
  TANDEM_EVENTS = 256
};

/* A parameter that a kind of subsystem takes. `unit`: that of a number, "1" for none; NULL: the parameter is
 * a word, any text without '&'. A number is finite, and written as in C ("1e-3"). `otherwise`: the text that
 * stands where none is given; NULL: one has to be. `sentence`: what it is. No name is there twice, nor holds
 * '=' or '&'. */
typedef struct tandem_parameter {
  const char* name;
  const char* unit;
  const char* otherwise;
  const char* sentence;
} tandem_parameter;

typedef struct tandem_info {
  const char* name;
  uint32_t abilities;
  int32_t input_count, output_count, feedthrough_count;
  const tandem_port* inputs;
  const tandem_port* outputs;
  const tandem_feedthrough* feedthrough;
} tandem_info;

#endif
