// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/compile.hpp"

#include <gtest/gtest.h>

#include "diagram_run.hpp"
#include "refusal.hpp"

namespace tandem::engine {
namespace {

using test::DiagramRun;
using test::refuses;

Program compiled(const std::string& text) { return compile(read_diagram("d", text)); }

TEST(Compile, SortsBlocksWhateverTheirOrderInTheFile) {
  DiagramRun run(
      "[blocks]\nc = { kind = 'gain', input = 'b', gain = 2 }\nb = { kind = 'sum', inputs = ['a', 'time', 1] "
      "}\n"
      "a = { kind = 'constant', value = 3 }\n[outputs]\nc = { unit = '1' }\n");
  run.simulation.start(5.0);
  EXPECT_EQ(run.simulation.output(0), 2.0 * (3.0 + 5.0 + 1.0));
}

TEST(Compile, NamesTheBlocksAlongAnAlgebraicLoop) {
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"algebraic loop", "a, c, b"}, [] {
    compiled(
        "[blocks]\na = { kind = 'gain', input = 'c', gain = 2 }\nb = { kind = 'gain', input = 'a', gain = 2 "
        "}\n"
        "c = { kind = 'sum', inputs = ['b', 'time'] }\n[outputs]\na = { unit = '1' }\n");
  }));
}

TEST(Compile, LeavesOutWhatFeedsNoOutputWithANotice) {
  const Program p = compiled(
      "[blocks]\nused = { kind = 'integrator', input = 1 }\nidle = { kind = 'integrator', input = 'used' }\n"
      "[outputs]\nused = { unit = '1' }\n");
  EXPECT_EQ(p.states, 1);
  EXPECT_EQ(p.left_out, std::vector<std::string>{"idle"});
}

TEST(Compile, DerivesFeedthroughOfEachOutputOnEachInput) {
  const Program p = compiled(
      "[inputs]\nu = { unit = '1' }\nw = { unit = '1' }\n[blocks]\nx = { kind = 'integrator', input = 'u' }\n"
      "y = { kind = 'sum', inputs = ['x', 'w'] }\nz = { kind = 'saturation', input = 'u', low = 0, high = 1 "
      "}\n"
      "[outputs]\nx = { unit = '1' }\ny = { unit = '1' }\nz = { unit = '1' }\n");
  EXPECT_EQ(p.feedthrough, (std::vector<std::pair<int, int>>{{1, 1}, {2, 0}}));
}

TEST(Compile, RefusesByPlaceAndName) {
  const auto blocks = [](const std::string& text) {
    return [text] { compiled("[blocks]\n" + text + "\n[outputs]\nx = { unit = '1' }\n"); };
  };
  const auto code = ErrorCode::invalid_argument;
  EXPECT_TRUE(refuses(code, {"d:2", "'x'", "'intgrator'", "integrator"},
                      blocks("x = { kind = 'intgrator', input = 1 }")));
  EXPECT_TRUE(refuses(code, {"d:2", "kind integrator", "no input"}, blocks("x = { kind = 'integrator' }")));
  EXPECT_TRUE(refuses(code, {"d:2", "'y' is not there", "x"},
                      blocks("x = { kind = 'gain', input = 'y', gain = 1 }")));
  EXPECT_TRUE(refuses(code, {"d:2", "'gian' is not there"},
                      blocks("x = { kind = 'gain', input = 1, gain = 1, gian = 2 }")));
  EXPECT_TRUE(refuses(code, {"d:2", "gain is the text 'a'", "finite number"},
                      blocks("x = { kind = 'gain', input = 1, gain = 'a' }")));
  EXPECT_TRUE(refuses(code, {"d:2", "low is 2", "below high, 1"},
                      blocks("x = { kind = 'saturation', input = 1, low = 2, high = 1 }")));
  EXPECT_TRUE(refuses(code, {"kind table", "the point 1 after 2"},
                      blocks("x = { kind = 'table', input = 'time', x = [0, 2, 1], y = [0, 0, 0] }")));
  EXPECT_TRUE(refuses(code, {"d:2", "'$$k'", "a finite number"},
                      blocks("x = { kind = 'gain', input = 1, gain = '$$k' }")));
}

TEST(Compile, ParametersStandForNumbers) {
  const std::string text =
      "[parameters]\nk = { value = 3, unit = '1' }\n[blocks]\nx = { kind = 'gain', input = 'time', gain = "
      "'$k' }\n"
      "[outputs]\nx = { unit = '1' }\n";
  const Program p = compile(read_diagram("d", text, {{"k", 7.0}}));
  Simulation s(p, nullptr, make_integrator({}));
  s.start(2.0);
  EXPECT_EQ(s.output(0), 14.0);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"parameter 'j'", "k"}, [&] {
    read_diagram("d", text, {{"j", 1.0}});
  }));
}

}  // namespace
}  // namespace tandem::engine
