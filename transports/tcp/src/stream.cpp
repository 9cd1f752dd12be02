// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "stream.hpp"

#include <algorithm>

#include "tandem/error.hpp"

namespace tandem::tcp {

/// Forgets the frame that was given out; what came behind it moves to the front.
void StreamChannel::drop_last() {
  std::copy(memory_.get() + last_, memory_.get() + size_, memory_.get());
  size_ -= last_;
  last_ = 0;
}

/// Memory for so many bytes, with those that have come.
void StreamChannel::hold(std::size_t room) {
  auto memory = std::make_unique_for_overwrite<std::byte[]>(room);
  std::copy_n(memory_.get(), size_, memory.get());
  memory_ = std::move(memory);
  room_ = room;
}

/// What a large frame has taken is given back.
void StreamChannel::forget() {
  drop_last();
  if (room_ > usual_room && size_ <= first_room) hold(first_room);
}

/// Bytes of the frame at the front, as far as its header is there.
std::size_t StreamChannel::wanted() const {
  if (size_ < wire::header_size) return wire::header_size;
  return wire::header_size + wire::read_header(came(), wire::usual_longest).length;
}

/// One read. Room is made for what is announced, but the system gives a page of it when something has come.
/// False: nothing by then.
bool StreamChannel::fill(wire::Deadline deadline) {
  if (size_ == room_) hold(std::max(wanted(), size_ + first_room));
  const auto count = stream_->read({memory_.get() + size_, room_ - size_}, deadline);
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
  return came().first(last_);
}

}  // namespace tandem::tcp
