// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sys/resource.h>

#include <fstream>
#include <iterator>

#include "child.hpp"
#include "scratch.hpp"

namespace tandem::test {

inline constexpr const char* served_model = "builtin:two_mass.slow";

/// `tandem serve` in a process of its own, with its log, and what Linux tells of it.
class ServerProcess {
 public:
  ServerProcess(const std::string& source, const std::string& address, std::vector<std::string> options = {})
      : child_(words(source, address, std::move(options))), uri_(child_.word_after(" at ")) {}

  const std::string& uri() const { return uri_; }
  Child& child() { return child_; }
  std::string log() const { return read_text(folder_.path() / "log"); }
  /// Waits up to 5 s for the log to hold that.
  bool logs(const std::string& text) const {
    for (int k = 0; k < 5000 && log().find(text) == std::string::npos; ++k) ::usleep(1000);
    return log().find(text) != std::string::npos;
  }
  int lines_with(const std::string& text) const {
    const std::string all = log();
    int count = 0;
    for (auto at = all.find(text); at != std::string::npos; at = all.find(text, at + 1)) ++count;
    return count;
  }

  /// "VmHWM" and the like of /proc/PID/status [bytes].
  std::int64_t memory(const std::string& name) const {
    std::ifstream status("/proc/" + std::to_string(child_.process()) + "/status");
    for (std::string line; std::getline(status, line);)
      if (line.starts_with(name + ":")) return 1024 * std::stoll(line.substr(name.size() + 1));
    return -1;
  }
  /// The lowest number of a descriptor that is free.
  rlim_t free_descriptor() const {
    const std::filesystem::path all = "/proc/" + std::to_string(child_.process()) + "/fd";
    rlim_t number = 0;
    while (std::filesystem::exists(std::filesystem::symlink_status(all / std::to_string(number)))) ++number;
    return number;
  }
  /// Processor time that it has taken [s].
  double seconds_of_processor() const {
    std::ifstream stat("/proc/" + std::to_string(child_.process()) + "/stat");
    std::string word;
    for (int k = 0; k < 13; ++k) stat >> word;
    double user = 0.0, system = 0.0;
    stat >> user >> system;
    return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
  }
  /// From now on; RLIM_INFINITY lifts it.
  void limit(__rlimit_resource what, rlim_t most) const {
    rlimit before{};
    ::prlimit(child_.process(), what, nullptr, &before);
    const rlimit now{std::min(most, before.rlim_max), before.rlim_max};
    ::prlimit(child_.process(), what, &now, nullptr);
  }

 private:
  std::vector<std::string> words(const std::string& source, const std::string& address,
                                 std::vector<std::string> options) const {
    std::vector<std::string> all = {
        TANDEM_COMMAND, "--log", (folder_.path() / "log").string(), "serve", source, "--listen", address};
    all.insert(all.end(), options.begin(), options.end());
    return all;
  }

  Scratch folder_;
  Child child_;
  std::string uri_;
};

}  // namespace tandem::test
