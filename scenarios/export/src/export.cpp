// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/export/export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "model_description.hpp"
#include "origin.hpp"
#include "tandem/bytes.hpp"
#include "tandem/error.hpp"
#include "tandem/files_read.hpp"
#include "tandem/fmi/fmi.hpp"
#include "tandem/fmi/platform.hpp"
#include "tandem/input_file.hpp"
#include "tandem/nearest.hpp"
#include "tandem/output/files.hpp"
#include "tandem/output/provenance.hpp"
#include "tandem/printable.hpp"
#include "tandem/scenario/shortest_step.hpp"
#include "tandem/transports/temporary_folder.hpp"
#include "zip.hpp"

namespace tandem::exported {
namespace {

namespace fs = std::filesystem;
using Contents = std::map<std::string, std::string>;  ///< of the FMU, by name

constexpr std::uint64_t most_bytes = std::uint64_t{1} << 30;
constexpr std::size_t longest_text = 4000;
const std::string resources = "resources/", files = "files/";

/// The folder that all of them lie in.
fs::path common_folder(const std::vector<fs::path>& all) {
  fs::path folder = all.at(0).parent_path();
  const auto holds = [&](const fs::path& file) {
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
  };
  while (!std::all_of(all.begin(), all.end(), holds)) folder = folder.parent_path();
  return folder;
}

std::string token_of(const Contents& contents) {
  std::uint64_t sums[] = {empty_checksum, ~empty_checksum};
  for (std::uint64_t& sum : sums)
    for (const auto& [name, text] : contents)
      for (const std::string& part : {name, text})
        sum = checksum(std::as_bytes(std::span(part.data(), part.size() + 1)), sum);
  return fmt::format("{:016x}{:016x}", sums[0], sums[1]);
}

/// What it runs: the files as they lie to each other, and the manifest.
Contents resources_of(const Origin& origin, Interface interface, const Builtins& here) {
  const auto all = files_of(origin, here);
  std::vector<fs::path> places;  // with ".." as it is written: links are not looked at
  for (const fs::path& file : all) places.push_back(file.lexically_normal());
  const fs::path folder = common_folder(places);
  Contents contents;
  for (std::size_t k = 0; k < all.size(); ++k)
    contents[resources + files + places[k].lexically_relative(folder).generic_string()] =
        read_file(all[k], most_bytes);
  const fs::path own = fs::absolute(origin.file).lexically_normal().lexically_relative(folder);
  Manifest manifest{"",
                    origin.scheme + ":" + files + own.generic_string(),
                    origin.overrides,
                    origin.parameters,
                    origin.starts,
                    interface};
  contents[resources + manifest_name] = written(manifest);
  manifest.token = token_of(contents);
  contents[resources + manifest_name] = written(manifest);
  return contents;
}

void write_below(const fs::path& folder, const Contents& contents) {
  for (const auto& [name, text] : contents) {
    output::make_folder((folder / name).parent_path());
    output::write_text(folder / name, text);
  }
}

/// All that it reads is in the FMU.
void check_reads(const FilesRead& read, const fs::path& unpacked) {
  const std::string folder = fs::absolute(unpacked).lexically_normal().string() + "/";
  for (const fs::path& file : read.files())
    if (!file.lexically_normal().string().starts_with(folder))
      throw Error(
          ErrorCode::invalid_argument,
          "file '" + file.string() +
              "' is named from the root, and is not there where the FMU will be; allowed are files that "
              "are named beside the file that names them");
}

void check_outputs(const SubsystemInfo& info) {
  if (info.outputs.empty())
    throw Error(
        ErrorCode::invalid_argument,
        "'" + info.name +
            "' has no output, so an FMU of it is of no use; allowed is one or more, of a mechanism also by "
            "animate = true, which gives the coordinates of its points");
}

/// Of the file's [run.inputs], or a member's.
void check_starts(const Unit& unit) {
  std::vector<std::string> inputs;
  for (int k = 0; k < unit.info().input_size(); ++k)
    inputs.push_back(scalar_at(unit.info().inputs, k).name());
  for (const auto& [name, value] : unit.manifest().starts)
    if (std::find(inputs.begin(), inputs.end(), name) == inputs.end())
      throw Error(ErrorCode::invalid_argument, "run.inputs: " + unknown("input", name, inputs));
}

void check_target(const ExportSettings& settings) {
  const auto refuse = [](const std::string& what) { throw Error(ErrorCode::invalid_argument, what); };
  if (settings.file.extension() != ".fmu")
    refuse("the file to be written is '" + settings.file.string() +
           "'; allowed is a name that ends in .fmu, or in .ssp for a scenario");
  if (fmi::binaries_of_this_platform(settings.version).empty())
    refuse("this version of FMI has no name for this platform; allowed is another version");
}

/// Whatever word a parameter is set to by a list of its file. The start refuses what changes the ports.
void start_with_each_word(Unit& unit, double t) {
  for (std::size_t k = 0; k < unit.variables().size(); ++k)
    for (const std::string& word : unit.allowed_words(k)) {
      unit.reset();
      unit.set_span(t);
      unit.set(k, word);
      unit.own_step();
    }
}

/// As an importer does: its library is loaded from it and started.
void try_out(const fs::path& fmu, double start, double step) {
  Builtins sources;
  add_fmi(sources);
  const auto subsystem = open(fmt::format("fmu:{}?step={}", fmu.string(), step), sources);
  std::vector<double> u, row(static_cast<std::size_t>(subsystem->info().row_size()));
  for (int k = 0; k < subsystem->info().input_size(); ++k)
    u.push_back(scalar_at(subsystem->info().inputs, k).port->start);
  Samples y(row.data(), subsystem->info().row_size(), 1);
  subsystem->initialize(start, start + 2.0 * step, u, y);
}

Contents library_files(const ExportSettings& settings, const std::string& identifier) {
  const std::string folder = fmi::binaries_of_this_platform(settings.version);
  constexpr const char* own = "tandem_fmu.so";
  if (!fs::exists(settings.library / own))
    throw Error(ErrorCode::input_output,
                "the library that an FMU brings, " + (settings.library / own).string() + ", is not there");
  Contents contents;
  for (const auto& entry : fs::directory_iterator(settings.library)) {
    const std::string name = entry.path().filename().string();
    const bool licences = entry.path().extension() == ".txt";
    contents[licences ? "documentation/licenses/license.txt"
                      : folder + (name == own ? identifier + ".so" : name)] =
        read_file(entry.path(), most_bytes);
  }
  return contents;
}

std::string size_of(const fs::path& file) {
  return fmt::format("{:.2f} MB", static_cast<double>(fs::file_size(file)) * 1e-6);
}

std::vector<std::string> told(const Unit& unit, const Facts& facts, const ExportSettings& settings) {
  const auto count = [&](auto wanted) {
    return std::count_if(unit.variables().begin(), unit.variables().end(), wanted);
  };
  using Kind = Variable::Kind;
  return {fmt::format("{}: FMI {}.0, {}, {}", settings.file.string(),
                      settings.version == fmi::Version::two ? 2 : 3, unit.manifest().interface_name(),
                      size_of(settings.file)),
          fmt::format("{} inputs, {} outputs, {} parameters, {} {} s, its state can{} be had",
                      unit.info().input_size(), unit.info().output_size(),
                      count([](const Variable& v) { return v.kind == Kind::number || v.kind == Kind::word; }),
                      unit.info().abilities.sampled ? "period" : "own step", facts.step,
                      unit.keeps_state() ? "" : "not")};
}

}  // namespace

std::vector<std::string> export_fmu(const ExportSettings& settings, const Builtins& here) {
  check_target(settings);
  const Origin origin = read_origin(settings);
  Contents contents = resources_of(origin, settings.interface, here);
  const TemporaryFolder folder;
  write_below(folder.path(), contents);
  const FilesRead read;
  const auto made_of = open_unit(folder.path() / resources);
  Unit& unit = *made_of;
  check_outputs(unit.info());
  check_starts(unit);
  const double start = origin.span ? origin.span->start : 0.0;
  unit.set_span(start);
  const Facts facts{identifier_of(settings.file.stem().string()),
                    printable(origin.name, longest_text),
                    printable(origin.description, longest_text),
                    "tandem " + output::version(),
                    origin.span,
                    scenario::shortest_step(unit.own_step(), start)};
  start_with_each_word(unit, start);
  check_reads(read, folder.path());
  contents["modelDescription.xml"] = model_description(unit, facts, settings.version);
  contents["documentation/index.html"] = documentation(unit, facts, settings.version);
  contents.merge(library_files(settings, facts.identifier));
  const fs::path made = folder.path() / "made.fmu";
  write_zip(made, contents);
  try_out(made, start, facts.step);
  output::replace_text(settings.file, read_file(made, most_bytes));
  return told(unit, facts, settings);
}

}  // namespace tandem::exported
