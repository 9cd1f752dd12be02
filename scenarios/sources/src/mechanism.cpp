// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/sources/mechanism.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "tandem/error.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/subsystem.hpp"
#include "tandem/nearest.hpp"
#include "tandem/sources/file_parameters.hpp"
#include "tandem/sources/run_table.hpp"
#include "tandem/sources/stepper.hpp"
#include "tandem/sources/view_table.hpp"

namespace tandem {
namespace {

mbs::MatrixDump dump(Parameters& p) {
  mbs::MatrixDump d;
  for (const char* name : {"matrices_at", "matrices_format"})
    if (p.has(name) && !p.has("matrices"))
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("parameter '{}' is given without 'matrices', the folder "
                              "that the matrices are written to",
                              name));
  d.folder = p.text("matrices", "");
  d.times = {-std::numeric_limits<double>::infinity()};
  if (p.has("matrices_at")) d.times = matrix_times("parameter 'matrices_at'", p.text("matrices_at", ""));
  d.format = mbs::matrix_format(p.text("matrices_format", "mtx"));
  return d;
}

/// An output for each coordinate of a point, and of a vector that moves, that has none of that name.
void animate(mbs::Description& d) {
  constexpr const char* axes[] = {"x", "y", "z"};
  for (int e = 0; e < static_cast<int>(d.entities.size()); ++e) {
    const mbs::Entity& entity = d.entities[static_cast<std::size_t>(e)];
    if (entity.fixed && entity.kind == mbs::Entity::Kind::vector) continue;
    for (int axis = 0; axis < d.dimension; ++axis) {
      const std::string name = entity.name + "." + axes[axis];
      const bool there = std::any_of(d.outputs.begin(), d.outputs.end(),
                                     [&](const mbs::Output& o) { return o.name == name; });
      if (!there) d.outputs.push_back({name, mbs::Output::Kind::position, {e, axis}});
    }
  }
}

/// With commas between.
std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> all;
  for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
    end = text.find(',', begin);
    all.push_back(text.substr(begin, end == std::string::npos ? end : end - begin));
  }
  return all;
}

/// Names of inputs or outputs.
template <class Ports>
std::vector<std::string> names_of(const Ports& ports) {
  std::vector<std::string> all;
  for (const auto& one : ports) all.push_back(one.name);
  return all;
}

void check_name(const char* parameter, const char* what, const std::string& name,
                const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw Error(ErrorCode::invalid_argument,
                fmt::format("parameter '{}': {}", parameter, unknown(what, name, known)));
}

/// Of "x.by.F,y.by.F": an output of that name for each displacement by an input, where only forces follow the input.
void tell_accelerances(const std::string& text, mbs::Description& d) {
  const std::vector<mbs::Output> outputs = d.outputs;
  const auto of_outputs = names_of(outputs), of_inputs = names_of(d.inputs);
  for (const std::string& name : words_of(text)) {
    const auto by = name.find(".by.");
    const std::string of = name.substr(0, by), force = by == std::string::npos ? "" : name.substr(by + 4);
    check_name("accelerances", "output", of, of_outputs);
    check_name("accelerances", "input", force, of_inputs);
    const auto output = std::find(of_outputs.begin(), of_outputs.end(), of) - of_outputs.begin();
    const auto input =
        static_cast<int>(std::find(of_inputs.begin(), of_inputs.end(), force) - of_inputs.begin());
    const mbs::Output& y = outputs[static_cast<std::size_t>(output)];
    if (y.kind != mbs::Output::Kind::position || !mbs::only_forces_follow(d, input)) continue;
    mbs::Output told{name, mbs::Output::Kind::accelerance, y.coordinate};
    told.gain = y.gain, told.input = input;
    d.outputs.push_back(told);
  }
}

void take_reactions(const std::string& text, mbs::Description& d) {
  for (const std::string& name : words_of(text)) check_name("reactions", "output", name, names_of(d.outputs));
  mbs::take_reactions(d, words_of(text));
}

Words mechanism_words() {
  return words_by(Setter::client, {"step", "animate", "accelerances", "reactions"}) + stepper_words() +
         words_by(Setter::operator_only, {"matrices", "matrices_at", "matrices_format"});
}

}  // namespace

std::vector<double> matrix_times(const std::string& name, const std::string& text) {
  std::vector<double> all;
  for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
    end = text.find(',', begin);
    const std::string word = text.substr(begin, end == std::string::npos ? end : end - begin);
    double t = 0.0;
    const auto [stop, code] = std::from_chars(word.data(), word.data() + word.size(), t);
    if (code != std::errc{} || stop != word.data() + word.size() || !std::isfinite(t))
      throw Error(
          ErrorCode::invalid_argument,
          fmt::format("{} is '{}', of which '{}' is no time; allowed are times in s with a comma between, as "
                      "0,0.5",
                      name, text, word));
    all.push_back(t);
  }
  std::sort(all.begin(), all.end());
  return all;
}

mbs::Description describe_mechanism(const SourceFile& file, Parameters& p, const mbs::ElementKinds& kinds) {
  const text::Document document = file.document();
  take_run_table(document, p);
  const text::GivenValues given = take_file_parameters(document, mechanism_words(), p);
  refuse_words_of_clients(document, given, p);
  mbs::Description description = mbs::read_mechanism(document, kinds, given);
  read_view(document, description);  // refuses what is wrong with it
  return description;
}

std::unique_ptr<Subsystem> make_mechanism(const SourceFile& file, Parameters& p,
                                          const mbs::ElementKinds& kinds, const mbs::TellOfLimit& tell) {
  mbs::Description description = describe_mechanism(file, p, kinds);
  if (p.flag("animate", false)) animate(description);
  if (p.has("accelerances")) tell_accelerances(p.text("accelerances", ""), description);
  if (p.has("reactions")) take_reactions(p.text("reactions", ""), description);
  if (!p.has("step"))
    throw Error(ErrorCode::invalid_argument,
                "mechanism '" + description.name +
                    "' has no own step; give the parameter step, a number above 0 "
                    "[s], or step in the table [run] of its file");
  const double step = p.number("step", 0.0);
  mbs::SubsystemSettings settings{step, take_stepper(p), dump(p)};
  if (tell)
    settings.tell = [tell, name = description.name](const std::string& text) {
      tell("mechanism '" + name + "': " + text);
    };
  return mbs::make_subsystem(std::move(description), settings);
}

Source mechanism_source(const mbs::ElementKinds& kinds, const mbs::TellOfLimit& tell) {
  return {mechanism_words(), [kinds, tell](const Address& address, Parameters& p) {
            return make_mechanism({address.file(), {}, address.overrides}, p, kinds, tell);
          }};
}

Builtins without_matrices(Builtins builtins) {
  const auto leave_out = [](Source& source) {
    if (std::none_of(source.words.begin(), source.words.end(),
                     [](const Word& word) { return word.name == "matrices"; }))
      return;
    source.make = [make = source.make](const Address& address, Parameters& p) {
      p.text("matrices", "");  // refuses what is no text
      p.set("matrices", std::string());
      return make(address, p);
    };
  };
  for (auto* sources : {&builtins.models, &builtins.schemes})
    for (auto& [name, source] : *sources) leave_out(source);
  return builtins;
}

}  // namespace tandem
