// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/wire/server.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "tandem/error.hpp"
#include "tandem/printable.hpp"

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
  while (!stop() && !(settings_.once && greeted_)) {
    clear_away(false);
    try {
      if (auto channel = listener_.accept(in_seconds(0.1))) {
        take(std::move(channel));
        shortage_.clear();
      }
    } catch (const std::exception& error) {
      wait_out(error);
    }
    if (settings_.once) wait_for_guest(stop);
  }
  end_sessions();
}

/// Those that wait for a request end at once, those that compute as soon as they are done.
void Server::end_sessions() {
  for (Guest& guest : guests_) guest.channel->close();
  const Deadline deadline = in_seconds(settings_.session.deadline);
  const auto computing = [this] {
    return static_cast<int>(
        std::count_if(guests_.begin(), guests_.end(), [](const Guest& guest) { return !guest.ended; }));
  };
  while (computing() > 0 && std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  if (const int left = computing(); left > 0 && settings_.overdue) settings_.overdue(left);
  clear_away(true);
}

/// The next one is let in when the one who is in has ended.
void Server::wait_for_guest(const std::function<bool()>& stop) {
  while (!stop() && !guests_.empty()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    clear_away(false);
  }
}

/// There is no descriptor or memory for another connection, which waits. Told once, and tried again at
/// leisure.
void Server::wait_out(const std::exception& error) noexcept {
  try {
    const std::string why = sentence_of(error);
    if (shortage_ != why) log("further connections wait: " + why);
    shortage_ = why;
  } catch (const std::exception&) {  // no memory for the sentence
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
}

void Server::take(std::unique_ptr<Channel> channel) {
  clear_away(false);  // one may have ended while this one was awaited
  if (static_cast<int>(guests_.size()) >= settings_.most_sessions)
    return turn_away(*channel, "has " + std::to_string(settings_.most_sessions) +
                                   " sessions open, the most that it allows");
  guests_.emplace_back(std::move(channel));
  Guest& guest = guests_.back();
  try {
    guest.thread = std::thread([this, &guest] { serve(guest); });
  } catch (const std::exception& error) {
    turn_away(*guest.channel, "can make no thread: " + sentence_of(error));
    guests_.pop_back();
  }
}

/// Its request is not awaited: whoever connects and says nothing costs nothing.
void Server::turn_away(Channel& channel, const std::string& why) {
  try {
    log(channel.peer() + ": turned away, as the server " + why);
    Writer frame;
    begin(frame, Type::error, 1);
    put_error(frame, ErrorCode::not_supported, "the server " + why + "; try again later");
    finish(frame);
    channel.send(frame.bytes(), in_seconds(0.1));
  } catch (const std::exception&) {  // gone already, or no memory for the sentence
  }
}

void Server::hold_session(Channel& channel) {
  Session session(channel, make_, settings_.session);
  const struct Note {  // however it ends
    const Session& session;
    std::atomic<bool>& greeted;
    ~Note() { greeted = greeted || session.greeted(); }
  } note{session, greeted_};
  session.serve();
}

void Server::serve(Guest& guest) noexcept {
  try {
    log(guest.channel->peer() + ": session begins");
    hold_session(*guest.channel);
    log(guest.channel->peer() + ": session ends");
  } catch (const std::exception& error) {
    log_end(guest, error);
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

/// What a peer has sent may be in it.
void Server::log(const std::string& sentence) const {
  if (settings_.log) settings_.log(printable(sentence));
}

void Server::log_end(const Guest& guest, const std::exception& why) const noexcept {
  try {
    log(guest.channel->peer() + ": session ends: " + sentence_of(why));
  } catch (const std::exception&) {  // no memory for the sentence; the session ends all the same
  }
}

}  // namespace tandem::wire
