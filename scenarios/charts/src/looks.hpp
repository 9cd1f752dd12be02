// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <array>
#include <limits>
#include <string>

namespace tandem::charts {

// How things are drawn, in gnuplot's words. Colours that the colour-blind can tell apart (M. Okabe, K. Ito,
// Color Universal Design, 2008), and four more; shapes and dashes differ too, so that all can be told apart
// in grey.

inline constexpr std::array<const char*, 12> colours = {"#000000", "#E69F00", "#56B4E9", "#D55E00",
                                                        "#0072B2", "#009E73", "#CC79A7", "#7A6A00",
                                                        "#909090", "#7B4FD0", "#A0307A", "#4D2600"};
/// Gnuplot's hollow point types; the filled one is the next.
inline constexpr std::array<int, 5> shapes = {6, 8, 4, 12, 10};
inline constexpr std::array<const char*, 4> dashes = {"1", "'-'", "'.'", "'-.'"};

/// A colour, a shape and dashes by their numbers, which may be any.
struct Look {
  std::size_t colour = 0, shape = 0;

  std::string line() const {
    return fmt::format("lc rgb '{}' lw 1.5 dt {}", colours[colour % colours.size()],
                       dashes[shape % dashes.size()]);
  }
  std::string filled() const { return point(colours[colour % colours.size()], 1); }
  std::string hollow() const { return point(colours[colour % colours.size()], 0) + " lw 1.2"; }
  std::string white() const { return point("white", 1); }

 private:
  std::string point(const char* rgb, int next) const {
    return fmt::format("lc rgb '{}' pt {} ps 0.6", rgb, shapes[shape % shapes.size()] + next);
  }
};

/// Thin grey lines at the numbers of both axes.
inline constexpr const char* grid_command = "set grid xtics ytics lt 1 dt 1 lw 0.7 lc rgb '#DCDCDC'";

/// Interrupts a curve.
inline constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

inline constexpr const char* reference_line = "with lines lc rgb '#606060' lw 1.3 dt '-'";
inline constexpr const char* order_line = "with lines lc rgb '#606060' lw 1";
inline constexpr const char* front_line = "with steps lc rgb '#000000' lw 1";
inline constexpr const char* front_ring = "with points pt 6 ps 1.3 lw 1 lc rgb '#000000'";
inline constexpr const char* overlay_points = "with points pt 3 ps 1 lw 1.5 lc rgb '#D55E00'";
inline constexpr const char* floor_line = "with lines lc rgb '#909090' lw 2.5 dt '.'";

}  // namespace tandem::charts
