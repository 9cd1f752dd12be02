// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/state_bytes.hpp"

namespace tandem::mbs {

void write(const State& s, ByteWriter& to) {
  to.put(s.time);
  for (const auto* vector : {&s.q, &s.v, &s.a, &s.lambda})
    to.put_list({vector->data(), static_cast<std::size_t>(vector->size())});
}

void read(State& s, ByteReader& from) {
  s.time = from.take<double>();
  for (auto* vector : {&s.q, &s.v, &s.a, &s.lambda})
    from.take_list({vector->data(), static_cast<std::size_t>(vector->size())});
}

}  // namespace tandem::mbs
