// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "hand_out.hpp"

#include <chrono>
#include <deque>
#include <map>
#include <thread>

#include "tandem/error.hpp"

namespace tandem::study {
namespace {

constexpr std::chrono::microseconds nap{200};
constexpr unsigned looks_between = 256;  ///< rounds of a run between two looks for a message

void send(Ranks& ranks, int to, const Told& what) { ranks.send(to, Told::to_cbor(what)); }

Told told_in(const Ranks::Message& message) { return Told::from_cbor(message.bytes); }

[[noreturn]] void rethrow(const Told& error) {
  throw Error(static_cast<ErrorCode>(error.at("code").get<int>()), error.at("error").get<std::string>());
}

}  // namespace

/// What the others have on the way is taken in: none of them may be left waiting to be rid of it.
HandOut::~HandOut() {
  try {
    tell_all({{"end", true}});
    for (int ended = 1; ended < ranks_.size();)
      if (const auto message = ranks_.receive())
        ended += told_in(*message).contains("ended") ? 1 : 0;
      else
        std::this_thread::sleep_for(nap);
  } catch (const std::exception&) {  // whoever starts the ranks ends them all when one of them fails
    return;
  }
}

void HandOut::tell_all(const Told& what) {
  for (int to = 1; to < ranks_.size(); ++to) send(ranks_, to, what);
}

void HandOut::each(std::size_t count, unsigned most, const std::function<Told(std::size_t)>& job,
                   const std::function<void(std::size_t, const Told&)>& done,
                   const std::function<bool(std::size_t)>& tick) {
  std::deque<int> idle;
  for (unsigned turn = 0; turn < (most > 1 ? 2 : 1); ++turn)
    for (int rank = 1; rank < ranks_.size() && static_cast<unsigned>(rank) <= most; ++rank)
      idle.push_back(rank);
  std::map<int, std::deque<std::size_t>> busy;  // a rank answers in the order in which it was told
  std::size_t next = 0, finished = 0;
  while (finished < count && tick(finished)) {
    for (; next < count && !idle.empty(); idle.pop_front()) {
      send(ranks_, idle.front(), job(next));
      busy[idle.front()].push_back(next++);
    }
    const auto message = ranks_.receive();
    if (!message) {
      std::this_thread::sleep_for(nap);
      continue;
    }
    const Told answer = told_in(*message);
    if (answer.contains("error")) rethrow(answer);
    done(busy.at(message->from).front(), answer);
    busy.at(message->from).pop_front();
    idle.push_back(message->from);
    ++finished;
  }
  tick(finished);
}

void work_for(Ranks& ranks, const std::function<Told(const Told&, const std::function<bool()>&)>& work,
              const std::function<bool()>& going) {
  std::deque<Told> waiting;
  bool end = false;
  unsigned looks = 0;
  const auto look = [&] {
    while (const auto message = ranks.receive()) {
      waiting.push_back(told_in(*message));
      end = end || waiting.back().contains("end");
    }
  };
  const auto go_on = [&] {
    if (++looks % looks_between == 0) look();
    return !end && going();
  };
  while (!end) {
    look();
    if (waiting.empty() || end) {
      std::this_thread::sleep_for(nap);
      continue;
    }
    const Told job = std::move(waiting.front());
    waiting.pop_front();
    try {
      if (const Told answer = work(job, go_on); !answer.is_null()) send(ranks, 0, answer);
    } catch (const Error& error) {
      if (!end) send(ranks, 0, {{"code", static_cast<int>(error.code())}, {"error", error.what()}});
    }
  }
  send(ranks, 0, {{"ended", true}});
}

}  // namespace tandem::study
