// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "options.h"

namespace ombrage::cli {

/// One subcommand: its options, and what it does when it is the one called. The result is the exit code; errors are
/// thrown.
struct Command {
    std::string name;
    std::string summary;
    std::vector<std::string> examples;  ///< what stands after "ombrage NAME "
    std::function<void(Options&)> declare;
    std::function<int(const Options&)> run;
};

Command listCommand();
Command infoCommand();
Command doctorCommand();
Command renderCommand();
Command referenceCommand();
Command compareCommand();
Command diffCommand();
Command reportCommand();
Command benchCommand();
Command tuneCommand();
Command demoCommand();

/// Results go to standard output through this. @throws Error(Environment) when it cannot be written.
void printResult(const std::string& text);

/// A message on standard error.
void printMessage(const std::string& text);

/// The arguments of this call, for records and reports.
const std::vector<std::string>& commandLine();

/// @throws Error(Usage) naming what is missing, with an example.
std::string requiredText(const Options& options, const std::string& key, const std::string& what);

}  // namespace ombrage::cli
