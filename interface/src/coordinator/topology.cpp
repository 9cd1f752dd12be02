// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/topology.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <tuple>

#include "../number_text.hpp"
#include "reconstruction_rules.hpp"
#include "tandem/check_info.hpp"
#include "tandem/coordinator/units.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem {
namespace {

[[noreturn]] void refuse_topology(const std::string& sentence) {
  throw Error(ErrorCode::invalid_argument, sentence);
}

}  // namespace

int Topology::add(const std::string& name, const SubsystemInfo& info) {
  if (name.empty() || name.find_first_of(".[] \t\n\",/\\") != std::string::npos)
    refuse_topology(
        "instance name '" + name +
        "' is empty or holds one of . [ ] , \" / \\ or a blank; allowed is a name without these, of "
        "a mechanism or diagram that runs alone the name of its file");
  if (numbers_.contains(name)) refuse_topology("instance name '" + name + "' is used twice");
  check_info(name, info);
  const auto inputs = static_cast<std::size_t>(info.input_size());
  Instance instance{name, &info, indexed(info.inputs), indexed(info.outputs), {}, {}, {}, {}, {}, {}, {}};
  for (auto* marks : {&instance.shared, &instance.half, &instance.open}) marks->resize(inputs);
  instance.driven.resize(inputs);
  instance.to.resize(inputs);
  for (const Port& port : info.inputs)
    for (int element = 0; element < port.size; ++element) instance.start.push_back(port.start_of(element));
  instances_.push_back(std::move(instance));
  return numbers_[name] = size() - 1;
}

Topology::PortIndex Topology::indexed(const std::vector<Port>& ports) {
  PortIndex index;
  int first = 0;
  for (const Port& port : ports) {
    index.numbers[port.name] = static_cast<int>(index.first.size());
    index.first.push_back(first);
    first += port.size;
  }
  return index;
}

std::optional<int> Topology::instance(std::string_view name) const {
  for (const Numbers* numbers : {&numbers_, &guests_})
    if (const auto found = numbers->find(std::string(name)); found != numbers->end()) return found->second;
  return {};
}

Topology::Named Topology::named(std::string_view text, std::size_t dot) const {
  const auto guest = guests_.find(std::string(text.substr(0, dot)));
  if (guest != guests_.end()) return {guest->second, std::string(text)};
  return {instance(text.substr(0, dot)), std::string(text.substr(dot + 1))};
}

std::string Topology::full_name(int instance, const std::string& port) const {
  if (guests_.empty()) return name(instance) + "." + port;
  const auto guest = guests_.find(port.substr(0, port.find('.')));
  return guest != guests_.end() && guest->second == instance ? port : name(instance) + "." + port;
}

const Port* Topology::output_port(std::string_view output) const {
  const auto dot = output.find('.');
  if (dot == std::string_view::npos) return nullptr;
  const auto [number, name] = named(output, dot);
  if (!number) return nullptr;
  const Numbers& numbers = at(*number).outputs.numbers;
  const auto found = numbers.find(name.substr(0, name.find('[')));
  return found == numbers.end() ? nullptr : &info(*number).outputs[static_cast<std::size_t>(found->second)];
}

