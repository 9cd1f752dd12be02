// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <bit>
#include <string>
#include <string_view>
#include <vector>

namespace tandem::view {

/// RFC 4648, section 4.
std::string base64(std::string_view bytes);

/// Of the bytes of numbers, the least significant first.
template <class Number>
std::string base64(const std::vector<Number>& numbers) {
  static_assert(std::endian::native == std::endian::little);
  return base64({reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)});
}

}  // namespace tandem::view
