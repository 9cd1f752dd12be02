// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>

namespace tandem::engine {

/// One operation on signals, which are numbers of slots in an image.
struct Operation {
  enum class Code : std::uint8_t {
    linear,      ///< `out = p0 + p1 a`.
    sum,         ///< `out = p0 a + p1 b`.
    add,         ///< `out += p0 a`.
    product,     ///< `out = a b`.
    quotient,    ///< `out = a / b`.
    polynomial,  ///< `out = p0 + p1 a + ..` up to the power b.
    function,    ///< `out = functions[b](a)`.
    function2,   ///< `out = functions2[more](a, b)`.
    curve,       ///< `out = curves[b](a)`.
    surface,     ///< `out = surfaces[more](a, b)`.
    data,        ///< `out = data[b]` at time a, of the run `more` between two jumps; of held data, at any.
    select,      ///< `out = more > 0 ? a : b`.
    clamp,       ///< `out = more < 0 ? p0 : more > 0 ? p1 : a`.
    dead_zone,   ///< `out = more < 0 ? a - p0 : more > 0 ? a - p1 : 0`.
    beyond,      ///< `out = a < p0 ? -1 : a > p1 ? 1 : 0`.
    compare,     ///< `out = a > b ? 1 : 0`.
    delay,       ///< `out = a`, what delays[b] remembers, at the time `more - p0`.
    call,        ///< `out, out + 1, .. = calls[more](p, states from a on, inputs from b on)`; -1: none.
    leave        ///< `out = more` where a points away from 0 on its side, else 0.
  };
  Code code;
  int out, a, b = 0;
  int more = 0;       ///< a third slot, or a number of a table
  int parameter = 0;  ///< of p0
};

}  // namespace tandem::engine
