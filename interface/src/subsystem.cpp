// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/subsystem.hpp"

#include "tandem/error.hpp"

namespace tandem {
namespace {
[[noreturn]] void refuse(const SubsystemInfo& info) {
  throw Error(ErrorCode::not_supported, "subsystem '" + info.name + "' has no ability to save its state");
}
[[noreturn]] void refuse_numbers(const SubsystemInfo& info) {
  throw Error(ErrorCode::not_supported, "subsystem '" + info.name + "' does not give its states as numbers");
}
[[noreturn]] void refuse_bytes(const SubsystemInfo& info) {
  throw Error(ErrorCode::not_supported,
              "subsystem '" + info.name + "' has no ability to give its state as bytes");
}
}  // namespace

std::vector<std::string> Subsystem::remarks(double) const { return {}; }

std::vector<Figure> Subsystem::figures() const { return {}; }

std::uint32_t to_bits(const SubsystemInfo& info) {
  const Abilities& a = info.abilities;
  std::uint32_t bits = 0;
  const auto add = [&](bool has, std::uint32_t bit) { bits |= has ? bit : 0U; };
  add(a.chooses_step, TANDEM_CHOOSES_STEP);
  add(a.lands, TANDEM_LANDS);
  add(a.saves_state, TANDEM_SAVES_STATE);
  add(a.restarts, TANDEM_RESTARTS);
  add(a.reactive_inputs, TANDEM_REACTIVE_INPUTS);
  add(a.serializes_state, TANDEM_SERIALIZES_STATE);
  add(a.sampled, TANDEM_SAMPLED);
  add(info.holds(), TANDEM_HOLDS);
  add(a.events, TANDEM_EVENTS);
  return bits;
}

Abilities abilities_from(std::uint32_t bits) {
  const auto has = [bits](std::uint32_t bit) { return (bits & bit) != 0; };
  return {has(TANDEM_CHOOSES_STEP), has(TANDEM_LANDS),           has(TANDEM_SAVES_STATE),
          has(TANDEM_RESTARTS),     has(TANDEM_REACTIVE_INPUTS), has(TANDEM_SERIALIZES_STATE),
          has(TANDEM_SAMPLED),      has(TANDEM_EVENTS)};
}

std::string Scalar::name() const {
  return port->size == 1 ? port->name : port->name + "[" + std::to_string(element) + "]";
}

Scalar scalar_at(const std::vector<Port>& ports, int index) {
  auto port = ports.begin();
  for (; index >= port->size; ++port) index -= port->size;
  return {&*port, index};
}

bool Subsystem::one_thread() const { return false; }

bool Subsystem::start_advance(double, bool, std::span<const Signal>, const Samples&) { return false; }

Clock Subsystem::finish_advance(Samples&) {
  throw Error(ErrorCode::wrong_state, "subsystem '" + info().name + "' has no advance under way to finish");
}

Clock Subsystem::sample(double, SamplePart, std::span<const double>, std::span<double>) {
  throw Error(ErrorCode::not_supported, "subsystem '" + info().name + "' is not sampled");
}

std::optional<std::vector<StateName>> Subsystem::states() const { return {}; }
void Subsystem::get_states(std::span<double>) const { refuse_numbers(info()); }
void Subsystem::set_states(std::span<const double>) { refuse_numbers(info()); }
std::optional<Linearized> Subsystem::linearized() const { return {}; }
std::shared_ptr<SlowModel> Subsystem::slow_model(std::span<const SlowLink>) const { return nullptr; }

StateId Subsystem::save_state() { refuse(info()); }
Clock Subsystem::restore_state(StateId) { refuse(info()); }
void Subsystem::release_state(StateId) { refuse(info()); }
std::vector<std::byte> Subsystem::serialize_state(StateId) { refuse_bytes(info()); }
StateId Subsystem::deserialize_state(std::span<const std::byte>) { refuse_bytes(info()); }

}  // namespace tandem
