// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Any bytes from a server: each call of the client gives a result that fits, or an Error.
#include <array>
#include <cstdlib>

#include "memory_stream.hpp"
#include "tandem/error.hpp"
#include "tandem/wire/remote_subsystem.hpp"

namespace {

using namespace tandem;

void drive(wire::RemoteSubsystem& remote) {
  const SubsystemInfo& info = remote.info();
  const auto stride = static_cast<std::size_t>(info.row_size());
  if (stride > 1000 || info.input_size() > 1000) return;
  constexpr std::int64_t rows = 8;
  std::vector<double> memory(rows * stride);
  const std::vector<double> u0(static_cast<std::size_t>(info.input_size()), 1.0);
  const Segment line{1.0, 0.0, {1.0, 0.5, 0.0, 0.0, 0.0, 0.0}};
  const std::vector<Signal> u(u0.size(), Signal(&line, 1, 1));
  Samples y(memory.data(), static_cast<std::int64_t>(stride), rows);
  remote.initialize(0.0, 10.0, u0, y);
  if (info.abilities.sampled) {
    std::vector<double> outputs(static_cast<std::size_t>(info.output_size()));
    for (const SamplePart part : {SamplePart::both, SamplePart::outputs, SamplePart::states})
      remote.sample(0.25, part, u0, outputs);
    return;
  }
  for (const double limit : {0.5, 1.0}) {
    y = Samples(memory.data(), static_cast<std::int64_t>(stride), rows);
    remote.advance(limit, false, u, y);
    if (y.size() > rows) std::abort();
  }
  if (!info.abilities.saves_state) return;
  const StateId state = remote.save_state();
  remote.restore_state(state);
  remote.release_state(state);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    wire::RemoteSubsystem remote(fuzz::channel_of(data, size), "m=2", 1.0);
    drive(remote);
  } catch (const Error&) {  // what has to come of bytes that are not right
  }
  return 0;
}
