// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/c_subsystem.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "c_info.hpp"
#include "guarded_call.hpp"
#include "number_text.hpp"
#include "tandem/check_info.hpp"
#include "tandem/error.hpp"

namespace tandem {
namespace {

static_assert(std::is_standard_layout_v<Signal>, "spans of signals are handed to C as they are");

void check_table(const tandem_subsystem_api* api) {
  if (!api) throw Error(ErrorCode::invalid_argument, "the subsystem library gave no table of functions");
  if (api->abi_version != TANDEM_ABI_VERSION)
    throw Error(ErrorCode::not_supported, "the subsystem has ABI version " +
                                              std::to_string(api->abi_version) + "; allowed is " +
                                              std::to_string(TANDEM_ABI_VERSION));
  if (api->table_size < TANDEM_SHORTEST_TABLE)
    throw Error(ErrorCode::not_supported, "the subsystem's table of functions has " +
                                              std::to_string(api->table_size) + " bytes; allowed is " +
                                              std::to_string(TANDEM_SHORTEST_TABLE) + " or more");
  if (!api->create || !api->destroy || !api->info || !api->last_error || !api->initialize)
    throw Error(ErrorCode::invalid_argument,
                "the subsystem's table lacks create, destroy, info, last_error or initialize");
}

/// The functions that are there; null for those behind the table's end.
tandem_subsystem_api table_of(const tandem_subsystem_api* api) {
  check_table(api);
  tandem_subsystem_api table{};
  std::memcpy(&table, api, std::min<std::size_t>(api->table_size, sizeof table));
  return table;
}

bool same_memory(const tandem_samples& a, const tandem_samples& b) {
  return a.rows == b.rows && a.stride == b.stride && a.capacity == b.capacity;
}

/// In a loop of its own, as rows are short: memcmp would take longer than the call of a small model.
bool same_bits(std::span<const double> a, std::span<const double> b) {
  std::uint64_t differences = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    differences |= std::bit_cast<std::uint64_t>(a[k]) ^ std::bit_cast<std::uint64_t>(b[k]);
  return differences == 0;
}

bool appended(const tandem_samples& before, const tandem_samples& after) {
  return same_memory(before, after) && after.size >= before.size && after.size <= before.capacity;
}

}  // namespace

CSubsystem::CSubsystem(const tandem_subsystem_api* api, const std::string& parameters, std::string library)
    : api_(table_of(api)), library_(std::move(library)) {
  const DeclaredParameters declared = ask_parameters();
  try {
    if (!declared.empty()) ParameterValues(declared, parameters);
    make(parameters);
    info_.parameters = declared;
  } catch (const Error& error) {
    destroy();
    if (declared.empty()) throw;
    throw NotMade(error, declared);
  } catch (...) {
    destroy();
    throw;
  }
}

/// Of all instances. The entries are looked at before there is one.
DeclaredParameters CSubsystem::ask_parameters() const {
  if (!api_.parameters) return {};
  std::int32_t count = 0;
  const tandem_parameter* const list = guarded("parameters", [&] { return api_.parameters(&count); });
  const auto size = static_cast<std::size_t>(std::max(count, 0));
  if (count < 0 || size > most_parameters || (size > 0 && !list))
    throw Error(ErrorCode::invalid_argument, "the subsystem declares " + std::to_string(count) +
                                                 " parameters" + (list ? "" : " without a list of them") +
                                                 "; allowed are 0 to " + std::to_string(most_parameters));
  return declared_from({list, size});
}

void CSubsystem::make(const std::string& parameters) {
  check(guarded("create", [&] { return api_.create(parameters.c_str(), &self_); }), "create");
  if (!self_)
    throw Error(ErrorCode::invalid_argument,
                "create gave no instance and no error; allowed is one of the two");
  ask_info();
  check_functions();
  newest_row_.resize(static_cast<std::size_t>(info_.row_size()));
}

void CSubsystem::ask_info() {
  const tandem_info* const c = guarded("info", [&] { return api_.info(self_); });
  if (c && c->name) info_.name = c->name;
  const bool holds = c && (c->abilities & TANDEM_HOLDS) != 0;
  if (holds && !api_.held) refuse_functions("has held outputs");
  const double* const nominal =
      api_.nominal ? guarded("nominal", [&] { return api_.nominal(self_); }) : nullptr;
  info_ = info_from(c, holds ? guarded("held", [&] { return api_.held(self_); }) : nullptr, nominal);
  if (info_.abilities.sampled && api_.sampling)
    check(guarded("sampling",
                  [&] { return api_.sampling(self_, &info_.sampling.period, &info_.sampling.latency); }),
          "sampling");
  check_info(info_.name, info_);
}

void CSubsystem::refuse_functions(const char* what) const {
  throw Error(ErrorCode::invalid_argument,
              "subsystem '" + info_.name + "' says that it " + what + ", but has not the functions");
}

void CSubsystem::check_functions() const {
  const bool saves = api_.save_state && api_.restore_state && api_.release_state;
  if (info_.abilities.saves_state && !saves) refuse_functions("saves its state");
  if (info_.abilities.serializes_state && !(saves && api_.serialize_state && api_.deserialize_state))
    refuse_functions("gives its state as bytes");
  if (info_.abilities.sampled && !(api_.sampling && api_.sample)) refuse_functions("is sampled");
  if (!info_.abilities.sampled && !api_.advance)
    throw Error(ErrorCode::invalid_argument, "subsystem '" + info_.name + "' lacks the function advance");
}

CSubsystem::~CSubsystem() { destroy(); }

void CSubsystem::destroy() noexcept {
  const LibraryCall in_library(library_.empty() ? nullptr : library_.c_str());
  if (self_ && !LibraryCall::has_faulted()) api_.destroy(self_);
}

/// How errors call it of which the library is to blame.
std::string CSubsystem::who() const {
  return "subsystem '" + info_.name + "'" + (library_.empty() ? "" : " of " + library_);
}

void CSubsystem::check(tandem_status status, const char* call) const {
  if (status == TANDEM_OK) return;
  const char* sentence = self_ ? guarded("last_error", [&] { return api_.last_error(self_); }) : nullptr;
  const bool known = status >= TANDEM_INVALID_ARGUMENT && status <= TANDEM_INTERNAL;
  const std::string name =
      info_.name.empty() ? "" : "subsystem '" + info_.name + "', ";  // none before info()
  throw Error(known ? static_cast<ErrorCode>(status) : ErrorCode::internal,
              name + call + ": " +
                  (sentence && *sentence ? sentence : "status " + std::to_string(static_cast<int>(status))));
}

Clock CSubsystem::clock_from(const tandem_clock& clock) const {
  if (clock.stop < TANDEM_STOP_LIMIT || clock.stop > TANDEM_STOP_FINISHED)
    throw Error(ErrorCode::invalid_argument, who() + " gives " + std::to_string(clock.stop) +
                                                 " as its reason to stop; allowed are 0 to 3");
  return {clock.time, clock.next_time, static_cast<Stop>(clock.stop)};
}

/// Fills rows of y by a call. Where what it leaves there is not sound, y is as it was before. Of the rows
/// that were there before only the newest is looked at again.
template <class Call>
void CSubsystem::fill(Samples& y, const char* name, const Call& make) {
  const tandem_samples before = y.c_view();
  const std::span<double> newest = newest_row(before);
  for (std::size_t k = 0; k < newest.size(); ++k) newest_row_[k] = newest[k];
  tandem_status status = TANDEM_OK;
  try {
    status = guarded(name, [&] { return make(&y.c_rows()); });
  } catch (const Error&) {
    y.c_rows() = before;
    throw;
  }
  if (!appended(before, y.c_rows())) {
    const tandem_samples after = std::exchange(y.c_rows(), before);
    if (status == TANDEM_OK) refuse_rows(before, after);
  }
  if (!same_bits(newest, newest_row_)) {
    std::copy_n(newest_row_.begin(), newest.size(), newest.begin());
    y.c_rows() = before;
    refuse_rewriting(newest[0]);
  }
  check(status, name);
}

std::span<double> CSubsystem::newest_row(const tandem_samples& rows) const {
  if (rows.size == 0) return {};
  return {rows.rows + (rows.size - 1) * rows.stride, newest_row_.size()};
}

void CSubsystem::refuse_rewriting(double t) const {
  throw Error(ErrorCode::invalid_argument, who() + " rewrote the row that it had given at t = " +
                                               number_text(t) + " s; allowed is to append");
}

void CSubsystem::refuse_rows(const tandem_samples& before, const tandem_samples& after) const {
  const bool only_size = same_memory(before, after);
  throw Error(ErrorCode::invalid_argument,
              who() + " " +
                  (only_size ? "says that " + std::to_string(after.size) + " sample rows are filled"
                             : "changed where the samples are, their stride or capacity") +
                  "; allowed " + (only_size ? "are " : "is a size of ") + std::to_string(before.size) +
                  " to " + std::to_string(before.capacity));
}

Clock CSubsystem::initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) {
  tandem_clock clock{};
  fill(y, "initialize", [&](tandem_samples* rows) {
    return api_.initialize(self_, t_start, t_stop, u0.data(), rows, &clock);
  });
  return clock_from(clock);
}

Clock CSubsystem::advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) {
  if (!api_.advance) throw Error(ErrorCode::not_supported, who() + " is sampled and has no function advance");
  tandem_clock clock{};
  const auto* signals = reinterpret_cast<const tandem_signal*>(u.data());  // same layout: see signal.hpp
  fill(y, "advance", [&](tandem_samples* rows) {
    return api_.advance(self_, t_limit, land ? 1 : 0, signals, rows, &clock);
  });
  return clock_from(clock);
}

Clock CSubsystem::sample(double t, SamplePart part, std::span<const double> u, std::span<double> y) {
  if (!info_.abilities.sampled) return Subsystem::sample(t, part, u, y);
  tandem_clock clock{};
  check(guarded("sample",
                [&] { return api_.sample(self_, t, static_cast<int>(part), u.data(), y.data(), &clock); }),
        "sample");
  return clock_from(clock);
}

}  // namespace tandem
