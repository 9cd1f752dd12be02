// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Systems of the standard SSP, read as scenarios.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "refusal.hpp"
#include "system_file.hpp"
#include "tandem/coordinator/units.hpp"
#include "tandem/scenario/scenario.hpp"

namespace tandem::test {
namespace {

using scenario::Scenario;

Scenario read_system(const Scratch& folder, const std::string& description,
                     const std::vector<std::string>& fmus = {"mass"}, const std::vector<Packed>& more = {}) {
  return scenario::read(write_system(folder, description, fmus, more));
}

/// Of a subsystem's parameter; empty: it is not given.
std::string given(const Scenario& s, std::size_t subsystem, const std::string& name) {
  for (const scenario::Parameter& p : s.subsystems.at(subsystem).parameters)
    if (p.name == name)
      return std::visit(
          [](const auto& value) {
            if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string>)
              return value;
            else
              return std::to_string(value);
          },
          p.value);
  return "";
}

bool is_given(const Scenario& s, std::size_t subsystem, const std::string& name) {
  const auto& all = s.subsystems.at(subsystem).parameters;
  return std::any_of(all.begin(), all.end(), [&](const scenario::Parameter& p) { return p.name == name; });
}

const std::string pair_of_masses =
    "<ssd:Elements>" +
    component("one", "mass",
              connectors({{"input", "u", "-"}, {"output", "x", "-"}}) + bindings({{"k", "4"}})) +
    component("two", "mass", connectors({{"input", "u", "-"}, {"output", "x", "-"}})) + "</ssd:Elements>" +
    "<ssd:Connections>" + ssd_connection("one.x", "two.u") + ssd_connection("one.u", "two.x") +
    "</ssd:Connections>";

TEST(System, OfTwoMassesIsAScenario) {
  const Scratch folder;
  const Scenario s = read_system(folder, ssd(pair_of_masses));
  EXPECT_EQ(s.name, "s");
  EXPECT_EQ(s.start, 0.0);
  EXPECT_EQ(s.stop, 1.0);
  ASSERT_EQ(s.subsystems.size(), 2U);
  EXPECT_EQ(s.subsystems[0].name, "one");
  EXPECT_EQ(s.subsystems[0].source, "fmu:s.ssp/resources/mass.fmu");
  EXPECT_EQ(given(s, 0, "set.k"), "4.000000");
  ASSERT_EQ(s.connections.size(), 2U);
  EXPECT_EQ(s.connections[0].connection.from, "one.x");
  EXPECT_EQ(s.connections[0].connection.to, "two.u");
  EXPECT_EQ(s.connections[1].connection.from, "two.x") << "start and end are no direction";
  EXPECT_EQ(s.connections[1].connection.to, "one.u");
  EXPECT_EQ(s.connections[1].connection.how->name(), "lagrange1");
  EXPECT_EQ(s.coordination.schedule, Schedule::Kind::slowest_first);
  ASSERT_EQ(s.remarks.size(), 1U);
  EXPECT_NE(s.remarks[0].find("says nothing of its coupling"), std::string::npos);
}

std::string annotated(const std::string& attributes) {
  return "<ssd:Annotations><ssc:Annotation type=\"other\"/><ssc:Annotation "
         "type=\"org.tandem.coordination\"><t:x " +
         attributes + "/></ssc:Annotation></ssd:Annotations>";
}

TEST(System, AnnotationsSayHowItIsCoupled) {
  const Scratch folder;
  const std::string system =
      "<ssd:Elements>" +
      component("one", "mass", annotated("step=\"0.002\" inputs=\"left\" land=\"never\"")) +
      component("two", "mass") + "</ssd:Elements><ssd:Connections>" +
      ssd_connection("one.x", "two.u", annotated("memory=\"true\"")) +
      ssd_connection("two.x", "one.u", annotated("reconstruction=\"hermite\"")) + "</ssd:Connections>";
  const Scenario s = read_system(
      folder,
      ssd(system,
          annotated("schedule=\"parallel\" communication_step=\"0.5\" reconstruction=\"lagrange2\"")));
  EXPECT_EQ(s.coordination.schedule, Schedule::Kind::parallel);
  EXPECT_EQ(s.coordination.communication_step, 0.5);
  EXPECT_EQ(given(s, 0, "step"), "0.002000");
  EXPECT_EQ(given(s, 0, "inputs"), "left");
  EXPECT_EQ(s.coordination.landing.at("one"), Landing::never);
  EXPECT_EQ(s.connections[0].connection.lag, Lag::memory);
  EXPECT_EQ(s.connections[0].connection.how->name(), "lagrange2");
  EXPECT_EQ(s.connections[1].connection.how->name(), "hermite");
  EXPECT_TRUE(s.remarks.empty());
}

/// One that goes through connectors of systems: how many are left on the way out, and entered on the way in.
struct Way {
  struct Hop {
    std::string unit;
    double factor, offset;
    bool keeps, swapped;
  };
  std::string from_unit;
  std::vector<Hop> hops;  ///< the last one ends at the component
  std::size_t outwards;

