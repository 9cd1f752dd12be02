// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "functions.hpp"
#include "tandem/fmi/description.hpp"

namespace tandem::fmi {

/// The functions that get and set the numbers of one type in FMI 3.0.
template <class Number>
struct Access {
  using number = Number;
  Call<const std::uint32_t*, std::size_t, Number*, std::size_t> get;
  Call<const std::uint32_t*, std::size_t, const Number*, std::size_t> set;
};

/// Of every type, and memory for their numbers.
class Accesses {
 public:
  /// find(function, name) for each.
  template <class Find>
  void find(const Find& find) {
    static const char* const names[] = {"Float64", "Float32", "Int8",  "UInt8",  "Int16",  "UInt16",
                                        "Int32",   "UInt32",  "Int64", "UInt64", "Boolean"};
    int k = 0;
    const auto both = [&](auto& access) {
      const std::string name = names[k++];
      find(access.get, "Get" + name), find(access.set, "Set" + name);
    };
    std::apply([&](auto&... all) { (both(all), ...); }, all_);
  }

  /// call(function, numbers) with as many numbers as there are values, which become the values.
  template <class Make>
  void get(Type type, std::span<double> values, const Make& call) {
    with(type, [&](auto& access) {
      auto* const numbers = memory<typename std::decay_t<decltype(access)>::number>(values.size());
      call(access.get, numbers);
      std::transform(numbers, numbers + values.size(), values.begin(),
                     [](auto number) { return static_cast<double>(number); });
    });
  }
  /// The other way round.
  template <class Make>
  void set(Type type, std::span<const double> values, const Make& call) {
    with(type, [&](auto& access) {
      using Number = typename std::decay_t<decltype(access)>::number;
      Number* const numbers = memory<Number>(values.size());
      std::transform(values.begin(), values.end(), numbers,
                     [](double value) { return static_cast<Number>(value); });
      call(access.set, static_cast<const Number*>(numbers));
    });
  }

 private:
  /// An enumeration is an Int64.
  template <class Use>
  void with(Type type, const Use& use) {
    const auto place = static_cast<std::size_t>(type == Type::enumeration ? Type::int64 : type);
    [&]<std::size_t... k>(std::index_sequence<k...>) {
      ((k == place ? use(std::get<k>(all_)) : void()), ...);
    }(std::make_index_sequence<std::tuple_size_v<decltype(all_)>>());
  }
  template <class Number>
  Number* memory(std::size_t count) {
    if (memory_.size() < count * sizeof(Number)) memory_.resize(count * sizeof(Number));
    return reinterpret_cast<Number*>(memory_.data());
  }

  std::tuple<Access<double>, Access<float>, Access<std::int8_t>, Access<std::uint8_t>, Access<std::int16_t>,
             Access<std::uint16_t>, Access<std::int32_t>, Access<std::uint32_t>, Access<std::int64_t>,
             Access<std::uint64_t>, Access<bool>>
      all_;  ///< in the order of Type
  std::vector<std::byte> memory_;
};

}  // namespace tandem::fmi
