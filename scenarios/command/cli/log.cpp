// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/log.hpp"

#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <atomic>
#include <memory>
#include <new>
#include <string_view>

#include "cli/log_file.hpp"
#include "tandem/error.hpp"
#include "tandem/output/progress.hpp"
#include "tandem/printable.hpp"

namespace tandem::cli {
namespace {

std::atomic<bool> log_failed = false;

/// A message's text; names in it may be a stranger's.
class PrintableText final : public spdlog::custom_flag_formatter {
 public:
  void format(const spdlog::details::log_msg& message, const std::tm&, spdlog::memory_buf_t& to) override {
    try {
      const std::string_view payload(message.payload.data(), message.payload.size());
      const std::string text = printable(payload, payload.npos);
      to.append(text.data(), text.data() + text.size());
    } catch (const std::bad_alloc&) {
      constexpr std::string_view instead = "there is no memory to show a message";
      to.append(instead.data(), instead.data() + instead.size());
    }
  }
  std::unique_ptr<custom_flag_formatter> clone() const override { return std::make_unique<PrintableText>(); }
};

std::unique_ptr<spdlog::formatter> lines_of(const std::string& pattern) {
  auto formatter = std::make_unique<spdlog::pattern_formatter>();
  formatter->add_flag<PrintableText>('*').set_pattern(pattern);
  return formatter;
}

}  // namespace

void set_up_log(const Context& context, const std::string& file) {
  std::vector<spdlog::sink_ptr> sinks{std::make_shared<spdlog::sinks::stderr_color_sink_mt>()};
  sinks[0]->set_formatter(lines_of("tandem: %*"));
  sinks[0]->set_level(context.quiet     ? spdlog::level::err
                      : context.verbose ? spdlog::level::debug
                                        : spdlog::level::info);
  try {
    if (!file.empty()) {
      sinks.push_back(std::make_shared<LogFile>(file));
      sinks[1]->set_formatter(lines_of("[%Y-%m-%d %H:%M:%S.%e] [%n] [%l] %*"));
    }
  } catch (const Error& error) {
    throw Error(error.code(), std::string("log ") + error.what());
  }
  auto log = std::make_shared<spdlog::logger>("tandem", sinks.begin(), sinks.end());
  log->set_level(spdlog::level::debug);
  log->flush_on(spdlog::level::debug);  // whoever is killed has told all
  log->set_error_handler([](const std::string& why) {
    if (!log_failed) output::show_progress("tandem: log " + why + "\n");
    log_failed = true;
  });
  spdlog::set_default_logger(log);
}

bool has_log_failed() { return log_failed; }

}  // namespace tandem::cli
