// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "log.hpp"

#include <charconv>
#include <utility>

#include "tandem/printable.hpp"

namespace tandem::fmi {
namespace {

char letter_of(Type type) {
  switch (type) {
    case Type::float64:
      return 'r';
    case Type::boolean:
      return 'b';
    case Type::text:
      return 's';
    default:
      return 'i';
  }
}

}  // namespace

Log::Log(std::string name, const Description& description, bool all, Tell tell)
    : name_(std::move(name)), description_(description), all_(all), tell_(std::move(tell)) {}

void Log::tell(const std::string& sentence) const {
  if (tell_) tell_(name_ + ": " + sentence);
}

std::string Log::take_last() { return std::exchange(last_, {}); }

void Log::add(Status status, const char* message) noexcept try {
  const std::string text = printable(description_.version == Version::two ? with_names(message) : message);
  if (status >= Status::discard) last_ = text;
  if (all_) tell("it says: " + text);
} catch (...) {
}

/// In 2.0 "#r123#" is the real variable with the reference 123, "##" is "#".
std::string Log::with_names(const std::string& message) const {
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
      if (number && v.reference == reference && letter_of(v.type) == message[at + 1]) name = v.name;
    text += name;
    at = end;
  }
  return text;
}

}  // namespace tandem::fmi
