// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "log.hpp"

#include <array>
#include <charconv>
#include <cstdarg>
#include <cstdio>
#include <utility>

#include "tandem/printable.hpp"

namespace tandem::fmi {

Log::Log(std::string name, const Description& description, bool all, Tell tell)
    : name_(std::move(name)), description_(description), all_(all), tell_(std::move(tell)) {}

void Log::tell(const std::string& sentence) const {
  if (tell_) tell_(name_ + ": " + sentence);
}

std::string Log::take_last() { return std::exchange(last_, {}); }

void Log::write(fmi2ComponentEnvironment log, fmi2String, fmi2Status status, fmi2String, fmi2String message,
                ...) {
  if (!log || !message) return;
  std::array<char, 4096> text{};
  std::va_list values;
  va_start(values, message);
  std::vsnprintf(text.data(), text.size(), message, values);
  va_end(values);
  static_cast<Log*>(log)->add(status, text.data());
}

void Log::add(fmi2Status status, const std::string& message) {
  const std::string text = printable(with_names(message));
  if (status >= fmi2Discard) last_ = text;
  if (all_) tell("it says: " + text);
}

/// "#r123#" is the real variable with the reference 123, "##" is "#".
std::string Log::with_names(const std::string& message) const {
  static const std::string letters = "ribis";  // in the order of Type
  std::string text;
  for (std::size_t at = 0; at < message.size(); ++at) {
    const std::size_t end = message[at] == '#' ? message.find('#', at + 1) : std::string::npos;
    if (end == std::string::npos) {
      text += message[at];
      continue;
    }
    std::uint32_t reference = 0;
    const char *const first = message.data() + at + 2, *const last = message.data() + end;
    const bool number = end > at + 2 && std::from_chars(first, last, reference).ptr == last;
    std::string name = end == at + 1 ? "#" : message.substr(at, end - at + 1);
    for (const Variable& v : description_.variables)
      if (number && v.reference == reference && letters[static_cast<std::size_t>(v.type)] == message[at + 1])
        name = v.name;
    text += name;
    at = end;
  }
  return text;
}

}  // namespace tandem::fmi
