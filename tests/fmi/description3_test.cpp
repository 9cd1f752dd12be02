// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "refusal.hpp"
#include "tandem/fmi/description.hpp"

namespace tandem::test {
namespace {

using namespace fmi;

/// A description of FMI 3.0 with one thing in place of another.
Description described3(const std::string& from = "", const std::string& to = "") {
  std::string text = R"X(<?xml version="1.0"?>
<fmiModelDescription fmiVersion="3.0.1" modelName="m" instantiationToken="{1}">
<ModelExchange modelIdentifier="m_1" needsCompletedIntegratorStep="true"/>
<CoSimulation modelIdentifier="m_1" canGetAndSetFMUState="true" hasEventMode="true" fixedInternalStepSize="0.1"/>
<TypeDefinitions><Float64Type name="Speed" unit="rad/s" max="100"/></TypeDefinitions>
<ModelVariables>
<UInt64 name="n" valueReference="4000000000" causality="structuralParameter" start="3"/>
<Float64 name="x" valueReference="7" causality="output" declaredType="Speed"><Alias name="speed"/></Float64>
<Float64 name="der(x)" valueReference="8" derivative="7"/>
<Float64 name="u" valueReference="9" causality="input" start="1 2 3 4 5 6" intermediateUpdate="true">
<Dimension valueReference="4000000000"/><Dimension start="2"/></Float64>
<Boolean name="b" valueReference="10" causality="parameter" start="true false"><Dimension start="2"/></Boolean>
<String name="s" valueReference="11" causality="parameter"><Start value="a text"/></String>
<Int8 name="i" valueReference="12" causality="input" min="-200" max="5"/>
</ModelVariables>
<ModelStructure>
<Output valueReference="7" dependencies="9 4000000000"/>
<ContinuousStateDerivative valueReference="8"/>
<EventIndicator valueReference="9"/>
</ModelStructure>
</fmiModelDescription>)X";
  if (!from.empty()) text.replace(text.find(from), from.size(), to);
  return read_description(text, "m.fmu");
}

TEST(FmuDescription3, GivesWhatIsWritten) {
  const Description d = described3();
  EXPECT_EQ(d.version, Version::three);
  EXPECT_EQ(d.guid, "{1}");
  EXPECT_FALSE(d.model_exchange->needs_no_completed_steps);
  EXPECT_TRUE(d.co_simulation->keeps_state && d.co_simulation->has_events);
  EXPECT_EQ(d.co_simulation->fixed_step, 0.1);
  ASSERT_EQ(d.variables.size(), 8U);
  EXPECT_EQ(d.at(0).reference, 4000000000U);
  EXPECT_EQ(d.at(0).variability, Variability::fixed);  // as of every parameter
  EXPECT_EQ(d.at(1).unit, "rad/s");
  EXPECT_EQ(d.at(1).max, 100.0);
  EXPECT_EQ(d.at(2).name, "speed");
  EXPECT_EQ(d.at(2).causality, Causality::local);
  EXPECT_EQ(d.at(3).derivative_of, 1);
  EXPECT_EQ(d.at(4).size, 6);
  EXPECT_EQ(d.at(4).start_values.back(), 6.0);
  EXPECT_TRUE(d.at(4).intermediate);
  EXPECT_EQ(d.at(5).start_values, (std::vector<double>{1.0, 0.0}));
  EXPECT_EQ(d.at(6).start, "a text");
  EXPECT_EQ(d.at(7).min, -128.0);  // of its type
  EXPECT_EQ(d.outputs[0].of, (std::vector<int>{4, 0}));
  EXPECT_EQ(d.event_indicators, 6);
  EXPECT_EQ(d.state_size(), 1);
}

TEST(FmuDescription3, WhatIsWrongIsNamedWithItsLine) {
  struct Case {
    std::string from, to;
    std::vector<std::string> texts;
  };
  for (const Case& c : std::vector<Case>{
           {"3.0.1", "4.0", {"m.fmu:2", "'4.0'", "2.0 or 3.0"}},
           {"derivative=\"7\"", "derivative=\"70\"", {"m.fmu:9", "'70'", "valueReference of a variable"}},
           {"derivative=\"7\"", "derivative=\"-1\"", {"m.fmu:9", "'-1'"}},
           {"<Dimension valueReference=\"4000000000\"/>",
            "<Dimension valueReference=\"1\"/>",
            {"m.fmu:11", "'1'", "valueReference of a variable"}},
           {"<Dimension start=\"2\"/></Float64>", "<Dimension start=\"x\"/></Float64>", {"m.fmu:11", "'x'"}},
           {"start=\"3\"/>", "/>", {"'u'", "size that is not known"}},
           {"start=\"3\"/>", "start=\"1e6\"/>", {"'u'", "more than 1048576"}},
           {"start=\"3\"/>", "start=\"-3\"/>", {"'u'", "size that is not known"}},
           {"<Alias name=\"speed\"/>", "<Alias name=\"n\"/>", {"'n' is there twice"}},
           {"<Output valueReference=\"7\"",
            "<Output valueReference=\"7\"/><Output valueReference=\"7\"",
            {"m.fmu:17", "'x' is listed twice"}},
           {"derivative=\"7\"", "derivative=\"9\"", {"'der(x)' has 1 elements and its state 6"}},
           {"start=\"3\"/>", "start=\"2.5\"/>", {"'u'", "size that is not known"}},
           {"start=\"3\"/>", "start=\"1e300\"/>", {"'u'", "size that is not known"}},
           {"3.0.1", "3.0-beta.5", {"'3.0-beta.5'"}},
           {"true false", "true no", {"m.fmu:12", "'true no'", "0, 1, false, true"}},
           {"1 2 3 4 5 6", "1 2 three", {"m.fmu:10", "numbers with blanks between"}},
           {"<Int8 ", "<Int7 ", {"m.fmu:14", "'i' has no type", "<Int8>"}},
           {"dependencies=\"9 4", "dependencies=\"99 4", {"m.fmu:17", "dependencies", "valueReference"}},
           {"<EventIndicator valueReference=\"9\"", "<EventIndicator", {"m.fmu:19", "not there"}},
           {"<ContinuousStateDerivative valueReference=\"8\"",
            "<ContinuousStateDerivative valueReference=\"9\"",
            {"'u' is listed as the derivative of a state"}}})
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, c.texts, [&] { described3(c.from, c.to); })) << c.to;
}

}  // namespace
}  // namespace tandem::test
