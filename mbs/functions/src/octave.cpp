// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/functions/octave.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <iterator>
#include <sstream>

#include "process.hpp"
#include "tandem/error.hpp"
#include "tandem/mbs/functions/octave_struct.hpp"

namespace tandem::mbs {
namespace {

/// An answer is a line: "tandem= ROWS COLUMNS VALUES...", "tandem: WORDS..." or "tandem! MESSAGE"; whatever
/// else a model prints is passed over.
constexpr const char* answers = R"octave(
function tandem_tell_values (f, varargin)
  [message, values] = tandem_evaluate (f, varargin{:});
  if (isempty (message))
    message = ["= " sprintf("%d %d", rows (values), columns (values)) sprintf(" %.17g", values)];
  else
    message = ["! " message];
  end
  printf ("\ntandem%s\n", message);
  fflush (stdout);
end
function tandem_tell_words (f)
  try
    words = f ();
    if (! iscellstr (words)) error ("it is a %s; allowed is a cell array of texts", class (words)); end
    message = [": " strjoin(words(:)', " ")];
  catch failure
    message = ["! " strrep(failure.message, "\n", " ")];
  end
  printf ("\ntandem%s\n", message);
  fflush (stdout);
end
function words = tandem_load (name)
  global tandem_model;
  tandem_model = feval (name);
  if (! isstruct (tandem_model)) error ("%s() gives a %s; allowed is a struct", name, class (tandem_model)); end
  words = fieldnames (tandem_model);
end
)octave";

/// As a text in Octave. Functions go to it as such texts: a program whose first word is `function` is taken for
/// a file of functions when it comes through a pipe.
std::string in_quotes(const std::string& text) {
  std::string all = "\"";
  for (const char c : text)
    if (c == '\n')
      all += "\\n";
    else
      all += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
  return all + "\"";
}

std::string column(const double* values, int size) {
  std::string text = ", [";
  for (int i = 0; i < size; ++i) text += fmt::format("{};", values[i]);
  return text + "]";
}

std::vector<std::string> words(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

class Octave final : public OctaveStruct {
 public:
  Octave(const std::filesystem::path& file, const OctaveSettings& settings)
      : OctaveStruct(file.stem().string()),
        settings_(settings),
        process_({settings.command, "--quiet", "--norc", "--no-history", "--no-line-editing"}),
        file_(std::filesystem::absolute(file)) {
    if (!(settings.deadline > 0.0 && settings.deadline <= 1e6))
      refuse(fmt::format("deadline is {} s; allowed is above 0, to 1e6", settings.deadline));
    if (!std::filesystem::is_regular_file(file_)) refuse("there is no file " + file_.string());
    take_info();
  }

 private:
  std::vector<std::string> fields() override {
    const std::string folder = file_.parent_path().string();
    return words(ask(file_.string(), fmt::format("eval ({}); eval ({}); global tandem_model; addpath ({});\n"
                                                 "tandem_tell_words (@() tandem_load ({}));\n",
                                                 in_quotes(octave_functions), in_quotes(answers),
                                                 in_quotes(folder), in_quotes(info().name))));
  }
  std::vector<std::string> texts(const std::string& field) override {
    return words(ask(field, fmt::format("tandem_tell_words (@() tandem_model.{});\n", field)));
  }
  void constant(const std::string& field, Values& values) override {
    take(ask(field, fmt::format("tandem_tell_values (@() tandem_model.{});\n", field)), values);
  }
  void call(  // NOLINT(readability-function-size): the interface has six
      Term term, const std::string& what, double t, const double* q, const double* v,
      Values& values) override {
    std::string arguments;
    if (q) arguments = fmt::format(", {}", t) + column(q, info().size());
    if (v) arguments += column(v, info().size());
    take(ask(what, fmt::format("tandem_tell_values (tandem_model.{}{});\n", name(term), arguments)), values);
  }

  static void take(const std::string& text, Values& values) {
    char* next = nullptr;
    values.rows = static_cast<int>(std::strtol(text.c_str(), &next, 10));
    values.columns = static_cast<int>(std::strtol(next, &next, 10));
    values.numbers.resize(static_cast<std::size_t>(values.rows * values.columns));
    for (double& number : values.numbers) number = std::strtod(next, &next);
  }

  /// What the answer has behind its mark.
  std::string ask(const std::string& what, const std::string& command) {
    using namespace std::chrono;
    const Instant deadline = steady_clock::now() + ceil<nanoseconds>(duration<double>(settings_.deadline));
    check(what, process_.write(command, deadline));
    for (std::string line;;) {
      check(what, process_.read_line(line, deadline));
      if (line.starts_with("tandem! ")) refuse(what + ": " + line.substr(8));
      if (line.starts_with("tandem= ") || line.starts_with("tandem: ")) return line.substr(8);
      if (!line.empty()) said_ = line;
    }
  }

  void check(const std::string& what, Process::Outcome outcome) {
    if (outcome == Process::Outcome::ok) return;
    const std::string how = process_.end();
    const std::string said = said_.empty() ? "" : "; the last that it printed is: " + said_;
    const std::string why =
        outcome == Process::Outcome::late
            ? fmt::format("no answer within the deadline of {} s, so it was ended", settings_.deadline)
            : fmt::format("it has ended ({})", how);
    refuse(fmt::format("{}: {}{}", what, why, said), ErrorCode::input_output);
  }

  OctaveSettings settings_;
  Process process_;
  std::filesystem::path file_;
  std::string said_;
};

}  // namespace

std::unique_ptr<Functions> open_octave(const std::filesystem::path& file, const OctaveSettings& settings) {
  return std::make_unique<Octave>(file, settings);
}

}  // namespace tandem::mbs
