// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Any text as the description of a system, beside an FMU: a scenario's text, or an Error.
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "../fmi/zip_file.hpp"
#include "tandem/error.hpp"
#include "tandem/ssp/ssp.hpp"
#include "tandem/text/document.hpp"

namespace {

constexpr const char* fmu = R"(<?xml version="1.0"?>
<fmiModelDescription fmiVersion="2.0" modelName="m" guid="{1}">
<CoSimulation modelIdentifier="m"/><ModelVariables>
<ScalarVariable name="u" valueReference="0" causality="input"><Real start="0" unit="m"/></ScalarVariable>
<ScalarVariable name="k" valueReference="1" causality="parameter" variability="fixed"><Real start="0"/></ScalarVariable>
<ScalarVariable name="x" valueReference="2" causality="output"><Real unit="m"/></ScalarVariable>
</ModelVariables><ModelStructure><Outputs><Unknown index="3"/></Outputs></ModelStructure></fmiModelDescription>)";

/// Of this process, with an FMU; it goes at the end.
struct Folder {
  Folder() {
    if (!::mkdtemp(path.data())) std::abort();
    std::filesystem::create_directory(path + "/resources");
    tandem::test::write_zip(path + "/resources/mass.fmu", {{"modelDescription.xml", fmu}});
  }
  ~Folder() { std::filesystem::remove_all(path); }
  std::string path = "/tmp/tandem_fuzz_XXXXXX";
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Folder folder;
  const std::string file = folder.path + "/s.ssd";
  std::ofstream(file).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    const auto system = tandem::ssp::scenario_text(file);
    tandem::text::Document(file, system.text, system.lines);
  } catch (const tandem::Error&) {  // what has to come of a text that is not right
  }
  return 0;
}
