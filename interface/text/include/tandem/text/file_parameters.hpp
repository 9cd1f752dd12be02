// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tandem/text/key_list.hpp"
#include "tandem/text/section.hpp"

namespace tandem::text {

/// Values of a file's parameters by name, in place of those in the file.
using GivenValues = FileValues;

/// A parameter as its file declares it, with the value that it has.
struct FileParameter {
  std::string name, unit;  ///< a word has no unit
  FileValue value;
  Place place;
  bool allowed_word = false;              ///< the word of the file, or one that it allows by a list
  std::vector<std::string> allowed = {};  ///< that list, of a word
};

/// The table [parameters] of a file: NAME = { value = NUMBER, unit = "kg" }, where the number may be an
/// expression of parameters before it, or NAME = { value = "word", allowed = ["word", ..] }. Puts their
/// values, the given ones in place of the file's, into `values`. Throws Error for a value of the other type,
/// a word that is not allowed, and a given one that the file does not have.
std::vector<FileParameter> read_parameters(Section& root, const GivenValues& given, Values& values);
/// The same of a document of which nothing else is read.
std::vector<FileParameter> parameters_of(const Document& document, const GivenValues& given);
/// The keys of that table, for the language of such files.
void keys_of_parameters(KeyList& to);

/// Whether it is a key of [run] itself, and not what a subsystem is made with: start, stop, inputs.
bool is_of_run(const std::string& name);

/// Of the parameters that a file declares, those that somebody else gives: find tells.
GivenValues given_values(const Document& document,
                         const std::function<std::optional<FileValue>(const FileParameter&)>& find);

/// What "$NAME" stands for in a file's table [run]: its parameters with the values that somebody else gives, as find
/// tells, else [run] itself, else the file. References of [run] see plain numbers and words there, and those of
/// parameters before theirs.
Values values_in_run(const Document& document,
                     const std::function<std::optional<FileValue>(const FileParameter&)>& find);

}  // namespace tandem::text
