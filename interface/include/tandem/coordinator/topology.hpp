// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "tandem/coordinator/connection.hpp"
#include "tandem/subsystem.hpp"
#include "tandem/time_series.hpp"

namespace tandem {

/// The subsystems of a run and what connects them, checked before anything runs.
class Topology {
 public:
  /// A new instance; its index. `info` must outlive the topology. Throws Error for a name (of the instance or
  /// of a port) that is empty, taken, or holds one of [ ] , " or a blank (an instance: or . / \). It also
  /// throws Error for ports that contradict themselves: size below 1, derivatives beyond 3, feedthrough of a
  /// port that is not there.
  int add(const std::string& name, const SubsystemInfo& info);

  /// An instance stands for another one, too: its ports "other.x" are called so, and not "instance.other.x".
  void add_guest(const std::string& other, int instance) { guests_[other] = instance; }

  /// Checks and adds a connection. Throws Error for:
  /// - an unknown instance or port, an index out of range;
  /// - sizes or units that differ;
  /// - an input connected twice without `add`;
  /// - a reconstruction that is missing, that the output's samples can't feed or that a held output does not
  ///   need;
  /// - a lag on mean or matched hold.
  void connect(const Connection& connection);

  /// One end of a connection whose other end is not known here: it is only looked for, and check() takes an
  /// input for connected. Throws Error for an unknown port, and an index out of range.
  void connect_half(std::string_view port, bool output);

  /// The value that an input ("instance.port", or one element) takes at the start, or for ever if it is not
  /// connected. Throws Error for an unknown port, an index out of range, and a value that is not finite.
  void set_start(std::string_view port, double value);

  /// The input ("instance.port", of one number, or one element) is this over the whole run. Throws Error for
  /// an unknown port, an index out of range, a port of several numbers, and an input that is connected or
  /// driven already.
  void drive(std::string_view port, std::shared_ptr<const TimeSeries> series);

  /// A scalar input, neither connected nor driven, that is open: `start` is what it is until the run is told more
  /// (Coordinator::open_input).
  void leave_open(int instance, int input, double start);

  /// Throws Error for an input that is neither connected nor driven nor has a start value, and for an
  /// algebraic loop, with its cycle.
  void check() const;

  /// Throws Error for a driven input that is not known over the whole of a run's span.
  void check_span(TimeSpan span) const;

  int size() const { return static_cast<int>(instances_.size()); }
  /// The number of an instance, or of the one that stands for another of this name; none: there is none.
  std::optional<int> instance(std::string_view name) const;
  /// The port of an output, "slow.x1" or "slow.x[2]"; null: there is none. The index is not looked at.
  const Port* output_port(std::string_view output) const;
  const std::string& name(int instance) const { return at(instance).name; }
  std::vector<std::string> names() const;
  const SubsystemInfo& info(int instance) const { return *at(instance).info; }
  const std::vector<Line>& lines() const { return lines_; }
  /// What the source gives at t reaches its reader's outputs at t, where it feeds through: there is no lag,
  /// and a sampled reader takes what it has from others as it was before its instant.
  bool at_once(const Line& line) const;
  /// A line with a memory between sampled subsystems: the value just before the instant of its reader.
  bool just_before(const Line& line) const {
    return line.lag == Lag::memory && info(line.source).abilities.sampled &&
           info(line.reader).abilities.sampled;
  }
  /// By scalar input: its start value, NaN for none.
  const std::vector<double>& start(int instance) const { return at(instance).start; }
  /// What drives a scalar input; null: nothing does.
  const TimeSeries* series(int instance, int input) const {
    return at(instance).driven[static_cast<std::size_t>(input)].get();
  }
  bool is_open(int instance, int input) const {
    return at(instance).open[static_cast<std::size_t>(input)] != 0;
  }
  /// Numbers of the lines that end at a scalar input, by the names of their sources and what is made of them:
  /// they are summed in this order, in whatever order they were connected.
  std::span<const int> lines_to(int instance, int input) const {
    return at(instance).to[static_cast<std::size_t>(input)];
  }
  /// Numbers of the lines that begin at an instance, in the order in which they were connected.
  std::span<const int> lines_from(int instance) const { return at(instance).from; }

  std::string input_name(int instance, int input) const;    ///< "instance.port" or "instance.port[i]"
  std::string output_name(int instance, int output) const;  ///< likewise
  /// Those of each instance one after the other; one by one takes time with the square of their number.
  std::vector<std::string> output_names(int instance) const;
  std::vector<std::string> output_names() const;

 private:
  using Numbers = std::unordered_map<std::string, int>;  ///< of things by their names
  /// Of ports, beside the first scalar of each.
  struct PortIndex {
    Numbers numbers;
    std::vector<int> first;
  };
  struct Instance {
    std::string name;
    const SubsystemInfo* info;
    PortIndex inputs, outputs;
    std::vector<double> start;
    std::vector<char> shared;                               ///< by scalar input: connected with `add`
    std::vector<char> half;                                 ///< by scalar input: by connect_half()
    std::vector<char> open;                                 ///< by scalar input
    std::vector<std::shared_ptr<const TimeSeries>> driven;  ///< by scalar input; null: it is not
    std::vector<std::vector<int>> to;                       ///< by scalar input: its lines
    std::vector<int> from;                                  ///< lines
  };
  /// A port, or one element of it, found by its text.
  struct Place {
    int instance;
    const Port* port;
    int first, count;  ///< flattened
  };
  const Instance& at(int i) const { return instances_[static_cast<std::size_t>(i)]; }
  /// An instance or one that it stands for, and its port.
  struct Named {
    std::optional<int> instance;
    std::string port;
  };
  Named named(std::string_view text, std::size_t dot) const;
  std::string full_name(int instance, const std::string& port) const;
  static PortIndex indexed(const std::vector<Port>& ports);
  Place find(std::string_view text, bool output) const;
  void connect_scalars(Line line, bool add, const Place& from, const Place& to);
  bool is_summed_before(const Line& a, const Line& b) const;
  void refuse_driven(int instance, int input, const std::string& besides) const;
  void check_loops() const;

  std::vector<Instance> instances_;
  Numbers numbers_, guests_;  ///< of instances, by their names, and by those that they stand for
  std::vector<Line> lines_;
};

}  // namespace tandem
