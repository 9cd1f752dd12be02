// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Systems of SSP that are wrong, or too large.
#include <gtest/gtest.h>

#include "refusal.hpp"
#include "system_reading.hpp"

namespace tandem::test {
namespace {

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

/// What would take long to read: a name with as many ways to look it up as it has dots, and values that go from
/// system to system.
TEST(System, LongNamesAndLongWaysAreRefused) {
  const std::string a = component("a", "mass"), b = component("b", "mass");
  std::string systems, ways = ssd_connection("a.x", "s0.u");
  for (int k = 0; k < 300; ++k) {
    const std::string name = "s" + std::to_string(k);
    systems += "<ssd:System name=\"" + name + "\">" +
               connectors({{"input", "u", "-"}, {"output", "y", "-"}}) + "<ssd:Connections>" +
               ssd_connection("u", "y") + "</ssd:Connections></ssd:System>";
    if (k > 0) ways += ssd_connection("s" + std::to_string(k - 1) + ".y", name + ".u");
  }
  expect_refused({
      {with(component(std::string(1001, 'x'), "mass")), {"name of 1001 characters", "at most 1000"}},
      {with(a + b + systems, ways + ssd_connection("s299.y", "b.u")), {"'u'", "more than 256 connections"}},
  });
  const Scratch folder;
  const Scenario s = read_system(folder, with(a + b + systems, ways + ssd_connection("s99.y", "b.u")));
  EXPECT_EQ(s.connections.size(), 1U);
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

TEST(System, ThatHoldsItselfIsRefused) {
  const Scratch folder;
  const std::string itself =
      "<ssd:Component name=\"a\" type=\"application/x-ssp-definition\" source=\"s.ssd\"/>";
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"holds itself"},
                      [&] { scenario::read(folder.write("s.ssd", with(itself))); }));
}

}  // namespace
}  // namespace tandem::test
