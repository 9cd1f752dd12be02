// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "two_mass/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <mutex>
#include <thread>

#include "tandem/error.hpp"

namespace tandem::two_mass {
namespace {

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : std::string();
}

[[noreturn]] void cannot_write(const std::filesystem::path& file) {
  throw Error(ErrorCode::input_output, "file '" + file.string() + "' can't be written");
}

}  // namespace

std::string SweepTable::header() {
  return "schedule,to_fast,to_slow,frequency_ratio,position_error,energy_error,exchange_energy_error,"
         "amplitude_error,"
         "phase_error,exchanges,evaluations,status,note";
}

std::string SweepTable::key(const Case& c) {
  return fmt::format("{},{},{},{}", c.scheme.schedule, c.scheme.to_fast, c.scheme.to_slow, c.frequency_ratio);
}

std::string SweepTable::row(const Case& c, const Outcome& o) {
  const Figures& f = o.figures;
  return fmt::format("{},{},{},{},{},{},{},{},{},{}", key(c), cell(f.position_error), cell(f.energy_error),
                     cell(f.exchange_energy_error), cell(f.amplitude_error), cell(f.phase_error), o.exchanges,
                     o.evaluations, f.failed ? "failed" : "ok", f.note);
}

SweepTable SweepTable::read(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  if (!in || !std::getline(in, line) || line != header())
    throw Error(ErrorCode::input_output, "file '" + file.string() + "', line 1: not the header of a sweep");
  SweepTable table;
  for (int number = 2; std::getline(in, line); ++number) {
    if (std::count(line.begin(), line.end(), ',') != 12)
      throw Error(ErrorCode::input_output,
                  fmt::format("file '{}', line {}: not a row of 13 cells", file.string(), number));
    std::size_t end = 0;
    for (int comma = 0; comma < 4; ++comma) end = line.find(',', end) + 1;
    table.rows_[line.substr(0, end - 1)] = line;
  }
  return table;
}

void SweepTable::write(const std::filesystem::path& file, const std::vector<Case>& cases) const {
  std::filesystem::path part = file;
  part += ".part";
  std::ofstream out(part);
  out << header() << '\n';
  for (const Case& c : cases)
    if (const auto it = rows_.find(key(c)); it != rows_.end()) out << it->second << '\n';
  out.close();
  std::error_code failed;
  if (out) std::filesystem::rename(part, file, failed);
  if (!out || failed) cannot_write(file);
}

std::map<std::string, double> run_sweep(const std::vector<Case>& cases, unsigned threads, SweepTable& table,
                                        const std::function<bool(std::size_t)>& tick) {
  std::vector<const Case*> open;
  for (const Case& c : cases)
    if (!table.has(c)) open.push_back(&c);
  std::map<std::string, double> seconds;
  std::atomic<std::size_t> next{0}, done{cases.size() - open.size()};
  std::atomic<bool> stop{false};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    for (std::size_t i; !stop && (i = next++) < open.size();) try {
        const auto started = std::chrono::steady_clock::now();
        const Outcome outcome = run_case(*open[i]);
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - started;
        const std::lock_guard lock(mutex);
        table.set(*open[i], outcome);
        seconds[SweepTable::key(*open[i])] = spent.count();
        ++done;
      } catch (...) {
        const std::lock_guard lock(mutex);
        failure = std::current_exception();
        stop = true;
      }
  };
  std::vector<std::thread> pool;
  for (unsigned t = 0; t < threads; ++t) pool.emplace_back(work);
  while (!stop && done < cases.size()) {
    if (!tick(done)) stop = true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  for (std::thread& t : pool) t.join();
  if (failure) std::rethrow_exception(failure);
  tick(done);
  return seconds;
}

}  // namespace tandem::two_mass
