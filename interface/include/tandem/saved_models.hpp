// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tandem/bytes.hpp"
#include "tandem/error.hpp"
#include "tandem/subsystem.hpp"

namespace tandem {

/// A model that gives its state as bytes.
template <class Model>
concept WritesState = requires(const Model& model, Model& other, ByteWriter& to, ByteReader& from) {
  model.write(to);
  other.read(from);
};

/// What FixedStep and Sampled have in common: a model, its place in time, and saved copies of both. Place has
/// clock(), write() and read().
template <class Model, class Place>
class SavedModels : public Subsystem {
 public:
  const SubsystemInfo& info() const override { return info_; }
  const Model& model() const { return model_; }

  StateId save_state() override {
    saved_.emplace_back(++last_id_, std::pair{model_, place_});
    return last_id_;
  }
  Clock restore_state(StateId id) override {
    std::tie(model_, place_) = saved(id)->second;
    return place_.clock();
  }
  void release_state(StateId id) override { saved_.erase(saved(id)); }

  std::vector<std::byte> serialize_state(StateId id) override {
    if constexpr (WritesState<Model>)
      if (info_.abilities.serializes_state) {
        ByteWriter to;
        saved(id)->second.second.write(to);
        saved(id)->second.first.write(to);
        return {to.bytes().begin(), to.bytes().end()};
      }
    return Subsystem::serialize_state(id);
  }
  StateId deserialize_state(std::span<const std::byte> bytes) override {
    if constexpr (WritesState<Model>)
      if (info_.abilities.serializes_state) {
        ByteReader from(bytes, info_.name, "state of");
        std::pair state{model_, place_};
        state.second.read(from);
        state.first.read(from);
        from.end();
        saved_.emplace_back(++last_id_, std::move(state));
        return last_id_;
      }
    return Subsystem::deserialize_state(bytes);
  }

 protected:
  /// With the abilities `restarts` and `saves_state`.
  explicit SavedModels(Model model) : model_(std::move(model)), info_(model_.info()) {
    info_.abilities.restarts = info_.abilities.saves_state = true;
  }

  Model model_;
  SubsystemInfo info_;
  Place place_;

 private:
  using Saved = std::vector<std::pair<StateId, std::pair<Model, Place>>>;

  typename Saved::iterator saved(StateId id) {
    const auto it =
        std::find_if(saved_.begin(), saved_.end(), [id](const auto& entry) { return entry.first == id; });
    if (it != saved_.end()) return it;
    throw Error(ErrorCode::invalid_argument,
                "subsystem '" + info_.name + "' has no saved state " + std::to_string(id));
  }

  StateId last_id_ = 0;
  Saved saved_;
};

}  // namespace tandem
