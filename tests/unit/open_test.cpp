// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/transports/open.hpp"

#include <gtest/gtest.h>

#include "refusal.hpp"
#include "scripted.hpp"

namespace tandem {
namespace {

using test::refuses;
using test::Scripted;

/// One builtin, "ramp.slow", whose own step is its parameter h.
Builtins ramps() {
  Builtins builtins;
  builtins.models["ramp.slow"] = {
      words_by(Setter::client, {"h"}), [](const Address&, Parameters& p) {
        return std::make_unique<Scripted>(test::source(p.number("h", 0.5), [](double t) { return t; }));
      }};
  return builtins;
}

double first_step(Subsystem& s) {
  std::vector<double> memory(static_cast<std::size_t>(s.info().row_size()));
  Samples y(memory.data(), s.info().row_size(), 1);
  return s.initialize(0.0, 1.0, {}, y).next_time;
}

TEST(Open, MakesABuiltinByName) { EXPECT_EQ(first_step(*open("builtin:ramp.slow", ramps())), 0.5); }

TEST(Open, TakesParametersFromTheUriAndBesideIt) {
  EXPECT_EQ(first_step(*open("builtin:ramp.slow?h=0.25", ramps())), 0.25);
  Parameters p;
  p.set("h", 0.125);
  EXPECT_EQ(first_step(*open("builtin:ramp.slow", ramps(), {p})), 0.125);
}

/// A source that is code: `make` must not be reached.
Builtins programs() {
  Builtins builtins;
  builtins.schemes["code"] = {words_by(Setter::operator_only, {"h"}),
                              [](const Address&, Parameters&) -> std::unique_ptr<Subsystem> {
                                throw Error(ErrorCode::internal, "code was run");
                              },
                              false, true,
                              [](const Address&, Parameters& p) -> std::optional<Look> {
                                p.number("h", 0.0);
                                return std::nullopt;
                              }};
  builtins.schemes["unseen"] = {{}, builtins.schemes["code"].make, false, true};
  return builtins;
}

TEST(Open, LooksAtCodeWithoutARunOfIt) {
  EXPECT_NO_THROW(look_at("code:x?h=1", programs(), {}));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'h'", "'fast'"},
                      [] { look_at("code:x?h=fast", programs(), {}); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'k' is not there"},
                      [] { look_at("code:x?k=1", programs(), {}); }));
  EXPECT_NO_THROW(look_at("unseen:x?k=1", programs(), {}));
  EXPECT_TRUE(refuses(ErrorCode::internal, {"run"}, [] { open("code:x", programs()); }));
}

TEST(Open, ShowsACommandAsAScenarioHasIt) {
  EXPECT_EQ(shown({"prog", "a b", "\"\\"}), "[\"prog\", \"a b\", \"\\\"\\\\\"]");
  EXPECT_EQ(shown({"\x1b[2K"}), "[\"\\x1b[2K\"]");
}

TEST(Open, RefusesAParameterGivenTwice) {
  Parameters p;
  p.set("h", 0.125);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'h' twice"},
                      [&] { open("builtin:ramp.slow?h=1", ramps(), {p}); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'h' twice"},
                      [&] { open("builtin:ramp.slow?h=1&h=2", ramps()); }));
}

TEST(Open, RefusesWhatItDoesNotKnow) {
  const auto opening = [](const std::string& uri) { return [uri] { open(uri, ramps()); }; };
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'ftp://host'", "builtin:NAME"}, opening("ftp://host")));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'ramp.slow'", "scheme"}, opening("ramp.slow")));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"ramp.slwo", "did you mean 'builtin:ramp.slow'"},
                      opening("builtin:ramp.slwo")));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"There are: builtin:ramp.slow"}, opening("builtin:")));
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"'step'", "There are: h"}, opening("builtin:ramp.slow?step=1")));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'h'", "key=value"}, opening("builtin:ramp.slow?h")));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'=1'", "key=value"}, opening("builtin:ramp.slow?=1")));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'h'", "'fast'"}, opening("builtin:ramp.slow?h=fast")));
}

}  // namespace
}  // namespace tandem
