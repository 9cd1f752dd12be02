// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "run_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tandem/bytes.hpp"

namespace tandem::scenario {

Estimate::Estimate(const Topology& topology, const JudgeEntry& judge, text::TimeTable expected,
                   const Indicators& indicators)
    : judge_(judge),
      indicators_(indicators),
      expected_(std::move(expected)),
      courses_(expected_),
      course_(courses_.course(judge.quantity)),
      name_("estimate(" + judge.quantity + ")") {
  for (int i = 0; i < topology.size(); ++i)
    for (int k = 0; k < topology.info(i).output_size(); ++k)
      if (topology.output_name(i, k) == judge.quantity)
        subsystem_ = i, output_ = k, unit_ = scalar_at(topology.info(i).outputs, k).port->unit;
}

bool Estimate::samples(int subsystem, const History& history, std::int64_t first, std::int64_t last) {
  if (subsystem != subsystem_) return true;
  if (ends_.empty()) ends_ = indicators_.times(), windows_.resize(ends_.size(), -1.0);
  for (std::int64_t row = first; row <= last; ++row) {
    const double t = history.time(row);
    if (!courses_.covers(t)) continue;
    courses_.move_to(t, t == last_);
    const double expected = courses_.value(course_);
    add(last_ = t, history.values(row)[static_cast<std::size_t>(output_)] - expected, expected);
  }
  return true;
}

void Estimate::add(double t, double off, double expected) {
  while (window_ + 1 < ends_.size() && ends_[window_] < t) ++window_;
  windows_[window_] = std::max(windows_[window_], std::abs(off));
  if (t < judge_.measure.from || t > judge_.measure.to) return;
  if (std::abs(off) > largest_) largest_ = std::abs(off), at_ = t;
  peak_ = std::max(peak_, std::abs(expected));
  off2_ += off * off, of2_ += expected * expected;
}

nlohmann::ordered_json Estimate::figures() const {
  return {{"largest", largest_},
          {"at", at_},
          {"peak", peak_},
          {"rms_relative", of2_ > 0.0 ? std::sqrt(off2_ / of2_) : 0.0}};
}

std::string Estimate::told() const {
  const bool rms = judge_.measure.norm == Norm::rms;
  const double part =
      rms ? (of2_ > 0.0 ? std::sqrt(off2_ / of2_) : 0.0) : (peak_ > 0.0 ? largest_ / peak_ : 0.0);
  return fmt::format("{} is off by {:.2g} of its {}, of which {:g} is allowed", judge_.quantity, part,
                     rms ? "rms" : "peak", judge_.tolerance);
}

void Estimate::save(ByteWriter& to) const {
  to.put_list(windows_);
  to.put_list(ends_);
  to.put(std::uint64_t{window_});
  for (const double value : {last_, largest_, at_, peak_, off2_, of2_}) to.put(value);
}

void Estimate::resume(ByteReader& from) {
  windows_ = from.take_list(), ends_ = from.take_list();
  window_ = from.take<std::uint64_t>();
  if (windows_.size() != ends_.size() || window_ >= std::max<std::size_t>(ends_.size(), 1))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("checkpoint: the estimate stands in window {} of {}, which end at {} times",
                            window_, windows_.size(), ends_.size()));
  for (double* value : {&last_, &largest_, &at_, &peak_, &off2_, &of2_}) *value = from.take<double>();
}

}  // namespace tandem::scenario
