// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "reply_checks.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "tandem/error.hpp"

namespace tandem::wire {
namespace {

std::string text_of(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}
std::string seconds(double value) { return text_of(value) + " s"; }

[[noreturn]] void refuse_reply(const std::string& what) {
  throw Error(ErrorCode::numerical, "the reply " + what);
}

[[noreturn]] void refuse_value(const SubsystemInfo& info, int column, const std::string& when) {
  if (column >= info.row_size() - Samples::header)
    refuse_reply("gives a state of the reaction not finite at " + when);
  refuse_reply("gives " + scalar_at(info.outputs, column % info.output_size()).name() +
               (column >= info.output_size() ? " (a derivative)" : "") + " not finite at " + when);
}

[[noreturn]] void refuse_row(const SubsystemInfo& info, const Samples& y, std::int64_t row) {
  const auto values = y.values(row);
  const auto bad = std::find_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); });
  refuse_value(info, static_cast<int>(bad - values.begin()), "t = " + seconds(y.time(row)));
}

/// A row's second number.
double flag_of(const Samples& y, std::int64_t row) {
  const tandem_samples rows = y.c_view();
  return rows.rows[rows.stride * row + 1];
}
bool is_flag(double flag) { return flag == 0.0 || flag == 1.0; }

[[noreturn]] void refuse_jump(double flag, double t) {
  refuse_reply("gives " + text_of(flag) + " as the jump flag of its sample at t = " + seconds(t) +
               "; allowed is 0 or 1");
}

/// All of it is finite, and its flag is one. Looked at without a branch for each number, as rows are many.
void check_row(const SubsystemInfo& info, const Samples& y, std::int64_t row) {
  bool finite = true;
  for (const double v : y.values(row)) finite &= std::isfinite(v);
  if (!std::isfinite(y.time(row))) refuse_reply("has a sample whose time is not finite");
  if (!finite) refuse_row(info, y, row);
  if (const double flag = flag_of(y, row); !is_flag(flag)) refuse_jump(flag, y.time(row));
}

void check_later(const Clock& clock) {
  if (!(clock.next_time > clock.time))
    refuse_reply("gives " + seconds(clock.next_time) +
                 " as the end of the next own step, which is not later than " + seconds(clock.time));
}

bool knows(const SubsystemInfo& info, std::span<const double> u0, int output) {
  return std::none_of(info.feedthrough.begin(), info.feedthrough.end(), [&](const Feedthrough& f) {
    return f.output == output && std::isnan(u0[static_cast<std::size_t>(f.input)]);
  });
}

/// Finite, but for what may follow inputs that are not known: outputs by feedthrough, derivatives by any.
void check_newest(const SubsystemInfo& info, std::span<const double> row, std::span<const double> u0) {
  const bool all_known = std::none_of(u0.begin(), u0.end(), [](double u) { return std::isnan(u); });
  for (int column = 0; column < static_cast<int>(row.size()); ++column)
    if (!std::isfinite(row[static_cast<std::size_t>(column)]) &&
        (all_known || (column < info.output_size() && knows(info, u0, column))))
      refuse_value(info, column, "the start");
}

void check_stands(const SubsystemInfo& info, const Clock& clock, double stands) {
  if (!(clock.time == stands))
    refuse_reply("says that it stands at t = " + seconds(clock.time) + ", but its newest sample is of " +
                 seconds(stands));
  check_clock(info, clock);
}

}  // namespace

void check_first(const GivenRows& given, double t_start, std::span<const double> u0) {
  const auto& [info, y, first, clock] = given;
  if (y.size() == first) refuse_reply("has no first sample");
  for (std::int64_t row = first; row < y.size(); ++row) {
    if (!(y.time(row) == t_start))
      refuse_reply("has a sample at t = " + seconds(y.time(row)) + "; allowed is the start, " +
                   seconds(t_start));
    if (const double flag = flag_of(y, row); !is_flag(flag)) refuse_jump(flag, t_start);
  }
  check_newest(info, y.values(y.size() - 1), u0);
  check_stands(info, clock, t_start);
}

void check_rows(const GivenRows& given, const AskedSpan& asked, const TimeTolerance& tolerance) {
  const auto& [info, y, first, clock] = given;
  double stands = asked.from;
  for (std::int64_t row = first; row < y.size(); ++row) {
    check_row(info, y, row);
    const double t = y.time(row);
    if (!(t > stands || (y.jump(row) && t == stands)))
      refuse_reply("has a sample at t = " + seconds(t) + " that does not come after t = " + seconds(stands));
    if (tolerance.before(asked.limit, t))
      refuse_reply("has a sample at t = " + seconds(t) + ", past the limit " + seconds(asked.limit));
    stands = t;
  }
  check_stands(info, clock, stands);
}

void check_clock(const SubsystemInfo& info, const Clock& clock) {
  if (!std::isfinite(clock.time)) refuse_reply("gives a time that is not finite");
  const bool at_its_first = info.abilities.sampled && clock.next_time == clock.time;
  if (clock.stop != Stop::finished && !at_its_first) check_later(clock);
}

void check_sample(const SubsystemInfo& info, std::span<const double> y, double t) {
  const auto bad = std::find_if(y.begin(), y.end(), [](double v) { return !std::isfinite(v); });
  if (bad != y.end())
    refuse_reply("gives " + scalar_at(info.outputs, static_cast<int>(bad - y.begin())).name() +
                 " not finite at t = " + seconds(t));
}

void check_next_instant(const Clock& clock, double t) {
  if (!(clock.time == t))
    refuse_reply("says that it stands at t = " + seconds(clock.time) + "; allowed is that of the sample, " +
                 seconds(t));
  if (clock.stop != Stop::finished) check_later(clock);
}

}  // namespace tandem::wire
