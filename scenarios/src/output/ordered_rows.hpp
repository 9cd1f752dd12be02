// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>

#include "tandem/output_file.hpp"

namespace tandem::output {

/// A table whose rows come in any order, from several threads. The file has them in theirs, each as soon as
/// those before it are there, so that what ends early leaves the first of them.
class OrderedRows {
 public:
  /// Throws Error(input_output) with path and reason, as set() does.
  OrderedRows(const std::filesystem::path& file, const std::string& header);

  void set(std::size_t row, std::string text);
  /// The next one, where all before it are there.
  void add(std::string text) { set(written(), std::move(text)); }
  /// In the file.
  std::size_t written() const;

 private:
  void put(const std::string& line);

  OutputFile file_;
  mutable std::mutex mutex_;
  std::map<std::size_t, std::string> waiting_;
  std::size_t written_ = 0;
};

}  // namespace tandem::output
