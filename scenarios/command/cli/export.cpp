// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#if TANDEM_HAS_EXPORT
#include "tandem/export/export.hpp"

#include "tandem/export/system.hpp"
#endif

#include <memory>

#include "cli/commands.hpp"
#include "cli/say.hpp"
#include "cli/validators.hpp"
#include "sources/this_program.hpp"
#include "tandem/error.hpp"

namespace tandem::cli {
namespace {

struct ExportOptions {
  std::string source, file;
  std::vector<std::string> overrides;
  int version = 2;
  std::string type = "cs";
};

#if TANDEM_HAS_EXPORT
std::vector<std::string> exported_to(const ExportOptions& options, const Builtins& here) {
  const std::filesystem::path file = options.file;
  const auto library =
      (std::filesystem::path(this_program()).parent_path() / TANDEM_FMU_FOLDER).lexically_normal();
  const auto version = options.version == 2 ? fmi::Version::two : fmi::Version::three;
  if (file.extension() == ".ssp") {
    if (options.type != "cs")
      throw Error(ErrorCode::invalid_argument,
                  "--type me is of one FMU; a system has FMUs of Co-Simulation, allowed is --type cs");
    return exported::export_system({options.source, options.overrides, file, version, library}, here);
  }
  const auto interface =
      options.type == "me" ? exported::Interface::model_exchange : exported::Interface::co_simulation;
  return exported::export_fmu({options.source, options.overrides, file, version, library, {}, interface},
                              here);
}

void export_to(const ExportOptions& options, const Context& context) {
  for (const std::string& line : exported_to(options, context.builtins)) say("{}\n", line);
}
#else
void export_to(const ExportOptions&, const Context&) {
  throw Error(
      ErrorCode::not_supported,
      "this build exports no FMUs, as a package was absent (libpugixml-dev, libminizip-dev, archives of "
      "libsundials-dev); configuring it says which");
}
#endif

constexpr const char* about_fmus = R"(
A scenario becomes one FMU, FILE.fmu, with inputs that nothing gives and the outputs that it records (docs/nested.md); or
a system of SSP, FILE.ssp: its mechanisms and diagrams as FMUs in it, FMUs as they are (docs/ssp.md).

An FMU needs nothing of tandem where it runs. It has the inputs, outputs and parameters of the source; the table [run]
of a file gives its step, settings and start values (docs/fmi.md). It integrates itself (Co-Simulation), or, of a diagram
with --type me, who imports it does (Model Exchange).
Exit status: 0, or 2 for what can't be exported.)";

}  // namespace

void add_export(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand(
      "export", "Make an FMU of a mechanism, a diagram or a scenario, or a system of SSP of a scenario");
  auto options = std::make_shared<ExportOptions>();
  command
      ->add_option("source", options->source,
                   "The file of a mechanism, a diagram or a scenario, or mechanism:FILE?KEY=VALUE, "
                   "diagram:FILE?.., scenario:FILE?..")
      ->required()
      ->type_name("SOURCE");
  command->add_option("file", options->file, "The FMU to be written, FILE.fmu, or the system, FILE.ssp")
      ->required()
      ->type_name("FILE");
  command->add_option("--fmi", options->version, "Version of FMI: 2 or 3")
      ->check(one_of({"2", "3"}))
      ->capture_default_str();
  command->add_option("--type", options->type, "cs (Co-Simulation), or me (Model Exchange) of a diagram")
      ->check(one_of({"cs", "me"}))
      ->capture_default_str();
  command->add_option("--set", options->overrides, "Set a value of the file (repeatable)")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  command->footer(about_fmus);
  command->callback([options, &context] { export_to(*options, context); });
}

}  // namespace tandem::cli
