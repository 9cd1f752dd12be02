// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Values that systems of SSP give parameters and inputs.
#include <gtest/gtest.h>

#include "system_reading.hpp"

namespace tandem::test {
namespace {

TEST(System, OuterBindingsHoldAndOfOneSystemTheLast) {
  const Scratch folder;
  const std::string inner = "<ssd:System name=\"in\">" + bindings({{"one.k", "2"}, {"one.d", "2"}}) +
                            "<ssd:Elements>" +
                            component("one", "mass", bindings({{"k", "1"}, {"d", "1"}, {"s", "1"}})) +
                            "</ssd:Elements></ssd:System>";
  const std::string set = "<ssv:Parameter name=\"k\"><ssv:Real value=\"4\"/></ssv:Parameter>";
  const std::string outer =
      "<ssd:ParameterBindings><ssd:ParameterBinding source=\"resources/p.ssv\" prefix=\"in.one.\"/>"
      "<ssd:ParameterBinding><ssd:ParameterValues>" +
      parameter_set(
          "<ssv:Parameter name=\"in.one.k\"><ssv:Real value=\"3\"/></ssv:Parameter>"
          "<ssv:Parameter name=\"nobody.k\"><ssv:Real value=\"3\"/></ssv:Parameter>") +
      "</ssd:ParameterValues></ssd:ParameterBinding></ssd:ParameterBindings>";
  const Scenario s = read_system(folder, ssd(outer + "<ssd:Elements>" + inner + "</ssd:Elements>"), {"mass"},
                                 {{"resources/p.ssv", parameter_set(set)}});
  EXPECT_EQ(s.subsystems[0].name, "in_one");
  EXPECT_EQ(given(s, 0, "set.k"), "3.000000");
  EXPECT_EQ(given(s, 0, "set.d"), "2.000000");
  EXPECT_EQ(given(s, 0, "set.s"), "1.000000");
  ASSERT_EQ(s.remarks.size(), 1U);
  EXPECT_NE(s.remarks[0].find("1 values of parameters are left out, as nothing takes them: nobody.k"),
            std::string::npos);
}

TEST(System, ValuesAreConvertedAndTransformedOnTheirWay) {
  const Scratch folder;
  const std::string set = parameter_set(
      "<ssv:Parameter name=\"far\"><ssv:Real value=\"3\" unit=\"mm\"/></ssv:Parameter>",
      "<ssv:Units><ssc:Unit name=\"mm\"><ssc:BaseUnit m=\"1\" factor=\"0.001\"/></ssc:Unit></ssv:Units>");
  const std::string mapping =
      "<ssd:ParameterMapping><ssm:ParameterMapping version=\"1.0\"><ssm:MappingEntry source=\"far\" "
      "target=\"c\">" +
      linear("2", "1") + "</ssm:MappingEntry></ssm:ParameterMapping></ssd:ParameterMapping>";
  const std::string system =
      connectors({{"input", "c", "m"}}) +
      "<ssd:ParameterBindings><ssd:ParameterBinding><ssd:ParameterValues>" + set + "</ssd:ParameterValues>" +
      mapping + "</ssd:ParameterBinding></ssd:ParameterBindings><ssd:Elements>" +
      component("one", "mass", connectors({{"input", "u", "mm"}})) + "</ssd:Elements><ssd:Connections>" +
      ssd_connection("c", "one.u", linear("10", "5")) + "</ssd:Connections>";
  const Scenario s = read_system(folder, ssd(system));
  ASSERT_EQ(s.subsystems[0].inputs.size(), 1U);
  EXPECT_EQ(s.subsystems[0].inputs[0].port, "u");
  EXPECT_NEAR(s.subsystems[0].inputs[0].at(0.0), 10.0 * (1000.0 * (2.0 * 0.003 + 1.0)) + 5.0, 1e-9);
}

TEST(System, ValuesOfEveryTypeAreGiven) {
  const Scratch folder;
  const std::string set = parameter_set(
      "<ssv:Parameter name=\"text\"><ssv:String value='say \"a\\b\"'/></ssv:Parameter>"
      "<ssv:Parameter name=\"flag_in\"><ssv:Boolean value=\"true\"/></ssv:Parameter>"
      "<ssv:Parameter name=\"whole_in\"><ssv:Integer value=\"-3\"/></ssv:Parameter>"
      "<ssv:Parameter name=\"choice_in\"><ssv:Enumeration value=\"high\" name=\"E\"/></ssv:Parameter>",
      "<ssv:Enumerations><ssc:Enumeration name=\"E\"><ssc:Item name=\"low\" value=\"1\"/>"
      "<ssc:Item name=\"high\" value=\"2\"/></ssc:Enumeration></ssv:Enumerations>");
  const std::string arrays =
      parameter_set("<ssv:Parameter name=\"A\"><ssv:Float64 value=\"0 1 -1 0\"/></ssv:Parameter>");
  const auto bound = [](const std::string& one) {
    return "<ssd:ParameterBindings><ssd:ParameterBinding><ssd:ParameterValues>" + one +
           "</ssd:ParameterValues></ssd:ParameterBinding></ssd:ParameterBindings>";
  };
  const Scenario s = read_system(folder,
                                 ssd("<ssd:Elements>" + component("types", "types3", bound(set)) +
                                     component("space", "space3", bound(arrays)) + "</ssd:Elements>"),
                                 {"types3", "space3"});
  EXPECT_EQ(given(s, 0, "set.text"), "say \"a\\b\"");
  ASSERT_EQ(s.subsystems[0].inputs.size(), 3U);
  for (const scenario::InputEntry& input : s.subsystems[0].inputs)
    EXPECT_EQ(input.at(0.0), input.port == "flag_in"    ? 1.0
                             : input.port == "whole_in" ? -3.0
                                                        : 2.0)
        << input.port;
  EXPECT_EQ(given(s, 1, "set.A"), "0 1 -1 0");
}

TEST(System, SeveralContainersOfBindingsAreRead) {
  const Scratch folder;
  const Scenario s = read_system(
      folder, ssd("<ssd:Elements>" + component("a", "mass", bindings({{"k", "2"}}) + bindings({{"d", "3"}})) +
                  "</ssd:Elements>"));
  EXPECT_EQ(given(s, 0, "set.k"), "2.000000");
  EXPECT_EQ(given(s, 0, "set.d"), "3.000000");
}

TEST(System, TextsThatBeginWithADollarStandForThemselves) {
  const Scratch folder;
  const std::string set =
      parameter_set("<ssv:Parameter name=\"text\"><ssv:String value=\"$(1+1)\"/></ssv:Parameter>");
  const Scenario s = read_system(
      folder,
      ssd("<ssd:Elements>" +
              component("$a", "types3",
                        "<ssd:ParameterBindings><ssd:ParameterBinding><ssd:ParameterValues>" + set +
                            "</ssd:ParameterValues></ssd:ParameterBinding></ssd:ParameterBindings>") +
              "</ssd:Elements>",
          "", "$s"),
      {"types3"});
  EXPECT_EQ(s.name, "$s");
  EXPECT_EQ(s.subsystems[0].name, "$a");
  EXPECT_EQ(given(s, 0, "set.text"), "$(1+1)");
}

}  // namespace
}  // namespace tandem::test
