// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gtest/gtest.h>

#include <memory>
#include <ostream>
#include <string>

#include "served.hpp"
#include "tandem/c_subsystem.hpp"
#include "tandem/peer.h"

namespace tandem::test {

/// How a subsystem at an address is driven.
struct Master {
  const char* name;
  std::unique_ptr<Subsystem> (*open)(const std::string& uri);
};
inline std::ostream& operator<<(std::ostream& out, const Master& master) { return out << master.name; }

inline const auto masters =
    testing::Values(Master{"Cpp", [](const std::string& uri) { return open(uri, all_sources()); }},
                    Master{"C", [](const std::string& uri) -> std::unique_ptr<Subsystem> {
                             return std::make_unique<CSubsystem>(tandem_remote(), uri);
                           }});
inline std::string master_name(const testing::TestParamInfo<Master>& test) { return test.param.name; }

/// What follows the address in a sentence. (What drives tables of functions puts the subsystem and the call
/// before it.)
inline std::string after_address(const std::string& sentence, const std::string& address) {
  const auto at = sentence.find(address + ", ");
  return at == std::string::npos ? sentence : sentence.substr(at + address.size() + 2);
}

}  // namespace tandem::test
