// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "reconstruction_rules.hpp"

#include "tandem/error.hpp"

namespace tandem {
namespace {

using Kind = Reconstruction::Kind;

[[noreturn]] void refuse_ports(const std::string& sentence) {
  throw Error(ErrorCode::invalid_argument, sentence);
}

[[noreturn]] void refuse_schedule(const std::string& sentence) {
  throw Error(ErrorCode::not_supported, sentence);
}

}  // namespace

Reconstruction reconstruction_of(const Connection& c, const Port& from, bool to_sampled,
                                 const std::string& what) {
  if (from.held && (!c.how || c.how->kind == Kind::held)) return {Kind::held};
  if (!c.how || c.how->kind == Kind::held)
    refuse_ports(what + " has no reconstruction; only a held output, which " + c.from +
                 " is not, needs none");
  if (from.held && c.how->kind != Kind::mean)
    refuse_ports(what + " is to be reconstructed by " + c.how->name() + ", but " + c.from +
                 " is held, constant from sample to sample; allowed is no reconstruction, or mean");
  if (from.derivatives < c.how->derivatives_read())
    refuse_ports(what + " is to be reconstructed by " + c.how->name() + ", but " + c.from +
                 " gives no derivative");
  if (to_sampled && c.how->kind == Kind::matched_hold)
    refuse_ports(what + " is a matched hold, which needs a reader that integrates itself; '" + c.to +
                 "' is of a sampled one");
  return *c.how;
}

void check_in_schedule(const Topology& topology, const Line& line, Schedule::Kind schedule,
                       bool source_ahead) {
  const auto refuse = [&](const std::string& why) {
    refuse_schedule("input " + topology.input_name(line.reader, line.input) + why);
  };
  const std::string by = " is reconstructed by " + line.how.name();
  const bool turns = schedule == Schedule::Kind::slowest_first || schedule == Schedule::Kind::fastest_first;
  if (schedule == Schedule::Kind::staggered && line.how.kind != Kind::matched_hold &&
      line.how.kind != Kind::held)
    refuse(by + "; schedule staggered takes matched_hold only");
  if (schedule == Schedule::Kind::parallel && line.how.kind == Kind::matched_hold)
    refuse(by + ", which needs subsystems that take turns; schedule parallel has none");
  if (line.how.kind == Kind::mean && !(turns && source_ahead))
    refuse(by + ", which needs a source that is ahead of its reader; in schedule " +
           std::string(Schedule::name(schedule)) + " '" + topology.name(line.source) + "' is not ahead of '" +
           topology.name(line.reader) + "'");
  if (line.lag == Lag::memory && topology.info(line.reader).abilities.chooses_step)
    refuse(" has a memory of one own step, but its subsystem chooses its steps; use a delay");
}

}  // namespace tandem
