// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/identification/models.hpp"

#include <utility>

#include "stand_in.hpp"

namespace tandem::identification {
namespace {

/// All that a source is made with, but for parameters that `left_out` tells.
std::string key_of(const Address& address, const Parameters& parameters,
                   const std::function<bool(const std::string& name)>& left_out) {
  std::string key = address.uri + '\n' + address.folder.string() + '\n' + parameters.written(left_out);
  for (const std::string& part : address.command) key += '\n' + part;
  for (const std::string& part : address.overrides) key += '\n' + part;
  return key;
}

bool is_of_model(const std::string& name) { return name == Models::step_word; }
bool is_of_step(const std::string& name) { return is_of_model(name) || name == "step"; }

}  // namespace

std::shared_ptr<Known> Models::known(const Address& address, const Parameters& parameters) {
  const std::lock_guard lock(mutex_);
  auto& one = known_[key_of(address, parameters, is_of_model)];
  if (one) return one;
  auto& kin = kin_[key_of(address, parameters, is_of_step)];
  if (!kin) kin = std::make_shared<Kin>();
  return one = std::make_shared<Known>(address.command.empty() ? address.uri : address.name(), kin);
}

Source Models::replacing(Source source) {
  source.words.push_back({step_word});
  source.make = [this, make = source.make](const Address& address,
                                           Parameters& parameters) -> std::unique_ptr<Subsystem> {
    const auto one = known(address, parameters);
    const double step = not_negative(parameters, step_word, 0.0);
    if (one->is_seen() && one->may_have_model()) {
      auto open = [make, address, parameters]() mutable { return make(address, parameters); };
      parameters.rest_escaped();  // they were right when it was opened
      return make_stand_in(one, step, without_, std::move(open));
    }
    auto real = make(address, parameters);
    one->see(*real);
    if (!one->may_have_model()) return refuse_without(one->stand(), without_), std::move(real);
    return make_stand_in(
        one, step, without_,
        [real = std::make_shared<std::unique_ptr<Subsystem>>(std::move(real))] { return std::move(*real); });
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
  for (const auto& [key, one] : known_) all.push_back(one->stand());
  return all;
}

}  // namespace tandem::identification
