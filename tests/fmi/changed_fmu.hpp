// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "scratch.hpp"
#include "tandem/fmi/archive.hpp"
#include "zip_file.hpp"

namespace tandem::test {

inline const std::string library = "binaries/linux64/decay.so", describing = "modelDescription.xml";

/// An FMU's description and library, with one file in place of another; without it, where
/// the content is empty.
inline std::string changed(const Scratch& scratch, const std::string& name, const std::string& content,
                           const std::string& fmu = "decay", const std::string& its_library = library) {
  const fmi::Archive whole(TANDEM_FMUS "/" + fmu + ".fmu");
  std::vector<Packed> all;
  for (const std::string& one : {describing, its_library})
    if (one != name) all.push_back({one, whole.text(one, 1U << 24)});
  if (!content.empty()) all.push_back({name, content});
  return "fmu:" + write_zip(scratch.path() / "x.fmu", all).string();
}

inline std::string description_with(const std::string& from, const std::string& to,
                                    const std::string& fmu = "decay") {
  std::string text = fmi::Archive(TANDEM_FMUS "/" + fmu + ".fmu").text(describing, 1U << 20);
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace tandem::test
