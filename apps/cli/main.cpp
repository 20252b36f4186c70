// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <ombrage/error.h>
#include <ombrage/log.h>
#include <ombrage/version.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <system_error>

#include "commands.h"
#include "progress.h"

namespace ombrage::cli {

namespace {

std::vector<std::string> g_commandLine;

void printError(const Error& error) {
    Progress::clearLine();
    fmt::print(stderr, "ombrage: {}\n", error.message());
    if (!error.where().empty()) fmt::print(stderr, "  where: {}\n", error.where());
    if (!error.hint().empty()) fmt::print(stderr, "  hint: {}\n", error.hint());
}

std::string footer(const Command& command) {
    std::string text = "Examples:\n";
    for (const std::string& example : command.examples)
        text += "  ombrage " + command.name + (example.empty() ? "" : " " + example) + "\n";
    return text;
}

/// Parses and runs. CLI11 reports what it cannot place; the words of the message and the suggestion are ours.
int runCommandLine(const std::vector<std::string>& arguments) {
    CLI::App app("Ombrage: real-time shadows and ambient occlusion, measured against the truth.", "ombrage");
    app.set_version_flag("--version", "ombrage " + std::string(versionString()));
    app.require_subcommand(0, 1);
    app.footer(
        "'ombrage COMMAND --help' explains a command.\n"
        "Exit codes: 0 done, 1 a gate or comparison failed, 2 wrong usage, 3 bad input file,\n"
        "4 environment (no OpenGL 4.5, disk full), 130 interrupted.\n\n"
        "Examples:\n  ombrage demo\n  ombrage list scenes\n  ombrage compare gap sphere --all shadow -o out\n");

    const std::vector<Command> commands{renderCommand(),    compareCommand(), benchCommand(),  tuneCommand(),
                                        referenceCommand(), diffCommand(),    reportCommand(), infoCommand(),
                                        listCommand(),      doctorCommand(),  demoCommand()};
    std::vector<std::string> names;
    std::vector<CLI::App*> apps;
    std::vector<std::unique_ptr<Options>> options;
    for (const Command& command : commands) {
        CLI::App* sub = app.add_subcommand(command.name, command.summary);
        sub->footer(footer(command));
        options.push_back(std::make_unique<Options>(*sub));
        command.declare(*options.back());
        apps.push_back(sub);
        names.push_back(command.name);
    }

    // What does not exist is told here, with a suggestion; the rest is the parser's.
    const auto first =
        std::find_if(arguments.begin(), arguments.end(), [](const std::string& a) { return a.empty() || a[0] != '-'; });
    const std::vector<std::string> general{"--help", "-h", "--version"};
    for (auto it = arguments.begin(); it != first; ++it)
        if (std::find(general.begin(), general.end(), *it) == general.end()) throw unknownName("option", *it, general);
    const std::size_t chosen = first == arguments.end()
                                   ? commands.size()
                                   : std::size_t(std::find(names.begin(), names.end(), *first) - names.begin());
    if (first != arguments.end() && chosen == commands.size()) throw unknownName("command", *first, names);
    if (chosen < commands.size()) options[chosen]->checkArguments({first + 1, arguments.end()}, commands[chosen].name);
    try {
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::CallForHelp&) {
        printResult(chosen < commands.size() ? apps[chosen]->help("ombrage") : app.help());
        return 0;
    } catch (const CLI::CallForVersion&) {
        printResult("ombrage " + std::string(versionString()) + "\n");
        return 0;
    } catch (const CLI::ParseError& e) {
        throw Error(ErrorCode::Usage, e.what(),
                    chosen < commands.size() ? "'ombrage " + commands[chosen].name + " --help' shows the options" : "");
    }
    if (chosen == commands.size()) {
        printMessage(app.help());
        return int(ErrorCode::Usage);
    }
    options[chosen]->refuseEmptyValues();
    options[chosen]->readState();
    const int code = commands[chosen].run(*options[chosen]);
    return interrupted() ? int(ErrorCode::Interrupted) : code;
}

}  // namespace

void printResult(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
        throw Error(ErrorCode::Environment, "cannot write to standard output", "is the disk full, or the pipe closed?");
}

void printMessage(const std::string& text) {
    Progress::clearLine();
    fmt::print(stderr, "{}\n", text);
}

const std::vector<std::string>& commandLine() {
    return g_commandLine;
}

std::string requiredText(const Options& options, const std::string& key, const std::string& what) {
    if (!options.has(key)) throw Error(ErrorCode::Usage, "no " + what, "--help shows how to name it");
    return options.text(key);
}

}  // namespace ombrage::cli

int main(int argc, char** argv) {
    using namespace ombrage;
    cli::g_commandLine.assign(argv, argv + argc);
    cli::g_commandLine.front() = "ombrage";
    cli::catchInterrupt();
    setLogSink([](LogLevel level, const std::string& message) {
        if (level == LogLevel::Warning) cli::printMessage("warning: " + message);
    });
    try {
        return cli::runCommandLine({argv + 1, argv + argc});
    } catch (const Error& error) {
        cli::printError(error);
        return int(error.code());
    } catch (const std::bad_alloc&) {
        cli::printError(
            Error(ErrorCode::Environment, "not enough memory", "ask for a smaller --size or a smaller scene"));
        return int(ErrorCode::Environment);
    } catch (const std::exception& error) {
        cli::printError(Error(ErrorCode::Environment, error.what()));
        return int(ErrorCode::Environment);
    }
}
