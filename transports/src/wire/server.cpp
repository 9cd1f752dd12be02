// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/wire/server.hpp"

#include <atomic>
#include <thread>

#include "tandem/error.hpp"

namespace tandem::wire {

/// One session under way.
struct Server::Guest {
  std::unique_ptr<Channel> channel;
  std::atomic<bool> ended = false;
  std::thread thread = {};
};

Server::Server(Listener& listener, MakeSubsystem make, ServerSettings settings)
    : listener_(listener), make_(std::move(make)), settings_(std::move(settings)) {}

Server::~Server() { clear_away(true); }

void Server::run(const std::function<bool()>& stop) {
  while (!stop()) {
    std::unique_ptr<Channel> channel;
    try {
      channel = listener_.accept(in_seconds(0.1));
    } catch (const Error& error) {  // of that one connection
      log(error.what());
    }
    clear_away(false);
    if (channel) take(std::move(channel));
    if (settings_.once && !guests_.empty()) {
      while (!stop() && !guests_.empty()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        clear_away(false);
      }
      break;
    }
  }
  clear_away(true);
}

void Server::take(std::unique_ptr<Channel> channel) {
  if (static_cast<int>(guests_.size()) >= settings_.most_sessions) return turn_away(*channel);
  Guest& guest = guests_.emplace_back(std::move(channel));
  log(guest.channel->peer() + ": session begins");
  guest.thread = std::thread([this, &guest] { serve(guest); });
}

/// Its request is not awaited: whoever connects and says nothing costs nothing.
void Server::turn_away(Channel& channel) {
  log(channel.peer() + ": turned away, " + std::to_string(settings_.most_sessions) + " sessions are open");
  try {
    Writer frame;
    begin(frame, Type::error, 1);
    put_error(frame, ErrorCode::not_supported,
              "the server has " + std::to_string(settings_.most_sessions) +
                  " sessions open, the most that it allows; try again later");
    finish(frame);
    channel.send(frame.bytes(), in_seconds(0.1));
  } catch (const Error&) {  // gone already
  }
}

void Server::serve(Guest& guest) {
  try {
    Session(*guest.channel, make_, settings_.session).serve();
    log(guest.channel->peer() + ": session ends");
  } catch (const std::exception& error) {
    log(guest.channel->peer() + ": session ends: " + error.what());
  }
  guest.channel->close();
  guest.ended = true;
}

/// Sessions that have ended; or all of them, which are closed first.
void Server::clear_away(bool all) {
  for (auto guest = guests_.begin(); guest != guests_.end();) {
    if (!all && !guest->ended) {
      ++guest;
      continue;
    }
    guest->channel->close();
    guest->thread.join();
    guest = guests_.erase(guest);
  }
}

void Server::log(const std::string& sentence) const {
  if (settings_.log) settings_.log(sentence);
}

}  // namespace tandem::wire
