// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/fmi/description.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "refusal.hpp"
#include "tandem/fmi/unit_definitions.hpp"

namespace tandem::test {
namespace {

using namespace fmi;

/// A description with one thing in place of another.
std::string description(const std::string& from = "", const std::string& to = "") {
  std::string text = R"X(<?xml version="1.0"?>
<fmiModelDescription fmiVersion="2.0" modelName="m" guid="{1}" numberOfEventIndicators="2">
<ModelExchange modelIdentifier="m_1" canGetAndSetFMUstate="true"/>
<TypeDefinitions><SimpleType name="Speed"><Real unit="rad/s" min="-3" nominal="100"/></SimpleType></TypeDefinitions>
<ModelVariables>
<ScalarVariable name="x" valueReference="7" causality="output"><Real declaredType="Speed" start="+1.5e0"/></ScalarVariable>
<ScalarVariable name="der(x)" valueReference="8"><Real derivative="1" unit="N.m/kg2"/></ScalarVariable>
<ScalarVariable name="n" valueReference="7" causality="input"><Integer start="3"/></ScalarVariable>
<ScalarVariable name="b" valueReference="1" causality="parameter" variability="fixed"><Boolean start="1"/></ScalarVariable>
</ModelVariables>
<ModelStructure>
<Outputs><Unknown index="1" dependencies=" 1
  3 "/></Outputs>
<Derivatives><Unknown index="2"/></Derivatives>
</ModelStructure>
</fmiModelDescription>)X";
  if (!from.empty()) text.replace(text.find(from), from.size(), to);
  return text;
}

TEST(FmuDescription, GivesWhatIsWritten) {
  const Description d = read_description(description(), "m.fmu");
  EXPECT_EQ(d.guid, "{1}");
  EXPECT_EQ(d.event_indicators, 2);
  EXPECT_FALSE(d.co_simulation);
  EXPECT_EQ(d.model_exchange->model, "m_1");
  EXPECT_TRUE(d.model_exchange->keeps_state);
  ASSERT_EQ(d.variables.size(), 4U);
  const Variable &x = d.variables[0], &dx = d.variables[1], &n = d.variables[2], &b = d.variables[3];
  EXPECT_EQ(x.unit, "rad/s");
  EXPECT_EQ(x.min, -3.0);
  EXPECT_EQ(x.nominal, 100.0);
  EXPECT_EQ(x.start_values, std::vector<double>{1.5});
  EXPECT_EQ(x.variability, Variability::continuous);
  EXPECT_EQ(dx.derivative_of, 0);
  EXPECT_EQ(dx.unit, "N m/kg^2");
  EXPECT_EQ(n.variability, Variability::discrete);
  EXPECT_EQ(n.unit, "");
  EXPECT_EQ(b.start_values, std::vector<double>{1.0});
  EXPECT_EQ(d.outputs[0].of, (std::vector<int>{0, 2}));
  EXPECT_TRUE(d.derivatives[0].of_all);
}

TEST(FmuDescription, WhatIsWrongIsNamedWithItsLine) {
  struct Case {
    std::string from, to;
    std::vector<std::string> texts;
  };
  for (const Case& c : std::vector<Case>{
           {"fmiVersion=\"2.0\"", "fmiVersion=\"1.0\"", {"m.fmu:2", "'1.0'", "2.0"}},
           {"m_1", "../m", {"m.fmu:3", "'../m'", "letters"}},
           {"<ModelExchange", "<Other", {"offers no interface"}},
           {"<ModelExchange", "<ScheduledExecution", {"offers Scheduled Execution alone"}},
           {"min=\"-3\"", "min=\"low\"", {"m.fmu:4", "min", "'low'", "a number"}},
           {"min=\"-3\"", "min=\"-3\" max=\"-4\"", {"m.fmu:6", "min above its max"}},
           {"<Integer start=\"3\"/>", "<Integer start=\"3 4\"/>", {"m.fmu:8", "'3 4'", "one number"}},
           {"<ModelExchange",
            "<ModelExchange modelIdentifier=\"m_1\"/>\n<ModelExchange",
            {"m.fmu:4", "twice"}},
           {"name=\"n\"", "name=\"x\"", {"m.fmu:8", "'x' is there twice"}},
           {"<Integer start=\"3\"/>", "", {"m.fmu:8", "'n' has no type"}},
           {"valueReference=\"8\"", "valueReference=\"-8\"", {"m.fmu:7", "'-8'"}},
           {"derivative=\"1\"", "derivative=\"5\"", {"m.fmu:7", "'5'", "from 1 to 4"}},
           {"derivative=\"1\"", "", {"'der(x)'", "attribute derivative"}},
           {"causality=\"input\"", "causality=\"inputs\"", {"'inputs'", "calculatedParameter"}},
           {"  3 ", "  9 ", {"dependencies", "from 1 to 4"}},
           {"index=\"2\"", "index=\"0\"", {"'0'", "from 1 to 4"}},
           {"declaredType=\"Speed\"", "declaredType=\"Sped\"", {"'Sped'"}},
           {"</ModelVariables>", "</ModelVariable>", {"m.fmu:10", "no well-formed XML"}},
           {"<fmiModelDescription ",
            "<!DOCTYPE x [<!ENTITY e SYSTEM \"file:///etc/passwd\">]>\n<fmiModelDescription ",
            {"document type"}},
           {"numberOfEventIndicators=\"2\"", "numberOfEventIndicators=\"1e9\"", {"whole number"}}})
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, c.texts, [&] {
      read_description(description(c.from, c.to), "m.fmu");
    })) << c.to;
}

