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

/// What runs inside an exported FMU: its source behind variables by number, as FMI wants it. Any call may
/// throw Error. A parameter may be set until the start is made; the source is opened with those that were set
/// when a value is wanted first, and started with the inputs as they are.
class Unit {
 public:
  using Tell = std::function<void(const std::string&)>;
  virtual ~Unit() = default;
  Unit(const Unit&) = delete;
  Unit& operator=(const Unit&) = delete;

  const Manifest& manifest() const { return manifest_; }
  const SubsystemInfo& info() const { return info_; }
  const std::vector<Variable>& variables() const { return variables_; }
  /// Throws for a number that is no variable's.
  const Variable& variable(std::size_t reference) const;

  /// That a word may be by a list of its file; empty for any other variable.
  std::vector<std::string> allowed_words(std::size_t reference) const;

  /// Before the start is made. stop: infinite if it is not known.
  void set_span(double start, double stop = std::numeric_limits<double>::infinity());

  /// Of a number: an input at any time, a parameter until the start is made.
  void set(std::size_t reference, double value);
  void set(std::size_t reference, const std::string& word);
  void set(std::size_t reference, bool flag);

  double number(std::size_t reference);
  std::string word(std::size_t reference) const;
  bool flag(std::size_t reference) const;

  /// The start is made: parameters stay as they are from now on.
  void begin();
  double time() const { return time_; }  ///< [s]
  /// The first own step, or the period of a sampled source [s].
  virtual double own_step() = 0;
  /// As it was when it was made.
  void reset();

  /// All that it goes by, parameters included, if keeps_state().
  virtual bool keeps_state() const = 0;
  std::vector<std::byte> state();
  /// Of any unit of the same FMU.
  void restore(std::span<const std::byte> bytes);

 protected:
  /// Opens the source once to know its variables.
  /// - resources: the FMU's folder of that name.
  /// - tell: takes sentences on what leaves the limits of a model.
  Unit(const std::filesystem::path& resources, const Tell& tell);

  /// With all as it is, unless it is so already.
  void start();
  const Variable& of_kind(std::size_t reference, Variable::Kind kind, const char* wanted) const;
  /// The parameters that it was exported with, and those that were set since.
  Parameters given() const;
  std::vector<double> start_values() const;
  std::vector<text::FileParameter> file_parameters() const;

  /// With the parameters as they are, beside subsystem_. Nothing has changed if it throws.
  virtual void open_source() {}
  /// Starts the source, which is opened with the parameters as they are.
  virtual void start_source() = 0;
  /// Once, before the first step.
  virtual void begin_source() {}
  virtual double output(const Variable& v) = 0;
  virtual void input_set(const Variable&) {}
  /// Of what is of use after the start alone.
  void check_begun() const;
  virtual void write_started(ByteWriter& to) = 0;
  /// To the end, where time() and inputs are these. Nothing has changed if it throws.
  virtual void read_started(ByteReader& from, double time, const Inputs& inputs) = 0;

  std::filesystem::path resources_;
  Manifest manifest_;
  std::unique_ptr<Subsystem> subsystem_;  ///< null: to be opened with the parameters as they are
  SubsystemInfo info_;
  std::vector<Variable> variables_;
  Inputs inputs_;
  std::vector<double> at_start_;  ///< the inputs that it was started with
  bool begun_ = false;            ///< parameters stay
  bool inputs_set_ = false;       ///< since the last step
  double start_ = 0.0, stop_ = std::numeric_limits<double>::infinity();
  double time_ = 0.0;  ///< where it stands [s], by the importer's sums

 private:
  void change(const Variable& v, Parameters::Value value);
  std::unique_ptr<Subsystem> opened() const;
  void reopen();
  void check_not_begun(const Variable& v) const;
  void write_changed(ByteWriter& to) const;
  std::map<std::string, Parameters::Value> read_changed(ByteReader& from) const;
  struct Kept {
    std::map<std::string, Parameters::Value> changed;
    double start, stop, time;
    Inputs inputs;
    bool begun = false, inputs_set = false, fresh = false;
    std::vector<double> at_start = {};
  };
  Kept read_kept(ByteReader& from) const;
  void take_up(const Kept& kept);
  void read(ByteReader& from);

  Builtins builtins_;
  std::map<std::string, Parameters::Value> changed_;  ///< parameters
  std::vector<text::FileParameter> parameters_;       ///< with their values as they are
  bool fresh_ = false;                                ///< it is started with all as it is
};

/// A SteppedUnit or an ExchangedUnit, by what its manifest says.
/// - resources: the FMU's folder of that name.
/// - tell: takes sentences on what leaves the limits of a model.
std::unique_ptr<Unit> open_unit(const std::filesystem::path& resources, const Unit::Tell& tell = {});

}  // namespace tandem::exported
