// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "read_metrics.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "axes.hpp"
#include "over_time.hpp"
#include "read_given.hpp"
#include "tandem/nearest.hpp"

namespace tandem::study {
namespace {

using text::Section;

const std::string steps = "steps.", share = "share.", none = "none";

std::vector<std::string> names_of(const std::vector<Reference>& references) {
  std::vector<std::string> names;
  for (const Reference& reference : references) names.push_back(reference.name);
  return names;
}

Metric::Norm norm_of(const std::string& word) {
  using enum Metric::Norm;
  return word == "rms" ? rms : word == "end" ? end : word == "least" ? least : word == "most" ? most : max;
}

Metric::Relative relative_of(const std::optional<std::string>& word) {
  using enum Metric::Relative;
  return !word ? no : *word == "peak" ? peak : *word == "rms" ? rms : start;
}

const std::string names_alone =
    "exchanges, steps.INSTANCE, seconds, share.INSTANCE, real_time_factor, spectral_radius, damping and "
    "detuning";

/// One metric of a table with keys.
class MetricReader {
 public:
  MetricReader(Section& section, const std::string& name, const Study& study)
      : section_(section), study_(study) {
    metric_.name = name;
    metric_.place = section.place();
  }

  Metric read() {
    read_kind();
    metric_.with = all_given(section_, "with");
    read_norm();
    read_reference();
    refuse_what_has_no_meaning();
    section_.leave_out("repetitions", "it is no time");
    section_.leave_out("state", "it is neither damping nor detuning");
    section_.refuse_unknown();
    return std::move(metric_);
  }

 private:
  void read_kind() {
    using Kind = Metric::Kind;
    const std::pair<const char*, Kind> kinds[] = {{"of", Kind::output},       {"signal", Kind::signal},
                                                  {"drift", Kind::drift},     {"order", Kind::order},
                                                  {"formula", Kind::formula}, {"builtin", Kind::coded},
                                                  {"defect", Kind::defect},   {"energy", Kind::energy}};
    int found = 0;
    for (const auto& [key, kind] : kinds)
      if (const auto text = section_.text(key)) {
        ++found, metric_.kind = kind, metric_.of = *text;
        if (kind == Kind::signal || kind == Kind::drift || kind == Kind::formula)
          metric_.formula = Formula{*text, section_.place(key)};
      }
    if (found > 1)
      refuse(section_.place(), section_.path() + " has " + std::to_string(found) +
                                   " of `of`, `signal`, `drift`, `order`, `formula`, `builtin`, `defect` and "
                                   "`energy`; allowed is one");
    if (found == 0)
      section_.missing("of",
                       "one of `of`, `signal`, `drift`, `order`, `formula`, `builtin`, `defect` and "
                       "`energy`; by their names alone "
                       "there are " +
                           names_alone);
  }

  void read_norm() {
    metric_.norm = norm_of(*section_.text("norm"));
    metric_.relative = relative_of(section_.text("relative"));
    metric_.window.from = section_.number("from").value_or(metric_.window.from);
    metric_.window.to = section_.number("to").value_or(metric_.window.to);
    metric_.window.shift = section_.positive("shift").value_or(0.0);
    metric_.window.lines = false;
    metric_.unit = section_.text("unit").value_or("");
    metric_.otherwise = read_otherwise();
    if (const toml::node* scale = section_.node("scale"))
      metric_.scale = Formula{scale->is_string() ? scale->as_string()->get() : fmt_number(*scale),
                              section_.place("scale")};
    if (!(metric_.window.from < metric_.window.to))
      section_.wrong("to", text::described(*section_.node("to")),
                     "a time in s after " + section_.name("from"));
  }

  std::optional<double> read_otherwise() {
    const toml::node* found = section_.node("otherwise");
    if (!found) return {};
    const auto number = found->value<double>();
    if (!number || std::isnan(*number))
      section_.wrong("otherwise", text::described(*found), "a number, or inf");
    return number;
  }

  std::string fmt_number(const toml::node& node) const {
    return text::shown(FileValue(text::number_of(section_.document(), node, section_.name("scale"))));
  }

  void read_reference() {
    const auto against = section_.text("against");
    const auto known = names_of(study_.references);
    if (metric_.is_over_time()) find_outputs(metric_, study_.references);
    if (against == none && metric_.kind == Metric::Kind::output) metric_.outputs = {metric_.of};
    if (against == none) return;
    if (against && std::find(known.begin(), known.end(), *against) == known.end())
      refuse(section_.place("against"),
             section_.name("against") + ": " + unknown("reference", *against, known));
    if (metric_.kind == Metric::Kind::coded && against) metric_.of_reference(*against, named_output());
    if (metric_.kind != Metric::Kind::output) return;
    if (!against && known.size() > 1) section_.missing("against", "one of the references " + listed(known));
    metric_.against = against ? *against : known.empty() ? "" : known[0];
    metric_.outputs = {metric_.of};
    if (!metric_.against.empty()) metric_.of_reference(metric_.against, metric_.of);
  }

  /// Of a builtin that compares with a reference.
  std::string named_output() const {
    for (const Given& one : metric_.with)
      if (const auto* text = std::get_if<std::string>(&one.value); text && one.name == "output") return *text;
    section_.missing("against", "with.output beside it, the output of the reference");
  }

