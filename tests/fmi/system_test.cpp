// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Systems of the standard SSP, read as scenarios.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "system_reading.hpp"
#include "tandem/coordinator/units.hpp"

namespace tandem::test {
namespace {

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

/// In their own units, by mappings, and through connectors of systems, in this order.
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

}  // namespace
}  // namespace tandem::test