Topology::Place Topology::find(std::string_view text, bool output) const {
  const auto dot = text.find('.');
  if (dot == std::string_view::npos)
    refuse_topology("port '" + std::string(text) + "' is not of the form instance.port");
  auto [number, port_name] = named(text, dot);
  int element = -1;
  if (const auto bracket = port_name.find('['); bracket != std::string::npos) {
    const char* first = port_name.data() + bracket + 1;
    const char* last = std::max(first, static_cast<const char*>(port_name.data() + port_name.size() -
                                                                1));  // "x[" ends at its bracket
    const auto [end, code] = std::from_chars(first, last, element);
    if (code != std::errc{} || end != last || *last != ']' || element < 0)
      refuse_topology("port '" + std::string(text) +
                      "' has an index that is not a whole number from 0 in brackets");
    port_name.resize(bracket);
  }
  const std::string instance_name(text.substr(0, dot));
  if (!number) refuse_topology(unknown("subsystem", instance_name, names()));
  const PortIndex& index = output ? at(*number).outputs : at(*number).inputs;
  const auto& ports = output ? info(*number).outputs : info(*number).inputs;
  if (const auto found = index.numbers.find(port_name); found != index.numbers.end()) {
    const auto k = static_cast<std::size_t>(found->second);
    const Port& port = ports[k];
    if (element >= port.size)
      refuse_topology("port '" + std::string(text) + "' has no element " + std::to_string(element) +
                      "; allowed are 0 to " + std::to_string(port.size - 1));
    return {*number, &port, index.first[k] + std::max(element, 0), element < 0 ? port.size : 1};
  }
  std::vector<std::string> known;
  for (const Port& port : ports) known.push_back(port.name);
  refuse_topology(
      unknown("subsystem '" + instance_name + "': " + (output ? "output" : "input"), port_name, known));
}

std::vector<std::string> Topology::names() const {
  std::vector<std::string> all;
  for (const Instance& instance : instances_) all.push_back(instance.name);
  return all;
}

void Topology::connect(const Connection& c) {
  const Place from = find(c.from, true), to = find(c.to, false);
  const std::string what = "connection from " + c.from + " to " + c.to;
  if (!std::isfinite(c.gain) || !std::isfinite(c.offset))
    refuse_topology(what + " has a gain or offset that is not finite");
  if (from.count != to.count)
    refuse_topology(what + " joins " + std::to_string(from.count) + " scalars to " +
                    std::to_string(to.count));
  const Reconstruction how = reconstruction_of(c, *from.port, info(to.instance).abilities.sampled, what);
  if (c.lag != Lag::none && !how.follows_samples())
    refuse_topology(what + " has a memory or delay together with " + how.name() + ", which has none");
  UnitConversion unit{1.0, 0.0};
  if (from.port->unit != to.port->unit && !from.port->unit.empty() && !to.port->unit.empty()) {
    const auto conversion = convert_unit(from.port->unit, to.port->unit);
    const std::string units = "'" + from.port->unit + "' to '" + to.port->unit + "'";
    if (!conversion) refuse_topology(what + " goes from unit " + units + ", which can't be converted");
    if (!c.convert)
      refuse_topology(what + " goes from unit " + units + "; say convert = true, or make them agree");
    unit = *conversion;
  }
  const Line line{0, 0, 0, 0, how, c.gain * unit.factor, c.gain * unit.shift + c.offset, c.lag};
  connect_scalars(line, c.add, from, to);
}

void Topology::connect_scalars(Line line, bool add, const Place& from, const Place& to) {
  Instance& reader = instances_[static_cast<std::size_t>(to.instance)];
  for (int k = 0; k < to.count; ++k) {
    char& shared = reader.shared[static_cast<std::size_t>(to.first + k)];
    if (!lines_to(to.instance, to.first + k).empty() && !(shared && add))
      refuse_topology("input " + input_name(to.instance, to.first + k) +
                      " is connected twice; to sum connections, each of them says add = true");
    refuse_driven(to.instance, to.first + k, "connected");
    shared = add;
  }
  for (int k = 0; k < to.count; ++k) {
    const auto number = static_cast<int>(lines_.size());
    instances_[static_cast<std::size_t>(from.instance)].from.push_back(number);
    line.source = from.instance, line.output = from.first + k;
    line.reader = to.instance, line.input = to.first + k;
    lines_.push_back(line);
    auto& terms = reader.to[static_cast<std::size_t>(line.input)];
    terms.insert(std::upper_bound(terms.begin(), terms.end(), number,
                                  [this](int a, int b) {
                                    return is_summed_before(lines_[static_cast<std::size_t>(a)],
                                                            lines_[static_cast<std::size_t>(b)]);
                                  }),
                 number);
  }
}

/// Of two that say the same, either is first.
bool Topology::is_summed_before(const Line& a, const Line& b) const {
  const auto key = [this](const Line& line) {
    const auto& [kind, degree, extra] = line.how;
    return std::tuple(std::string_view(name(line.source)), line.output, line.gain, line.offset, line.lag,
                      kind, degree, extra);
  };
  return key(a) < key(b);
}

