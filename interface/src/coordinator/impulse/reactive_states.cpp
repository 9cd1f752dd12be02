// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "reactive_side.hpp"

namespace tandem {

std::optional<std::vector<StateName>> ReactiveSide::states() const {
  auto all = fast_->states();
  const auto more = surrogate_.states();
  for (std::size_t k = 0; all && k < more->size(); ++k)
    all->push_back({name_ + "." + (*more)[k].name, (*more)[k].unit});
  return all;
}

void ReactiveSide::get_states(std::span<double> x) const {
  const std::size_t of_surrogate = surrogate_.states()->size();
  fast_->get_states(x.first(x.size() - of_surrogate));
  surrogate_.get_states(x.last(of_surrogate));
}

void ReactiveSide::set_states(std::span<const double> x) {
  const std::size_t of_surrogate = surrogate_.states()->size();
  fast_->set_states(x.first(x.size() - of_surrogate));
  surrogate_.set_states(x.last(of_surrogate));
}

StateId ReactiveSide::save_state() {
  const StateId id = fast_->save_state();
  kept_.insert_or_assign(id, surrogate_);
  return id;
}

Clock ReactiveSide::restore_state(StateId id) {
  clock_ = fast_->restore_state(id);
  surrogate_ = kept_.at(id);
  return clock_;
}

void ReactiveSide::release_state(StateId id) {
  fast_->release_state(id);
  kept_.erase(id);
}

std::vector<std::byte> ReactiveSide::serialize_state(StateId id) {
  const std::vector<std::byte> of_fast = fast_->serialize_state(id);
  ByteWriter to;
  kept_.at(id).write(to);
  to.put_bytes(of_fast);
  return {to.bytes().begin(), to.bytes().end()};
}

StateId ReactiveSide::deserialize_state(std::span<const std::byte> bytes) {
  ByteReader from(bytes, name_, "state of");
  Surrogate surrogate = surrogate_;
  surrogate.read(from);
  const StateId id = fast_->deserialize_state(from.take_bytes(from.left()));
  kept_.insert_or_assign(id, std::move(surrogate));
  return id;
}

}  // namespace tandem
