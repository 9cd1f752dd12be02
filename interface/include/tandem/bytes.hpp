// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

/// Numbers as bytes that leave the process: on the wire, in a state, in a file.
namespace tandem {

/// A number as it stands there: little-endian, two's complement, IEEE 754.
template <class T>
std::array<std::byte, sizeof(T)> to_wire(T value) {
  static_assert(std::is_arithmetic_v<T>);
  auto bytes = std::bit_cast<std::array<std::byte, sizeof(T)>>(value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// The number at the beginning of `bytes`. Precondition: there are enough of them.
template <class T>
T from_wire(std::span<const std::byte> bytes) {
  std::array<std::byte, sizeof(T)> copy;
  std::copy_n(bytes.begin(), sizeof(T), copy.begin());
  if constexpr (std::endian::native == std::endian::big) std::reverse(copy.begin(), copy.end());
  return std::bit_cast<T>(copy);
}

/// FNV-1a of 64 bits (G. Fowler, L. C. Noll, K.-P. Vo): no change of a single byte keeps it. `before`: that
/// of the bytes that stand in front of these.
inline constexpr std::uint64_t empty_checksum = 0xcbf29ce484222325;
std::uint64_t checksum(std::span<const std::byte> bytes, std::uint64_t before = empty_checksum);

/// Bytes that are put one after another; its memory is used again after clear(). What is not written yet
/// takes room, but no page of the system's memory.
class ByteWriter {
 public:
  void clear() { size_ = 0; }
  std::size_t size() const { return size_; }
  std::span<const std::byte> bytes() const { return {memory_.get(), size_}; }

  template <class T>
  void put(T value) {
    const auto bytes = to_wire(value);
    std::copy(bytes.begin(), bytes.end(), more(sizeof(T)));
  }
  /// Overwrites the number at `place`, which is there already.
  template <class T>
  void put_at(std::size_t place, T value) {
    const auto bytes = to_wire(value);
    std::copy(bytes.begin(), bytes.end(), memory_.get() + place);
  }
  void put_doubles(std::span<const double> values);
  /// Their number as u32, then the numbers.
  void put_list(std::span<const double> values);
  /// Length as u32, then the bytes.
  void put_text(std::string_view text);
  void put_bytes(std::span<const std::byte> bytes);
  /// Room for so many bytes from `place` on, which may be filled before they are put: by put_filled().
  std::byte* room(std::size_t place, std::size_t bytes);
  /// So many bytes that were filled behind the end.
  void put_filled(std::size_t bytes) { size_ += bytes; }
  /// Gives back memory beyond `most` bytes, with what it holds.
  void release_beyond(std::size_t most);

 private:
  /// Room for so many bytes at the end, to be filled.
  std::byte* more(std::size_t bytes) {
    if (size_ + bytes > capacity_) grow(2 * (size_ + bytes));
    size_ += bytes;
    return memory_.get() + size_ - bytes;
  }
  void grow(std::size_t capacity);

  std::unique_ptr<std::byte[]> memory_;
  std::size_t size_ = 0, capacity_ = 0;
};

/// Bytes that are taken one after another. Whatever is not there is refused, before anything is allocated for
/// it, with Error(invalid_argument) that names what it is of ("the message 'advance'") and the place.
class ByteReader {
 public:
  /// kind, what: views that outlive the reader.
  ByteReader(std::span<const std::byte> bytes, std::string_view what, std::string_view kind = "message")
      : all_(bytes), what_(what), kind_(kind) {}

  std::size_t left() const { return all_.size() - place_; }

  template <class T>
  T take() {
    need(sizeof(T));
    const T value = from_wire<T>(all_.subspan(place_));
    place_ += sizeof(T);
    return value;
  }
  void take_doubles(std::span<double> values);
  /// What put_list() wrote; the second: of just as many numbers as there is room for.
  std::vector<double> take_list();
  void take_list(std::span<double> values);
  /// At most `longest` bytes.
  std::string take_text(std::uint32_t longest);
  /// A view of so many.
  std::span<const std::byte> take_bytes(std::uint64_t bytes);
  /// A count of things that take at least `bytes_each`, so that no more are announced than could follow.
  std::uint64_t take_count(std::uint64_t bytes_each);
  /// Nothing may be left.
  void end() const;
  [[noreturn]] void refuse(const std::string& sentence) const;

 private:
  void need(std::uint64_t bytes) const {
    if (bytes > left()) refuse_length(bytes);
  }
  [[noreturn]] void refuse_length(std::uint64_t bytes) const;

  std::span<const std::byte> all_;
  std::string_view what_, kind_;
  std::size_t place_ = 0;
};

}  // namespace tandem
