// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Any bytes from a client: a session ends, or breaks with an Error.
#include "memory_stream.hpp"
#include "sum.hpp"
#include "tandem/error.hpp"
#include "tandem/wire/session.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tandem;
  for (const bool reacts : {false, true}) try {
      const auto channel = fuzz::channel_of(data, size);
      wire::Session(*channel, [&](const std::string&) {
        return std::make_unique<fuzz::Sum>(reacts);
      }).serve();
    } catch (const Error&) {  // what has to come of bytes that are not right
    }
  return 0;
}
