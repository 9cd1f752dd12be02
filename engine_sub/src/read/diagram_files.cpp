// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "read/reader.hpp"
#include "tandem/error.hpp"

namespace tandem::engine {

namespace fs = std::filesystem;

namespace {

constexpr int most_blocks = 20'000, deepest = 50;

}  // namespace

const text::Document& DiagramFiles::document(const fs::path& file) {
  auto& document = documents_[fs::weakly_canonical(file)];
  if (!document) document = std::make_unique<text::Document>(file);
  return *document;
}

bool DiagramFiles::in_bounds(const fs::path& file) const {
  std::error_code unknown;  // a folder that may not be searched, a circle of links: it is not told which
  const fs::path path = fs::weakly_canonical(fs::absolute(file), unknown);
  return !unknown &&
         std::mismatch(bound_.begin(), bound_.end(), path.begin(), path.end()).first == bound_.end();
}

void DiagramFiles::count_block(const text::Place& place) {
  if (++blocks_ > most_blocks)
    text::refuse(place, fmt::format("there are more than {} blocks, with those of the diagrams in blocks; "
                                    "allowed are up to {}",
                                    most_blocks, most_blocks));
}

void DiagramFiles::check_depth(const text::Place& place) const {
  if (depth_ == deepest)
    text::refuse(place, fmt::format("diagrams stand in each other more than {} deep", deepest));
}

Description DiagramFiles::read(const text::Document& found, const Given& given) {
  const fs::path path = fs::weakly_canonical(found.file());
  const auto first = std::find(open_.begin(), open_.end(), path);
  if (first != open_.end()) {
    std::vector<std::string> chain;
    for (auto it = first; it != open_.end(); ++it) chain.push_back(it->filename().string());
    chain.push_back(path.filename().string());
    throw Error(ErrorCode::invalid_argument,
                fmt::format("diagram {} contains itself: {}; allowed are diagrams without a circle",
                            found.file(), fmt::join(chain, " > ")));
  }
  open_.push_back(path);
  Description all = DiagramReader({found, language_of_diagrams()}, given, *this).read();
  open_.pop_back();
  return all;
}

}  // namespace tandem::engine
