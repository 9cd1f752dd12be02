// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace tandem {

/// A URI "scheme:place?query" taken apart; what it has not is empty.
struct SourceUri {
  std::string scheme, place, query;

  explicit SourceUri(const std::string& uri) {
    const auto mark = uri.find('?'), colon = uri.find(':');
    const bool has_scheme = colon < mark;  // npos is the largest
    const auto begin = has_scheme ? colon + 1 : 0;
    if (has_scheme) scheme = uri.substr(0, colon);
    place = uri.substr(begin, mark == std::string::npos ? mark : mark - begin);
    if (mark != std::string::npos) query = uri.substr(mark + 1);
  }
};

}  // namespace tandem
