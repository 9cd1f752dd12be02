// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <utility>

#include "socket_stream.hpp"

namespace tandem::tcp {

/// Closes a descriptor that nobody has taken out of it.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) noexcept : number_(number) {}
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  int get() const noexcept { return number_; }
  int release() noexcept { return std::exchange(number_, -1); }

 private:
  int number_;
};

/// A socket of Asio over it, which Asio may not have the memory for. Throws boost::system::system_error.
Socket socket_of(Descriptor descriptor, const boost::asio::generic::stream_protocol& protocol);

/// A new socket that programs which are started don't inherit. Throws Error(input_output).
Socket open_socket(const boost::asio::generic::stream_protocol& protocol);

/// The next connection of a listening socket, which is not inherited either. -1, with errno, if there is
/// none.
Descriptor accept_connection(int listening) noexcept;

}  // namespace tandem::tcp
