// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "derived_outputs.hpp"
#include "group.hpp"
#include "kept_state.hpp"
#include "tandem/bytes.hpp"
#include "tandem/error.hpp"

namespace tandem::fmi {

/// values[place] of each becomes that of its signal at t. Whether some differ from before.
bool take(const std::vector<Seat>& seats, std::span<const Signal> u, double t, std::vector<double>& values);
/// By scalar u0 or, where it is not known, what the port says.
void put_start(const std::vector<Port>& inputs, std::span<const double> u0, std::vector<double>& values);

/// An FMU that is run, in either way: its ports, its start, its states. A copy is a state that is kept: it
/// shares the instance.
class Running {
 public:
  explicit Running(std::shared_ptr<Instance> instance);
  Running(const Running& other);
  Running& operator=(const Running& other);
  Running(Running&&) = default;
  Running& operator=(Running&&) = default;
  ~Running() = default;

  const Fmu& fmu() const { return instance().fmu(); }
  const SubsystemInfo& info() const { return fmu().ports.info; }
  Instance& instance() const { return *machine_->instance; }
  double own_step() const { return fmu().settings.step; }
  bool keeps_state() const { return info().abilities.saves_state; }

  /// Until the FMU is initialized, with what is known of the inputs. What follows one that is not known is
  /// NaN in outputs until inputs are set.
  void initialize(double t, std::optional<double> t_stop, std::span<const double> u0);
  /// Goes on with the state that is kept, if one is.
  void resume();
  /// values: of all inputs.
  void set_continuous(const double* values, double t) { machine_->continuous.set(instance(), values, t); }
  void set_discrete(const double* values, double t) { machine_->discrete.set(instance(), values, t); }
  void set_followed(const double* values, double t) { machine_->followed.set(instance(), values, t); }
  void set_asked(const double* values, double t) { machine_->asked.set(instance(), values, t); }
  bool has_followed() const { return !machine_->followed.empty(); }
  void know_inputs() { hidden_ = false; }
  /// In event mode: until its discrete states have settled, or it has ended. Error(numerical) after 100
  /// rounds.
  Updated settle(double t);
  void read_row(double* y) const;
  /// Whether the FMU gives the derivatives that it is to give: DerivedOutputs::try_each().
  void try_derivatives() { machine_->derived.try_each(instance()); }

  /// Of a state that is kept.
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  struct Machine {
    explicit Machine(std::shared_ptr<Instance> of);
    std::shared_ptr<Instance> instance;
    Group continuous, discrete, followed, asked, row;
    DerivedOutputs derived;
    std::vector<char> is_known;  ///< by input, at the start
  };
  void set_known(std::span<const double> u0, double t);

  std::shared_ptr<Machine> machine_;
  KeptState kept_;
  bool hidden_ = false;  ///< some of the row follow inputs that are not known
};

}  // namespace tandem::fmi
