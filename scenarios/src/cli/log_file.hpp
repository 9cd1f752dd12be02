// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <spdlog/sinks/base_sink.h>

#include <filesystem>
#include <mutex>

#include "output/lock.hpp"
#include "tandem/output_file.hpp"

namespace tandem::cli {

/// All messages as lines of a file, in place of an earlier one; of one process at a time. Each is in the file
/// at once.
class LogFile final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  explicit LogFile(const std::filesystem::path& file) : file_(file, OutputFile::Begin::kept) {
    output::lock_file(file_.descriptor(), "file '" + file.string() + "'");
    file_.cut(0);
  }

 protected:
  void sink_it_(const spdlog::details::log_msg& message) override {
    spdlog::memory_buf_t line;
    formatter_->format(message, line);
    file_.write({line.data(), line.size()});
  }
  void flush_() override {}

 private:
  OutputFile file_;
};

}  // namespace tandem::cli
