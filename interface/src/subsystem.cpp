// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/subsystem.hpp"

#include "tandem/error.hpp"

namespace tandem {
namespace {
[[noreturn]] void refuse(const SubsystemInfo& info) {
  throw Error(ErrorCode::not_supported, "subsystem '" + info.name + "' has no ability to save its state");
}
}  // namespace

std::string Scalar::name() const {
  return port->size == 1 ? port->name : port->name + "[" + std::to_string(element) + "]";
}

Scalar scalar_at(const std::vector<Port>& ports, int index) {
  auto port = ports.begin();
  for (; index >= port->size; ++port) index -= port->size;
  return {&*port, index};
}

StateId Subsystem::save_state() { refuse(info()); }
Clock Subsystem::restore_state(StateId) { refuse(info()); }
void Subsystem::release_state(StateId) { refuse(info()); }

}  // namespace tandem
