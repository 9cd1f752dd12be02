// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "answers.hpp"
#include "fmu.hpp"
#include "functions.hpp"
#include "loading.hpp"
#include "only_once.hpp"
#include "tandem/error.hpp"
#include "tandem/fixed_step.hpp"
#include "tandem/library_file.hpp"
#include "tandem/transports/temporary_folder.hpp"

namespace tandem::fmi {

/// A loaded FMU that runs: unpacked, its library loaded, one instance of it. Calls of its functions stand in
/// within(). One that answers with more than a warning is Error(numerical) with the FMU's own message.
/// The header is long, as it has a line for each function of FMI.
class Instance {
 public:
  /// Of its version.
  static std::shared_ptr<Instance> make(Fmu fmu, Tell tell);
  virtual ~Instance() = default;
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  const Fmu& fmu() const { return fmu_; }
  Log& log() { return log_; }
  /// Whether nothing has been told of this variable yet; it has been from now on.
  bool tells_first_of(int variable) { return told_of_.insert(variable).second; }

  /// Makes calls of the library, whose faults and exits are told (LibraryCall).
  template <class Calls>
  auto within(const Calls& calls) const {
    return LibraryCall(name_.c_str()).make(calls);
  }

  /// Puts it back to before the start and into initialization mode, with the values of the settings.
  void begin(double t_start, std::optional<double> t_stop);
  void end_initialization();

  using References = std::span<const std::uint32_t>;
  /// Of variables of one type: their scalars, one variable after the other. Other types than text and binary.
  virtual void get(Type type, References of, std::span<double> values) = 0;
  /// The values are of the type already.
  virtual void set(Type type, References of, std::span<const double> values) = 0;

  /// States that the FMU keeps until they are released.
  void* state();
  void put_back(void* state) { call(functions_.set_state, state); }
  /// made: which of the instances that were made gave it; one that is freed has freed it.
  void release(void* state, int made) noexcept;
  int made() const { return made_; }
  std::vector<std::byte> bytes(void* state);
  void* state_from(std::span<const std::byte> bytes);

  void enter_events() { call(functions_.enter_events); }
  virtual Updated update() = 0;

  // Model Exchange.
  void enter_continuous_time() { call(functions_.enter_continuous_time); }
  virtual Completed complete_step(bool never_back) = 0;
  void set_time(double t) { call(functions_.set_time, t); }
  void set_states(std::span<const double> x) { call(functions_.set_states, x.data(), x.size()); }
  void get_states(std::span<double> x) { call(functions_.get_states, x.data(), x.size()); }
  void get_rates(double* dx, std::size_t size) { call(functions_.get_rates, dx, size); }
  void get_indicators(std::span<double> z) { call(functions_.get_indicators, z.data(), z.size()); }

  /// Directional derivatives: of the unknowns' scalars, along `seed` of the knowns' scalars. Real ones.
  virtual void derive(References unknowns, References knowns, std::span<const double> seed,
                      std::span<double> found) = 0;

  // Co-Simulation.
  /// Of 2.0: derivatives of inputs at the begin of the next step.
  virtual void set_input_derivatives(References of, std::span<const int> orders,
                                     std::span<const double> values) = 0;
  /// First time derivatives of outputs: their scalars, one output after the other.
  virtual void get_output_derivatives(References of, std::span<const int> orders,
                                      std::span<double> values) = 0;
  /// Of 3.0: out of event mode.
  virtual void enter_steps() = 0;
  /// One step, as far as the FMU goes. Error(numerical) for one that it says it has taken, and has not.
  virtual Taken do_step(const OwnStep& s, bool never_back, InputsWithin& inputs) = 0;

 protected:
  Instance(Fmu fmu, Tell tell);
  /// Out of the constructor of a version: finds the functions, makes an instance.
  void open();
  /// Out of its destructor.
  void close() noexcept;

  template <class Signature>
  void find(Function<Signature>& function, const std::string& name);
  template <class Signature, class... Arguments>
  void call(const Function<Signature>& function, Arguments... arguments) {
    if (!failed_.empty()) throw Error(ErrorCode::numerical, failed_);  // nothing else may be called then
    check(function.name, function.call(component_, arguments...));
  }
  void check(const std::string& name, int status) {
    if (!is_good(status)) fail(name, static_cast<Status>(status));
  }
  [[noreturn]] void fail(const std::string& name, Status status);
  /// `own`: the FMU's time after a step that it says it has taken. A step too much or too little after a hundred that were
  /// right is the rounding of its own sums, and is told once.
  void check_time(const OwnStep& s, double own);

  bool exchanges() const { return fmu_.settings.kind == Kind::model_exchange; }
  const Offer& offer() const { return offer_of(fmu_.description, fmu_.settings.kind); }
  void* component() const { return component_; }
  const std::string& resources() const { return resources_; }
  /// "fmi2", "fmi3", and what the library's version begins with.
  virtual const char* prefix() const = 0;
  virtual const char* version() const = 0;
  virtual void find_functions() = 0;
  virtual void* instantiate() = 0;
  virtual void set_up(double t_start, std::optional<double> t_stop) = 0;
  virtual void set_text(std::uint32_t reference, const std::string& text) = 0;
  virtual void enter_initialization() = 0;

 private:
  void find_common();
  void check_version() const;
  void make_instance();
  void free() noexcept;
  void set_values();

  Fmu fmu_;
  OnlyOnce only_;
  std::string name_;
  Log log_;
  TemporaryFolder folder_;
  std::string resources_;
  std::unique_ptr<LoadedLibrary> library_;
  Functions functions_;
  void* component_ = nullptr;
  std::set<int> told_of_;
  std::int64_t right_steps_ = 0;
  bool told_of_time_ = false;
  std::string failed_;    ///< why it may not be called until it is begun anew
  int made_ = 0;          ///< instances before this one
  bool fresh_ = false;    ///< just instantiated
  bool running_ = false;  ///< initialized and not failed
  bool fatal_ = false;    ///< it may not be called any more
};

template <class Signature>
void Instance::find(Function<Signature>& function, const std::string& name) {
  function.name = prefix() + name;
  const auto& library = library_->get();
  if (!library.has(function.name))
    throw Error(ErrorCode::invalid_argument, name_ + ": its library has no function '" + function.name + "'");
  function.call = &library.get<Signature>(function.name);
  check_function(reinterpret_cast<const void*>(function.call), name_, function.name);
}

std::shared_ptr<Instance> make_instance_of_2(Fmu fmu, Tell tell);
std::shared_ptr<Instance> make_instance_of_3(Fmu fmu, Tell tell);

}  // namespace tandem::fmi
