// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A library whose table, info, statuses, rows and clocks are any bytes: each call gives a result that fits,
// or an Error. Pointers are null or right, as what a wrong one points to can't be checked.
#include <fuzzer/FuzzedDataProvider.h>

#include <array>
#include <cstdlib>
#include <limits>

#include "tandem/c_subsystem.hpp"
#include "tandem/error.hpp"

namespace {

using namespace tandem;

FuzzedDataProvider* bytes = nullptr;

const char* any_name() {
  static const char* const names[] = {"x", "", "y", nullptr, "a name", "x", "[3]", "1"};
  return bytes->PickValueInArray(names);
}

double any_number() {
  static constexpr double odd[] = {0.0,
                                   0.1,
                                   1.0,
                                   -1.0,
                                   1e300,
                                   std::numeric_limits<double>::quiet_NaN(),
                                   std::numeric_limits<double>::infinity()};
  return bytes->ConsumeBool() ? bytes->PickValueInArray(odd) : bytes->ConsumeFloatingPoint<double>();
}

tandem_status any_status() {
  return bytes->ConsumeIntegralInRange(0, 3)
             ? TANDEM_OK
             : static_cast<tandem_status>(bytes->ConsumeIntegralInRange(-1, 8));
}

struct Described {
  std::array<tandem_port, 3> inputs, outputs;
  std::array<tandem_feedthrough, 3> feedthrough;
  tandem_info info;
};

tandem_port any_port() {
  return {any_name(), any_name(), bytes->ConsumeIntegralInRange(-1, 4), bytes->ConsumeIntegralInRange(-1, 4),
          any_number()};
}

void describe(Described& d) {
  for (auto* ports : {&d.inputs, &d.outputs})
    for (tandem_port& port : *ports) port = any_port();
  for (tandem_feedthrough& f : d.feedthrough)
    f = {bytes->ConsumeIntegralInRange(-1, 4), bytes->ConsumeIntegralInRange(-1, 4)};
  const auto count = [] { return bytes->ConsumeIntegralInRange(-1, 3); };
  d.info = {
      any_name(), bytes->ConsumeIntegral<std::uint32_t>(),          count(),          count(),
      count(),    bytes->ConsumeBool() ? d.inputs.data() : nullptr, d.outputs.data(), d.feedthrough.data()};
}

tandem_status create(const char*, void** self) {
  auto* made = new Described;
  describe(*made);
  *self = made;
  return any_status();
}
void destroy(void* self) { delete static_cast<Described*>(self); }
const tandem_info* info(void* self) { return &static_cast<Described*>(self)->info; }
const char* last_error(void*) { return any_name(); }

/// Fills some rows that there are, and says another number of them.
tandem_status rows(tandem_samples* y, tandem_clock* clock) {
  const std::int64_t filled = std::min<std::int64_t>(bytes->ConsumeIntegralInRange(0, 9), y->capacity);
  for (std::int64_t k = 0; k < filled * y->stride; ++k) y->rows[k] = any_number();
  y->size = bytes->ConsumeBool() ? filled : bytes->ConsumeIntegral<std::int64_t>();
  *clock = {any_number(), any_number(), bytes->ConsumeIntegralInRange(-1, 5), 0};
  return any_status();
}
tandem_status initialize(void*, double, double, const double*, tandem_samples* y, tandem_clock* clock) {
  return rows(y, clock);
}
tandem_status advance(void*, double, std::int32_t, const tandem_signal*, tandem_samples* y,
                      tandem_clock* clock) {
  return rows(y, clock);
}
tandem_status save(void*, std::int64_t* id) {
  *id = bytes->ConsumeIntegral<std::int64_t>();
  return any_status();
}
tandem_status restore(void*, std::int64_t, tandem_clock* clock) {
  *clock = {any_number(), any_number(), bytes->ConsumeIntegralInRange(-1, 5), 0};
  return any_status();
}
tandem_status release(void*, std::int64_t) { return any_status(); }
tandem_status serialize(void*, std::int64_t, const void** state, std::int64_t* size) {
  static constexpr char known[8] = {};
  *state = bytes->ConsumeBool() ? known : nullptr;
  *size = bytes->ConsumeIntegralInRange<std::int64_t>(-2, sizeof known);
  return any_status();
}
tandem_status deserialize(void*, const void*, std::int64_t, std::int64_t* id) { return save(nullptr, id); }

const tandem_parameter* parameters(std::int32_t* count) {
  static std::array<tandem_parameter, 3> declared;
  for (tandem_parameter& p : declared) p = {any_name(), any_name(), any_name(), any_name()};
  *count = bytes->ConsumeIntegralInRange(-1, 3);
  return bytes->ConsumeIntegralInRange(0, 9) ? declared.data() : nullptr;
}
const double* nominal(void*) {
  static std::array<double, 3> values;
  for (double& value : values) value = bytes->ConsumeIntegralInRange(0, 9) ? 1.0 : any_number();
  return values.data();
}

template <class Function>
Function* maybe(Function* function) {
  return bytes->ConsumeIntegralInRange(0, 30) ? function : nullptr;
}

tandem_subsystem_api any_table() {
  const bool usual = bytes->ConsumeBool();
  return {usual ? TANDEM_ABI_VERSION : bytes->ConsumeIntegral<std::uint32_t>(),
          usual ? static_cast<std::uint32_t>(sizeof(tandem_subsystem_api))
                : bytes->ConsumeIntegralInRange<std::uint32_t>(0, 2 * sizeof(tandem_subsystem_api)),
          maybe(create),
          maybe(destroy),
          maybe(info),
          maybe(last_error),
          maybe(initialize),
          maybe(advance),
          maybe(save),
          maybe(restore),
          maybe(release),
          maybe(serialize),
          maybe(deserialize),
          nullptr,
          nullptr,
          nullptr,
          bytes->ConsumeIntegralInRange(0, 3) ? nullptr : parameters,
          maybe(nominal)};
}

void drive(Subsystem& s) {
  const std::vector<double> u0(static_cast<std::size_t>(s.info().input_size()), 1.0);
  const Segment line{1.0, 0.0, {1.0, 0.5, 0.0, 0.0, 0.0, 0.0}};
  const std::vector<Signal> u(u0.size(), Signal(&line, 1, 1));
  const std::int64_t stride = s.info().row_size();
  constexpr std::int64_t room = 4;
  std::vector<double> memory(static_cast<std::size_t>(room * stride));
  Samples y(memory.data(), stride, room);
  s.initialize(0.0, 10.0, u0, y);
  y = Samples(memory.data(), stride, room);
  s.advance(1.0, false, u, y);
  if (y.size() > room) std::abort();
  if (!s.info().abilities.saves_state) return;
  const StateId state = s.save_state();
  if (s.info().abilities.serializes_state) s.release_state(s.deserialize_state(s.serialize_state(state)));
  s.restore_state(state);
  s.release_state(state);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider provider(data, size);
  bytes = &provider;
  const tandem_subsystem_api table = any_table();
  try {
    CSubsystem subsystem(bytes->ConsumeIntegralInRange(0, 30) ? &table : nullptr,
                         bytes->ConsumeBool() ? "" : "x=1");
    drive(subsystem);
  } catch (const Error&) {  // what has to come of a library that is not right
  }
  return 0;
}
