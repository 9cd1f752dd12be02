// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/c_table.hpp"

#include <new>
#include <utility>
#include <vector>

#include "tandem/error.hpp"

namespace tandem {
namespace {

/// An instance, with its info in the layout of C.
struct Instance {
  std::unique_ptr<Subsystem> subsystem;
  std::string error;
  std::vector<std::byte> bytes;  ///< of the state that was serialized last
  std::vector<tandem_port> inputs, outputs;
  std::vector<tandem_feedthrough> feedthrough;
  std::vector<std::int32_t> held;  ///< by output
  std::vector<double> nominal;     ///< likewise
  tandem_info info = {};
};

Instance& instance(void* self) { return *static_cast<Instance*>(self); }

std::vector<tandem_port> ports_of(const std::vector<Port>& ports) {
  std::vector<tandem_port> list;
  for (const Port& p : ports)
    list.push_back({p.name.c_str(), p.unit.c_str(), p.size, p.derivatives, p.start});
  return list;
}

void fill_info(Instance& it) {
  const SubsystemInfo& info = it.subsystem->info();
  it.inputs = ports_of(info.inputs);
  it.outputs = ports_of(info.outputs);
  for (const Feedthrough& f : info.feedthrough) it.feedthrough.push_back({f.output, f.input});
  for (const Port& port : info.outputs) {
    it.held.push_back(port.held ? 1 : 0);
    it.nominal.push_back(port.nominal);
  }
  it.info = {info.name.c_str(),
             to_bits(info),
             static_cast<std::int32_t>(it.inputs.size()),
             static_cast<std::int32_t>(it.outputs.size()),
             static_cast<std::int32_t>(it.feedthrough.size()),
             it.inputs.data(),
             it.outputs.data(),
             it.feedthrough.data()};
}

/// Nothing is thrown across the C interface.
template <class Call>
tandem_status guarded(Instance& it, const Call& call) noexcept {
  try {
    call();
    return TANDEM_OK;
  } catch (const Error& error) {
    it.error = error.what();
    return static_cast<tandem_status>(error.code());
  } catch (const std::exception& error) {
    it.error = error.what();
  } catch (...) {
    it.error = "an exception that is no std::exception";
  }
  return TANDEM_INTERNAL;
}

tandem_clock c_clock(const Clock& c) { return {c.time, c.next_time, static_cast<std::int32_t>(c.stop), 0}; }

/// The caller's rows for one call; the rows that were appended before an error count too.
class Rows {
 public:
  explicit Rows(tandem_samples& c) : c_(c), samples_(c.rows, c.stride, c.capacity, c.size) {}
  ~Rows() { c_.size = samples_.size(); }
  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;
  Samples& samples() { return samples_; }

 private:
  tandem_samples& c_;
  Samples samples_;
};

void destroy(void* self) { delete static_cast<Instance*>(self); }
const tandem_info* info(void* self) { return &instance(self).info; }
const char* last_error(void* self) { return instance(self).error.c_str(); }

tandem_status initialize(void* self, double t_start, double t_stop, const double* u0, tandem_samples* y,
                         tandem_clock* clock) {
  Instance& it = instance(self);
  return guarded(it, [&] {
    Rows rows(*y);
    const auto inputs = static_cast<std::size_t>(it.subsystem->info().input_size());
    *clock = c_clock(it.subsystem->initialize(t_start, t_stop, {u0, inputs}, rows.samples()));
  });
}

tandem_status advance(void* self, double t_limit, std::int32_t land, const tandem_signal* u,
                      tandem_samples* y, tandem_clock* clock) {
  Instance& it = instance(self);
  return guarded(it, [&] {
    Rows rows(*y);
    const auto inputs = static_cast<std::size_t>(it.subsystem->info().input_size());
    const auto* signals = reinterpret_cast<const Signal*>(u);  // same layout: see signal.hpp
    *clock = c_clock(it.subsystem->advance(t_limit, land != 0, {signals, inputs}, rows.samples()));
  });
}

tandem_status save_state(void* self, std::int64_t* id) {
  return guarded(instance(self), [&] { *id = instance(self).subsystem->save_state(); });
}

tandem_status restore_state(void* self, std::int64_t id, tandem_clock* clock) {
  return guarded(instance(self), [&] { *clock = c_clock(instance(self).subsystem->restore_state(id)); });
}

tandem_status release_state(void* self, std::int64_t id) {
  return guarded(instance(self), [&] { instance(self).subsystem->release_state(id); });
}

tandem_status serialize_state(void* self, std::int64_t id, const void** bytes, std::int64_t* size) {
  Instance& it = instance(self);
  return guarded(it, [&] {
    it.bytes = it.subsystem->serialize_state(id);
    *bytes = it.bytes.data();
    *size = static_cast<std::int64_t>(it.bytes.size());
  });
}

tandem_status deserialize_state(void* self, const void* bytes, std::int64_t size, std::int64_t* id) {
  return guarded(instance(self), [&] {
    *id = instance(self).subsystem->deserialize_state(
        {static_cast<const std::byte*>(bytes), static_cast<std::size_t>(size)});
  });
}

const std::int32_t* held(void* self) { return instance(self).held.data(); }
const double* nominal(void* self) { return instance(self).nominal.data(); }

tandem_status sampling(void* self, double* period, double* latency) {
  const Sampling& sampling = instance(self).subsystem->info().sampling;
  *period = sampling.period;
  *latency = sampling.latency;
  return TANDEM_OK;
}

tandem_status sample(void* self, double t, std::int32_t parts, const double* u, double* y,
                     tandem_clock* clock) {
  Instance& it = instance(self);
  return guarded(it, [&] {
    const SubsystemInfo& info = it.subsystem->info();
    const auto inputs = static_cast<std::size_t>(info.input_size()),
               outputs = static_cast<std::size_t>(info.output_size());
    *clock = c_clock(it.subsystem->sample(t, static_cast<SamplePart>(parts), {u, inputs}, {y, outputs}));
  });
}

template <class Make>
tandem_status create_by(const Make& make, void** self) noexcept {
  auto* it = new (std::nothrow) Instance;
  *self = it;
  if (!it) return TANDEM_INTERNAL;
  return guarded(*it, [&] {
    it->subsystem = make();
    fill_info(*it);
  });
}

}  // namespace

tandem_subsystem_api CTable::with(Create create) {
  return {TANDEM_ABI_VERSION,
          sizeof(tandem_subsystem_api),
          create,
          destroy,
          info,
          last_error,
          initialize,
          advance,
          save_state,
          restore_state,
          release_state,
          serialize_state,
          deserialize_state,
          held,
          sampling,
          sample,
          nullptr,
          nominal};
}

tandem_status CTable::create(MakeSubsystem make, const char* parameters, void** self) noexcept {
  return create_by([&] { return make(parameters); }, self);
}

tandem_status CTable::create(MakeFromValues make, std::span<const tandem_parameter> declared,
                             const char* parameters, void** self) noexcept {
  return create_by([&] { return make(ParameterValues(declared_from(declared), parameters)); }, self);
}

}  // namespace tandem
