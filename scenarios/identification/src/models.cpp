// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/identification/models.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "tandem/error.hpp"
#include "tandem/identification/identify.hpp"
#include "tandem/identification/surrogate.hpp"

namespace tandem::identification {
namespace {

/// Nothing: it may have a linear model.
std::string why_not(const SubsystemInfo& info) {
  if (info.abilities.sampled) return "it is sampled";
  if (info.abilities.events) return "it has events";
  if (info.abilities.chooses_step) return "its own steps vary";
  if (!info.abilities.restarts) return "it can't start again";
  return "";
}

/// Responses that last a quarter of the run, where that is not too long.
Wanted wanted(const SubsystemInfo& info, const Clock& start, double t_stop, std::span<const double> u0) {
  constexpr double least = 12.0, most = 1536.0;
  const double steps = 0.25 * (t_stop - start.time) / (start.next_time - start.time);
  Wanted all{start.time, {u0.begin(), u0.end()}, {}};
  all.steps = static_cast<std::int64_t>(std::clamp(steps, least, most));
  for (int k = 0; k < info.row_size() - Samples::header; ++k) all.values.push_back(k);
  return all;
}

/// A subsystem and its model from the start to the end of the run, with inputs that stay as they are.
class SideBySide {
 public:
  SideBySide(Subsystem& real, Subsystem& model, std::span<const double> u0)
      : real_(real), model_(model), u0_(u0), stride_(real.info().row_size()) {
    for (const double u : u0) segments_.push_back({0.0, 0.0, {u}});
    for (const Segment& one : segments_) signals_.emplace_back(&one, 1, 0);
    values_.resize(static_cast<std::size_t>(stride_ - Samples::header));
  }

  /// When a value differs most, if that is by more than a part of its largest magnitude; else nothing.
  std::optional<double> apart(double t_start, double t_stop, double part) {
    std::vector<double> a(static_cast<std::size_t>(stride_ * rows)), b = a;
    Samples y(a.data(), stride_, rows), of_model(b.data(), stride_, rows);
    real_.initialize(t_start, t_stop, u0_, y), model_.initialize(t_start, t_stop, u0_, of_model);
    while (y.size() > 0) {
      if (y.size() != of_model.size()) return t_stop;
      for (std::int64_t row = 0; row < y.size(); ++row)
        compare(a.data() + row * stride_, b.data() + row * stride_);
      y = Samples(a.data(), stride_, rows), of_model = Samples(b.data(), stride_, rows);
      real_.advance(t_stop, false, signals_, y), model_.advance(t_stop, false, signals_, of_model);
    }
    const auto far = [part](const Value& v) { return !(v.off <= part * v.peak); };
    const auto it = std::find_if(values_.begin(), values_.end(), far);
    return it == values_.end() ? std::nullopt : std::optional(it->at);
  }

 private:
  static constexpr std::int64_t rows = 256;
  struct Value {
    double peak = 1e-9, off = 0.0, at = 0.0;
  };
  void compare(const double* a, const double* b) {
    for (std::size_t k = 0; k < values_.size(); ++k) {
      Value& value = values_[k];
      const double own = a[Samples::header + k], off = std::abs(own - b[Samples::header + k]);
      value.peak = std::max(value.peak, std::abs(own));
      if (!(off <= value.off)) value.off = off, value.at = a[0];
    }
  }

  Subsystem &real_, &model_;
  std::span<const double> u0_;
  std::int64_t stride_;
  std::vector<Value> values_;
  std::vector<Segment> segments_;
  std::vector<Signal> signals_;
};

}  // namespace

struct Models::Entry {
  Entry(const std::string& source, double own_step) : step(own_step) { stand.source = source; }

  std::once_flag found;
  double step;  ///< of the model; 0: that of the subsystem
  std::optional<LinearModel> model;
  Stand stand;

  void find(Subsystem& subsystem, const Clock& start, double t_stop, std::span<const double> u0) {
    try {
      const auto what = wanted(subsystem.info(), start, t_stop, u0);
      if (!is_linear(subsystem, what)) {
        stand.why = "it is not linear";
        return;
      }
      LinearModel found = identify(subsystem, what);
      stand.order = static_cast<int>(found.order()), stand.residual = found.residual;
      stand.modelled = found.residual <= most_residual;
      if (stand.modelled)
        keep(subsystem, std::move(found), start.time, t_stop, u0);
      else
        stand.why = fmt::format("the best linear model leaves {:.2g} of its responses; allowed is {}",
                                found.residual, most_residual);
    } catch (const Error& error) {
      stand.modelled = false, stand.why = error.what();
    }
  }

