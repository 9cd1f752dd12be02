// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace tandem::charts {

/// Errors above this are not results: charts draw them as failures.
inline constexpr double failure_limit = 0.5;

/// Thin grey lines at the numbers of both axes.
inline constexpr const char* grid_command = "set grid xtics ytics lt 1 dt 1 lw 0.7 lc rgb '#DCDCDC'";

/// How the k-th of up to six things is drawn, in gnuplot's words. Colours that the colour-blind can tell
/// apart (M. Okabe, K. Ito, Color Universal Design, 2008); line types and markers differ too, so that all can
/// be told apart in grey.
std::string line_of(int k);
std::string marker_of(int k);
/// The same marker, hollow: it takes two plots, first the white ground and then the outline.
std::string white_marker_of(int k);
std::string hollow_marker_of(int k);
/// Line and marker in one, for a legend.
std::string line_and_marker_of(int k);

/// The lines of a caption from a file conditions.json: processor, cores, compiler, commit, reference, error
/// norm and repetitions. Each line holds up to `width` characters. Throws Error naming the file, and the key
/// that is missing.
std::vector<std::string> conditions_caption(const std::filesystem::path& file, std::size_t width);
/// A number of such a file. Throws likewise.
double conditions_number(const std::filesystem::path& file, const std::string& key);

}  // namespace tandem::charts
