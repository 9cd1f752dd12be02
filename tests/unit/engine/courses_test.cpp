// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Which outputs of a diagram are held, which can jump, and which diagrams are sampled.
#include <gtest/gtest.h>

#include "diagram_run.hpp"
#include "refusal.hpp"
#include "tandem/engine/subsystem.hpp"

namespace tandem::engine {
namespace {

/// A diagram with inputs u and w, the blocks, and output y.
Program with_blocks(const std::string& blocks) {
  return compile(read_diagram("d", "[inputs]\nu = { unit = '1' }\nw = { unit = '1' }\n[blocks]\n" + blocks +
                                       "\n[outputs]\ny = { unit = '1' }\n"));
}

struct Case {
  const char* blocks;
  bool held, jumps;
};

/// What bends is not what jumps; a constant is not held, as it never changes.
TEST(Courses, OfOutputsAreHeldOrJumpOrNeither) {
  for (const Case& c : std::initializer_list<Case>{
           {"y = { kind = 'constant', value = 1 }", false, false},
           {"y = { kind = 'gain', input = 'u', gain = 2 }", false, false},
           {"y = { kind = 'lag', input = 'u', time = 1 }", false, false},
           {"y = { kind = 'saturation', input = 'u', low = 0, high = 1 }", false, false},
           {"y = { kind = 'dead_zone', input = 'u', low = 0, high = 1 }", false, false},
           {"y = { kind = 'integrator', input = 'u', low = 0, high = 1 }", false, false},
           {"y = { kind = 'rate_limiter', input = 'u', time = 0.1, rising = 1, falling = 1 }", false, false},
           {"y = { kind = 'pid', input = 'u', kp = 1, ki = 1, low = 0, high = 1 }", false, false},
           {"y = { kind = 'ramp', time = 1, slope = 2 }", false, false},
           {"y = { kind = 'piecewise_linear', times = [0, 1], values = [0, 1] }", false, false},
           {"y = { kind = 'piecewise_linear', times = [0, 1, 1, 2], values = [0, 1, 2, 1] }", false, true},
           {"y = { kind = 'piecewise_linear', times = [0, 1], values = [0, 1], interpolation = 'hold' }",
            true, true},
           {"y = { kind = 'memory', input = 'u' }", false, false},
           {"y = { kind = 'step', time = 1, after = 2 }", true, true},
           {"y = { kind = 'relay', input = 'u', low = 0, high = 1 }", true, true},
           {"y = { kind = 'sample', input = 'u', trigger = 'w' }", true, true},
           {"y = { kind = 'sample', input = 'u', period = 0.1 }", true, true},
           {"y = { kind = 'switch', control = 'u', above = 1, below = 2 }", true, true},
           {"y = { kind = 'switch', control = 'u', above = 'w', below = 2 }", false, true},
           {"y = { kind = 'integrator', input = 'u', reset = 'w' }", false, true},
           {"y = { kind = 'delay', input = 'u', delay = 0.1 }", false, true},
           {"y = { kind = 'delay', input = 'l', delay = 0.1 }\nl = { kind = 'lag', input = 'u', time = 1 }",
            false, false},
           {"y = { kind = 'sum', inputs = ['u', 's'] }\ns = { kind = 'step', time = 1, after = 2 }", false,
            true},
           {"y = { kind = 'lag', input = 's', time = 1 }\ns = { kind = 'step', time = 1, after = 2 }", false,
            false},
           {"y = { kind = 'gain', input = 's', gain = 2 }\ns = { kind = 'step', time = 1, after = 2 }", true,
            true}}) {
    const Program p = with_blocks(c.blocks);
    EXPECT_EQ(p.courses[0].held, c.held) << c.blocks;
    EXPECT_EQ(p.courses[0].jumps, c.jumps) << c.blocks;
    EXPECT_EQ(p.jumps(), c.jumps) << c.blocks;
  }
}

/// Values of the instant go through to what they make at it, but not to what was held before.
TEST(Courses, OfSampledDiagramsFollowInputsAtTheirInstants) {
  using Pairs = std::vector<std::pair<int, int>>;
  const auto feedthrough = [](const char* blocks) {
    const Program p = with_blocks(blocks);
    EXPECT_TRUE(p.sampled()) << blocks;
    return p.feedthrough;
  };
  EXPECT_EQ(feedthrough("y = { kind = 'sample', input = 'u', period = 0.1 }"), (Pairs{{0, 0}}));
  EXPECT_EQ(feedthrough("y = { kind = 'unit_delay', input = 'u', period = 0.1 }"), Pairs{});
  EXPECT_EQ(feedthrough("y = { kind = 'sample', input = 'l', period = 0.1 }\n"
                        "l = { kind = 'switch', control = 'w', above = 'u', below = 1 }"),
            (Pairs{{0, 0}, {0, 1}}));
  EXPECT_EQ(feedthrough("y = { kind = 'sample', input = 'x', period = 0.1 }\n"
                        "x = { kind = 'sample', input = 'u', period = 0.1 }"),
            Pairs{});
  EXPECT_EQ(feedthrough("y = { kind = 'relay', input = 'x', low = 0, high = 1 }\n"
                        "x = { kind = 'sample', input = 'u', period = 0.1 }"),
            (Pairs{{0, 0}}));
}

/// A relay of an input, a state, a step of time at an output: they do something between instants.
TEST(Courses, OfSomethingBetweenInstantsMakeADiagramThatIsNotSampled) {
  const std::string held = "h = { kind = 'sample', input = 'u', period = 0.1 }\n";
  for (const std::string more :
       {"y = { kind = 'switch', control = 'u', above = 'h', below = 1 }",
        "y = { kind = 'sum', inputs = ['h', 'r'] }\n"
        "r = { kind = 'relay', input = 'u', low = 0, high = 1 }",
        "y = { kind = 'sum', inputs = ['u', 'h'] }", "y = { kind = 'lag', input = 'h', time = 1 }",
        "y = { kind = 'delay', input = 'h', delay = 0.1 }",
        "y = { kind = 'sum', inputs = ['h', 's'] }\n"
        "s = { kind = 'step', time = 1, after = 2 }"})
    EXPECT_FALSE(with_blocks(held + more).sampled()) << more;
  EXPECT_TRUE(with_blocks(held + "y = { kind = 'gain', input = 'h', gain = 2 }").sampled());
}

TEST(Courses, OfSampledDiagramsHaveTheLeastTimeBetweenTwoInstants) {
  const auto period = [](const std::string& first, const std::string& second) {
    return with_blocks("y = { kind = 'sum', inputs = ['a', 'b'] }\na = { kind = 'sample', input = 'u', " +
                       first + " }\nb = { kind = 'sample', input = 'w', " + second + " }")
        .shortest_period;
  };
  EXPECT_DOUBLE_EQ(period("period = 0.2", "period = 0.2"), 0.2);
  EXPECT_DOUBLE_EQ(period("period = 0.2", "period = 0.3"), 0.1);
  EXPECT_NEAR(period("period = 0.2", "period = 0.2, offset = 0.15"), 0.05, 1e-15);
  EXPECT_NEAR(period("period = 0.006, offset = 0.001", "period = 0.009"), 0.001, 1e-15);
  EXPECT_NEAR(period("period = 0.7", "period = 0.1, offset = 0.3"), 0.1, 1e-15);
  test::refuses(ErrorCode::invalid_argument, {"no common measure", "'b'", "'a'", "1 s", "1.4142"},
                [&] { period("period = 1", "period = 1.4142135623730951"); });
}

TEST(Courses, OfASampledDiagramTakeNoStep) {
  const auto d = read_diagram("d",
                              "[inputs]\nu = { unit = '1' }\n[blocks]\ny = { kind = 'sample', input = 'u', "
                              "period = 0.25 }\n[outputs]\ny = { unit = '1' }\n");
  test::refuses(ErrorCode::invalid_argument, {"diagram 'd' is sampled", "0.25 s", "0.1 s"},
                [&] { make_subsystem(d, {.step = 0.1}); });
  const auto subsystem = make_subsystem(d, {});
  EXPECT_TRUE(subsystem->info().abilities.sampled);
  EXPECT_TRUE(subsystem->info().outputs[0].held);
  EXPECT_EQ(subsystem->info().sampling.period, 0.25);
}

}  // namespace
}  // namespace tandem::engine
