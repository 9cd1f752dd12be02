// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <spdlog/sinks/base_sink.h>

#include <filesystem>
#include <mutex>

#include "tandem/error.hpp"
#include "tandem/input_file.hpp"
#include "tandem/output/lock.hpp"
#include "tandem/output_file.hpp"

namespace tandem::cli {

/// All messages as lines of a file, in place of an earlier log, and of nothing else; of one process at a
/// time. Each is in the file at once.
class LogFile final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  explicit LogFile(const std::filesystem::path& file) : file_(file, OutputFile::Begin::kept) {
    output::lock_file(file_.descriptor(), "file '" + file.string() + "'");
    require_log(file);
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
  /// Results, say, of a run that goes on.
  static void require_log(const std::filesystem::path& file) {
    if (!std::filesystem::is_regular_file(file)) return;
    std::byte first{'['};
    InputFile(file).read({&first, 1});
    if (first != std::byte{'['})
      throw Error(ErrorCode::input_output,
                  "file '" + file.string() +
                      "' is there and is no log; allowed is an earlier log, or a file "
                      "that is not there");
  }

  OutputFile file_;
};

}  // namespace tandem::cli
