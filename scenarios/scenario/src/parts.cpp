// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/scenario/parts.hpp"

#include <algorithm>
#include <cmath>

#include "impulse.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"
#include "tandem/printable.hpp"

namespace tandem::scenario {
namespace {

const std::string animated = "animate", telling = "accelerances", reacting = "reactions";

/// use(opening) with errors that name the place in the file, and a subsystem that lives elsewhere: the
/// address alone may serve several. animate: it is to tell where its points are, unless its own parameters
/// say whether.
template <class Use>
auto with_opening(const SubsystemEntry& entry, const Builtins& builtins, bool animate, const Use& use) {
  Opening opening{{},
                  std::filesystem::path(entry.place.file).parent_path(),
                  entry.command,
                  entry.overrides,
                  entry.isolated};
  for (const Parameter& p : entry.parameters) opening.parameters.set(p.name, p.value);
  const auto place_of = [&](const std::string& sentence) { return entry.place_named_in(sentence); };
  return located(place_of, [&] {
    if (animate && takes(entry, builtins, animated) && !opening.parameters.has(animated))
      opening.parameters.set(animated, true);
    if (!entry.accelerances.empty() && takes(entry, builtins, telling) && !opening.parameters.has(telling))
      opening.parameters.set(telling, entry.accelerances);
    if (!entry.reactions.empty() && takes(entry, builtins, reacting))
      opening.parameters.set(reacting, entry.reactions);
    try {
      return use(std::move(opening));
    } catch (const Error& error) {
      if (!source_of(entry.source, builtins).elsewhere) throw;
      throw Error(error.code(), "subsystem '" + entry.name + "': " + error.what());
    }
  });
}

bool is_code(const SubsystemEntry& entry, const Builtins& builtins) {
  return located(entry.source_place, [&] { return source_of(entry.source, builtins).code; });
}

/// As a run does it first: with the inputs that are not connected, and NaN for the others.
void start(Subsystem& subsystem, const Topology& topology, int instance, const TimeSpan& span) {
  std::vector<double> u0 = topology.start(instance);
  for (int k = 0; k < static_cast<int>(u0.size()); ++k)
    if (const TimeSeries* series = topology.series(instance, k))
      u0[static_cast<std::size_t>(k)] = series->value(span.start);
    else if (!topology.lines_to(instance, k).empty())
      u0[static_cast<std::size_t>(k)] = std::nan("");
  std::vector<double> row(static_cast<std::size_t>(subsystem.info().row_size()));
  Samples y(row.data(), subsystem.info().row_size(), 1);
  try {
    subsystem.initialize(span.start, span.stop, u0, y);
  } catch (const Error& error) {
    throw Error(error.code(), "subsystem '" + topology.name(instance) + "': " + error.what());
  }
}

}  // namespace

bool takes(const SubsystemEntry& entry, const Builtins& builtins, const std::string& word) {
  return located(entry.source_place, [&] {
    const Words& words = source_of(entry.source, builtins).words;
    return std::any_of(words.begin(), words.end(), [&](const Word& one) { return one.name == word; });
  });
}

Parts::Parts(const Scenario& scenario, const Builtins& builtins, Code code) : scenario_(scenario) {
  if (scenario.chooses)
    refuse(scenario.place("coordination.scheme"),
           "coordination.scheme is auto, and no scheme has been taken; allowed here is stated");
  if (code == Code::run && lacks_fast_period(scenario))
    refuse(scenario.place("coordination.coupling"),
           "coordination.fast_period is not stated, and has not been found; allowed here is a number above 0 "
           "[s]");
  if (scenario.animate) check_animation(builtins);
  open_sides(builtins, code);
  put_instances();
  Connections connections = scenario.connections;
  by_impulse(scenario) ? couple(connections, builtins.stand_ins) : put_connections(connections);
  if (scenario.judge) check_output(scenario.judge->place, "judge.quantity: output", scenario.judge->quantity);
  for (const std::string& name : scenario.plots)
    check_output(scenario.place("view.plots"), "view.plots: output", name);
  located([&](const std::string& sentence) { return scenario_.place_named_in(sentence); },
          [&] { topology_.check(); });
}

void Parts::open_sides(const Builtins& builtins, Code code) {
  std::error_code none;  // of a folder that is gone
  const auto home = std::filesystem::current_path(none);
  for (const SubsystemEntry& entry : scenario_.subsystems) {
    if (entry.impulse) continue;
    std::filesystem::current_path(home, none);  // a library may have gone elsewhere
    const bool out = code == Code::leave_out && is_code(entry, builtins);
    auto subsystem = out ? nullptr : opened(entry, builtins, scenario_.animate);
    keep(std::move(subsystem), out ? leave_out(entry, builtins) : std::nullopt);
  }
}

void Parts::keep(std::unique_ptr<Subsystem> subsystem, std::optional<Look> look) {
  subsystems_.push_back(std::move(subsystem)), looks_.push_back(std::move(look));
}

void Parts::put_instances() {
  for (std::size_t i = 0; i < subsystems_.size(); ++i) put_instance(i);
  set_inputs();
}

void Parts::put_instance(std::size_t instance) {
  const SubsystemEntry& entry = scenario_.subsystems[instance];
  located(entry.place, [&] { topology_.add(entry.name, info(instance)); });
}

void Parts::put_connections(const Connections& all) {
  for (const ConnectionEntry& entry : all)
    located([&](const std::string& sentence) { return entry.place_named_in(sentence); },
            [&] { connect(entry); });
}

void Parts::check_animation(const Builtins& builtins) const {
  const auto& all = scenario_.subsystems;
  const bool any = std::any_of(all.begin(), all.end(),
                               [&](const SubsystemEntry& entry) { return takes(entry, builtins, animated); });
  if (!any)
    refuse(scenario_.place("record.animate"),
           "record.animate is true, but no subsystem has a source that tells where its points are, as "
           "mechanism:FILE does; allowed is to leave it out");
}

std::unique_ptr<Subsystem> Parts::opened(const SubsystemEntry& entry, const Builtins& builtins,
                                         bool animate) {
  return with_opening(entry, builtins, animate,
                      [&](Opening opening) { return open(entry.source, builtins, std::move(opening)); });
}

/// Its address is shown as who decides whether it may be run has to see it.
std::optional<Look> Parts::leave_out(const SubsystemEntry& entry, const Builtins& builtins) {
  auto look = with_opening(entry, builtins, scenario_.animate, [&](Opening opening) {
    auto seen = look_at(entry.source, builtins, std::move(opening));
    if (seen && seen->own_step == 0.0)
      throw Error(ErrorCode::invalid_argument,
                  "source '" + entry.address() +
                      "' names no step of its own; give the parameter step, a number "
                      "above 0 [s]");
    return seen;
  });
  left_out_.push_back(entry.source_place.text() + ": subsystem '" + entry.name + "' is " +
                      (look ? "read and not run" : "left out") +
                      ", as its source is code: " + printable(entry.address(), std::string::npos) +
                      (look && !look->obstacle.empty() ? "; it can't be run here: " + look->obstacle : ""));
  return look;
}

const SubsystemInfo& Parts::info(std::size_t instance) const {
  if (subsystems_[instance]) return subsystems_[instance]->info();
  return looks_[instance] ? looks_[instance]->info : no_ports_;
}

bool Parts::is_left_out(const std::string& port) const {
  const auto dot = port.find('.');
  const auto number = topology_.instance(std::string_view(port).substr(0, dot));
  return dot != std::string::npos && number && !subsystem(*number) && !look(*number);
}

void Parts::set_inputs() {
  for (const SubsystemEntry& entry : scenario_.subsystems)
    for (const InputEntry& input : entry.inputs)
      if (const std::string port = entry.name + "." + input.port; !is_left_out(port))
        located(input.place, [&] {
          if (const double* value = std::get_if<double>(&input.value))
            topology_.set_start(port, *value);
          else
            topology_.drive(port, std::get<1>(input.value));
        });
}

void Parts::connect(const ConnectionEntry& entry) {
  Connection c = entry.connection;
  if (const Port* port = topology_.output_port(c.from); !c.how && port && !port->held)
    c.how = scenario_.otherwise;
  const bool no_source = is_left_out(c.from), no_reader = is_left_out(c.to);
  if (!no_source && !no_reader) return topology_.connect(c);
  if (!no_source) topology_.connect_half(c.from, true);
  if (!no_reader) topology_.connect_half(c.to, false);
}

void Parts::check_output(const Place& place, const std::string& what, const std::string& name) const {
  const auto known = topology_.output_names();
  if (!is_left_out(name) && std::find(known.begin(), known.end(), name) == known.end())
    refuse(place, unknown(what, name, known));
}

void Parts::check_each() const {
  std::vector<std::string> ports = scenario_.recording.ports;
  std::erase_if(ports, [this](const std::string& port) { return is_left_out(port); });
  if (const auto why = unknown_output(topology_.output_names(), ports); !why.empty())
    refuse(scenario_.place("record.ports"), why);
  const TimeSpan span{scenario_.start, scenario_.stop};
  const auto place_of = [&](const std::string& sentence) { return scenario_.place_named_in(sentence); };
  located(place_of, [&] { topology_.check_span(span); });
  for (int i = 0; i < topology_.size(); ++i)
    if (Subsystem* one = subsystem(i)) located(place_of, [&] { start(*one, topology_, i, span); });
}

void Parts::add_notes_of_units(std::vector<std::string>& notes) const {
  for (const Line& line : topology_.lines()) {
    const Scalar from = scalar_at(topology_.info(line.source).outputs, line.output);
    const Scalar to = scalar_at(topology_.info(line.reader).inputs, line.input);
    if (is_of_surrogate(line)) continue;
    if (from.port->unit.empty() == to.port->unit.empty() || from.element > 0) continue;
    const auto end = [&](int instance, const Port& port) {
      return topology_.name(instance) + "." + port.name +
             (port.unit.empty() ? ", whose unit is not said," : " [" + port.unit + "]");
    };
    notes.push_back("connection from " + end(line.source, *from.port) + " to " + end(line.reader, *to.port) +
                    " takes values as they are");
  }
}

/// Of subsystems that hold inputs over a step, which makes the order: a higher degree gains little then.
void Parts::add_notes_of_degrees(std::vector<std::string>& notes) const {
  for (const Line& line : topology_.lines()) {
    const Look* const seen = look(line.reader);
    const Scalar from = scalar_at(topology_.info(line.source).outputs, line.output);
    const int degree = line.how.polynomial_degree(), first = seen ? std::max(seen->input_order - 1, 1) : 0;
    if (!seen || seen->input_order == 0 || degree <= first || from.element > 0) continue;
    notes.push_back("connection from " + topology_.name(line.source) + "." + from.port->name +
                    " is of degree " + std::to_string(degree) + ", and '" + topology_.name(line.reader) +
                    "' holds its inputs over a step, which is of order " + std::to_string(seen->input_order) +
                    "; degree " + std::to_string(first) +
                    " comes first, as a higher one is unstable sooner in a stiff loop");
  }
}

std::vector<std::string> Parts::notes() const {
  std::vector<std::string> all = scenario_.remarks;
  all.insert(all.end(), couplings_.begin(), couplings_.end());
  add_notes_of_units(all);
  add_notes_of_degrees(all);
  for (int i = 0; i < topology_.size(); ++i)
    if (const Subsystem* one = subsystem(i))
      for (const std::string& remark : one->remarks(scenario_.stop)) all.push_back(note_of(i, remark));
  return all;
}

std::string once_per_process(const Scenario& scenario, const Builtins& builtins) {
  for (const SubsystemEntry& entry : scenario.subsystems) {
    if (entry.isolated || !is_code(entry, builtins)) continue;
    const auto look = with_opening(entry, builtins, false, [&](Opening opening) {
      return look_at(entry.source, builtins, std::move(opening));
    });
    if (look && look->once_per_process) return entry.name;
  }
  return {};
}

bool names_code(const Scenario& scenario, const Builtins& builtins) {
  return std::any_of(scenario.subsystems.begin(), scenario.subsystems.end(),
                     [&](const SubsystemEntry& entry) { return is_code(entry, builtins); });
}

}  // namespace tandem::scenario
