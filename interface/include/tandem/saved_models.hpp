// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <concepts>
#include <optional>
#include <string>
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

/// A model that says whether it can be copied once it has started; others can.
template <class Model>
concept SaysWhetherKept = requires(const Model& model) {
  { model.keeps_state() } -> std::same_as<bool>;
};

/// A model that gives its states as numbers.
template <class Model>
concept GivesStates =
    requires(Model& model, const Model& same, std::span<double> to, std::span<const double> x) {
      { same.states() } -> std::same_as<std::optional<std::vector<StateName>>>;
      same.get_states(to);
      model.set_states(x);
    };

/// What FixedStep and Sampled have in common: a model, its place in time, and saved copies of both. Place has
/// clock(), write() and read(). (Long by the calls of Subsystem that it hands on to the model, each in one place.)
template <class Model, class Place>
class SavedModels : public Subsystem {
 public:
  const SubsystemInfo& info() const override { return info_; }
  const Model& model() const { return model_; }

  std::vector<std::string> remarks(double t_stop) const override {
    if constexpr (requires { model_.remarks(t_stop); }) return model_.remarks(t_stop);
    return {};
  }
  std::vector<Figure> figures() const override {
    if constexpr (requires { model_.figures(); }) return model_.figures();
    return {};
  }

  std::optional<std::vector<StateName>> states() const override {
    if constexpr (GivesStates<Model>) return model_.states();
    return {};
  }
  void get_states(std::span<double> x) const override {
    if constexpr (GivesStates<Model>)
      if (model_.states()) return model_.get_states(x);
    Subsystem::get_states(x);
  }
  void set_states(std::span<const double> x) override {
    if constexpr (GivesStates<Model>)
      if (model_.states()) return model_.set_states(x);
    Subsystem::set_states(x);
  }

  std::optional<Linearized> linearized() const override {
    if constexpr (requires { model_.linearized(); }) return model_.linearized();
    return {};
  }
  std::shared_ptr<SlowModel> slow_model(std::span<const SlowLink> links) const override {
    if constexpr (requires { model_.slow_model(links); }) return model_.slow_model(links);
    return nullptr;
  }

  StateId save_state() override {
    return info_.abilities.saves_state ? keep(model_, place_) : Subsystem::save_state();
  }
  Clock restore_state(StateId id) override {
    if (!info_.abilities.saves_state) return Subsystem::restore_state(id);
    const Saved& from = saved(id);
    model_ = from.model, place_ = from.place;
    return place_.clock();
  }
  void release_state(StateId id) override {
    if (!info_.abilities.saves_state) return Subsystem::release_state(id);
    saved(id).id = nobody;
  }

  std::vector<std::byte> serialize_state(StateId id) override {
    if constexpr (WritesState<Model>)
      if (info_.abilities.serializes_state) {
        ByteWriter to;
        saved(id).place.write(to);
        saved(id).model.write(to);
        return {to.bytes().begin(), to.bytes().end()};
      }
    return Subsystem::serialize_state(id);
  }
  StateId deserialize_state(std::span<const std::byte> bytes) override {
    if constexpr (WritesState<Model>)
      if (info_.abilities.serializes_state) {
        ByteReader from(bytes, info_.name, "state of");
        Model model = model_;
        Place place = place_;
        place.read(from);
        model.read(from);
        from.end();
        return keep(model, place);
      }
    return Subsystem::deserialize_state(bytes);
  }

 protected:
  /// With the abilities `restarts` and, unless the model says that it is not kept, `saves_state`.
  explicit SavedModels(Model model) : model_(std::move(model)), info_(model_.info()) {
    info_.abilities.restarts = info_.abilities.saves_state = true;
    if constexpr (SaysWhetherKept<Model>) info_.abilities.saves_state = model_.keeps_state();
  }

  Model model_;
  SubsystemInfo info_;
  Place place_;

 private:
  static constexpr StateId nobody = -1;
  struct Saved {
    StateId id;
    Model model;
    Place place;
  };

  /// In the memory of one that is released, if there is one.
  StateId keep(const Model& model, const Place& place) {
    const auto free =
        std::find_if(saved_.begin(), saved_.end(), [](const Saved& s) { return s.id == nobody; });
    if (free == saved_.end())
      saved_.push_back({++last_id_, model, place});
    else
      free->model = model, free->place = place, free->id = ++last_id_;
    return last_id_;
  }

  Saved& saved(StateId id) {
    const auto it = std::find_if(saved_.begin(), saved_.end(),
                                 [id](const Saved& s) { return s.id == id && id != nobody; });
    if (it != saved_.end()) return *it;
    throw Error(ErrorCode::invalid_argument,
                "subsystem '" + info_.name + "' has no saved state " + std::to_string(id));
  }

  StateId last_id_ = 0;
  std::vector<Saved> saved_;
};

}  // namespace tandem
