// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "refuse.hpp"

namespace tandem::engine {
namespace {

struct Keeper {
  const char* kind;
  std::array<const char*, 2> inputs;
};
constexpr std::array<Keeper, 12> keepers = {{{"sum", {"inputs"}},
                                             {"function", {"input", "inputs"}},
                                             {"integrator", {"initial", "reset_to"}},
                                             {"lag", {"input", "initial"}},
                                             {"saturation", {"input"}},
                                             {"dead_zone", {"input"}},
                                             {"rate_limiter", {"input"}},
                                             {"sample", {"input"}},
                                             {"unit_delay", {"input"}},
                                             {"memory", {"input"}},
                                             {"delay", {"input"}},
                                             {"switch", {"above", "below"}}}};

std::vector<std::string> signals_at(const Block& block, const char* key) {
  const auto it = block.values.find(key ? key : "");
  if (it == block.values.end()) return {};
  if (const auto* one = std::get_if<std::string>(&it->second)) return {*one};
  std::vector<std::string> names;
  if (const auto* list = std::get_if<std::vector<Wire>>(&it->second))
    for (const Wire& wire : *list)
      if (const auto* name = std::get_if<std::string>(&wire)) names.push_back(*name);
  return names;
}

/// By a factor, or a function other than those that choose a value.
bool changes_unit(const Block& block) {
  const auto value = [&](const char* key) {
    const auto it = block.values.find(key);
    return it == block.values.end() ? nullptr : &it->second;
  };
  if (value("gain")) return true;
  if (const auto* gains = value("gains")) {
    const auto* list = std::get_if<std::vector<Wire>>(gains);
    return !list || std::any_of(list->begin(), list->end(), [](const Wire& gain) {
      const auto* number = std::get_if<double>(&gain);
      return !number || std::abs(*number) != 1.0;
    });
  }
  if (block.kind != "function") return false;
  const auto* word = value("function") ? std::get_if<std::string>(value("function")) : nullptr;
  return !word || (*word != "abs" && *word != "min" && *word != "max");
}

/// The first of those that share their unit.
class Families {
 public:
  explicit Families(const Lowering& d) : d_(d), parent_(d.signals.size()) {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (const auto& [a, b] : d.same_units) parent_[first(a)] = first(b);
  }
  int first(int signal) {
    signal = d_.resolved(signal);
    while (parent_[signal] != signal) signal = parent_[signal] = parent_[parent_[signal]];
    return signal;
  }

 private:
  const Lowering& d_;
  std::vector<int> parent_;
};

}  // namespace

void keep_units(const Block& block, Lowering& to) {
  if (changes_unit(block)) return;
  for (const Keeper& keeper : keepers)
    for (const char* key : keeper.inputs)
      if (block.kind == keeper.kind)
        for (const std::string& name : signals_at(block, key))
          to.same_units.emplace_back(to.named(name, block.where), to.named(block.name, block.where));
}

void refuse_mixed_units(const Lowering& d) {
  Families families(d);
  std::map<int, const Lowering::PortUnit*> said;
  for (const auto& port : d.port_units) {
    const auto& before = *said.emplace(families.first(port.signal), &port).first->second;
    if (before.unit != port.unit)
      refuse(port.where,
             fmt::format("{} is in '{}', but {}, the same signal or one that keeps its unit, is in "
                         "'{}'; allowed is one unit, or a gain in between",
                         port.name, port.unit, before.name, before.unit));
  }
}

}  // namespace tandem::engine
