// SPDX-License-Identifier: MIT
#include <ombrage/compare.h>

#include "commands.h"

namespace ombrage::cli {

namespace {

int runReport(const Options& options) {
    const std::string folder = requiredText(options, "dir", "folder with records");
    const ReportPictures pictures = options.flag("full") ? ReportPictures::Full : ReportPictures::Fitting;
    printResult(writeReport(folder, options.text("output"), pictures).string() + "\n");
    return 0;
}

}  // namespace

Command reportCommand() {
    return {"report",
            "Makes the report of a folder that compare wrote",
            {"out", "out -o summary.html", "out --full"},
            [](Options& options) {
                options.add("dir", "a folder with results.sqlite or records.jsonl");
                options.add("-o,--output", "FILE.html (DIR/report.html)");
                options.add("--full", "embed every picture as it is, however large the file becomes", Take::Flag);
            },
            runReport};
}

}  // namespace ombrage::cli