void Topology::connect_half(std::string_view port, bool output) {
  const Place place = find(port, output);
  auto& half = instances_[static_cast<std::size_t>(place.instance)].half;
  if (!output) std::fill_n(half.begin() + place.first, place.count, 1);
}

void Topology::set_start(std::string_view port, double value) {
  if (!std::isfinite(value)) refuse_topology("start value of " + std::string(port) + " is not finite");
  const Place place = find(port, false);
  auto& start = instances_[static_cast<std::size_t>(place.instance)].start;
  for (int k = 0; k < place.count; ++k) start[static_cast<std::size_t>(place.first + k)] = value;
}

void Topology::drive(std::string_view port, std::shared_ptr<const TimeSeries> series) {
  const Place place = find(port, false);
  if (place.count > 1)
    refuse_topology("input " + std::string(port) + " is driven by " + series->name() +
                    ", which is one number, and has " + std::to_string(place.count) +
                    "; allowed are its elements, " + std::string(port) + "[0] and so on");
  if (!lines_to(place.instance, place.first).empty())
    refuse_topology("input " + std::string(port) + " is driven by " + series->name() +
                    " and connected; allowed is one of them");
  refuse_driven(place.instance, place.first, "driven once more");
  instances_[static_cast<std::size_t>(place.instance)].driven[static_cast<std::size_t>(place.first)] =
      std::move(series);
}

void Topology::leave_open(int instance, int input, double start) {
  Instance& reader = instances_[static_cast<std::size_t>(instance)];
  const auto k = static_cast<std::size_t>(input);
  assert(lines_to(instance, input).empty() && !series(instance, input));
  reader.start[k] = start, reader.open[k] = 1;
}

void Topology::refuse_driven(int instance, int input, const std::string& besides) const {
  if (const TimeSeries* series = this->series(instance, input))
    refuse_topology("input " + input_name(instance, input) + " is driven by " + series->name() + " and " +
                    besides + "; allowed is one of them");
}

void Topology::check() const {
  for (int i = 0; i < size(); ++i)
    for (int k = 0; k < info(i).input_size(); ++k)
      if (lines_to(i, k).empty() && !at(i).half[static_cast<std::size_t>(k)] && !series(i, k) &&
          std::isnan(start(i)[static_cast<std::size_t>(k)]))
        refuse_topology("input " + input_name(i, k) + " is not connected and has no start value");
  check_loops();
}

void Topology::check_span(TimeSpan span) const {
  const TimeTolerance tolerance(span.start);
  for (int i = 0; i < size(); ++i)
    for (int k = 0; k < info(i).input_size(); ++k)
      if (const TimeSeries* data = series(i, k);
          data && (tolerance.before(span.start, data->begin()) || tolerance.before(data->end(), span.stop)))
        refuse_topology("input " + input_name(i, k) + " is driven by " + data->name() +
                        ", which has data from " + number_text(data->begin()) + " to " +
                        number_text(data->end()) + " s; the run goes from " + number_text(span.start) +
                        " to " + number_text(span.stop) +
                        " s; allowed are data for all of it, or beyond = \"hold\"");
}

std::string Topology::input_name(int instance, int input) const {
  return full_name(instance, scalar_at(info(instance).inputs, input).name());
}
std::string Topology::output_name(int instance, int output) const {
  return full_name(instance, scalar_at(info(instance).outputs, output).name());
}

std::vector<std::string> Topology::output_names(int instance) const {
  std::vector<std::string> names;
  for (const Port& port : info(instance).outputs)
    for (int e = 0; e < port.size; ++e) names.push_back(full_name(instance, Scalar{&port, e}.name()));
  return names;
}

std::vector<std::string> Topology::output_names() const {
  std::vector<std::string> all;
  for (int i = 0; i < size(); ++i)
    for (std::string& name : output_names(i)) all.push_back(std::move(name));
  return all;
}

}  // namespace tandem
