// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/shared_library/shared_library.hpp"

#include "loading.hpp"
#include "tandem/c_subsystem.hpp"
#include "tandem/error.hpp"
#include "tandem/library_file.hpp"
#include "tandem/shared_library/three_functions.hpp"

namespace tandem {
namespace {

namespace fs = std::filesystem;
namespace dll = boost::dll;

const tandem_subsystem_api* table(const dll::shared_library& library, const fs::path& file,
                                  const std::string& entry) {
  if (!library.has(entry))
    throw Error(ErrorCode::invalid_argument, library_named(file) + " has no symbol '" + entry +
                                                 "'; name the one that it exports by ?entry=NAME");
  const std::string name = library_named(file);
  auto& give = library.get<const tandem_subsystem_api*()>(entry);
  check_function(reinterpret_cast<const void*>(&give), name, entry);
  LibraryCall in_library(name.c_str());
  try {
    return in_library.make(give);
  } catch (const std::exception& error) {
    throw Error(ErrorCode::internal, library_named(file) + ": '" + entry + "' threw: " + error.what());
  } catch (...) {
    throw Error(ErrorCode::internal, library_named(file) + ": '" + entry + "' threw");
  }
}

class LibrarySubsystem final : LoadedLibrary, public CSubsystem {
 public:
  LibrarySubsystem(dll::shared_library loaded, const tandem_subsystem_api* api, const std::string& parameters,
                   const std::string& library)
      : LoadedLibrary(std::move(loaded)), CSubsystem(api, parameters, library) {}
};

/// "three_functions:FILE": what the library does not say of itself are parameters.
ThreeFunctions functions_of(Parameters& p) {
  ThreeFunctions what;
  what.initiate = p.text("initiate", what.initiate);
  what.step = p.text("advance", what.step);
  what.clean_up = p.text("clean_up", what.clean_up);
  if (!p.has("step"))
    throw Error(ErrorCode::invalid_argument,
                "it has no own step; give the parameter step, a number above 0 [s]");
  what.own_step = positive(p, "step", what.own_step);
  what.inputs = ports_of_text("parameter inputs", p.text("inputs", ""));
  what.outputs = ports_of_text("parameter outputs", p.text("outputs", ""), &what.start);
  return what;
}

std::unique_ptr<Subsystem> three_functions(const Address& address, Parameters& p) {
  return load_three_functions(address.file(), functions_of(p));
}

std::optional<Look> look_at_three_functions(const Address& address, Parameters& p) {
  require_library(address.file());
  functions_of(p);
  return std::nullopt;
}

std::unique_ptr<Subsystem> lib(const Address& address, Parameters& p) {
  const std::string entry = p.text("entry", default_entry);
  return load_subsystem(address.file(), entry, p.rest());
}

std::optional<Look> look_at_lib(const Address& address, Parameters& p) {
  require_library(address.file());
  p.text("entry", default_entry);
  p.rest();
  return std::nullopt;
}

}  // namespace

std::unique_ptr<Subsystem> load_subsystem(const fs::path& file, const std::string& entry,
                                          const std::string& parameters) {
  dll::shared_library library = load_library(file, file);
  const tandem_subsystem_api* api = table(library, file, entry);
  try {
    return std::make_unique<LibrarySubsystem>(std::move(library), api, parameters, library_named(file));
  } catch (const Error& error) {
    throw_behind(library_named(file) + ": ", error);
  }
}

void add_shared_library(Builtins& builtins) {
  builtins.schemes["three_functions"] = {
      words_by(Setter::operator_only, {"initiate", "advance", "clean_up", "step", "inputs", "outputs"}),
      three_functions,
      true,
      true,
      look_at_three_functions,
      true};
  builtins.schemes["lib"] = {words_by(Setter::operator_only, {"entry"}), lib, true, true, look_at_lib, true};
}

}  // namespace tandem
