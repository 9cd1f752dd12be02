// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Parameters of files, and expressions of them.
#include "tandem/text/values.hpp"

#include <gtest/gtest.h>

#include "refusal.hpp"
#include "tandem/text/file_parameters.hpp"

namespace tandem::text {
namespace {

const std::map<std::string, FileValue> numbers = {{"m", 2.0}, {"k", 8.0}, {"word", "slow"}, {"m_2", 0.1}};

TEST(Expressions, AreNumbers) {
  for (const auto& [expression, value] :
       std::initializer_list<std::pair<const char*, double>>{{"sqrt(k/m)", 2.0},
                                                             {"2*m + 1", 5.0},
                                                             {"-m^2", -4.0},
                                                             {"m_2", 0.1},
                                                             {"0.1 + 0.2", 0.1 + 0.2},
                                                             {"k > m ? 1 : 0", 1.0},
                                                             {"k == 8 && m != 3", 1.0},
                                                             {"max(m, k, 3)", 8.0},
                                                             {"_pi", 3.141592653589793},
                                                             {"_e", 2.718281828459045},
                                                             {"1e-3*m", 2e-3}})
    EXPECT_EQ(evaluated(expression, numbers), value) << expression;
}

TEST(Expressions, ThatAreNoneAreRefused) {
  const auto refuses = [](const std::string& expression, const std::vector<std::string>& says) {
    test::refuses(ErrorCode::invalid_argument, says, [&] { evaluated(expression, numbers); });
  };
  refuses("m = 3", {"'m = 3'", "single ="});
  refuses("1, 2", {"comma"});
  refuses("(1, 2)", {"comma"});
  refuses("max(1, (2, 3))", {"comma"});
  refuses("2*q", {"'2*q'", "at letter 3", "k, m, m_2"});
  refuses("2*word", {"'2*word'"});
  refuses("", {"''"});
  refuses("2*(m", {"'2*(m'"});
  refuses("1/(m - 2)", {"is inf", "m = 2", "finite"});
  refuses("sqrt(-k)", {"nan", "k = 8"});
  refuses(std::string(2000, '('), {"1000 letters"});
  refuses("\"m\"", {"can't be read"});
}

std::vector<FileParameter> read(const std::string& text, const GivenValues& given, Values& values) {
  const Document document("f.toml", text);
  KeyList list;
  keys_of_parameters(list);
  const Keys language(std::move(list).list());
  Section root(document, language);
  return read_parameters(root, given, values);
}

TEST(FileParameters, AreThoseOfTheFileOrThoseThatAreGiven) {
  const std::string text =
      "[parameters]\nm = { value = 2, unit = 'kg' }\nk = { value = '$(4*m)', unit = 'N/m' }\n"
      "how = { value = 'a', allowed = ['a', 'b'] }\n";
  Values own, given;
  const auto all = read(text, {}, own);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(std::get<double>(all[1].value), 8.0);
  EXPECT_EQ(all[1].unit, "N/m");
  const auto others = read(text, {{"m", 3.0}, {"how", "b"}}, given);
  EXPECT_EQ(std::get<double>(others[1].value), 12.0);
  EXPECT_EQ(std::get<std::string>(others[2].value), "b");
  const auto refuses = [&](const GivenValues& wrong, const std::vector<std::string>& says) {
    Values values;
    test::refuses(ErrorCode::invalid_argument, says, [&] { read(text, wrong, values); });
  };
  refuses({{"q", 1.0}}, {"f.toml", "unknown parameter 'q'", "m, k, how"});
  refuses({{"m", "x"}}, {"'m' is 'x'", "a number"});
  refuses({{"how", "c"}}, {"'how' is 'c'", "a, b"});
  Values values;
  test::refuses(ErrorCode::invalid_argument, {"f.toml:2", "unit"},
                [&] { read("[parameters]\nm = { value = 2 }\n", {}, values); });
  test::refuses(ErrorCode::invalid_argument, {"f.toml:2", "parameters.k.value", "'2*later'"}, [&] {
    read("[parameters]\nk = { value = '$(2*later)', unit = '1' }\nlater = { value = 1, unit = '1' }\n", {},
         values);
  });
}

}  // namespace
}  // namespace tandem::text
