// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "output/ordered_rows.hpp"

namespace tandem::output {

OrderedRows::OrderedRows(const std::filesystem::path& file, const std::string& header)
    : file_(file, OutputFile::Begin::empty) {
  put(header);
}

void OrderedRows::set(std::size_t row, std::string text) {
  const std::lock_guard lock(mutex_);
  waiting_.emplace(row, std::move(text));
  for (; !waiting_.empty() && waiting_.begin()->first == written_; ++written_)
    put(waiting_.extract(waiting_.begin()).mapped());
}

std::size_t OrderedRows::written() const {
  const std::lock_guard lock(mutex_);
  return written_;
}

void OrderedRows::put(const std::string& line) { file_.write(line + '\n'); }

}  // namespace tandem::output
