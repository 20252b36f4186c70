// SPDX-License-Identifier: MIT
#include <ombrage/compare.h>
#include <ombrage/error.h>
#include <algorithm>
#include <fstream>
#include <tuple>

#include "report/page.h"

namespace ombrage {

namespace {

/// A report is to be at most 8 MB; what is left beside the pictures holds the tables and the raw records.
constexpr std::size_t kPictureBudget = 7'000'000;

auto identity(const RunRecord& r) {
    return std::tuple(std::tie(r.scene, r.sceneHash, r.camera, r.light, r.width, r.height, r.seed, r.pipeline),
                      r.truth ? r.truth->kind : std::string());
}

/// A run that was done again takes the place of the earlier one.
std::vector<RunRecord> readRecords(const std::filesystem::path& folder) {
    std::vector<RunRecord> records;
    int line = 0;
    for (const std::string& text : readLines(folder / kRecordsFile)) {
        RunRecord record = RunRecord::fromJson(text, (folder / kRecordsFile).string() + ":" + std::to_string(++line));
        const auto same = std::find_if(records.begin(), records.end(),
                                       [&](const RunRecord& other) { return identity(other) == identity(record); });
        if (same == records.end())
            records.push_back(std::move(record));
        else
            *same = std::move(record);
    }
    return records;
}

}  // namespace

std::filesystem::path writeReport(const std::filesystem::path& folder, const std::filesystem::path& output) {
    ReportData data;
    data.records = readRecords(folder);
    if (data.records.empty())
        throw Error(ErrorCode::Input, "there are no records in '" + folder.string() + "'",
                    "a folder that 'ombrage compare -o DIR' wrote has a " + std::string(kRecordsFile));
    int line = 0;
    for (const std::string& text : readLines(folder / kRunsFile))
        data.notes.push_back(RunNote::fromJson(text, (folder / kRunsFile).string() + ":" + std::to_string(++line)));
    data.previews = makePreviews(folder, data.records, kPictureBudget);

    const std::filesystem::path file = output.empty() ? folder / "report.html" : output;
    const std::string page = reportPage(data);
    std::ofstream out(file, std::ios::binary);
    out.write(page.data(), std::streamsize(page.size()));
    out.close();
    if (!out)
        throw Error(ErrorCode::Environment, "cannot write the report '" + file.string() + "'",
                    "check that its folder exists and the disk has space", file.string());
    return file;
}

}  // namespace ombrage