TEST(FmuDescription, UnitsAreWrittenAsTandemWritesThem) {
  for (const auto& [theirs, ours] :
       std::vector<std::pair<std::string, std::string>>{{"N.m", "N m"},
                                                        {"m/s2", "m/s^2"},
                                                        {"kg.m2", "kg m^2"},
                                                        {"rad/s", "rad/s"},
                                                        {"1", "1"},
                                                        {"", ""},
                                                        {"N.m.s/rad", "N m s/rad"},
                                                        {"s-1", "s^-1"},
                                                        {"r/min", "rpm"},
                                                        {"m/s^2", "m/s^2"}})
    EXPECT_EQ(unit_in(theirs, {}), ours);
}

/// As an FMU defines it.
std::string unit_of(const std::string& name, const std::string& base) {
  const std::string text = "<Units><Unit name=\"" + name + "\"><BaseUnit " + base + "/></Unit></Units>";
  const Xml xml(text, "units.xml");
  return unit_in(name, read_units(xml, xml.root("Units")));
}

TEST(FmuDescription, UnitsMeanWhatTheirBaseUnitsSay) {
  for (const auto& [name, base, ours] : std::vector<std::array<std::string, 3>>{
           {"N.m", "kg='1' m='2' s='-2'", "N m"},
           {"Nm", "kg='1' m='2' s='-2'", "kg m^2 s^-2"},
           {"newton", "kg='1' m='1' s='-2'", "N"},
           {"rev/min", "s='-1' rad='1' factor='0.104719755'", "rpm"},
           {"rpm", "s='-1' factor='0.10471975511966'", "rpm"},
           {"Celsius", "K='1' offset='273.15'", "degC"},
           {"g", "m='1' s='-2' factor='9.80665'", "9.80665 m s^-2"},
           {"N.s/m", "kg='1' s='-1'", "N s/m"},
           {"Nms", "kg='1' m='2' s='-1'", "kg m^2 s^-1"},
           {"degF", "K='1' factor='0.5' offset='255.5'", "0.5 K + 255.5"}})
    EXPECT_EQ(unit_of(name, base), ours);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"kg", "whole number"}, [] { unit_of("x", "kg='0.5'"); }));
}

}  // namespace
}  // namespace tandem::test
