// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/text/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tandem::text {
namespace {

/// In the order of OnLeaving.
const std::vector<std::string>& words() {
  static const std::vector<std::string> all = {"ignore", "warn", "stop"};
  return all;
}

}  // namespace

void keys_of_limits(KeyList& to, const std::string& when, Key::Type type, const std::string& what) {
  using enum Key::Type;
  to.named("limits", "Values between which the model is believed.",
           "A limit. It has `low` or `high`, or both.")
      .need("signal", type, "What is watched, " + when + ".", {.allowed = what})
      .may("low", number, "The least value.")
      .may("high", number, "The largest value.")
      .need("sentence", text, "Why.")
      .may("on_leaving", word, "What is done where the signal leaves them: it is told once, or the run ends.",
           {.otherwise = "warn", .words = words()});
}

FileLimit read_limit(Section& section) {
  const auto low = section.number("low"), high = section.number("high");
  if (!low && !high) section.missing("low", "a number at low, at high, or at both");
  if (low && high && !(*low < *high))
    section.wrong("low", fmt::format("{}", *low), fmt::format("one below high, {}", *high));
  const std::string word = *section.text("on_leaving");
  return {
      low.value_or(-HUGE_VAL), high.value_or(HUGE_VAL), section.required_text("sentence"),
      static_cast<FileLimit::OnLeaving>(std::find(words().begin(), words().end(), word) - words().begin())};
}

}  // namespace tandem::text
