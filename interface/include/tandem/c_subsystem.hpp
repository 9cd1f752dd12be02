// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <string>
#include <vector>

#include "tandem/subsystem.h"
#include "tandem/subsystem.hpp"

namespace tandem {

/// A subsystem behind the C table of subsystem.h. A status other than TANDEM_OK is thrown as Error with the
/// same code and the subsystem's own sentence; an exception that a library lets pass is Error(internal).
class CSubsystem : public Subsystem {
 public:
  /// A new instance of what `api` makes from `parameters` ("key=value&key=value"). `api` must outlive it.
  /// Throws Error for another ABI version, a table too small, a missing function, or ports that make no
  /// sense. Where the kind declares parameters, it throws NotMade for what is not among them, and for all
  /// that keeps an instance from being made.
  /// - library: how errors call where it comes from, "library 'FILE'"; empty: this program.
  CSubsystem(const tandem_subsystem_api* api, const std::string& parameters, std::string library = "");
  ~CSubsystem() override;
  CSubsystem(const CSubsystem&) = delete;
  CSubsystem& operator=(const CSubsystem&) = delete;

  const SubsystemInfo& info() const override { return info_; }
  Clock initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) override;
  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override;
  Clock sample(double t, SamplePart part, std::span<const double> u, std::span<double> y) override;
  StateId save_state() override;
  Clock restore_state(StateId id) override;
  void release_state(StateId id) override;
  std::vector<std::byte> serialize_state(StateId id) override;
  StateId deserialize_state(std::span<const std::byte> bytes) override;

 private:
  template <class Call>
  auto guarded(const char* call, const Call& make) const;
  void destroy() noexcept;
  std::string who() const;
  void check(tandem_status status, const char* call) const;
  DeclaredParameters ask_parameters() const;
  void make(const std::string& parameters);
  void ask_info();
  void check_functions() const;
  [[noreturn]] void refuse_functions(const char* what) const;
  void require_saving() const;
  void require_serializing() const;
  template <class Call>
  void fill(Samples& y, const char* name, const Call& make);
  std::span<double> newest_row(const tandem_samples& rows) const;
  [[noreturn]] void refuse_rewriting(double t) const;
  [[noreturn]] void refuse_rows(const tandem_samples& before, const tandem_samples& after) const;
  Clock clock_from(const tandem_clock& clock) const;

  tandem_subsystem_api api_;  ///< functions that the table does not reach to are null
  std::string library_;
  void* self_ = nullptr;
  SubsystemInfo info_;
  std::vector<double> newest_row_;  ///< as it was before a call
};

}  // namespace tandem
