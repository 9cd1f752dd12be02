// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tandem::charts {

enum class Format { svg, png };

/// A point of a data block. NaN in y interrupts a curve.
struct Point {
  double x, y;
};

/// What a panel covers of the picture, as fractions of its width and height from the lower left corner.
struct Box {
  double left, right, bottom, top;
};

/// One element of a gnuplot command `plot`: what is drawn (a data block, a function), how, and its entry in
/// the legend (none if empty).
struct Curve {
  std::string data;
  std::string style;
  std::string title = {};
};

/// A text as gnuplot reads it: in single quotes, on one line, its own single quotes as ’. (Gnuplot takes two
/// of them for one, but not where a text begins.)
std::string quote(std::string_view text);

/// A picture of one or more panels, written as a gnuplot script that holds its data, so that it can be drawn
/// again or changed by hand: `gnuplot NAME.gp`, or `gnuplot -e "format='png'" NAME.gp`.
class Picture {
 public:
  /// `name` is the stem of the files, of letters, digits and _; the size is in pixels.
  Picture(std::string name, int width, int height);

  const std::string& name() const { return name_; }
  int height() const { return height_; }
  /// Adds a data block and returns its name, for use in a Curve.
  std::string data(const std::vector<Point>& points);
  /// Adds a command as it is.
  void command(const std::string& text);
  /// Later plots go there.
  void panel(const Box& box);
  void plot(const std::vector<Curve>& curves);
  /// A panel that holds nothing but the legend of these curves, in so many columns.
  void legend(const Box& box, const std::vector<Curve>& curves, int columns);
  /// Small lines of text at the foot of the picture, the last one lowest. To be called before the first
  /// panel.
  void caption(const std::vector<std::string>& lines);
  /// Text centred above the picture. To be called before the first panel.
  void title(const std::string& text);

  std::string script() const;
  /// Writes NAME.gp into the folder and runs the program gnuplot on it, which writes NAME.svg or NAME.png;
  /// returns that file. Throws Error if a file can't be written, gnuplot is not installed, or it finds fault
  /// with the script.
  std::filesystem::path draw(const std::filesystem::path& folder, Format format) const;

 private:
  std::string name_, head_, data_, commands_;
  int blocks_ = 0, labels_ = 0;
  int height_;
};

}  // namespace tandem::charts