  double value(double x) const {
    std::string unit = from_unit;
    for (const Hop& hop : hops) {
      if (!hop.keeps && unit != "-" && hop.unit != "-") {
        const auto c = convert_unit(ours(unit), ours(hop.unit));
        x = c->factor * x + c->shift;
      }
      if (hop.keeps || hop.unit != "-") unit = hop.unit;
      x = hop.factor * x + hop.offset;
    }
    return x;
  }

  static std::string ours(const std::string& unit) {
    return unit == "inch" ? "0.0254 m" : unit == "datum" ? "2 m + 5" : unit;
  }

  /// Systems around each end, each of which has the connector c.
  std::string description() const {
    std::string from = component("a", "mass", connectors({{"output", "x", from_unit}})), inside = "a.x";
    for (std::size_t k = 0; k < outwards; ++k) {
      from = "<ssd:System name=\"o\">" + connectors({{"output", "c", hops[k].unit}}) + "<ssd:Elements>" +
             from + "</ssd:Elements><ssd:Connections>" + joined(inside, "c", k) +
             "</ssd:Connections></ssd:System>";
      inside = "o.c";
    }
    std::string to = component("b", "mass", connectors({{"input", "u", hops.back().unit}})), end = "b.u";
    for (std::size_t k = hops.size() - 1; k > outwards; --k) {
      to = "<ssd:System name=\"i\">" + connectors({{"input", "c", hops[k - 1].unit}}) + "<ssd:Elements>" +
           to + "</ssd:Elements><ssd:Connections>" + joined("c", end, k) + "</ssd:Connections></ssd:System>";
      end = "i.c";
    }
    return "<ssd:Elements>" + from + to + "</ssd:Elements><ssd:Connections>" + joined(inside, end, outwards) +
           "</ssd:Connections>";
  }

