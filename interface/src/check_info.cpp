// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/check_info.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_set>

#include "number_text.hpp"
#include "tandem/error.hpp"

namespace tandem {
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw Error(ErrorCode::invalid_argument, "subsystem '" + name + "': " + what);
}

void check_unique(const std::string& name, const std::vector<Port>& ports) {
  std::unordered_set<std::string_view> seen;
  for (const Port& port : ports)
    if (!seen.insert(port.name).second)
      refuse(name, "port '" + port.name + "' is there twice among its inputs or outputs");
}

void check_port(const std::string& name, const Port& port) {
  if (port.name.empty() || port.name.find_first_of("[] \t\n\",") != std::string::npos || port.size < 1 ||
      port.derivatives < 0 || port.derivatives > 3 ||
      (!port.starts.empty() && std::ssize(port.starts) != port.size))
    refuse(name, "port '" + port.name + "' has size " + std::to_string(port.size) + " and " +
                     std::to_string(port.derivatives) +
                     " derivatives; allowed are a name without [ ] , \" and blanks, a size from 1, 0 to 3 "
                     "derivatives, and as many start values as it has scalars");
}

void check_ports(const std::string& name, const std::vector<Port>& ports) {
  check_unique(name, ports);
  long long scalars = 0;
  for (const Port& port : ports) {
    check_port(name, port);
    scalars += port.size;
    if (scalars > most_scalars)
      refuse(name, "port '" + port.name + "' of size " + std::to_string(port.size) + " brings its ports to " +
                       std::to_string(scalars) + " scalars; allowed are up to " +
                       std::to_string(most_scalars));
  }
}

void check_nominal(const std::string& name, const std::vector<Port>& outputs) {
  for (const Port& port : outputs)
    if (!(port.nominal > 0.0) || !std::isfinite(port.nominal))
      refuse(name, "output '" + port.name + "' has the nominal value " + number_text(port.nominal) +
                       "; allowed is a number above 0");
}

void check_held(const std::string& name, const SubsystemInfo& info) {
  for (const Port& port : info.inputs)
    if (port.held) refuse(name, "input '" + port.name + "' is held; allowed is that of outputs");
  for (const Port& port : info.outputs)
    if (port.held && port.derivatives > 0)
      refuse(name, "output '" + port.name + "' is held and gives " + std::to_string(port.derivatives) +
                       " derivatives; allowed is none, as it is constant");
}

void check_sampling(const std::string& name, const SubsystemInfo& info) {
  const auto& [period, latency] = info.sampling;
  if (!info.abilities.sampled) {
    if (period != 0.0 || latency != 0.0) refuse(name, "has a period or latency, but is not sampled");
    return;
  }
  if (!(period > 0.0) || !std::isfinite(period) || !(latency >= 0.0) || !std::isfinite(latency))
    refuse(name, "is sampled with a period of " + number_text(period) + " s and a latency of " +
                     number_text(latency) + " s; allowed are a period above 0, a latency of 0 or more");
  if (info.abilities.lands || info.abilities.chooses_step || info.abilities.reactive_inputs)
    refuse(name, "is sampled and lands, chooses its step or has reactive inputs; allowed is none of these");
  if (std::any_of(info.outputs.begin(), info.outputs.end(), [](const Port& port) { return !port.held; }))
    refuse(name, "is sampled, but not all of its outputs are held");
}

}  // namespace

void check_info(const std::string& name, const SubsystemInfo& info) {
  check_ports(name, info.inputs);
  check_ports(name, info.outputs);
  check_nominal(name, info.outputs);
  check_held(name, info);
  check_sampling(name, info);
  const int inputs = info.input_size(), outputs = info.output_size();
  for (const Feedthrough& f : info.feedthrough)
    if (f.input < 0 || f.input >= inputs || f.output < 0 || f.output >= outputs)
      refuse(name, "feedthrough from input " + std::to_string(f.input) + " to output " +
                       std::to_string(f.output) + " names a port that is not there");
}

}  // namespace tandem
