// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "scratch.hpp"
#include "zip_file.hpp"

namespace tandem::test {

/// A description of SSP around what its elements say.
inline std::string ssd(const std::string& system, const std::string& rest = "",
                       const std::string& name = "s") {
  return R"(<?xml version="1.0" encoding="UTF-8"?>
<ssd:SystemStructureDescription version="1.0" name=")" +
         name + R"(" xmlns:ssc="http://ssp-standard.org/SSP1/SystemStructureCommon"
 xmlns:ssd="http://ssp-standard.org/SSP1/SystemStructureDescription"
 xmlns:ssv="http://ssp-standard.org/SSP1/SystemStructureParameterValues"
 xmlns:ssm="http://ssp-standard.org/SSP1/SystemStructureParameterMapping" xmlns:t="https://tandem.example/coordination">
)" + "<ssd:System name=\"root\">\n" +
         system + "</ssd:System>\n<ssd:Units>" + R"(<ssc:Unit name="m"><ssc:BaseUnit m="1"/></ssc:Unit>
<ssc:Unit name="mm"><ssc:BaseUnit m="1" factor="0.001"/></ssc:Unit>
<ssc:Unit name="inch"><ssc:BaseUnit m="1" factor="0.0254"/></ssc:Unit>
<ssc:Unit name="datum"><ssc:BaseUnit m="1" factor="2" offset="5"/></ssc:Unit>
<ssc:Unit name="N.m"><ssc:BaseUnit kg="1" m="2" s="-2"/></ssc:Unit></ssd:Units>)" +
         "\n<ssd:DefaultExperiment startTime=\"0\" stopTime=\"1\"/>\n" + rest +
         "</ssd:SystemStructureDescription>\n";
}

/// Connectors, "kind name unit", a unit of "-" is none.
inline std::string connectors(const std::vector<std::array<std::string, 3>>& all) {
  std::string text = "<ssd:Connectors>";
  for (const auto& [kind, name, unit] : all)
    text += "<ssd:Connector name=\"" + name + "\" kind=\"" + kind + "\"><ssc:Real" +
            (unit == "-" ? "" : " unit=\"" + unit + "\"") + "/></ssd:Connector>";
  return text + "</ssd:Connectors>";
}

inline std::string component(const std::string& name, const std::string& fmu,
                             const std::string& inside = "") {
  return "<ssd:Component name=\"" + name + "\" source=\"resources/" + fmu + ".fmu\">" + inside +
         "</ssd:Component>\n";
}

/// "a.x" and so on; "x" is of the system itself.
inline std::string ssd_connection(const std::string& from, const std::string& to,
                                  const std::string& inside = "", const std::string& attributes = "") {
  const auto end = [](const std::string& which, const std::string& port) {
    const auto dot = port.find('.');
    const std::string connector = which + "Connector=\"" + port.substr(dot + 1) + "\" ";
    return dot == std::string::npos ? connector
                                    : which + "Element=\"" + port.substr(0, dot) + "\" " + connector;
  };
  return "<ssd:Connection " + end("start", from) + end("end", to) + attributes + ">" + inside +
         "</ssd:Connection>\n";
}

inline std::string linear(const std::string& factor, const std::string& offset) {
  return "<ssc:LinearTransformation factor=\"" + factor + "\" offset=\"" + offset + "\"/>";
}

inline std::string parameter_set(const std::string& parameters, const std::string& rest = "") {
  return "<ssv:ParameterSet xmlns:ssv=\"http://ssp-standard.org/SSP1/SystemStructureParameterValues\""
         " xmlns:ssc=\"http://ssp-standard.org/SSP1/SystemStructureCommon\" version=\"1.0\" name=\"p\">"
         "<ssv:Parameters>" +
         parameters + "</ssv:Parameters>" + rest + "</ssv:ParameterSet>";
}

/// Inline: names with numbers.
inline std::string bindings(const std::vector<std::pair<std::string, std::string>>& values,
                            const std::string& attributes = "") {
  std::string text;
  for (const auto& [name, value] : values)
    text += "<ssv:Parameter name=\"" + name + "\"><ssv:Real value=\"" + value + "\"/></ssv:Parameter>";
  return "<ssd:ParameterBindings><ssd:ParameterBinding " + attributes + "><ssd:ParameterValues>" +
         parameter_set(text) + "</ssd:ParameterValues></ssd:ParameterBinding></ssd:ParameterBindings>";
}

/// An archive with the description and FMUs of tests/libraries/fmi, and more files.
inline std::filesystem::path write_system(const Scratch& folder, const std::string& description,
                                          const std::vector<std::string>& fmus = {"mass"},
                                          std::vector<Packed> more = {}) {
  more.push_back({"SystemStructure.ssd", description});
  for (const std::string& fmu : fmus)
    more.push_back({"resources/" + fmu + ".fmu", read_text(TANDEM_FMUS "/" + fmu + ".fmu")});
  return write_zip(folder.path() / "s.ssp", more);
}

}  // namespace tandem::test
