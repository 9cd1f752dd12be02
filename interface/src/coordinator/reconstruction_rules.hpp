// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/coordinator/schedule.hpp"
#include "tandem/coordinator/topology.hpp"

namespace tandem {

// What a reconstruction may do: by what it joins, and by who goes first.

/// That of a connection from `from`; what: how sentences begin. Throws Error(invalid_argument) for none where one
/// is needed, and for one that the output, or a sampled reader, can't have.
Reconstruction reconstruction_of(const Connection& connection, const Port& from, bool to_sampled,
                                 const std::string& what);

/// Throws Error(not_supported) for one that the schedule can't honour. source_ahead: the source goes before the
/// reader. Precondition: both integrate themselves.
void check_in_schedule(const Topology& topology, const Line& line, Schedule::Kind schedule,
                       bool source_ahead);

}  // namespace tandem
