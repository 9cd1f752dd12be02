// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tandem/exported/inputs.hpp"
#include "tandem/exported/manifest.hpp"
#include "tandem/exported/variables.hpp"
#include "tandem/subsystem.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::exported {

/// What runs inside an exported FMU: its source as a subsystem, behind variables by number, as FMI wants it.
/// Any call may throw Error. A parameter may be set until the first step; the source is opened with those that
/// were set when a value is wanted first, and started with the inputs as they are.
class Unit {
 public:
  using Tell = std::function<void(const std::string&)>;

  /// Opens the source once to know its variables.
  /// - resources: the FMU's folder of that name.
  /// - tell: takes sentences on what leaves the limits of a model.
  explicit Unit(const std::filesystem::path& resources, const Tell& tell = {});

  const Manifest& manifest() const { return manifest_; }
  const SubsystemInfo& info() const { return info_; }
  const std::vector<Variable>& variables() const { return variables_; }
  /// Throws for a number that is no variable's.
  const Variable& variable(std::size_t reference) const;

  /// That a word may be by a list of its file; empty for any other variable.
  std::vector<std::string> allowed_words(std::size_t reference) const;

  /// Before the first step. stop: infinite if it is not known.
  void set_span(double start, double stop = std::numeric_limits<double>::infinity());

  /// Of a number: an input at any time, a parameter until the first step.
  void set(std::size_t reference, double value);
  void set(std::size_t reference, const std::string& word);
  void set(std::size_t reference, bool flag);
  /// Of an input, for the next step.
  void set_derivative(std::size_t reference, int order, double value);

  /// An output is that of the last step's end. One that follows inputs at once follows those that were set since
  /// then, as by a jump (if it changes by 1e-9 of its magnitude); before the first step each does.
  double number(std::size_t reference);
  std::string word(std::size_t reference) const;
  bool flag(std::size_t reference) const;
  /// Of an output.
  double derivative(std::size_t reference, int order);

  /// The start is made: parameters stay as they are from now on.
  void begin();
  /// From t, where it stands, over `length` [s].
  void step(double t, double length);
  double time() const { return time_; }  ///< [s]
  /// The first own step, or the period of a sampled source [s].
  double own_step();
  /// As it was when it was made.
  void reset();

  /// All that it goes by, parameters included; with the ability serializes_state of info() alone.
  std::vector<std::byte> state();
  /// Of any unit of the same FMU.
  void restore(std::span<const std::byte> bytes);

 private:
  static constexpr std::int64_t most_rows = 64;  ///< of a call
  const Variable& of_kind(std::size_t reference, Variable::Kind kind, const char* wanted) const;
  void change(const Variable& v, Parameters::Value value);
  std::unique_ptr<Subsystem> opened() const;
  void reopen();
  std::vector<double> start_values() const;
  void start();
  void follow_inputs();
  std::vector<text::FileParameter> file_parameters() const;
  void check_not_begun(const Variable& v) const;
  void take(const Samples& y);
  double slack() const;
  void check_step(double t, double length) const;
  void run(double end, std::span<const Signal> u);
  void advance(double limit, bool land, std::span<const Signal> u);
  void run_instants(double end, std::span<const Signal> u);
  void act(double t, SamplePart part, std::span<const Signal> u);
  void write_changed(ByteWriter& to) const;
  std::map<std::string, Parameters::Value> read_changed(ByteReader& from) const;
  void read(ByteReader& from);
  void read_started(ByteReader& from);

  std::filesystem::path resources_;
  Manifest manifest_;
  Builtins builtins_;
  std::map<std::string, Parameters::Value> changed_;  ///< parameters
  std::unique_ptr<Subsystem> subsystem_;              ///< null: to be opened with the parameters as they are
  SubsystemInfo info_;
  std::vector<Variable> variables_;
  Inputs inputs_;
  std::vector<text::FileParameter> parameters_;  ///< with their values as they are
  std::vector<double> at_start_;                 ///< the inputs that it was started with
  bool fresh_ = false;                           ///< it is started with all as it is
  bool begun_ = false;                           ///< parameters stay
  bool inputs_set_ = false;                      ///< since the last step
  double own_step_ = 0.0, start_ = 0.0, stop_ = std::numeric_limits<double>::infinity();
  /// Where it stands [s], by the importer's sums and by its own nodes. Both go on by the same lengths, so that what
  /// is added up wrongly cuts no step.
  double time_ = 0.0, place_ = 0.0;
  Clock clock_{};
  std::vector<double> rows_, row_;  ///< room for a call, the newest
};

}  // namespace tandem::exported
