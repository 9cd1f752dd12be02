// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/c_subsystem.hpp"
#include "tandem/error.hpp"
#include "tandem/library_file.hpp"

namespace tandem {

/// C functions don't throw; what a library in C++ lets pass all the same becomes an error with its name.
template <class Call>
auto CSubsystem::guarded(const char* call, const Call& make) const {
  LibraryCall in_library(library_.empty() ? nullptr : library_.c_str());
  try {
    return in_library.make(make);
  } catch (const std::exception& error) {
    if (LibraryCall::has_faulted())
      throw Error(ErrorCode::internal, who() + ", " + call + ": " + error.what());
    throw Error(ErrorCode::internal, "subsystem '" + info_.name + "', " + call +
                                         ": threw through its C function: " + error.what());
  } catch (...) {
    throw Error(ErrorCode::internal,
                "subsystem '" + info_.name + "', " + call + ": threw through its C function");
  }
}

}  // namespace tandem
