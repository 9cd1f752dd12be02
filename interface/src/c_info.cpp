// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "c_info.hpp"

#include "tandem/error.hpp"

namespace tandem {
namespace {

[[noreturn]] void refuse(const std::string& sentence) { throw Error(ErrorCode::invalid_argument, sentence); }

std::vector<Port> ports_from(const tandem_port* ports, int32_t count) {
  if (count < 0 || (count > 0 && !ports))
    refuse("the subsystem gives " + std::to_string(count) + " ports without a list of them");
  std::vector<Port> list;
  for (const tandem_port* p = ports; p != ports + count; ++p) {
    if (!p->name || !p->unit)
      refuse("the subsystem's port " + std::to_string(p - ports) +
             " has no name or no unit; allowed is \"1\" for none");
    list.push_back({p->name, p->unit, p->size, p->derivatives, p->start});
  }
  return list;
}

void mark_held(SubsystemInfo& info, const std::int32_t* held) {
  for (std::size_t i = 0; held && i < info.outputs.size(); ++i) {
    if (held[i] != 0 && held[i] != 1)
      refuse("the subsystem '" + info.name + "' gives " + std::to_string(held[i]) + " for whether output '" +
             info.outputs[i].name + "' is held; allowed are 0 and 1");
    info.outputs[i].held = held[i] == 1;
  }
  if (info.abilities.sampled && !held)
    for (Port& port : info.outputs) port.held = true;
}

}  // namespace

SubsystemInfo info_from(const tandem_info* c, const std::int32_t* held, const double* nominal) {
  if (!c) refuse("the subsystem gives no info");
  SubsystemInfo info;
  if (!c->name) refuse("the subsystem gives no name");
  info.name = c->name;
  info.inputs = ports_from(c->inputs, c->input_count);
  info.outputs = ports_from(c->outputs, c->output_count);
  if (c->feedthrough_count < 0 || (c->feedthrough_count > 0 && !c->feedthrough))
    refuse("the subsystem '" + info.name + "' gives no list of its feedthrough");
  for (int32_t i = 0; i < c->feedthrough_count; ++i)
    info.feedthrough.push_back({c->feedthrough[i].output, c->feedthrough[i].input});
  info.abilities = abilities_from(c->abilities);
  mark_held(info, held);
  for (std::size_t i = 0; nominal && i < info.outputs.size(); ++i) info.outputs[i].nominal = nominal[i];
  return info;
}

}  // namespace tandem
