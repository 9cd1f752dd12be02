// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/bytes.hpp"

#include "tandem/error.hpp"

namespace tandem {

std::uint64_t checksum(std::span<const std::byte> bytes, std::uint64_t before) {
  std::uint64_t sum = before;
  for (const std::byte byte : bytes) sum = (sum ^ std::to_integer<std::uint64_t>(byte)) * 0x100000001b3;
  return sum;
}

void ByteWriter::grow(std::size_t capacity) {
  auto memory = std::make_unique_for_overwrite<std::byte[]>(capacity);
  if (size_ > 0) std::memcpy(memory.get(), memory_.get(), size_);
  memory_ = std::move(memory);
  capacity_ = capacity;
}

std::byte* ByteWriter::room(std::size_t place, std::size_t bytes) {
  if (place + bytes > capacity_) grow(place + bytes);
  return memory_.get() + place;
}

void ByteWriter::release_beyond(std::size_t most) {
  if (capacity_ <= most) return;
  memory_.reset();
  size_ = capacity_ = 0;
}

void ByteWriter::put_doubles(std::span<const double> values) {
  if constexpr (std::endian::native == std::endian::little) {
    put_bytes(std::as_bytes(values));
  } else {
    for (const double value : values) put(value);
  }
}

void ByteWriter::put_list(std::span<const double> values) {
  put(static_cast<std::uint32_t>(values.size()));
  put_doubles(values);
}

void ByteWriter::put_text(std::string_view text) {
  put(static_cast<std::uint32_t>(text.size()));
  put_bytes(std::as_bytes(std::span(text)));
}

void ByteWriter::put_bytes(std::span<const std::byte> bytes) {
  if (!bytes.empty()) std::memcpy(more(bytes.size()), bytes.data(), bytes.size());
}

void ByteReader::take_doubles(std::span<double> values) {
  need(values.size_bytes());
  if constexpr (std::endian::native == std::endian::little) {
    if (!values.empty()) std::memcpy(values.data(), all_.data() + place_, values.size_bytes());
    place_ += values.size_bytes();
  } else {
    for (double& value : values) value = take<double>();
  }
}

std::vector<double> ByteReader::take_list() {
  std::vector<double> values(take_count(sizeof(double)));
  take_doubles(values);
  return values;
}

void ByteReader::take_list(std::span<double> values) {
  const std::uint64_t count = take_count(sizeof(double));
  if (count != values.size())
    refuse("has " + std::to_string(count) + " numbers in a list; allowed are " +
           std::to_string(values.size()));
  take_doubles(values);
}

std::span<const std::byte> ByteReader::take_bytes(std::uint64_t bytes) {
  need(bytes);
  place_ += bytes;
  return all_.subspan(place_ - bytes, bytes);
}

std::string ByteReader::take_text(std::uint32_t longest) {
  const auto length = take<std::uint32_t>();
  if (length > longest)
    refuse("has a text of " + std::to_string(length) + " bytes; allowed are up to " +
           std::to_string(longest));
  need(length);
  std::string text(length, '\0');
  if (length > 0) std::memcpy(text.data(), all_.data() + place_, length);
  place_ += length;
  return text;
}

std::uint64_t ByteReader::take_count(std::uint64_t bytes_each) {
  const auto count = take<std::uint32_t>();
  if (count > left() / bytes_each)
    refuse("announces " + std::to_string(count) + " things of " + std::to_string(bytes_each) +
           " bytes or more, but only " + std::to_string(left()) + " bytes follow");
  return count;
}

void ByteReader::end() const {
  if (left() != 0) refuse("has " + std::to_string(left()) + " bytes more than it should");
}

void ByteReader::refuse_length(std::uint64_t bytes) const {
  refuse("ends after " + std::to_string(all_.size()) + " bytes; at byte " + std::to_string(place_) + " " +
         std::to_string(bytes) + " more were to follow");
}

void ByteReader::refuse(const std::string& sentence) const {
  throw Error(ErrorCode::invalid_argument,
              "the " + std::string(kind_) + " '" + std::string(what_) + "' " + sentence);
}

}  // namespace tandem
