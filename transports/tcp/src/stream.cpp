// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "stream.hpp"

#include <algorithm>

#include "tandem/error.hpp"

namespace tandem::tcp {

/// Forgets the frame that was given out; what came behind it moves to the front.
void StreamChannel::drop_last() {
  std::copy(memory_.begin() + static_cast<std::ptrdiff_t>(last_),
            memory_.begin() + static_cast<std::ptrdiff_t>(size_), memory_.begin());
  size_ -= last_;
  last_ = 0;
}

/// Bytes of the frame at the front, as far as its header is there.
std::size_t StreamChannel::wanted() const {
  if (size_ < wire::header_size) return wire::header_size;
  return wire::header_size + wire::read_header(memory_, wire::usual_longest).length;
}

/// One read. Memory grows with what has come, never with what is announced. False: nothing by then.
bool StreamChannel::fill(wire::Deadline deadline) {
  if (size_ == memory_.size()) memory_.resize(2 * memory_.size());
  const auto count = stream_->read(std::span(memory_).subspan(size_), deadline);
  if (!count) return false;
  size_ += *count;
  ended_ = *count == 0;
  return true;
}

bool StreamChannel::wait(wire::Deadline deadline) {
  drop_last();
  return size_ > 0 || ended_ || fill(deadline);
}

std::span<const std::byte> StreamChannel::receive(wire::Deadline deadline) {
  drop_last();
  for (std::size_t size; size_ < (size = wanted());) {
    if (ended_ && size_ == 0) return {};
    if (ended_)
      throw Error(ErrorCode::input_output, "the peer closed the connection after " + std::to_string(size_) +
                                               " bytes of a frame of " + std::to_string(size) + " or more");
    if (!fill(deadline))
      throw Error(ErrorCode::input_output, size_ == 0 ? "no reply came within the deadline"
                                                      : "only " + std::to_string(size_) +
                                                            " bytes of a frame came within the deadline");
  }
  last_ = wanted();
  return std::span(memory_).first(last_);
}

}  // namespace tandem::tcp
