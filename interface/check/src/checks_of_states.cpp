// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <exception>
#include <thread>

#include "checks.hpp"
#include "number_text.hpp"
#include "tandem/error.hpp"

namespace tandem::checks {
namespace {

template <class Call>
void require_refusal(ErrorCode code, const std::string& what, const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    require(error.code() == code, what + " was refused with the code " +
                                      std::to_string(static_cast<int>(error.code())) + " (" + error.what() +
                                      "); allowed is " + std::to_string(static_cast<int>(code)));
    return;
  }
  throw Broken(what + " was done; allowed is to refuse it");
}

void refuse_states(Subsystem& s) {
  const std::string what = " without the ability to save states";
  require_refusal(ErrorCode::not_supported, "save_state" + what, [&] { s.save_state(); });
  require_refusal(ErrorCode::not_supported, "restore_state" + what, [&] { s.restore_state(0); });
  require_refusal(ErrorCode::not_supported, "release_state" + what, [&] { s.release_state(0); });
}

void refuse_bytes(Subsystem& s) {
  const std::string what = " without the ability to give states as bytes";
  require_refusal(ErrorCode::not_supported, "serialize_state" + what, [&] { s.serialize_state(0); });
  require_refusal(ErrorCode::not_supported, "deserialize_state" + what, [&] { s.deserialize_state({}); });
}

void refuse_numbers(Subsystem& s) {
  const std::string what = " of one that gives no states as numbers";
  require_refusal(ErrorCode::not_supported, "get_states" + what, [&] { s.get_states({}); });
  require_refusal(ErrorCode::not_supported, "set_states" + what, [&] { s.set_states({}); });
}

void go_on_from_a_state(const Subject& of) {
  Instance it(of);
  Subsystem& s = *it.subsystem;
  if (!it.can().saves_state) return refuse_states(s);
  const bool lands = it.can().lands;
  it.advance(it.ahead(3.5));
  const Clock saved_at = it.clock;
  const std::size_t rows_then = it.rows.size();
  const StateId first = s.save_state();
  const double end = it.ahead(9.37);
  it.advance(end, lands);
  const Rows expected = it.rows;
  const StateId second = s.save_state();
  for (int again = 0; again < 2; ++again) {
    it.clock = s.restore_state(first);
    require(it.clock.time == saved_at.time && it.clock.next_time == saved_at.next_time,
            "the state saved at t = " + number_text(saved_at.time) + " s came back at " +
                number_text(it.clock.time) + " s, next " + number_text(it.clock.next_time) +
                " s; allowed is the same, next " + number_text(saved_at.next_time) + " s");
    it.rows.resize(rows_then);
    it.advance(end, lands);
    require_same(it.rows, expected, "from a state that was saved");
  }
  s.release_state(first);
  require(s.restore_state(second).time == expected.back()[0], "a second saved state was lost with the first");
  s.release_state(second);
}

void give_a_state_as_bytes(const Subject& of) {
  Instance it(of), other(of);
  if (!it.can().serializes_state) return refuse_bytes(*it.subsystem);
  require(it.can().saves_state, "it gives saved states as bytes but does not say that it saves them");
  const bool lands = it.can().lands;
  const double end = it.ahead(17.37);
  it.advance(it.ahead(3.37), lands);
  const StateId id = it.subsystem->save_state();
  const auto bytes = it.subsystem->serialize_state(id);
  it.subsystem->release_state(id);
  const StateId there = other.subsystem->deserialize_state(bytes);
  other.clock = other.subsystem->restore_state(there);
  require(other.clock.time == it.clock.time && other.clock.next_time == it.clock.next_time,
          "from its bytes the state of t = " + number_text(it.clock.time) + " s came to stand at " +
              number_text(other.clock.time) + " s, next " + number_text(other.clock.next_time) +
              " s; allowed is the same, next " + number_text(it.clock.next_time) + " s");
  other.rows = it.rows;
  Instance whole(of);
  whole.advance(whole.ahead(3.37), lands);
  for (Instance* one : {&whole, &it, &other}) one->advance(end, lands);
  require_same(it.rows, whole.rows, "after its state was saved");
  require_same(other.rows, whole.rows, "from the bytes of a state");
}

void refuse_other_bytes(const Subject& of) {
  Instance it(of);
  if (!it.can().serializes_state) throw LeftOut("it does not say that it gives its state as bytes");
  Subsystem& s = *it.subsystem;
  it.advance(it.ahead(3.5));
  const StateId id = s.save_state();
  auto bytes = s.serialize_state(id);
  s.release_state(id);
  const auto code = ErrorCode::invalid_argument;
  require_refusal(code, "serializing a state that was released", [&] { s.serialize_state(id); });
  require_refusal(code, "taking a state of no bytes", [&] { s.deserialize_state({}); });
  bytes.push_back(std::byte{0});
  require_refusal(code, "taking a state with a byte too many", [&] { s.deserialize_state(bytes); });
  require_refusal(code, "taking half a state", [&] {
    s.deserialize_state({bytes.data(), (bytes.size() - 1) / 2});
  });
}

void know_its_states(const Subject& of) {
  Instance it(of);
  if (!it.can().saves_state) throw LeftOut("it does not say that it saves its state");
  Subsystem& s = *it.subsystem;
  const StateId id = s.save_state();
  const auto code = ErrorCode::invalid_argument;
  require_refusal(code, "restoring a state that was never saved", [&] { s.restore_state(id + 1); });
  s.release_state(id);
  require_refusal(code, "restoring a state that was released", [&] { s.restore_state(id); });
  require_refusal(code, "releasing a state that was released", [&] { s.release_state(id); });
}

/// Of what it is compared with: a mechanism also goes by accelerations, which its step before has left.
constexpr double like = 1e-6;

void require_like(double found, double expected, double size, const std::string& what) {
  require(std::abs(found - expected) <= like * size, what + " is " + number_text(found) + "; allowed is " +
                                                         number_text(expected) + " to 1e-6 of " +
                                                         number_text(size));
}

/// The newest rows.
void require_like(const Rows& found, const Rows& all) {
  const std::size_t first = all.size() - std::min(all.size(), found.size());
  for (std::size_t k = 0; k < all.front().size(); ++k) {
    double size = 0.0;
    for (const auto& row : all) size = std::max(size, std::abs(row[k]));
    for (std::size_t row = 0; row < found.size() && first > 0; ++row)
      require_like(found[row][k], all[first + row][k], size,
                   "from its states as numbers, column " + std::to_string(k) +
                       " at t = " + number_text(all[first + row][0]) + " s");
  }
}

/// Another instance that is started there and put at its states goes on as it does.
void give_its_states(const Subject& of) {
  Instance it(of), other(of);
  const auto names = it.subsystem->states();
  if (!names) return refuse_numbers(*it.subsystem);
  it.advance(it.ahead(1.5));
  std::vector<double> x(names->size()), again(x.size());
  it.subsystem->get_states(x);
  other.initialize_at(it.clock.time);
  other.subsystem->set_states(x);
  other.subsystem->get_states(again);
  for (std::size_t k = 0; k < x.size(); ++k)
    require_like(again[k], x[k], std::abs(x[k]),
                 "its state '" + (*names)[k].name + "', put and taken again,");
  const double end = it.ahead(5.5);
  it.advance(end), other.advance(end);
  other.rows.erase(other.rows.begin());
  require_like(other.rows, it.rows);
}

void be_independent(const Subject& of) {
  Instance it(of), other(of);
  const double end = it.ahead(12.5);
  for (int step = 0; it.clock.next_time < end && step < 100; ++step) {
    it.advance(it.clock.next_time);
    other.advance(other.clock.next_time);
  }
  require_same(it.rows, in_one_call(of, end), "beside another instance");
  require_same(other.rows, it.rows, "of two instances in turns");
}

/// Each in a thread of its own.
void work_at_once(const Subject& of) {
  Instance it(of), other(of);
  if (it.subsystem->one_thread()) throw LeftOut("all its calls have to come from one thread");
  const double end = it.ahead(100.5);
  std::exception_ptr error;
  std::thread another([&] {
    try {
      other.go_to(end);
    } catch (...) {
      error = std::current_exception();
    }
  });
  try {
    it.go_to(end);
  } catch (...) {
    another.join();
    throw;
  }
  another.join();
  if (error) std::rethrow_exception(error);
  const Rows expected = in_one_call(of, end);
  require_same(it.rows, expected, "while another instance was at work in another thread");
  require_same(other.rows, expected, "in another thread");
}

}  // namespace

const std::vector<Check> states = {
    {"a restored state goes on with the same bits", go_on_from_a_state},
    {"a state that is released or was never saved is refused", know_its_states},
    {"a state goes as bytes to another instance and goes on with the same bits", give_a_state_as_bytes},
    {"bytes that are no state are refused", refuse_other_bytes},
    {"from its states as numbers another instance goes on alike", give_its_states},
    {"instances are independent", be_independent},
    {"two instances may be at work at once", work_at_once}};

}  // namespace tandem::checks