  std::string joined(const std::string& from, const std::string& to, std::size_t k) const {
    const Hop& hop = hops[k];
    const std::string how = linear(std::to_string(hop.factor), std::to_string(hop.offset));
    const std::string keeps = hop.keeps ? "suppressUnitConversion=\"true\"" : "";
    return hop.swapped ? ssd_connection(to, from, how, keeps) : ssd_connection(from, to, how, keeps);
  }
};

Way random_way(std::mt19937& random) {
  const std::array<std::string, 6> units = {"m", "mm", "inch", "km", "datum", "-"};
  const auto pick = [&](std::size_t most) {
    return std::uniform_int_distribution<std::size_t>(0, most)(random);
  };
  const std::size_t outwards = pick(3), inwards = pick(3);
  Way way{units[pick(4)], {}, outwards};
  for (std::size_t k = 0; k <= outwards + inwards; ++k) {
    const bool last = k == outwards + inwards;
    way.hops.push_back({units[pick(last ? 4 : 5)], 0.25 * (1.0 + static_cast<double>(pick(8))),
                        static_cast<double>(pick(4)), pick(5) == 0, pick(1) == 0});
  }
  return way;
}

/// What the scenario's connection makes of a number at the port `a` in the unit of that port.
double carried(const Scenario& s, double x) {
  const Connection& c = s.connections.at(0).connection;
  const auto unit = [&](std::size_t subsystem, const std::string& port) {
    for (const scenario::Parameter& p : s.subsystems[subsystem].parameters)
      if (p.name == "unit." + port) return std::get<std::string>(p.value);
    return std::string("m");
  };
  const std::string from = unit(0, "x"), to = unit(1, "u");
  if (from != to && !to.empty()) {
    EXPECT_TRUE(c.convert);
    const auto conversion = convert_unit(from, to);
    x = conversion->factor * x + conversion->shift;
  }
  return c.gain * x + c.offset;
}

/// Against the same numbers taken hop by hop.
TEST(System, TransformationsAndUnitsOfRandomWaysThroughSystemsAdd) {
  std::mt19937 random(24);
  for (int trial = 0; trial < 300; ++trial) {
    const Scratch folder;
    const Way way = random_way(random);
    const Scenario s = read_system(folder, ssd(way.description()));
    ASSERT_EQ(s.connections.size(), 1U);
    for (const double x : {0.0, 1.0, -3.5}) {
      const double right = way.value(x);
      EXPECT_NEAR(carried(s, x), right, 1e-12 * std::max(1.0, std::abs(right)))
          << trial << ": " << way.description();
    }
  }
}

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

/// In their own units, by mappings, and through connectors of systems, in this order.
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

/// A system in an archive within the archive, twice.
TEST(System, OtherSystemsLieInIt) {
  const Scratch folder, inner;
  const std::string one =
      connectors({{"input", "in", "-"}, {"output", "out", "-"}, {"parameter", "p", "-"}}) +
      bindings({{"p", "7"}, {"m.d", "1"}}) + "<ssd:Elements>" + component("m", "mass") +
      "</ssd:Elements><ssd:Connections>" + ssd_connection("in", "m.u") + ssd_connection("m.x", "out") +
      ssd_connection("p", "m.k") + "</ssd:Connections>";
  const std::string archive = read_text(write_system(inner, ssd(one)));
  const auto nested = [](const std::string& name, const std::string& inside = "") {
    return "<ssd:Component name=\"" + name +
           "\" type=\"application/x-ssp-package\" source=\"resources/in%20ner.ssp\">" + inside +
           "</ssd:Component>";
  };
  const std::string outer = "<ssd:Elements>" + nested("a", bindings({{"p", "8"}})) + nested("b") +
                            "</ssd:Elements><ssd:Connections>" + ssd_connection("a.out", "b.in") +
                            ssd_connection("b.out", "a.in") + "</ssd:Connections>";
  const Scenario s = read_system(folder, ssd(outer), {}, {{"resources/in ner.ssp", archive}});
  ASSERT_EQ(s.subsystems.size(), 2U);
  EXPECT_EQ(s.subsystems[0].source, "fmu:s.ssp/resources/in ner.ssp/resources/mass.fmu");
  EXPECT_EQ(given(s, 0, "set.k"), "8.000000");
  EXPECT_EQ(given(s, 1, "set.k"), "7.000000");
  EXPECT_EQ(given(s, 1, "set.d"), "1.000000");
  ASSERT_EQ(s.connections.size(), 2U);
  EXPECT_EQ(s.connections[0].connection.from, "b_m.x");
  EXPECT_EQ(s.connections[0].connection.to, "a_m.u");
}

/// Of a variable that the FMU does not call an output, too.
TEST(System, UnitsOfConnectorsHold) {
  const Scratch folder;
  const std::string system =
      "<ssd:Elements>" + component("a", "mass", connectors({{"local", "a", "mm"}, {"output", "v", "mm"}})) +
      component("b", "mass", connectors({{"input", "u", "m"}})) + "</ssd:Elements><ssd:Connections>" +
      ssd_connection("a.a", "b.u") + "</ssd:Connections>";
  const Scenario s = read_system(folder, ssd(system));
  EXPECT_EQ(given(s, 0, "unit.a"), "mm");
  EXPECT_EQ(given(s, 0, "unit.v"), "mm");
  EXPECT_EQ(given(s, 0, "outputs.a"), "1");
  EXPECT_TRUE(s.connections[0].connection.convert);
  ASSERT_EQ(s.remarks.size(), 3U);
  EXPECT_NE(s.remarks[0].find("'a.a' has the unit 'mm' of the system; its FMU says 'm/s^2'"),
            std::string::npos)
      << s.remarks[0];
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

TEST(System, ManyPartsTakeLittleTimeAndTooManySystemsInEachOtherAreRefused) {
  const Scratch folder;
  std::string deep = component("a", "mass"), text;
  for (int k = 0; k < 20000; ++k)
    deep = "<ssd:System name=\"s\"><ssd:Elements>" + deep + "</ssd:Elements></ssd:System>";
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"more than 32 systems lie in each other"},
                      [&] { read_system(folder, ssd("<ssd:Elements>" + deep + "</ssd:Elements>")); }));
  std::vector<std::pair<std::string, std::string>> many;
  for (int k = 0; k < 20000; ++k) many.emplace_back("x" + std::to_string(k), "1");
  const Scenario s = read_system(
      folder, ssd(bindings(many) + "<ssd:Elements>" + component("a", "mass") + "</ssd:Elements>"));
  ASSERT_EQ(s.remarks.size(), 1U);
  EXPECT_NE(s.remarks[0].find("20000 values"), std::string::npos);
}

