// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "kept_state.hpp"

namespace tandem::fmi {

KeptState::KeptState(const std::shared_ptr<Instance>& of, void* state)
    : state_(state,
             [of, made = of->made()](void* kept) {
               if (!LibraryCall::has_faulted()) of->within([&] { of->release(kept, made); });
             }),
      made_(of->made()) {}

KeptState KeptState::of(const std::shared_ptr<Instance>& instance) {
  return {instance, instance->within([&] { return instance->state(); })};
}

KeptState KeptState::from(const std::shared_ptr<Instance>& instance, std::span<const std::byte> bytes) {
  return {instance, instance->within([&] { return instance->state_from(bytes); })};
}

void KeptState::put_back(Instance& to) const {
  if (made_ != to.made())
    throw Error(ErrorCode::numerical, "the FMU has been made anew since its state was kept");
  to.within([&] { to.put_back(state_.get()); });
}

std::vector<std::byte> KeptState::bytes(Instance& of) const {
  return of.within([&] { return of.bytes(state_.get()); });
}

}  // namespace tandem::fmi
