// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The multibody core in Octave, a MEX file:  motion = tandem_mbs (model, settings)
//   model     a struct of function handles, as OctaveStruct wants it
//   settings  a struct: step, stop [s], name, and any setting of a stepper (formulation, penalty, solver,
//   ...) motion    a struct: time, q, v (a row for each time), iterations
#include <mex.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>

#include "tandem/error.hpp"
#include "tandem/mbs/functions/function_model.hpp"
#include "tandem/mbs/functions/octave_struct.hpp"
#include "tandem/mbs/trajectory.hpp"
#include "tandem/sources/stepper.hpp"

namespace {

using tandem::Error;
using tandem::ErrorCode;

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorCode::invalid_argument, what); }

/// An array of Octave's that is ours to free.
struct Free {
  void operator()(mxArray* array) const { mxDestroyArray(array); }
};
using Array = std::unique_ptr<mxArray, Free>;

Array array_of(const double* values, int size) {
  Array array(mxCreateDoubleMatrix(static_cast<mwSize>(size), 1, mxREAL));
  std::copy_n(values, size, mxGetPr(array.get()));
  return array;
}

std::string text_of(const mxArray* array) {
  char* text = mxArrayToString(array);
  if (!text) refuse("a text is not one");
  std::string copy = text;
  mxFree(text);
  return copy;
}

/// A struct of the caller's, evaluated in the same process.
class CallersStruct final : public tandem::mbs::OctaveStruct {
 public:
  CallersStruct(const std::string& name, const mxArray* model) : OctaveStruct(name), model_(model) {
    if (!mxIsStruct(model)) refuse("the model is not a struct");
    const Array failed(mexEvalStringWithTrap(tandem::mbs::octave_functions));
    if (failed) refuse("tandem_evaluate can't be defined");
    take_info();
  }

 private:
  std::vector<std::string> fields() override {
    std::vector<std::string> all;
    for (int k = 0; k < mxGetNumberOfFields(model_); ++k) all.emplace_back(mxGetFieldNameByNumber(model_, k));
    return all;
  }
  std::vector<std::string> texts(const std::string& field) override {
    const mxArray* cell = mxGetField(model_, 0, field.c_str());
    if (!mxIsCell(cell)) refuse(field + " is no cell array of texts");
    std::vector<std::string> all;
    for (std::size_t k = 0; k < mxGetNumberOfElements(cell); ++k)
      all.push_back(text_of(mxGetCell(cell, static_cast<mwIndex>(k))));
    return all;
  }
  void constant(const std::string& field, Values& values) override {
    const mxArray* array = mxGetField(model_, 0, field.c_str());
    if (!mxIsDouble(array) || mxIsComplex(array) || mxIsSparse(array))
      refuse(field + " is no full real matrix");
    take(array, values);
  }
  void call(  // NOLINT(readability-function-size): the interface has six
      tandem::mbs::Term term, const std::string& what, double t, const double* q, const double* v,
      Values& values) override {
    const std::string field(name(term));
    Array time, positions, velocities;
    mxArray* in[] = {mxGetField(model_, 0, field.c_str()), nullptr, nullptr, nullptr};
    int count = 1;
    if (q) time = array_of(&t, 1), positions = array_of(q, info().size());
    if (v) velocities = array_of(v, info().size());
    for (const Array* argument : {&time, &positions, &velocities})
      if (*argument) in[count++] = argument->get();
    mxArray* out[2] = {};
    const Array failed(mexCallMATLABWithTrap(2, out, count, in, "tandem_evaluate"));
    if (failed) refuse(what + ": it can't be called");
    const Array message(out[0]), result(out[1]);
    if (!mxIsEmpty(message.get())) refuse(what + ": " + text_of(message.get()));
    take(result.get(), values);
  }

  static void take(const mxArray* array, Values& values) {
    values.rows = static_cast<int>(mxGetM(array));
    values.columns = static_cast<int>(mxGetN(array));
    values.numbers.assign(mxGetPr(array), mxGetPr(array) + mxGetNumberOfElements(array));
  }

  const mxArray* model_;
};

tandem::Parameters parameters_of(const mxArray* settings) {
  if (!mxIsStruct(settings)) refuse("the settings are not a struct");
  tandem::Parameters all;
  for (int k = 0; k < mxGetNumberOfFields(settings); ++k) {
    const char* name = mxGetFieldNameByNumber(settings, k);
    const mxArray* value = mxGetFieldByNumber(settings, 0, k);
    if (mxIsChar(value))
      all.set(name, text_of(value));
    else if (mxIsLogicalScalar(value))
      all.set(name, mxIsLogicalScalarTrue(value));
    else if (mxIsDouble(value) && mxGetNumberOfElements(value) == 1)
      all.set(name, mxGetScalar(value));
    else
      refuse(std::string("setting '") + name + "' is no number, text or logical value");
  }
  return all;
}

mxArray* matrix_of(const Eigen::MatrixXd& values) {
  mxArray* array =
      mxCreateDoubleMatrix(static_cast<mwSize>(values.rows()), static_cast<mwSize>(values.cols()), mxREAL);
  std::copy_n(values.data(), values.size(), mxGetPr(array));
  return array;
}

mxArray* motion_of(const tandem::mbs::Trajectory& trajectory) {
  const char* names[] = {"time", "q", "v", "iterations"};
  mxArray* motion = mxCreateStructMatrix(1, 1, 4, names);
  mxSetField(motion, 0, "time", matrix_of(trajectory.time));
  mxSetField(motion, 0, "q", matrix_of(trajectory.q));
  mxSetField(motion, 0, "v", matrix_of(trajectory.v));
  mxSetField(motion, 0, "iterations", mxCreateDoubleScalar(static_cast<double>(trajectory.iterations)));
  return motion;
}

mxArray* run(int count, const mxArray** arguments) {
  if (count != 2) refuse("it has " + std::to_string(count) + " arguments; allowed is (model, settings)");
  tandem::Parameters p = parameters_of(arguments[1]);
  const double step = p.number("step", 0.0), stop = p.number("stop", 0.0);
  if (!(step > 0.0) || !(stop >= step) || !(stop / step < 1e9))
    refuse("step is " + std::to_string(step) + " s and stop " + std::to_string(stop) +
           " s; allowed are a step above 0 and a stop of 1 to 1e9 steps");
  const std::string name = p.text("name", "of the caller");
  const tandem::mbs::StepperSettings settings = tandem::take_stepper(p);
  p.refuse_unused("settings");
  tandem::mbs::FunctionModel model(std::make_unique<CallersStruct>(name, arguments[0]));
  const int steps = static_cast<int>(std::lround(stop / step));
  return motion_of(trajectory(model, model.initial(0.0), settings, step, steps));
}

}  // namespace

/// Octave's error leaves this function without unwinding, so nothing may be left to destroy by then.
void mexFunction(int, mxArray* results[], int count, const mxArray* arguments[]) {
  static char sentence[4096];
  try {
    results[0] = run(count, arguments);
    return;
  } catch (const std::exception& error) {
    std::strncpy(sentence, error.what(), sizeof sentence - 1);
  }
  mexErrMsgIdAndTxt("tandem:failed", "%s", sentence);
}
