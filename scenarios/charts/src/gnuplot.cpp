// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/charts/gnuplot.hpp"

#include <fmt/format.h>

#include <fstream>

#include "tandem/charts/program.hpp"
#include "tandem/error.hpp"
#include "tandem/output/files.hpp"
#include "tandem/output_file.hpp"

namespace tandem::charts {

namespace {

/// What gnuplot writes last: its exit status says nothing of a full disk.
bool ends_with(const std::filesystem::path& file, const std::string& mark) {
  constexpr std::uintmax_t tail = 16;
  std::error_code failed;
  const auto size = std::filesystem::file_size(file, failed);
  if (failed || size < tail) return false;
  std::ifstream in(file, std::ios::binary);
  in.seekg(-static_cast<std::streamoff>(tail), std::ios::end);
  return std::string(std::istreambuf_iterator<char>(in), {}).find(mark) != std::string::npos;
}

}  // namespace

std::string quote(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text)
    if (c == '\'')
      quoted += "’";
    else
      quoted += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  return quoted + "'";
}

Picture::Picture(std::string name, int width, int height) : name_(std::move(name)), height_(height) {
  head_ = fmt::format(
      "# Drawn by gnuplot 5.4: gnuplot {0}.gp, or for {0}.png: gnuplot -e \"format='png'\" {0}.gp\n"
      "if (!exists('format')) format = 'svg'\n"
      "if (format eq 'png') {{\n"
      "  set terminal pngcairo size {1},{2} font 'sans-serif,11' pointscale 1.7 background rgb 'white'\n"
      "  small = ',9'; large = ',13'\n"
      "}} else {{\n"
      "  set terminal svg size {1},{2} font 'sans-serif,14' background rgb 'white'\n"
      "  small = ',11'; large = ',16'\n"
      "}}\n"
      "set encoding utf8\n"
      "set output '{0}.' . format\n",
      name_, width, height);
  command("set multiplot");
}

std::string Picture::data(const std::vector<Point>& points) {
  std::string name = fmt::format("$d{}", ++blocks_);
  data_ += name + " << END\n";
  for (const Point& p : points) data_ += fmt::format("{:.9g} {:.9g}\n", p.x, p.y);
  // A block without points is an error to gnuplot; one undefined point is not.
  data_ += points.empty() ? "nan nan\nEND\n" : "END\n";
  return name;
}

void Picture::command(const std::string& text) { commands_ += text + '\n'; }

void Picture::panel(const Box& box) {
  command(
      fmt::format("set lmargin at screen {}; set rmargin at screen {}; set bmargin at screen {}; set tmargin "
                  "at screen {}",
                  box.left, box.right, box.bottom, box.top));
}

void Picture::plot(const std::vector<Curve>& curves) {
  std::string text = "plot ";
  for (const Curve& c : curves) {
    if (&c != &curves.front()) text += ", \\\n     ";
    text +=
        c.data + " " + c.style + (c.title.empty() ? " notitle" : " title " + quote(c.title) + " noenhanced");
  }
  command(text);
  for (; labels_ > 0; --labels_) command(fmt::format("unset label {}", labels_));
}

void Picture::legend(const Box& box, const std::vector<Curve>& curves, int columns) {
  panel(box);
  command(
      "unset border; unset tics; unset xlabel; unset ylabel; unset title; unset logscale; unset grid; unset "
      "object");
  command(
      fmt::format("set xrange [0:1]; set yrange [0:1]; set key inside center center horizontal maxcols {} "
                  "Left reverse samplen 3",
                  columns));
  std::vector<Curve> samples = curves;
  for (Curve& c : samples) c.data = "NaN";
  plot(samples);
  command("set border; set tics; unset key; set xrange [*:*]; set yrange [*:*]");
}

void Picture::caption(const std::vector<std::string>& lines) {
  double y = 14.0 * static_cast<double>(lines.size()) - 4.0;  // pixels
  for (const std::string& line : lines) {
    command(fmt::format("set label {} {} at screen 0.5,{:.5f} center noenhanced font small tc rgb '#404040'",
                        ++labels_, quote(line), y / height_));
    y -= 14.0;
  }
}

void Picture::title(const std::string& text) {
  command(fmt::format("set label {} {} at screen 0.5,{:.5f} center noenhanced font large", ++labels_,
                      quote(text), 1.0 - 16.0 / height_));
}

std::string Picture::script() const { return head_ + data_ + commands_ + "unset multiplot\nunset output\n"; }

std::filesystem::path Picture::draw(const std::filesystem::path& folder, Format format) const {
  const std::string script_file = name_ + ".gp", ending = format == Format::svg ? "svg" : "png";
  output::write_text(folder / script_file, script());
  std::filesystem::path file = folder / (name_ + "." + ending);
  if (std::filesystem::exists(file))
    OutputFile(file, OutputFile::Begin::kept);  // gnuplot would wait at a FIFO
  run_program({"gnuplot", "-e", "format='" + ending + "'", script_file}, folder,
              "Debian package gnuplot-nox");
  if (!ends_with(file, format == Format::svg ? "</svg>" : "IEND"))
    throw Error(ErrorCode::input_output, "file '" + file.string() + "' was not written to its end");
  return file;
}

}  // namespace tandem::charts
