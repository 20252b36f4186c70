// SPDX-License-Identifier: MIT
// ombrage_bad_inputs [--program FILE] [--cuts N] [--data DIR] [--all]: runs the program on every bad input there is and
// prints a table. Exit code 1 when one crashes it, hangs, needs too much memory, is refused without its name, or gives
// a picture with NaN.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <map>
#include <random>
#include <thread>

#include <fmt/format.h>
#include <ombrage/error.h>
#include <ombrage/image.h>
#include <nlohmann/json.hpp>

#include "good_files.h"
#include "odd_files.h"
#include "program_run.h"

namespace ombrage::bad_inputs {
namespace {

namespace fs = std::filesystem;

constexpr double kLongest_s = 10, kMostMemory_MiB = 2048;

/// One input and what is done with it.
struct Case {
    std::string group, name;
    fs::path file;
    std::vector<std::string> extra;  ///< options; with some, "render" is used, else "reference", which needs no OpenGL
    bool mustLoad = false;
    std::size_t cutLength = 0;  ///< of `good`: cut in a folder of its own, with links to its neighbours
    GoodFile good;
};

struct Outcome {
    Run run;
    std::string verdict;  ///< "picture", "refused", or what is wrong in capitals
    bool bad = false;
    std::string firstLine;
};

bool allFinite(const Image& image) {
    for (int plane = 0; plane < image.planeCount(); ++plane)
        for (const float value : image.plane(plane))
            if (!std::isfinite(value)) return false;
    return true;
}

std::string firstError(const std::string& messages) {
    const std::size_t start = messages.find("ombrage: ");
    const std::string from = start == std::string::npos ? messages : messages.substr(start + 9);
    return from.substr(0, from.find('\n'));
}

void judge(const Case& test, const fs::path& file, const fs::path& picture, Outcome& outcome) {
    const Run& run = outcome.run;
    const auto wrong = [&](const std::string& verdict) {
        outcome.verdict = verdict;
        outcome.bad = true;
    };
    outcome.firstLine = firstError(run.messages);
    if (run.hung || run.time_s > kLongest_s) return wrong("HANGS");
    if (run.signal != 0) return wrong("CRASH, signal " + std::to_string(run.signal));
    if (run.memory_MiB > kMostMemory_MiB) return wrong("MEMORY");
    if (run.code == 3) {
        outcome.verdict = "refused";
        if (test.mustLoad) return wrong("REFUSED, but can be read");
        // The name, in the message or in the place.
        if (run.messages.find(file.filename().string()) == std::string::npos) return wrong("REFUSED WITHOUT NAME");
        return;
    }
    if (run.code != 0) return wrong("EXIT CODE " + std::to_string(run.code));
    outcome.verdict = "picture";
    try {
        if (!allFinite(readImage(picture))) wrong("NAN IN THE PICTURE");
    } catch (const Error& error) {
        wrong("NO PICTURE");
    }
}

Outcome tryCase(const Case& test, const std::string& program, const fs::path& work) {
    fs::create_directories(work);
    fs::path file = test.file;
    if (!test.good.cut.empty()) {
        // The file cut short; its neighbours as they are.
        const fs::path folder = work / "cut";
        fs::create_directories(folder);
        for (const auto& entry : fs::directory_iterator(test.good.folder))
            if (entry.path().filename() != test.good.cut)
                fs::create_symlink(fs::absolute(entry.path()), folder / entry.path().filename());
        writeFile(folder / test.good.cut, readFile(test.good.folder / test.good.cut).substr(0, test.cutLength));
        file = folder / test.good.opened;
    }
    const fs::path picture = work / "picture.exr";
    std::vector<std::string> command{program};
    if (test.extra.empty())
        command.insert(command.end(), {"reference", file.string(), "-o", picture.string(), "--quantity", "picture",
                                       "--spp", "1", "--size", "24x16"});
    else
        command.insert(command.end(), {"render", file.string(), "-o", picture.string(), "--size", "48x32"});
    command.insert(command.end(), test.extra.begin(), test.extra.end());
    if (!test.good.cut.empty()) command.push_back("--allow-outside");  // its neighbours are links
    Outcome outcome;
    outcome.run = run(command, work, kLongest_s + 5);
    judge(test, file, picture, outcome);
    std::error_code ignored;
    fs::remove_all(work, ignored);
    return outcome;
}

void addCuts(std::vector<Case>& cases, const std::vector<GoodFile>& files, int count) {
    std::mt19937 random(1);
    for (const GoodFile& good : files) {
        const std::string content = readFile(good.folder / good.cut);
        for (int i = 0; i < count; ++i) {
            const std::size_t length = random() % content.size();
            cases.push_back({"cut " + good.kind,
                             std::to_string(length) + " of " + std::to_string(content.size()),
                             {},
                             {},
                             false,
                             length,
                             good});
        }
        // The whole file must read, or the cuts prove nothing.
        cases.push_back({"cut " + good.kind, "whole", {}, {}, true, content.size(), good});
    }
}

void addTree(std::vector<Case>& cases, const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files)
        cases.push_back({"malformed", fs::relative(file, folder).string(), file, {}, false, 0, {}});
}

/// Every technique there is, as options of "render".
std::vector<std::vector<std::string>> everyTechnique(const std::string& program, const fs::path& work) {
    const fs::path list = work / "techniques.json";
    const std::string command = "'" + program + "' list techniques --json > '" + list.string() + "'";
    if (std::system(command.c_str()) != 0) return {};
    std::vector<std::vector<std::string>> options;
    const auto json = nlohmann::json::parse(readFile(list));
    for (const auto& technique : json.at("techniques")) {
        const std::string id = technique.at("id");
        // Models get a sun, which some techniques refuse.
        if (technique.contains("domain")) {
            const auto& lights = technique["domain"].at("lights");
            if (std::find(lights.begin(), lights.end(), "sun") == lights.end()) continue;
        }
        options.push_back({"--" + id.substr(0, id.find('/')), id});
    }
    return options;
}

void addDegenerate(std::vector<Case>& cases, const fs::path& folder,
                   const std::vector<std::vector<std::string>>& techniques) {
    for (const OddFile& odd : writeDegenerateFiles(folder)) {
        const std::string name = odd.path.filename().string();
        cases.push_back({"degenerate", name + " truth", odd.path, {}, odd.mustLoad, 0, {}});
        for (const auto& options : techniques)
            cases.push_back({"degenerate", name + " " + options[1], odd.path, options, odd.mustLoad, 0, {}});
    }
}

/// Files that a terminal shows as they are may hold anything.
std::string printable(std::string text, std::size_t width) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126) c = '?';
    return text.size() > width ? text.substr(0, width - 3) + "..." : text;
}