TEST(System, UnitsThatAreNotKnownAreRemarked) {
  const Scratch folder;
  const std::string system = "<ssd:Elements><ssd:System name=\"i\">" + connectors({{"output", "c", "[m]"}}) +
                             "<ssd:Elements>" + component("a", "mass") + "</ssd:Elements><ssd:Connections>" +
                             ssd_connection("a.x", "c") + "</ssd:Connections></ssd:System>" +
                             component("b", "mass") + "</ssd:Elements><ssd:Connections>" +
                             ssd_connection("i.c", "b.u", linear("2", "1")) + "</ssd:Connections>";
  const Scenario s = read_system(folder, ssd(system));
  EXPECT_FALSE(is_given(s, 1, "unit.u")) << "from m to m in the end";
  EXPECT_EQ(s.connections[0].connection.gain, 2.0);
  ASSERT_EQ(s.remarks.size(), 2U);
  EXPECT_NE(s.remarks[1].find("[m]"), std::string::npos) << s.remarks[1];
}

/// Whether the component declares the connector or not.
TEST(System, SuppressedConversionsTakeNumbersAsTheyAre) {
  for (const std::string& declared : {connectors({{"input", "u", "m"}}), std::string()}) {
    const Scratch folder;
    const std::string system =
        "<ssd:Elements>" + component("a", "mass", connectors({{"output", "x", "mm"}})) +
        component("b", "mass", declared) + "</ssd:Elements><ssd:Connections>" +
        ssd_connection("a.x", "b.u", "", "suppressUnitConversion=\"true\"") + "</ssd:Connections>";
    const Scenario s = read_system(folder, ssd(system));
    EXPECT_TRUE(is_given(s, 1, "unit.u"));
    EXPECT_EQ(given(s, 1, "unit.u"), "");
    EXPECT_FALSE(s.connections[0].connection.convert);
  }
}

struct Fault {
  std::string description;
  std::vector<std::string> texts;
};

void expect_refused(const std::vector<Fault>& faults) {
  for (const Fault& fault : faults) {
    const Scratch folder;
    std::string found;
    try {
      read_system(folder, fault.description);
    } catch (const Error& error) {
      found = error.what();
    }
    for (const std::string& text : fault.texts)
      EXPECT_NE(found.find(text), std::string::npos) << "'" << text << "' in: " << found;
  }
}

std::string with(const std::string& elements, const std::string& connections_text = "") {
  return ssd("<ssd:Elements>" + elements + "</ssd:Elements>" +
             (connections_text.empty() ? "" : "<ssd:Connections>" + connections_text + "</ssd:Connections>"));
}

