// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/text/key_list.hpp"
#include "tandem/text/section.hpp"

namespace tandem::text {

/// Values of a signal between which a model is believed, and what happens where it leaves them.
struct FileLimit {
  enum class OnLeaving { ignore, warn, stop };
  double low, high;  ///< low < high; one of them may be infinite
  std::string sentence;
  OnLeaving on_leaving;
};

/// A table of [limits], but for its `signal`.
FileLimit read_limit(Section& section);
/// The keys of [limits]; what: may be watched.
void keys_of_limits(KeyList& to, const std::string& when, Key::Type type, const std::string& what = "");

}  // namespace tandem::text
