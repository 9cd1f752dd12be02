// run_scenario FILE [KEY=VALUE ...]: a scenario, from its file to its results.
#include <cstdio>

#include "tandem/scenario/run.hpp"
#include "tandem/scenario/sources.hpp"
#include "tandem/text/time_table.hpp"

int main(int count, char** words) try {
  const auto sources = tandem::scenario::sources();
  const auto scenario = tandem::scenario::read(words[1], {words + 2, words + count});
  const auto end = tandem::scenario::run(scenario, sources, {.folder = "results"});
  const auto rows = tandem::text::TimeTable::read("results");
  std::printf("%s: t = %g s, %s = %.12g\n", end.status.c_str(), rows.times.back(), rows.names.back().c_str(),
              rows.columns.back().back());
  return end.status == "ok" ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
