// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Models with blocks in C++ beside the same of listed blocks, over their scenes.
#include <gtest/gtest.h>

#include <cmath>

#include "engine_files.hpp"
#include "engine_models/compiled.hpp"

namespace tandem::engine {
namespace {

using test::engine_file;
using test::EngineRun;
using test::open_loop;

Description with_kinds(Description d) {
  d.kinds = engine_models::compiled_kinds();
  return d;
}

/// The largest difference of each output over 10 s, relative to 1 or its size.
double difference(const Description& one, const Description& other) {
  EngineRun a(one), b(with_kinds(other));
  double most = 0.0;
  for (int k = 1; k <= 1000; ++k) {
    a.run(0.01 * k), b.run(0.01 * k);
    for (const Output& output : one.outputs)
      most =
          std::max(most, std::abs(a[output.name] - b[output.name]) / std::max(1.0, std::abs(a[output.name])));
  }
  return most;
}

TEST(CompiledTwins, AreTheEngineInItsOpenLoop) {
  EXPECT_LT(difference(open_loop(engine_file("engine.toml")), open_loop(engine_file("engine_compiled.toml"))),
            1e-9);
}

TEST(CompiledTwins, AreThePowerTrainOverTheKartsManoeuvre) {
  EXPECT_LT(difference(engine_file("kart_monolithic.toml"),
                       engine_file("kart_monolithic.toml", {{"engine", "engine_compiled.toml"},
                                                            {"gearbox", "kart_automatic_compiled.toml"}})),
            1e-9);
}

}  // namespace
}  // namespace tandem::engine
