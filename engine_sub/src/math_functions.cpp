// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "math_functions.hpp"

#include <cmath>

namespace tandem::engine {

const std::vector<Named<Function>> functions = {
    {"sin", [](double x) { return std::sin(x); }},
    {"cos", [](double x) { return std::cos(x); }},
    {"tan", [](double x) { return std::tan(x); }},
    {"asin", [](double x) { return std::asin(x); }},
    {"acos", [](double x) { return std::acos(x); }},
    {"atan", [](double x) { return std::atan(x); }},
    {"sinh", [](double x) { return std::sinh(x); }},
    {"cosh", [](double x) { return std::cosh(x); }},
    {"tanh", [](double x) { return std::tanh(x); }},
    {"exp", [](double x) { return std::exp(x); }},
    {"log", [](double x) { return std::log(x); }},
    {"sqrt", [](double x) { return std::sqrt(x); }},
    {"square", [](double x) { return x * x; }},
    {"abs", [](double x) { return std::abs(x); }},
    {"sign", [](double x) { return x > 0.0   ? 1.0
                                   : x < 0.0 ? -1.0
                                             : 0.0 * x; }},
    {"floor", [](double x) { return std::floor(x); }}};

const std::vector<Named<Function2>> functions2 = {
    {"min", [](double x, double y) { return y < x || std::isnan(y) ? y : x; }},
    {"max", [](double x, double y) { return y > x || std::isnan(y) ? y : x; }},
    {"power", [](double x, double y) { return std::pow(x, y); }},
    {"atan2", [](double x, double y) { return std::atan2(x, y); }},
    {"hypot", [](double x, double y) { return std::hypot(x, y); }},
    {"remainder", [](double x, double y) { return x - y * std::floor(x / y); }}};

}  // namespace tandem::engine