TEST(System, WhatIsWrongIsNamed) {
  const std::string a = component("a", "mass"), b = component("b", "mass");
  expect_refused({
      {"no xml", {"no well-formed XML"}},
      {"<a/>", {"<SystemStructureDescription>"}},
      {ssd(""), {"no component"}},
      {with(a + a), {"'a' is there twice"}},
      {with(component("a", "mas")), {"s.ssp' holds no 'resources/mas.fmu'"}},
      {with("<ssd:Component name=\"a\" source=\"../mass.fmu\"/>"), {"'../mass.fmu'", "in this archive"}},
      {with("<ssd:Component name=\"a\" source=\"/etc/passwd\"/>"), {"'/etc/passwd'", "relative path"}},
      {with("<ssd:Component name=\"a\" source=\"http://x/y.fmu\"/>"), {"relative path"}},
      {with("<ssd:Component name=\"a\" source=\"\"/>"), {"attribute source"}},
      {with("<ssd:Component name=\"a\" type=\"text/x-modelica\" source=\"a.mo\"/>"), {"text/x-modelica"}},
      {with("<ssd:SignalDictionaryReference name=\"a\" dictionary=\"d\"/>"), {"SignalDictionaryReference"}},
      {with(a + b, ssd_connection("a.x", "b.y")), {"'b': connector 'y' is not there"}},
      {with(a + b, ssd_connection("a.x", "c.u")), {"element 'c' is not there"}},
      {with(a + b, ssd_connection("a.x", "b.x")), {"'a.x' and 'b.x', give values"}},
      {with(a + b, ssd_connection("a.u", "b.u")), {"take values"}},
      {with(a + b, ssd_connection("a.x", "b.u") + ssd_connection("a.v", "b.u")), {"a second connection"}},
      {with(a + b, ssd_connection("a.v", "b.u")), {"'u' takes values of unit 'm/s' in unit 'm'"}},
      {with(a + b, ssd_connection("a.x", "b.k")), {"parameter 'k' is to follow another component"}},
      {with(a + b, ssd_connection("a.x", "b.u", "<ssc:IntegerMappingTransformation/>")), {"IntegerMapping"}},
      {with(a + b, ssd_connection("a.x", "b.u", annotated("gain=\"2\""))),
       {"attribute of a connection 'gain'"}},
      {with(a + component("b", "mass", annotated("unit=\"m\""))), {"attribute 'unit'"}},
      {with("<ssd:Component name=\"a\" source=\"resources/mass.fmu\" implementation=\"Any\"/>"), {"'Any'"}},
      {with(component("a", "mass", connectors({{"in", "u", "m"}}))), {"attribute kind", "'in'"}},
      {ssd("<ssd:Elements>" + a + "</ssd:Elements><ssd:Elements>" + b + "</ssd:Elements>"),
       {"<ssd:Elements> is there twice"}},
      {with(a + component("b", "mass",
                          "<ssd:ParameterBindings><ssd:ParameterBinding><ssd:ParameterValues>" +
                              parameter_set("<ssv:Parameter name=\"k\"><ssv:String/></ssv:Parameter>") +
                              "</ssd:ParameterValues></ssd:ParameterBinding></ssd:ParameterBindings>")),
       {"attribute value", "a text"}},
      {with("<ssd:System name=\"i\">" + annotated("step=\"1\"") + "<ssd:Elements>" + a +
            "</ssd:Elements></ssd:System>"),
       {"a system has an annotation"}},
      {with(a + component("b", "mass", bindings({{"k", "x"}}))),
       {"attribute value", "'x'", "numbers with blanks"}},
      {ssd("<ssd:Elements>" + a + "</ssd:Elements>", annotated("schedul=\"x\"")), {"schedul"}},
  });
}

/// The file that the schemas of the standard call valid, and that fuzzing begins with.
TEST(System, OfEveryThingOnceIsRead) {
  const Scratch folder;
  const std::string file = read_text(std::string(TANDEM_SOURCE_DIR) + "/tests/fmi/all.ssd");
  const Scenario s = read_system(folder, file);
  EXPECT_EQ(given(s, 0, "type"), "cs");
  EXPECT_EQ(given(s, 1, "set.k"), "6000.000000");
  ASSERT_EQ(s.connections.size(), 2U);
  EXPECT_EQ(s.connections[0].connection.gain, 0.5);
  EXPECT_EQ(s.connections[1].connection.from, "inner_mass.x");
  EXPECT_EQ(s.connections[1].connection.lag, Lag::memory);
  EXPECT_NEAR(s.connections[1].connection.gain, 1e-3, 1e-18)
      << "metres are taken as millimetres, and then converted";
  EXPECT_TRUE(s.remarks.empty()) << "what a mapping leaves out is meant to be";
}

TEST(System, ThatHoldsItselfIsRefused) {
  const Scratch folder;
  const std::string itself =
      "<ssd:Component name=\"a\" type=\"application/x-ssp-definition\" source=\"s.ssd\"/>";
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"holds itself"},
                      [&] { scenario::read(folder.write("s.ssd", with(itself))); }));
}

}  // namespace
}  // namespace tandem::test