struct Options {
    std::string program = OMBRAGE_PROGRAM;
    std::string data;
    int cuts = 200;
    bool all = false;
};

Options parse(int argc, char** argv) {
    Options options;
    if (const char* data = std::getenv("OMBRAGE_DATA")) options.data = data;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const bool hasValue = i + 1 < argc;
        if (argument == "--all")
            options.all = true;
        else if (argument == "--program" && hasValue)
            options.program = argv[++i];
        else if (argument == "--data" && hasValue)
            options.data = argv[++i];
        else if (argument == "--cuts" && hasValue)
            options.cuts = std::atoi(argv[++i]);
        else
            throw Error(ErrorCode::Usage, "usage: ombrage_bad_inputs [--program FILE] [--cuts N] [--data DIR] [--all]");
    }
    return options;
}

void printRow(const Case& test, const Outcome& outcome) {
    fmt::print("{:<44} {:<18} {:>3} {:>6.0f} ms {:>5.0f} MiB  {}\n", printable(test.group + ": " + test.name, 44),
               outcome.verdict, outcome.run.code, outcome.run.time_s * 1000, outcome.run.memory_MiB,
               printable(outcome.firstLine, 110));
}

int main(int argc, char** argv) {
    const Options options = parse(argc, argv);
    ::setenv("OMBRAGE_CACHE", "off", 1);
    std::string pattern = (fs::temp_directory_path() / "ombrage-bad-XXXXXX").string();
    const fs::path work = ::mkdtemp(pattern.data());

    std::vector<Case> cases;
    if (!options.data.empty() && fs::exists(fs::path(options.data) / "malformed"))
        addTree(cases, fs::path(options.data) / "malformed");
    for (const OddFile& odd : writeOddFiles(work / "files"))
        cases.push_back({odd.path.parent_path().filename().string(),
                         odd.path.filename().string(),
                         odd.path,
                         {},
                         odd.mustLoad,
                         {},
                         {}});
    addDegenerate(cases, work / "degenerate", everyTechnique(options.program, work));
    addCuts(cases, writeGoodFiles(work / "good"), options.cuts);
    if (!options.data.empty()) addCuts(cases, realFiles(options.data), options.cuts);

    std::vector<Outcome> outcomes(cases.size());
    std::atomic<std::size_t> next = 0;
    std::vector<std::thread> workers;
    for (unsigned w = 0; w < std::max(1u, std::thread::hardware_concurrency()); ++w)
        workers.emplace_back([&, w] {
            for (std::size_t i = next++; i < cases.size(); i = next++)
                outcomes[i] = tryCase(cases[i], options.program, work / ("run" + std::to_string(w)));
        });
    for (std::thread& worker : workers) worker.join();
    std::error_code ignored;
    fs::remove_all(work, ignored);

    // Single rows for what somebody made by hand and for all that went wrong; one row for all cuts of a file.
    struct Total {
        int tried = 0, pictures = 0, refused = 0, bad = 0;
        double longest_s = 0, memory_MiB = 0;
    };
    std::map<std::string, Total> totals;
    Total sum;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Outcome& outcome = outcomes[i];
        const bool single = cases[i].good.cut.empty() && cases[i].group != "degenerate";
        if (single || outcome.bad || options.all) printRow(cases[i], outcome);
        for (Total* total : {&totals[cases[i].group], &sum}) {
            ++total->tried;
            total->pictures += !outcome.bad && outcome.verdict == "picture";
            total->refused += !outcome.bad && outcome.verdict == "refused";
            total->bad += outcome.bad;
            total->longest_s = std::max(total->longest_s, outcome.run.time_s);
            total->memory_MiB = std::max(total->memory_MiB, outcome.run.memory_MiB);
        }
    }
    fmt::print("\n{:<32} {:>6} {:>9} {:>8} {:>5} {:>12} {:>12}\n", "group", "tried", "pictures", "refused", "bad",
               "longest", "most memory");
    totals["total"] = sum;
    for (const auto& [name, t] : totals)
        fmt::print("{:<32} {:>6} {:>9} {:>8} {:>5} {:>9.0f} ms {:>8.0f} MiB\n", name, t.tried, t.pictures, t.refused,
                   t.bad, t.longest_s * 1000, t.memory_MiB);
    return sum.bad > 0 ? 1 : 0;
}

}  // namespace
}  // namespace ombrage::bad_inputs

int main(int argc, char** argv) {
    try {
        return ombrage::bad_inputs::main(argc, argv);
    } catch (const std::exception& error) {
        fmt::print(stderr, "ombrage_bad_inputs: {}\n", error.what());
        return 2;
    }
}
