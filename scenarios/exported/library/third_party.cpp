// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// fmt and toml++ as sources: Debian has them as shared libraries alone, and an FMU has to stand alone.
#include <fmt/format-inl.h>

template fmt::detail::thousands_sep_result<char> fmt::detail::thousands_sep_impl(fmt::detail::locale_ref);
template char fmt::detail::decimal_point_impl(fmt::detail::locale_ref);

#define TOML_IMPLEMENTATION
#include <toml++/toml.h>
