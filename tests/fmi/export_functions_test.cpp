// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The functions of an FMU's library as other importers call them.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdarg>
#include <thread>

#include "exports.hpp"
#include "fmi2.h"

namespace tandem::test {
namespace {

const std::string of_a_lag =
    "[parameters]\nT = { value = 0.1, unit = 's' }\nsign = { value = 'plus', allowed = ['plus', 'minus'] }\n"
    "[inputs]\nu = { unit = '1' }\n[blocks]\nx = { kind = 'lag', input = 'u', time = '$T' }\n[outputs]\n"
    "x = { unit = '1' }\n[run]\nstep = 0.01\n";

class ExportedFunctions : public testing::Test {
 protected:
  ExportedFunctions() {
    fmi::Archive archive(fmu);
    archive.unpack("binaries/", exports.folder.path() / "x");
    const auto file = exports.folder.path() / "x/binaries/linux64/x.so";
    library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    EXPECT_TRUE(library) << dlerror();
    token = fmi::read_description(archive.text("modelDescription.xml", 1 << 20), "x").guid;
  }
  ~ExportedFunctions() override { dlclose(library); }

  template <class... Arguments>
  int call(const char* name, Arguments... arguments) const {
    return reinterpret_cast<int (*)(Arguments...)>(dlsym(library, name))(arguments...);
  }
  static void log(void* all, const char*, fmi2Status, const char*, const char* form, ...) {
    EXPECT_STREQ(form, "%s");
    va_list list;
    va_start(list, form);
    *static_cast<std::string*>(all) += va_arg(list, const char*);
    va_end(list);
  }
  fmi2Component instance(const std::string& uri, const std::string& guid, std::string* all,
                         fmi2Type type = fmi2CoSimulation) const {
    static fmi2CallbackFunctions callbacks;
    callbacks = {&log, nullptr, nullptr, nullptr, all};
    return reinterpret_cast<fmi2InstantiateType*>(dlsym(library, "fmi2Instantiate"))(
        "x", type, guid.c_str(), uri.c_str(), &callbacks, 0, 0);
  }
  double x(fmi2Component c) const {
    const unsigned reference = 2;
    double value = NAN;
    EXPECT_EQ(call("fmi2GetReal", c, &reference, std::size_t{1}, &value), 0);
    return value;
  }
  void set(fmi2Component c, unsigned reference, double value) const {
    EXPECT_EQ(call("fmi2SetReal", c, &reference, std::size_t{1}, &value), 0);
  }
  void start(fmi2Component c) const {
    EXPECT_EQ(call("fmi2SetupExperiment", c, 0, 0.0, 0.0, 0, 0.0), 0);
    EXPECT_EQ(call("fmi2EnterInitializationMode", c), 0);
    EXPECT_EQ(call("fmi2ExitInitializationMode", c), 0);
  }
  void step(fmi2Component c, double t) const { EXPECT_EQ(call("fmi2DoStep", c, t, 0.01, 1), 0); }
  void free(fmi2Component c) const { call("fmi2FreeInstance", c); }

