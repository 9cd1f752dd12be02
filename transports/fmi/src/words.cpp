// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "words.hpp"

#include <limits>

namespace tandem::fmi {
namespace {

template <class Number>
constexpr Range range() {
  return {static_cast<double>(std::numeric_limits<Number>::lowest()),
          static_cast<double>(std::numeric_limits<Number>::max())};
}

}  // namespace

const std::map<std::string, Type>& types_of(Version version) {
  static const std::map<std::string, Type> two = {{"Real", Type::float64},
                                                  {"Integer", Type::int32},
                                                  {"Boolean", Type::boolean},
                                                  {"Enumeration", Type::enumeration},
                                                  {"String", Type::text}};
  static const std::map<std::string, Type> three = {
      {"Float64", Type::float64}, {"Float32", Type::float32}, {"Int8", Type::int8},
      {"UInt8", Type::uint8},     {"Int16", Type::int16},     {"UInt16", Type::uint16},
      {"Int32", Type::int32},     {"UInt32", Type::uint32},   {"Int64", Type::int64},
      {"UInt64", Type::uint64},   {"Boolean", Type::boolean}, {"Enumeration", Type::enumeration},
      {"String", Type::text},     {"Binary", Type::binary},   {"Clock", Type::clock}};
  return version == Version::two ? two : three;
}

std::string listed_types(const std::map<std::string, Type>& types) {
  std::string all;
  for (const auto& [name, type] : types) all += (all.empty() ? "<" : ", <") + name + ">";
  return all;
}

const std::map<std::string, Causality>& causalities() {
  static const std::map<std::string, Causality> all = {
      {"parameter", Causality::parameter},
      {"calculatedParameter", Causality::calculated_parameter},
      {"structuralParameter", Causality::structural_parameter},
      {"input", Causality::input},
      {"output", Causality::output},
      {"local", Causality::local},
      {"independent", Causality::independent}};
  return all;
}

const std::map<std::string, Variability>& variabilities() {
  static const std::map<std::string, Variability> all = {{"constant", Variability::constant},
                                                         {"fixed", Variability::fixed},
                                                         {"tunable", Variability::tunable},
                                                         {"discrete", Variability::discrete},
                                                         {"continuous", Variability::continuous}};
  return all;
}

Range range_of(Type type) {
  constexpr double largest_whole = 9007199254740991.0;  // 2^53 - 1
  constexpr double infinite = std::numeric_limits<double>::infinity();
  switch (type) {
    case Type::float32:
      return range<float>();
    case Type::int8:
      return range<std::int8_t>();
    case Type::uint8:
      return range<std::uint8_t>();
    case Type::int16:
      return range<std::int16_t>();
    case Type::uint16:
      return range<std::uint16_t>();
    case Type::int32:
      return range<std::int32_t>();
    case Type::uint32:
      return range<std::uint32_t>();
    case Type::int64:
    case Type::enumeration:
      return {-largest_whole, largest_whole};
    case Type::uint64:
      return {0.0, largest_whole};
    case Type::boolean:
      return {0.0, 1.0};
    default:
      return {-infinite, infinite};
  }
}

}  // namespace tandem::fmi
