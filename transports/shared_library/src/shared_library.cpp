// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/shared_library/shared_library.hpp"

#define BOOST_DLL_USE_STD_FS 1
#include <boost/dll/shared_library.hpp>

#include "tandem/c_subsystem.hpp"
#include "tandem/error.hpp"

namespace tandem {
namespace {

namespace fs = std::filesystem;
namespace dll = boost::dll;

std::string named(const fs::path& file) { return "library '" + file.string() + "'"; }

dll::shared_library load(const fs::path& file) {
  if (!fs::exists(file)) throw Error(ErrorCode::input_output, named(file) + " is not there");
  try {
    // The whole of it at once: a symbol that it lacks is told here, not in the middle of a run.
    return dll::shared_library(file, dll::load_mode::rtld_now | dll::load_mode::rtld_local);
  } catch (const std::exception& error) {
    throw Error(ErrorCode::input_output, named(file) + " can't be loaded: " + error.what());
  }
}

const tandem_subsystem_api* table(const dll::shared_library& library, const fs::path& file,
                                  const std::string& entry) {
  if (!library.has(entry))
    throw Error(ErrorCode::invalid_argument,
                named(file) + " has no symbol '" + entry + "'; name the one that it exports by ?entry=NAME");
  try {
    return library.get<const tandem_subsystem_api*()>(entry)();
  } catch (const std::exception& error) {
    throw Error(ErrorCode::internal, named(file) + ": '" + entry + "' threw: " + error.what());
  } catch (...) {
    throw Error(ErrorCode::internal, named(file) + ": '" + entry + "' threw");
  }
}

/// The library, to be kept for longer than what is made from it.
struct Loaded {
  dll::shared_library library;
};

class LibrarySubsystem final : Loaded, public CSubsystem {
 public:
  LibrarySubsystem(dll::shared_library loaded, const tandem_subsystem_api* api, const std::string& parameters)
      : Loaded{std::move(loaded)}, CSubsystem(api, parameters) {}
};

}  // namespace

std::unique_ptr<Subsystem> load_subsystem(const fs::path& file, const std::string& entry,
                                          const std::string& parameters) {
  dll::shared_library library = load(file);
  const tandem_subsystem_api* api = table(library, file, entry);
  try {
    return std::make_unique<LibrarySubsystem>(std::move(library), api, parameters);
  } catch (const Error& error) {
    throw Error(error.code(), named(file) + ": " + error.what());
  }
}

void add_shared_library(Builtins& builtins) {
  builtins.addresses["lib"] = [](const Address& address, Parameters& parameters) {
    const std::string entry = parameters.text("entry", default_entry);
    return load_subsystem(address.folder / address.place, entry, parameters.rest());
  };
}

}  // namespace tandem
