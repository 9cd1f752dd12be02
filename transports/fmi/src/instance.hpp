// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fmu.hpp"
#include "loading.hpp"
#include "tandem/library_file.hpp"

namespace tandem::fmi {

/// The functions of an FMU's library; those that it says it has not are null.
struct Functions {
#define TANDEM_FMI2_POINTER(result, name, arguments) result(*name) arguments = nullptr;
  TANDEM_FMI2_COMMON(TANDEM_FMI2_POINTER)
  TANDEM_FMI2_STATES(TANDEM_FMI2_POINTER)
  TANDEM_FMI2_BYTES(TANDEM_FMI2_POINTER)
  TANDEM_FMI2_MODEL_EXCHANGE(TANDEM_FMI2_POINTER)
  TANDEM_FMI2_CO_SIMULATION(TANDEM_FMI2_POINTER)
  TANDEM_FMI2_INPUT_DERIVATIVES(TANDEM_FMI2_POINTER)
#undef TANDEM_FMI2_POINTER
};

/// A loaded FMU that runs: unpacked, its library loaded, one instance of it. All calls stand in within().
class Instance {
 public:
  Instance(Fmu fmu, Tell tell);
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  const Fmu& fmu() const { return fmu_; }
  const Log& log() const { return log_; }

  /// Whether nothing has been told of this variable yet; it has been from now on.
  bool tells_first_of(int variable) { return told_of_.insert(variable).second; }

  /// Makes calls of the library, whose faults and exits are told (LibraryCall).
  template <class Calls>
  auto within(const Calls& calls) const {
    return LibraryCall(name_.c_str()).make(calls);
  }
  /// call(&Functions::DoStep, "fmi2DoStep", t, h, fmi2True): throws Error(numerical) with the FMU's own
  /// message for any status but OK and warning.
  template <class Function, class... Arguments>
  void call(Function Functions::*function, const char* name, Arguments... arguments) {
    check(name, (functions_.*function)(component_, arguments...));
  }
  /// The same for who has a use for the status.
  template <class Function, class... Arguments>
  fmi2Status ask(Function Functions::*function, Arguments... arguments) const {
    return (functions_.*function)(component_, arguments...);
  }
  void check(const char* name, fmi2Status status);

  /// Puts it back to before the start and into initialization mode, with the values of the settings.
  void begin(double t_start, std::optional<double> t_stop);
  void end_initialization();

 private:
  void find_functions();
  template <class Function>
  void find(Function*& function, const char* name);
  void instantiate();
  void free() noexcept;
  void set_values();

  Fmu fmu_;
  std::string name_;
  Log log_;
  TemporaryFolder folder_;
  std::string resources_;
  std::unique_ptr<LoadedLibrary> library_;
  Functions functions_;
  fmi2CallbackFunctions callbacks_;
  fmi2Component component_ = nullptr;
  std::set<int> told_of_;
  bool fresh_ = false;    ///< just instantiated
  bool running_ = false;  ///< initialized and not failed
  bool fatal_ = false;    ///< it may not be called any more
};

}  // namespace tandem::fmi
