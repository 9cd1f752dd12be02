// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/declared_parameters.hpp"

#include <gtest/gtest.h>

#include "c_models.h"
#include "refusal.hpp"
#include "tandem/c_subsystem.hpp"
#include "tandem/c_table.hpp"
#include "tandem/fixed_step.hpp"

namespace tandem {
namespace {

using test::refuses;
constexpr ErrorCode code = ErrorCode::invalid_argument;

const DeclaredParameters declared = {
    {"mass", "kg", {}, "of the body"}, {"ratio", "1", "0.5", "of teeth"}, {"file", {}, "a.csv", "its track"}};

TEST(DeclaredParameters, WhatIsNotDeclaredIsRefusedWithTheNearest) {
  const auto given = [](const char* pairs) { return [=] { check_given(declared, pairs); }; };
  EXPECT_NO_THROW(given("")());  // what is needed may come from elsewhere
  EXPECT_NO_THROW(given("file=x y=z&ratio=-1e-3")());
  EXPECT_TRUE(refuses(code,
                      {"parameter 'mas' is not there; did you mean 'mass'? There are: mass, ratio, file"},
                      given("mas=1")));
  EXPECT_TRUE(refuses(code, {"parameter '' is not there"}, given("=1")));
  EXPECT_TRUE(refuses(code, {"parameter 'mass' is given twice"}, given("mass=1&mass=1")));
  EXPECT_TRUE(refuses(code, {"'mass' stands where key=value is allowed"}, given("ratio=1&mass")));
  EXPECT_TRUE(refuses(code, {"parameter 'x\\x1b' is not there"}, given("x\x1b=1")));
}

TEST(DeclaredParameters, ATextIsNoNumber) {
  for (const std::string none : {"", "heavy", "1kg", " 1", "+1", "0x1p3", "1,5", "nan", "inf", "1e999"})
    EXPECT_TRUE(refuses(code, {"parameter 'mass' is '" + none + "'; allowed is a finite number in kg"},
                        [&] { check_given(declared, "mass=" + none); }));
  EXPECT_TRUE(refuses(code, {"'ratio' is 'half'; allowed is a finite number"},
                      [] { check_given(declared, "ratio=half"); }));
}

TEST(DeclaredParameters, WhereNoneAreDeclaredAnyAreAllowed) {
  EXPECT_NO_THROW(check_given({}, "colour=blue&anything"));
}

TEST(DeclaredParameters, ValuesAreWhatIsGivenOrStandsOtherwise) {
  const ParameterValues values(declared, "ratio=0.1&mass=3");
  EXPECT_EQ(values.number("mass"), 3.0);
  EXPECT_EQ(values.number("ratio"), 0.1);
  EXPECT_EQ(values.word("file"), "a.csv");
  EXPECT_TRUE(refuses(ErrorCode::internal, {"'colour' is not declared"}, [&] { values.number("colour"); }));
  EXPECT_TRUE(
      refuses(ErrorCode::internal, {"'file' is not declared as a number"}, [&] { values.number("file"); }));
  EXPECT_TRUE(refuses(code, {"parameter 'mass' is needed, a finite number in kg: of the body"},
                      [] { ParameterValues(declared, "ratio=0.1"); }));
}

/// The integral's table with another declaration.
template <int count>
testing::AssertionResult refuses_declaring(const std::string& sentence, const tandem_parameter* list) {
  static const tandem_parameter* given;
  given = list;
  tandem_subsystem_api api = *c_integral();
  api.parameters = [](std::int32_t* number) {
    *number = count;
    return given;
  };
  return refuses(code, {sentence}, [&] { CSubsystem(&api, ""); });
}

TEST(DeclaredParameters, OfALibraryThatMakeNoSenseAreRefused) {
  static const tandem_parameter nameless[] = {{"a", "1", "1", "one"}, {nullptr, "1", "1", "two"}};
  static const tandem_parameter silent[] = {{"a", "1", "1", nullptr}};
  static const tandem_parameter twice[] = {{"a", "1", "1", "one"}, {"a", "1", "1", "two"}};
  static const tandem_parameter no_number[] = {{"a", "1", "one", "one"}};
  static const std::string long_text(5000, 'x');
  static const tandem_parameter endless[] = {{"a", "1", "1", long_text.c_str()}};
  EXPECT_TRUE(refuses_declaring<2>("parameter 1 is declared without name or sentence", nameless));
  EXPECT_TRUE(refuses_declaring<1>("parameter 0 is declared without name or sentence", silent));
  EXPECT_TRUE(refuses_declaring<2>("parameter 'a' is declared twice", twice));
  EXPECT_TRUE(refuses_declaring<1>("parameter 'a' is declared to be 'one' where none is given", no_number));
  EXPECT_TRUE(refuses_declaring<1>("parameter 'a' is declared with a text of 5000 bytes", endless));
  EXPECT_TRUE(refuses_declaring<-1>("declares -1 parameters", twice));
  EXPECT_TRUE(refuses_declaring<5000>("declares 5000 parameters; allowed are 0 to 4096", twice));
  EXPECT_TRUE(refuses_declaring<1>("declares 1 parameters without a list of them", nullptr));
}

TEST(DeclaredParameters, OfALibraryThatDeclaresNoneAreItsOwn) {
  tandem_subsystem_api api = *c_integral();
  api.parameters = [](std::int32_t* number) {
    *number = 0;
    return static_cast<const tandem_parameter*>(nullptr);
  };
  EXPECT_TRUE(refuses(code, {"create: 'gian=1' is no parameter"}, [&] { CSubsystem(&api, "gian=1"); }));
}

/// What was declared is in the error of all that keeps an instance from being made.
TEST(DeclaredParameters, AreToldWithTheErrorWhereNoInstanceIsMade) {
  for (const char* pairs : {"gian=1", "rule=trapez"}) try {
      CSubsystem(c_integral(), pairs);
      ADD_FAILURE() << pairs;
    } catch (const NotMade& error) {
      EXPECT_EQ(error.parameters().size(), 4U);
      try {
        throw_behind("library 'x': ", error);
      } catch (const NotMade& longer) {
        EXPECT_EQ(longer.what(), std::string("library 'x': ") + error.what());
        EXPECT_EQ(longer.parameters().size(), 4U);
      }
    }
}

/// A model in C++ that declares: x' = slope.
constexpr tandem_parameter ramp_parameters[] = {{"slope", "m/s", nullptr, "of x"},
                                                {"h", "s", "0.5", "own step"}};

struct SlopedRamp {
  double slope, h, x = 0.0;
  SubsystemInfo info() const {
    SubsystemInfo info{"ramp", {}, {{"x", "m"}}, {}, {}};
    info.outputs[0].nominal = 10.0 * slope;
    return info;
  }
  double own_step() const { return h; }
  void start(double, std::span<const double>) { x = 0.0; }
  void step(const OwnStep& s, std::span<const Signal>) { x += slope * s.length; }
  void outputs(double* y) const { *y = x; }
};

std::unique_ptr<Subsystem> make_ramp(const ParameterValues& p) {
  return std::make_unique<FixedStep<SlopedRamp>>(SlopedRamp{p.number("slope"), p.number("h")});
}

TEST(DeclaredParameters, OfAModelInCppAreAnArray) {
  const auto* const api = c_table<make_ramp, ramp_parameters>();
  const CSubsystem ramp(api, "slope=3");
  EXPECT_EQ(ramp.info().parameters.size(), 2U);
  EXPECT_EQ(ramp.info().outputs[0].nominal, 30.0);
  EXPECT_TRUE(refuses(code, {"did you mean 'slope'?"}, [&] { CSubsystem(api, "slop=3"); }));
  EXPECT_TRUE(refuses(code, {"parameter 'slope' is needed"}, [&] { CSubsystem(api, ""); }));
  EXPECT_TRUE(refuses(code, {"output 'x' has the nominal value -10"}, [&] { CSubsystem(api, "slope=-1"); }));
}

}  // namespace
}  // namespace tandem