  void refuse_what_has_no_meaning() {
    const bool output = metric_.kind == Metric::Kind::output, drift = metric_.kind == Metric::Kind::drift;
    const bool is_signed = metric_.norm == Metric::Norm::least || metric_.norm == Metric::Norm::most;
    const std::string no_reference = "there is no reference";
    if (!output && metric_.kind != Metric::Kind::coded)
      section_.leave_out("against", "it is neither `of` nor `builtin`");
    if (!output) section_.leave_out("shift", "it is no `of`");
    if (!output) section_.leave_out("unit", "it is no `of`");
    if (output && metric_.against.empty())
      section_.leave_out("relative", no_reference), section_.leave_out("shift", no_reference);
    if (metric_.kind != Metric::Kind::coded) section_.leave_out("with", "it is no `builtin`");
    if (!output && !metric_.is_over_time())
      for (const char* key : {"norm", "from", "to"})
        section_.leave_out(key, "it is neither `of` nor `signal` nor `drift`");
    if (!output && !drift) section_.leave_out("relative", "it is neither `of` nor `drift`");
    if (is_signed && !metric_.against.empty())
      section_.wrong("norm", "'" + *section_.text("norm") + "'", "max, rms or end, of a difference");
    const bool relative = metric_.relative != Metric::Relative::no;
    if (relative && (metric_.relative == Metric::Relative::start) != drift)
      section_.wrong("relative", "'" + *section_.text("relative") + "'",
                     drift ? "start, of a drift" : "peak or rms, of an output");
    if (relative) section_.leave_out("unit", "a fraction has none");
  }

  Section& section_;
  const Study& study_;
  Metric metric_{};
};

/// Of a time the runs of which it is the least, its only key.
int repetitions(Section& section) {
  constexpr double most = 1000.0;
  const toml::node* found = section.node("repetitions");
  const double count = found ? section.number_of(*found, section.name("repetitions")) : 3.0;
  if (!(count >= 1.0) || count > most || count != std::floor(count))
    section.wrong("repetitions", text::described(*found), "a whole number from 1 to 1000");
  return static_cast<int>(count);
}

const std::string modal[] = {"damping", "detuning"};

/// By its name, with the one key that it may have; nothing if it has others.
std::optional<Metric> by_name(Section& section, const std::string& name) {
  using Kind = Metric::Kind;
  const bool is_time = name == "seconds" || name == "real_time_factor",
             is_modal = std::find(std::begin(modal), std::end(modal), name) != std::end(modal);
  const auto has_one = [&](const char* key) { return section.table().contains(key); };
  const bool own_key = (is_time && has_one("repetitions")) || (is_modal && has_one("state"));
  if (section.table().size() > (own_key ? 1U : 0U)) return {};
  Metric one{.name = name, .kind = Kind::exchanges, .place = section.place()};
  if (is_time)
    one.kind = name == "seconds" ? Kind::seconds : Kind::real_time, one.repetitions = repetitions(section);
  if (name.starts_with(steps)) one.kind = Kind::steps, one.of = name.substr(steps.size());
  if (name.starts_with(share)) one.kind = Kind::share, one.of = name.substr(share.size());
  if (name == "spectral_radius" || is_modal)
    one.kind = Kind::stability, one.of = name, one.state = section.text("state").value_or("");
  return is_time || name == "exchanges" || !one.of.empty() ? std::optional(one) : std::nullopt;
}

void check_names(const Formula& formula, const std::string& what, const std::vector<std::string>& known) {
  located(formula.place, [&] {
    for (const std::string& name : text::names_in(formula.text))
      if (std::find(known.begin(), known.end(), name) == known.end())
        throw Error(ErrorCode::invalid_argument, what + ": " + unknown("name", name, known));
  });
}

void check_signal(const Metric& one, const std::vector<std::string>& columns) {
  const bool columns_alone =
      std::all_of(one.outputs.begin(), one.outputs.end(), [&](const std::string& name) {
        return std::find(columns.begin(), columns.end(), name) != columns.end();
      });
  if (columns_alone && one.referred.empty())
    refuse(one.formula->place, "metrics." + one.name + ": '" + one.formula->text +
                                   "' names no output; allowed is an expression of outputs");
}

/// Of what it is the order.
void check_order(const Metric& one, const Study& study) {
  using Kind = Metric::Kind;
  std::vector<std::string> known;
  for (const Metric& metric : study.metrics)
    if (metric.kind == Kind::output || metric.is_over_time() || metric.kind == Kind::formula ||
        metric.kind == Kind::coded)
      known.push_back(metric.name);
  if (std::find(known.begin(), known.end(), one.of) == known.end())
    refuse(one.place, "metrics." + one.name + ".order: " + unknown("metric before it", one.of, known));
}

}  // namespace

void read_metrics(Section& root, Study& to) {
  auto all = root.section("metrics");
  if (!all) return;
  for (auto& [name, section] : all->named_sections()) {
    auto metric = by_name(section, name);
    if (!metric && !is_column_name(name))
      refuse(section.place(),
             "metrics." + name +
                 ": allowed names have letters, digits and _, no digit first; by their names "
                 "alone there are " +
                 names_alone);
    refuse_own_column("metrics." + name, name, section.place());
    const auto columns = to.columns();
    if (std::find(columns.begin(), columns.end(), name) != columns.end())
      refuse(section.place(), "metrics." + name + " has the name of a column");
    const Metric one = metric ? *metric : MetricReader(section, name, to).read();
    if (one.kind == Metric::Kind::formula) check_formula(*one.formula, "metrics." + name + ".formula", to);
    if (one.is_over_time()) check_signal(one, columns);
    if (one.kind == Metric::Kind::order) check_order(one, to);
    if (one.scale) check_names(*one.scale, "metrics." + name + ".scale", to.columns());
    to.metrics.push_back(one);
  }
}

void check_formula(const Formula& formula, const std::string& what, const Study& study) {
  auto known = study.columns();
  for (const Metric& metric : study.metrics)
    for (const std::string& name : study.names_of(metric)) known.push_back(name);
  check_names(formula, what, known);
}

}  // namespace tandem::study
