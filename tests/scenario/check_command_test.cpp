// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "command.hpp"

namespace tandem {
namespace {

using test::contains;
using test::Said;
using test::Scratch;
using test::tandem;

TEST(CheckCommand, FindsNothingWrongWithOurOwn) {
  const Scratch folder;
  for (const char* source :
       {"builtin:two_mass.fast",
        "mechanism:" TANDEM_SOURCE_DIR "/scenarios/engine_linkage/linkage.toml?step=1e-3",
        "diagram:" TANDEM_SOURCE_DIR "/scenarios/engine/kart_power_train.toml?step=1e-3"}) {
    const Said said = tandem(folder, {"check", source});
    EXPECT_EQ(said.status, 0) << said.out << said.err;
    EXPECT_TRUE(contains(said.out, "31 checks, nothing wrong")) << said.out;
  }
}

TEST(CheckCommand, TellsWhatIsWrongWithStatusOne) {
  const Scratch folder;
  folder.write(
      "d.toml",
      "[inputs]\nu = { unit = '1' }\n[blocks]\nx = { kind = 'integrator', input = 'r', initial = 1 }\n"
      "r = { kind = 'product', inputs = ['x', 'x', 'u'] }\n[outputs]\nx = { unit = '1' }\n");
  const Said said = tandem(folder, {"check", "diagram:d.toml?step=0.1", "--input", "u=9"});
  EXPECT_EQ(said.status, 1);
  EXPECT_TRUE(contains(said.out, "wrong: times rise: it threw: ")) << said.out;
  EXPECT_TRUE(contains(said.err, "checks found something wrong")) << said.err;
}

TEST(CheckCommand, RefusesWhatItCanNotOpen) {
  const Scratch folder;
  EXPECT_EQ(tandem(folder, {"check", "builtin:two_mas.fast"}).status, 2);
  const Said said = tandem(folder, {"check", "builtin:two_mass.fast", "--input", "w=3"});
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "input 'w'")) << said.err;
}

}  // namespace
}  // namespace tandem
