// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/wire/frame.hpp"

#include <string>

#include "tandem/error.hpp"

namespace tandem::wire {
namespace {

[[noreturn]] void refuse(const std::string& sentence) { throw Error(ErrorCode::invalid_argument, sentence); }

}  // namespace

std::string_view name(Type type) {
  constexpr std::string_view names[] = {"none",    "hello", "info",      "initialize",  "advance",
                                        "samples", "save",  "restore",   "release",     "ping",
                                        "error",   "bye",   "serialize", "deserialize", "sample"};
  return names[static_cast<std::uint32_t>(type)];
}

Header read_header(std::span<const std::byte> bytes, std::uint64_t longest) {
  Reader in(bytes.first(header_size), "header");
  const auto length = in.take<std::uint64_t>();
  const auto type = in.take<std::uint32_t>();
  if (type == 0 || type > last_type)
    refuse("the frame has the type " + std::to_string(type) + "; allowed are 1 to " +
           std::to_string(last_type));
  const Header header{length, static_cast<Type>(type), in.take<std::uint32_t>()};
  if (length > longest)
    refuse("the frame '" + std::string(name(header.type)) + "' announces " + std::to_string(length) +
           " bytes; allowed are up to " + std::to_string(longest));
  return header;
}

Frame Frame::read(std::span<const std::byte> bytes, std::uint64_t longest) {
  if (bytes.size() < header_size)
    refuse("the frame has " + std::to_string(bytes.size()) + " bytes; allowed are " +
           std::to_string(header_size) + " or more");
  const Header header = read_header(bytes, longest);
  if (header.length != bytes.size() - header_size)
    refuse("the frame '" + std::string(name(header.type)) + "' announces " + std::to_string(header.length) +
           " bytes, and " + std::to_string(bytes.size() - header_size) + " follow");
  return {header, bytes.subspan(header_size)};
}

void begin(Writer& frame, Type type, std::uint32_t number) {
  frame.clear();
  frame.put(std::uint64_t{0});
  frame.put(static_cast<std::uint32_t>(type));
  frame.put(number);
}

void finish(Writer& frame) { frame.put_at<std::uint64_t>(0, frame.size() - header_size); }

}  // namespace tandem::wire
