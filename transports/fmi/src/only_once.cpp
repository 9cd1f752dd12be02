// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "only_once.hpp"

#include <mutex>
#include <set>

#include "tandem/error.hpp"

namespace tandem::fmi {
namespace {

/// Tokens of FMUs that are there and may be so once.
std::set<std::string>& present() {
  static std::set<std::string> all;
  return all;
}
std::mutex& guard_of_present() {
  static std::mutex guard;
  return guard;
}

}  // namespace

OnlyOnce::OnlyOnce(const Fmu& fmu)
    : token_(offer_of(fmu.description, fmu.settings.kind).once_per_process ? fmu.description.guid : "") {
  const std::lock_guard lock(guard_of_present());
  if (!token_.empty() && !present().insert(token_).second)
    throw Error(ErrorCode::not_supported,
                "FMU '" + fmu.file.string() +
                    "' may be there once in a process (canBeInstantiatedOnlyOncePerProcess), and is there "
                    "already; 'isolate = true' gives another one a process of its own");
}

OnlyOnce::~OnlyOnce() {
  const std::lock_guard lock(guard_of_present());
  present().erase(token_);
}

}  // namespace tandem::fmi
