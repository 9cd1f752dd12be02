// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "tandem/subsystem.hpp"
#include "tandem/transports/parameters.hpp"

namespace tandem {

/// Makes a subsystem from its parameters.
using Builder = std::function<std::unique_ptr<Subsystem>(Parameters&)>;
/// Makes a subsystem from a file and its parameters.
using FileBuilder = std::function<std::unique_ptr<Subsystem>(const std::filesystem::path&, Parameters&)>;

/// A URI taken apart: "lib:./x.so?entry=name" has the scheme "lib" and the place "./x.so".
struct Address {
  std::string uri, scheme, place;
  std::filesystem::path folder;  ///< where a file is looked for that is not named from the root
};
/// Makes a subsystem that lives behind an address. What it does not ask the parameters for itself, it hands
/// on to that subsystem (Parameters::rest).
using AddressBuilder = std::function<std::unique_ptr<Subsystem>(const Address&, Parameters&)>;

/// What URIs can name. Whoever owns the models fills it, and add_shared_library(), add_tcp() and the like add
/// their schemes; what opens a URI knows no model and no transport.
struct Builtins {
  std::map<std::string, Builder> models;            ///< by the NAME of "builtin:NAME"
  std::map<std::string, FileBuilder> files;         ///< by the scheme of "scheme:FILE"
  std::map<std::string, AddressBuilder> addresses;  ///< by the scheme of "scheme:PLACE"
};

/// What a URI is opened with.
struct Opening {
  Parameters parameters = {};
  std::filesystem::path folder = {};  ///< where a file is looked for that is not named from the root
};

/// The subsystem that a URI names: "builtin:NAME", "mechanism:FILE" or "tcp://HOST:PORT", each with
/// "?key=value&key=value" if wanted. Values in the URI stand beside the parameters; the same one in both is
/// an error. Throws Error for an unknown scheme or name, and for parameters that the subsystem does not take.
std::unique_ptr<Subsystem> open(const std::string& uri, const Builtins& builtins, Opening opening = {});

/// Throws Error for what open() refuses whatever the parameters are: a scheme or a builtin's name that is not
/// there. Nothing is opened.
void check_known(const std::string& uri, const Builtins& builtins);

}  // namespace tandem
