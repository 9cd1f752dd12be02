// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "tandem/tcp/tcp.hpp"
#include "tandem/wire/messages.hpp"

namespace tandem::test {

/// A server in a thread of its own that gives one session these answers, whatever is asked.
class ByHand {
 public:
  struct Answer {
    wire::Type type;
    std::function<void(wire::Writer&)> put;  ///< the payload
  };

  explicit ByHand(std::vector<Answer> answers)
      : listener_(listen("tcp://127.0.0.1:0", {})),
        thread_([this, all = std::move(answers)] { serve(all); }) {}
  ~ByHand() { thread_.join(); }
  ByHand(const ByHand&) = delete;
  ByHand& operator=(const ByHand&) = delete;

  const std::string& address() const { return listener_->address(); }

 private:
  void serve(const std::vector<Answer>& answers) const {
    try {
      const auto channel = listener_->accept(wire::in_seconds(10.0));
      if (!channel) return;
      for (const Answer& answer : answers) {
        const auto bytes = channel->receive(wire::in_seconds(10.0));
        if (bytes.empty()) return;
        wire::Writer frame;
        wire::begin(frame, answer.type, wire::Frame::read(bytes, wire::usual_longest).header.number);
        answer.put(frame);
        wire::finish(frame);
        channel->send(frame.bytes(), wire::in_seconds(10.0));
      }
      channel->receive(wire::in_seconds(10.0));  // the client's end
    } catch (const Error&) {                     // which may be one in the middle
    }
  }

  std::unique_ptr<wire::Listener> listener_;
  std::thread thread_;
};

/// The first answers of every server. It does not speak of parameters, as a master in C does not.
inline std::vector<ByHand::Answer> opening_answers(const SubsystemInfo& info) {
  constexpr std::uint32_t both = wire::carries_held | wire::carries_nominal;
  return {{wire::Type::hello,
           [](wire::Writer& w) { wire::put_hello(w, {.capabilities = both, .text = "by hand"}); }},
          {wire::Type::info, [info](wire::Writer& w) { wire::put_info(w, info, both); }}};
}

}  // namespace tandem::test
