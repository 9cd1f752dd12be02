// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "kept_state.hpp"

namespace tandem::fmi {

KeptState::KeptState(const std::shared_ptr<Instance>& of, void* state)
    : state_(state, [of](void* kept) {
        if (!LibraryCall::has_faulted()) of->within([&] { of->ask(&Functions::FreeFMUstate, &kept); });
      }) {}

KeptState KeptState::of(const std::shared_ptr<Instance>& instance) {
  void* state = nullptr;
  instance->within([&] { instance->call(&Functions::GetFMUstate, "fmi2GetFMUstate", &state); });
  return {instance, state};
}

KeptState KeptState::from(const std::shared_ptr<Instance>& instance, std::span<const std::byte> bytes) {
  void* state = nullptr;
  instance->within([&] {
    instance->call(&Functions::DeSerializeFMUstate, "fmi2DeSerializeFMUstate",
                   reinterpret_cast<const fmi2Byte*>(bytes.data()), bytes.size(), &state);
  });
  return {instance, state};
}

void KeptState::put_back(Instance& to) const {
  to.within([&] { to.call(&Functions::SetFMUstate, "fmi2SetFMUstate", state_.get()); });
}

std::vector<std::byte> KeptState::bytes(Instance& of) const {
  std::vector<std::byte> all;
  of.within([&] {
    std::size_t size = 0;
    of.call(&Functions::SerializedFMUstateSize, "fmi2SerializedFMUstateSize", state_.get(), &size);
    all.resize(size);
    of.call(&Functions::SerializeFMUstate, "fmi2SerializeFMUstate", state_.get(),
            reinterpret_cast<fmi2Byte*>(all.data()), size);
  });
  return all;
}

}  // namespace tandem::fmi
