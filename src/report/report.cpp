// SPDX-License-Identifier: MIT
#include <ombrage/compare.h>
#include <ombrage/error.h>
#include <map>
#include <nlohmann/json.hpp>

#include "core/whole_file.h"
#include "lab/run_record.h"
#include "lab/store.h"
#include "report/crops.h"
#include "report/page.h"
#include "report/record_groups.h"

namespace ombrage {

namespace {

/// A report is to be at most 8 MB; what is left beside the pictures holds the tables and the raw records.
constexpr std::size_t kPictureBudget = 6'500'000;
/// Of it, what all crops together may take.
constexpr std::size_t kCropBudget = 1'500'000;

/// What the folder's store holds, or its JSON lines where it has none.
struct Stored {
    std::vector<std::string> records, notes, benches;
    std::string recordsFile, notesFile;  ///< for messages
};

Stored readFolder(const std::filesystem::path& folder) {
    if (const auto store = ResultStore::openForReading(folder)) {
        const std::string file = ResultStore::fileIn(folder).string();
        return {store->records(kCompareKind), store->notes(), store->records(kBenchKind), file + ": record ",
                file + ": note "};
    }
    return {readLines(folder / kRecordsFile),
            readLines(folder / kRunsFile),
            {},
            (folder / kRecordsFile).string() + ":",
            (folder / kRunsFile).string() + ":"};
}

/// A run that was done again takes the place of the earlier one.
std::vector<RunRecord> recordsOf(const Stored& stored) {
    std::vector<RunRecord> records;
    std::map<std::string, std::size_t> places;
    int line = 0;
    for (const std::string& text : stored.records) {
        RunRecord record = RunRecord::fromJson(text, stored.recordsFile + std::to_string(++line));
        const auto [place, isNew] = places.emplace(identityOf(record), records.size());
        if (isNew)
            records.push_back(std::move(record));
        else
            records[place->second] = std::move(record);
    }
    return records;
}

/// Of the same techniques measured again, by another build of the program perhaps, the later ones.
std::vector<std::string> benchesOf(const Stored& stored, const std::filesystem::path& folder) {
    std::vector<std::string> benches;
    std::map<std::string, std::size_t> places;
    for (const std::string& text : stored.benches) {
        const auto group = nlohmann::json::parse(text, nullptr, false);
        if (!group.is_object())
            throw Error(ErrorCode::Input, "a bench in '" + folder.string() + "' is not JSON", "measure it again");
        auto identity = nlohmann::json::array();
        for (const char* key : {"scene", "scene_hash", "camera", "light", "size", "axis", "value"})
            identity.push_back(group.value(key, nlohmann::json()));
        for (const auto& run : group.value("runs", nlohmann::json::array()))
            identity.push_back(run.is_object() ? run.value("label", nlohmann::json()) : nlohmann::json());
        const auto [place, isNew] = places.emplace(identity.dump(), benches.size());
        if (isNew)
            benches.push_back(text);
        else
            benches[place->second] = text;
    }
    return benches;
}

}  // namespace

std::filesystem::path writeReport(const std::filesystem::path& folder, const std::filesystem::path& output,
                                  ReportPictures size) {
    ReportData data;
    const Stored stored = readFolder(folder);
    data.records = recordsOf(stored);
    if (data.records.empty())
        throw Error(ErrorCode::Input, "there are no records in '" + folder.string() + "'",
                    stored.benches.empty() ? "a folder that 'ombrage compare -o DIR' wrote has some"
                                           : "it has benches, which stand in the report of a comparison: 'ombrage "
                                             "compare' into the same folder makes one");
    int line = 0;
    for (const std::string& text : stored.notes)
        data.notes.push_back(RunNote::fromJson(text, stored.notesFile + std::to_string(++line)));
    data.benchGroups = benchesOf(stored, folder);

    const PictureFiles pictures(folder, data.records);
    data.missingPictures = pictures.missing();
    std::size_t cropsLeft = kCropBudget;
    for (const RecordGroup& group : groupRecords(data.records))
        data.crops.push_back(cropFigures(pictures, group, cropsLeft));
    data.previews = size == ReportPictures::Full ? fullPreviews(pictures)
                                                 : makePreviews(pictures, kPictureBudget - (kCropBudget - cropsLeft));

    const std::filesystem::path file = output.empty() ? folder / "report.html" : output;
    writeWhole(file, reportPage(data));
    return file;
}

}  // namespace ombrage
