/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* Sizes and offsets of every type in subsystem.h, in the order of its text, as this compiler lays them out.
 */
#ifndef SUBSYSTEM_C_LAYOUT_H
#define SUBSYSTEM_C_LAYOUT_H
#include <stddef.h>

#include "tandem/subsystem.h"

#define LAYOUT                                                                                               \
  {                                                                                                          \
    sizeof(tandem_status), sizeof(tandem_stop), sizeof(tandem_segment), offsetof(tandem_segment, end),       \
        offsetof(tandem_segment, origin), offsetof(tandem_segment, c), sizeof(tandem_signal),                \
        offsetof(tandem_signal, segments), offsetof(tandem_signal, count), offsetof(tandem_signal, degree),  \
        offsetof(tandem_signal, reactive), sizeof(tandem_samples), offsetof(tandem_samples, rows),           \
        offsetof(tandem_samples, stride), offsetof(tandem_samples, capacity),                                \
        offsetof(tandem_samples, size), sizeof(tandem_clock), offsetof(tandem_clock, time),                  \
        offsetof(tandem_clock, next_time), offsetof(tandem_clock, stop), offsetof(tandem_clock, reserved),   \
        sizeof(tandem_port), offsetof(tandem_port, name), offsetof(tandem_port, unit),                       \
        offsetof(tandem_port, size), offsetof(tandem_port, derivatives), offsetof(tandem_port, start),       \
        sizeof(tandem_feedthrough), offsetof(tandem_feedthrough, output),                                    \
        offsetof(tandem_feedthrough, input), sizeof(tandem_info), offsetof(tandem_info, name),               \
        offsetof(tandem_info, abilities), offsetof(tandem_info, input_count),                                \
        offsetof(tandem_info, output_count), offsetof(tandem_info, feedthrough_count),                       \
        offsetof(tandem_info, inputs), offsetof(tandem_info, outputs), offsetof(tandem_info, feedthrough),   \
        sizeof(tandem_subsystem_api), offsetof(tandem_subsystem_api, create),                                \
        offsetof(tandem_subsystem_api, advance), offsetof(tandem_subsystem_api, release_state),              \
        offsetof(tandem_subsystem_api, serialize_state), offsetof(tandem_subsystem_api, parameters),         \
        offsetof(tandem_subsystem_api, nominal), sizeof(tandem_parameter), offsetof(tandem_parameter, unit), \
        offsetof(tandem_parameter, otherwise), offsetof(tandem_parameter, sentence)                          \
  }

#endif