 private:
  /// If it goes like the subsystem to the end.
  void keep(Subsystem& subsystem, LinearModel found, double t_start, double t_stop,
            std::span<const double> u0) {
    const auto surrogate = make_surrogate(found, subsystem.info());
    const auto apart = SideBySide(subsystem, *surrogate, u0).apart(t_start, t_stop, most_apart);
    stand.modelled = !apart;
    if (apart)
      stand.why = fmt::format(
          "its model is farthest off at t = {:.6g} s, by more than 1e-4 of the peak: it goes by its own "
          "clock, or is not linear",
          *apart);
    else
      model = step > 0.0 ? with_step(found, step) : std::move(found);
  }
};

/// A subsystem that becomes its model where it starts with inputs that are known.
class Models::Modelled final : public Subsystem {
 public:
  Modelled(std::unique_ptr<Subsystem> real, const Models& all, Entry& entry)
      : real_(std::move(real)), all_(all), entry_(entry), info_(real_->info()) {
    info_.abilities.serializes_state = info_.abilities.reactive_inputs = false;
  }

  const SubsystemInfo& info() const override { return info_; }
  bool one_thread() const override { return real_->one_thread(); }
  std::vector<std::string> remarks(double t_stop) const override { return real_->remarks(t_stop); }

  Clock initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) override {
    active_ = real_.get();
    Clock clock = real_->initialize(t_start, t_stop, u0, y);
    if (std::any_of(u0.begin(), u0.end(), [](double u) { return std::isnan(u); })) {
      if (entry_.step > 0.0) clock.next_time = t_start + entry_.step;  // as it will be
      return clock;
    }
    std::call_once(entry_.found, [&] { entry_.find(*real_, clock, t_stop, u0); });
    all_.refuse_without(entry_.stand);
    if (entry_.model) {
      if (!surrogate_) surrogate_ = make_surrogate(*entry_.model, info_);
      active_ = surrogate_.get();
    }
    std::vector<double> row(static_cast<std::size_t>(info_.row_size()));
    Samples unused(row.data(), info_.row_size(), 1);
    return active_->initialize(t_start, t_stop, u0, unused);
  }

  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override {
    return active_->advance(t_limit, land, u, y);
  }
  /// Of what runs itself.
  std::shared_ptr<SlowModel> slow_model(std::span<const SlowLink> links) const override {
    return active_ == real_.get() ? real_->slow_model(links) : nullptr;
  }
  StateId save_state() override { return active_->save_state(); }
  Clock restore_state(StateId id) override { return active_->restore_state(id); }
  void release_state(StateId id) override { active_->release_state(id); }

 private:
  std::unique_ptr<Subsystem> real_, surrogate_;
  Subsystem* active_ = nullptr;
  const Models& all_;
  Entry& entry_;
  SubsystemInfo info_;
};

void Models::refuse_without(const Stand& stand) const {
  if (without_ == Without::refused && !stand.is_known())
    throw Error(ErrorCode::not_supported, "there is no linear model of " + stand.source + ": " + stand.why);
}

Models::Entry& Models::entry(const std::string& key, const std::string& source, double step) {
  const std::lock_guard lock(mutex_);
  auto& one = entries_[key];
  if (!one) one = std::make_shared<Entry>(source, step);
  return *one;
}

Source Models::replacing(Source source) {
  source.words.push_back({step_word});
  source.make = [this, make = source.make](const Address& address,
                                           Parameters& parameters) -> std::unique_ptr<Subsystem> {
    std::string key = address.uri + '\n' + address.folder.string() + '\n' + parameters.written();
    for (const std::string& part : address.command) key += '\n' + part;
    for (const std::string& part : address.overrides) key += '\n' + part;
    const double step = not_negative(parameters, step_word, 0.0);
    auto real = make(address, parameters);
    Entry& one = entry(key, address.command.empty() ? address.uri : address.name(), step);
    const std::string why = why_not(real->info());
    if (why.empty()) return std::make_unique<Modelled>(std::move(real), *this, one);
    std::call_once(one.found,
                   [&] { one.stand.sampled = real->info().abilities.sampled, one.stand.why = why; });
    refuse_without(one.stand);
    return real;
  };
  return source;
}

Builtins Models::replacing(Builtins all) {
  for (auto* list : {&all.models, &all.schemes})
    for (auto& [name, source] : *list) source = replacing(source);
  all.stand_ins = true;
  return all;
}

std::vector<Stand> Models::stands() const {
  const std::lock_guard lock(mutex_);
  std::vector<Stand> all;
  for (const auto& [key, one] : entries_) all.push_back(one->stand);
  return all;
}

}  // namespace tandem::identification