  Exports exports;
  std::filesystem::path fmu = exports.fmu("x", of_a_lag);
  std::string resources = "file://" + exports.unpacked(fmu).string(), token, said;
  void* library = nullptr;
};

TEST_F(ExportedFunctions, KeepStatesAlsoAsBytesAndBeginAnew) {
  fmi2Component one = instance(resources, token, &said), other = instance(resources + "/", token, &said);
  ASSERT_TRUE(one && other) << said;
  set(one, 1, 2.0), start(one), step(one, 0.0);
  void* state = nullptr;
  EXPECT_EQ(call("fmi2GetFMUstate", one, &state), 0);
  std::size_t size = 0;
  EXPECT_EQ(call("fmi2SerializedFMUstateSize", one, state, &size), 0);
  std::vector<char> bytes(size);
  EXPECT_EQ(call("fmi2SerializeFMUstate", one, state, bytes.data(), size), 0);
  EXPECT_EQ(call("fmi2SerializeFMUstate", one, state, bytes.data(), size - 1), 3);
  const double before = x(one);
  step(one, 0.01);
  const double after = x(one);
  EXPECT_EQ(call("fmi2SetFMUstate", one, state), 0);
  EXPECT_EQ(x(one), before);
  void* copy = nullptr;
  EXPECT_EQ(call("fmi2DeSerializeFMUstate", other, const_cast<const char*>(bytes.data()), size, &copy), 0);
  EXPECT_EQ(call("fmi2SetFMUstate", other, copy), 0);
  for (fmi2Component c : {one, other}) {
    step(c, 0.01);
    EXPECT_EQ(x(c), after);
  }
  EXPECT_EQ(call("fmi2GetFMUstate", one, &state), 0);  // into the one that is there
  for (void** kept : {&state, &copy}) {
    EXPECT_EQ(call("fmi2FreeFMUstate", one, kept), 0);
    EXPECT_FALSE(*kept);
  }
  EXPECT_EQ(call("fmi2Terminate", one), 0);
  EXPECT_EQ(call("fmi2Reset", one), 0);
  set(one, 1, 2.0), start(one), step(one, 0.0);
  EXPECT_EQ(x(one), before);
  free(one), free(other);
}

TEST_F(ExportedFunctions, TakeWordsAndBooleansAndTellWhatIsWrong) {
  fmi2Component c = instance(resources, token, &said);
  const unsigned sign = 5, along = 6, nothing = 99;
  const char* word = "minus";
  EXPECT_EQ(call("fmi2SetString", c, &sign, std::size_t{1}, &word), 0);
  EXPECT_EQ(call("fmi2GetString", c, &sign, std::size_t{1}, &word), 0);
  EXPECT_STREQ(word, "minus");
  int flag = 1;
  EXPECT_EQ(call("fmi2SetBoolean", c, &along, std::size_t{1}, &flag), 0);
  flag = 0;
  EXPECT_EQ(call("fmi2GetBoolean", c, &along, std::size_t{1}, &flag), 0);
  EXPECT_EQ(flag, 1);
  double value = 0.0;
  EXPECT_EQ(call("fmi2GetReal", c, &nothing, std::size_t{1}, &value), 3);
  EXPECT_NE(said.find("no variable of value reference 99"), std::string::npos) << said;
  EXPECT_EQ(call("fmi2GetReal", fmi2Component{}, &nothing, std::size_t{1}, &value), 3);
  EXPECT_EQ(call("fmi2CancelStep", c), 3);
  EXPECT_EQ(call("fmi2SetTime", c, 0.0), 3);
  EXPECT_NE(said.find("this FMU is for Co-Simulation"), std::string::npos) << said;
  free(c);
}

TEST_F(ExportedFunctions, MakeNoInstanceOfAnother) {
  EXPECT_FALSE(instance(resources, token, &said, fmi2ModelExchange));
  EXPECT_NE(said.find("this FMU is for Co-Simulation"), std::string::npos) << said;
  EXPECT_FALSE(instance(resources, "another", &said));
  EXPECT_NE(said.find("'another'; allowed is"), std::string::npos) << said;
  EXPECT_FALSE(instance("file:///not/there", token, &said));
  EXPECT_NE(said.find("/not/there"), std::string::npos) << said;
}

TEST_F(ExportedFunctions, WorkInTwoThreads) {
  double last[2];
  const auto run = [&](int which) {
    std::string own;
    fmi2Component c = instance(resources, token, &said);
    set(c, 1, 1.0), start(c);
    for (int k = 0; k < 500; ++k) step(c, k * 0.01);
    last[which] = x(c);
    free(c);
  };
  std::thread other(run, 1);
  run(0);
  other.join();
  EXPECT_EQ(last[0], last[1]);
  EXPECT_NEAR(last[0], 1.0, 1e-9);
}

}  // namespace
}  // namespace tandem::test
