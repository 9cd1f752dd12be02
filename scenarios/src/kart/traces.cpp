// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "kart/sweep.hpp"

namespace tandem::kart {
namespace {

std::string rows(const std::string& key, const Trace& trace, const Trace& reference) {
  constexpr std::size_t pitch = 3;
  static_assert(std::string_view(traced[pitch].name) == "pitch");
  std::string text;
  for (std::size_t row = 0; row < trace[pitch].size(); ++row) {
    text += fmt::format("{},{:.2f},{:.6g}", key, static_cast<double>(row) * Trace::step,
                        trace[pitch][row] - reference[pitch][row]);
    for (std::size_t k = 0; k < std::size(traced); ++k)
      text += row < trace[k].size() ? fmt::format(",{:.6g}", trace[k][row]) : ",";
    text += '\n';
  }
  return text;
}

}  // namespace

void Extremes::add(const Scheme& scheme, const Outcome& outcome) {
  if (!outcome.course.failure.empty() || !outcome.stable) return;
  const double largest = outcome.from_better.largest;
  if (!worst_ || largest > worst_->outcome.from_better.largest) worst_ = {scheme, outcome};
  if (!best_ || largest < best_->outcome.from_better.largest) best_ = {scheme, outcome};
}

std::string traces_header() {
  std::string header = "level,run,schedule,to_fast,to_slow,time,difference";
  for (const Traced& t : traced) header += std::string(",") + t.name;
  return header;
}

std::string trace_rows(const Judge& judge, const Extremes& extremes) {
  const Trace& reference = judge.reference().better.trace;
  const Scheme& s = better_scheme;
  std::string text =
      rows(fmt::format("{},reference,{},{},{}", judge.level(), s.schedule, s.to_fast, s.to_slow), reference,
           reference);
  for (const auto& [run, extreme] : {std::pair("worst", &extremes.worst()), {"best", &extremes.best()}})
    if (*extreme) {
      const Scheme& scheme = (*extreme)->scheme;
      text += rows(
          fmt::format("{},{},{},{},{}", judge.level(), run, scheme.schedule, scheme.to_fast, scheme.to_slow),
          (*extreme)->outcome.course.trace, reference);
    }
  return text;
}

}  // namespace tandem::kart
