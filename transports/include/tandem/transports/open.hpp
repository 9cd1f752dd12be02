// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tandem/subsystem.hpp"
#include "tandem/transports/parameters.hpp"

namespace tandem {

/// A URI taken apart: "lib:./x.so?entry=name" has the scheme "lib" and the place "./x.so".
struct Address {
  std::string uri, scheme, place;
  std::filesystem::path folder;             ///< where a file is looked for that is not named from the root
  std::vector<std::string> command = {};    ///< Opening::command
  std::vector<std::string> overrides = {};  ///< Opening::overrides
  bool isolated = false;                    ///< Opening::isolated, of the program that serves it
  std::filesystem::path file() const { return folder / place; }
  /// "source 'URI'" or "command [...]": what errors call it.
  std::string name() const;
};

/// What is known of a source that is code before any of it is run.
struct Look {
  SubsystemInfo info;
  DeclaredParameters parameters = {};  ///< that its model takes
  double own_step = 0.0;               ///< [s]; 0: it has none, and the parameter `step` has to be given
  int input_order = 0;  ///< of a coupling, as inputs are held over a step; 0: they are functions of time
  bool once_per_process = false;  ///< no second one may be in this process at the same time
  std::vector<bool> discrete = {};  ///< by scalar input, that it takes constants alone; empty: none
  std::vector<std::string> sentences = {};
  std::string obstacle = {};  ///< why it can't be run here; empty: nothing is seen against it
};

/// How subsystems of one kind are made.
struct Source {
  /// What the maker asks the parameters for itself, with who may set it. Any other word it may declare later
  /// (a file's own parameters), or hand on to the subsystem unread (Parameters::rest).
  Words words;
  std::function<std::unique_ptr<Subsystem>(const Address&, Parameters&)> make;
  bool elsewhere = false;  ///< The subsystem is not made here: it lives in a library or another process.
  bool code = false;       ///< To open it runs code that its place names.
  /// Of code: checks what can be without running any, and asks the parameters that `make` asks for. Gives
  /// what it has seen; nothing, where only the code itself can say.
  std::function<std::optional<Look>(const Address&, Parameters&)> look = {};
  bool native = false;  ///< Of code: it is loaded into this process, unless it is isolated.
};

/// What URIs can name. Whoever owns the models fills it, and add_shared_library(), add_tcp() and the like add
/// their schemes; what opens a URI knows no model and no transport.
struct Builtins {
  std::map<std::string, Source> models;   ///< by the NAME of "builtin:NAME"
  std::map<std::string, Source> schemes;  ///< by the scheme of "scheme:PLACE"
  /// A program and its first arguments, which serves the source that is its next argument to the process that
  /// starts it, for what is isolated. Empty: there is none.
  std::vector<std::string> server = {};
  bool stand_ins = false;  ///< what is opened stands in the place of what is named, and may do less
};

/// What a URI is opened with.
struct Opening {
  Parameters parameters = {};
  std::filesystem::path folder = {};  ///< where a file is looked for that is not named from the root
  /// In place of what follows "spawn:": a program and its arguments, which is started without a shell.
  std::vector<std::string> command = {};
  /// "KEY=VALUE" that the command line puts into the file that the place names, if the source reads one.
  std::vector<std::string> overrides = {};
  /// Native code runs in a process of its own, as behind "spawn:", whose parameters it may have besides.
  bool isolated = false;
};

/// The subsystem that a URI names: "builtin:NAME", "mechanism:FILE" or "tcp://HOST:PORT", each with
/// "?key=value&key=value" if wanted. Values in the URI stand beside the parameters; the same one in both is
/// an error. Throws Error for an unknown scheme or name, for a client's value of a word that is the
/// operator's, before anything is opened, and for parameters that the subsystem does not take.
std::unique_ptr<Subsystem> open(const std::string& uri, const Builtins& builtins, Opening opening = {});

/// What open() finds wrong with a source that is code before it runs any, and what it sees of it; nothing of
/// it is run.
std::optional<Look> look_at(const std::string& uri, const Builtins& builtins, Opening opening);

/// What follows the question mark of a URI. Throws Error for what is no pair.
Parameters query_of(const std::string& uri);

/// A command as a scenario has it: ["program", "argument"].
std::string shown(const std::vector<std::string>& command);

/// What makes the subsystem that a URI names. Nothing is opened. Throws Error for a scheme or a builtin's
/// name that is not there.
const Source& source_of(const std::string& uri, const Builtins& builtins);

}  // namespace tandem
