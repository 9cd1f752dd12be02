// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Units of a diagram's ports: what is one signal has one unit.
#include <gtest/gtest.h>

#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/engine/compile.hpp"
#include "tandem/engine/read.hpp"

namespace tandem::engine {
namespace {

class DiagramUnits : public testing::Test {
 protected:
  void SetUp() override {
    folder.write("shaft.toml",
                 "[parameters]\nJ = { value = 2, unit = 'kg m^2' }\n[inputs]\ntorque = { unit = 'N m' }\n"
                 "[blocks]\nrate = { kind = 'quotient', numerator = 'torque', denominator = '$J' }\n"
                 "N = { kind = 'integrator', input = 'rate' }\n[outputs]\nN = { unit = 'rad/s' }\n");
  }
  Program compiled(const std::string& text) const {
    return compile(read_diagram(folder.write("d.toml", text)));
  }
  testing::AssertionResult refused(const std::string& text, const std::vector<std::string>& words) const {
    return test::refuses(ErrorCode::invalid_argument, words, [&] { compiled(text); });
  }
  const test::Scratch folder;
};

const std::string shaft = "[blocks]\nshaft = { kind = 'diagram', file = 'shaft.toml', torque = 'M' }\n",
                  input = "[inputs]\nM = { unit = 'N m' }\n";

TEST_F(DiagramUnits, AreThoseOfTheDiagramsInBlocks) {
  EXPECT_NO_THROW(compiled(input + shaft + "[outputs]\nN = { unit = 'rad/s', from = 'shaft' }\n"));
  EXPECT_TRUE(refused(
      "[inputs]\nM = { unit = 'N' }\n" + shaft + "[outputs]\nN = { unit = 'rad/s', from = 'shaft' }\n",
      {"d.toml:4", "block 'shaft' of kind diagram: input 'torque' is in 'N m'", "input 'M'", "'N'"}));
  EXPECT_TRUE(refused(
      input + shaft + "[outputs]\nN = { unit = 'rpm', from = 'shaft.N' }\n",
      {"d.toml:6", "output 'N' is in 'rpm'", "block 'shaft' of kind diagram: output 'N'", "'rad/s'"}));
}

TEST_F(DiagramUnits, AreKeptByWhatOnlyLimitsHoldsOrAdds) {
  for (const char* kind :
       {"{ kind = 'sum', inputs = ['M', 1] }", "{ kind = 'sum', inputs = ['M', 1], gains = [-1, 1] }",
        "{ kind = 'lag', input = 'M', time = 1 }", "{ kind = 'function', function = 'abs', input = 'M' }",
        "{ kind = 'function', function = 'max', inputs = [0, 'M'] }",
        "{ kind = 'integrator', input = 1, initial = 'M' }",
        "{ kind = 'saturation', input = 'M', low = 0, high = 1 }", "{ kind = 'memory', input = 'M' }",
        "{ kind = 'delay', input = 'M', delay = 1 }",
        "{ kind = 'switch', control = 'time', above = 'M', below = 0 }"}) {
    const std::string text = input + "[blocks]\nx = " + kind + "\n[outputs]\nx = { unit = ";
    EXPECT_NO_THROW(compiled(text + "'N m' }\n")) << kind;
    EXPECT_TRUE(refused(text + "'rad/s' }\n", {"d.toml:6", "output 'x' is in 'rad/s'", "input 'M'"})) << kind;
  }
  for (const char* kind :
       {"{ kind = 'gain', input = 'M', gain = 1 }", "{ kind = 'sum', inputs = ['M'], gains = [2] }",
        "{ kind = 'lag', input = 'M', time = 1, gain = 1 }",
        "{ kind = 'function', function = 'square', input = 'M' }", "{ kind = 'integrator', input = 'M' }"})
    EXPECT_NO_THROW(compiled(input + "[blocks]\nx = " + kind + "\n[outputs]\nx = { unit = 'N' }\n")) << kind;
}

TEST_F(DiagramUnits, OfTermsOfASumAreTheSame) {
  EXPECT_TRUE(
      refused("[inputs]\nM = { unit = 'N m' }\nN = { unit = 'rad/s' }\n[blocks]\n"
              "x = { kind = 'sum', inputs = ['M', 'N'] }\ny = { kind = 'gain', input = 'x', gain = 2 }\n"
              "[outputs]\ny = { unit = 'W' }\n",
              {"d.toml:3", "input 'N' is in 'rad/s'", "input 'M'", "'N m'"}));
}

TEST_F(DiagramUnits, OfAParameterThatIsHandedOnIsThatOfTheOther) {
  const auto text = [](const char* unit) {
    return std::string("[parameters]\nm = { value = 1, unit = '") + unit + "' }\n" + input +
           "[blocks]\nshaft = { kind = 'diagram', file = 'shaft.toml', torque = 'M', J = '$m' }\n"
           "[outputs]\nN = { unit = 'rad/s', from = 'shaft' }\n";
  };
  EXPECT_NO_THROW(compiled(text("kg m^2")));
  EXPECT_TRUE(refused(text("kg"), {"d.toml:6", "blocks.shaft.J", "parameter 'm' is in 'kg'", "'kg m^2'"}));
}

}  // namespace
}  // namespace tandem::engine
