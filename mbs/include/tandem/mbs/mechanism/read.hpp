// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <variant>

#include "tandem/mbs/mechanism/description.hpp"

namespace tandem::text {
class Document;
}

namespace tandem::mbs {

/// Values of a mechanism's parameters by name, in place of those in its file.
using ParameterValues = std::map<std::string, std::variant<double, std::string>>;

/// A mechanism from its TOML file (docs/mechanisms.md has the form). kinds: of elements, besides those that
/// are built in. Throws Error that names file, line, the value found and the values allowed.
Description read_mechanism(const std::filesystem::path& file, const ElementKinds& kinds = {},
                           const ParameterValues& parameters = {});

/// The same from a text; `name` is what errors call it, and files that it names are looked for in the folder
/// of that name.
Description read_mechanism(const std::string& name, const std::string& text, const ElementKinds& kinds = {},
                           const ParameterValues& parameters = {});

/// The same of a document, in which values may have been set.
Description read_mechanism(const text::Document& document, const ElementKinds& kinds = {},
                           const ParameterValues& parameters = {});

}  // namespace tandem::mbs
