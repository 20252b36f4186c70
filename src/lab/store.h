// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lab/result_key.h"
#include "lab/sqlite.h"

namespace ombrage {

/// @throws Error(Environment) when the folder of results is not there and cannot be made.
void makeResultFolder(const std::filesystem::path& folder);

/// What has been measured into a folder: DIR/results.sqlite, in write-ahead mode. It is the authority; records.jsonl
/// and runs.jsonl beside it are exports. Each result is one transaction, so a process killed at any moment loses what
/// it was measuring and nothing else, and several processes may share a folder. One object per thread.
///
/// Every member throws Error(Input) for a damaged, foreign or newer file, and Error(Environment) for a full disk,
/// missing permissions and a process that does not give way.
class ResultStore {
public:
    /// Opens the folder's store or makes it. What records.jsonl and runs.jsonl hold when there is none becomes its
    /// first content; it is shown, and never taken for a result that is asked for.
    explicit ResultStore(const std::filesystem::path& folder);

    /// For reading only, also in folders that cannot be written. Nothing when the folder has no store.
    static std::optional<ResultStore> openForReading(const std::filesystem::path& folder);

    static std::filesystem::path fileIn(const std::filesystem::path& folder);

    /// The record of a result that is there with all of its pictures, whole as they were written.
    std::optional<std::string> find(const ResultKey& key) const;

    /// Adds a result, or puts it in the place of the one with this key.
    /// @param pictures paths relative to the folder, of files that are written
    void put(const ResultKey& key, const std::string& record, const std::vector<std::string>& pictures);

    /// All records of a kind in the order in which they were first added.
    std::vector<std::string> records(const std::string& kind) const;

    /// What is to be told of a call of the program. It takes the place of what an earlier call of that name told.
    void note(const std::string& call, const std::string& text);
    /// The latest call last.
    std::vector<std::string> notes() const;

    /// Forgets everything. Pictures stay where they are.
    void clear();

    /// Writes the comparisons' records to records.jsonl, the benches' and the searches', where there are any,
    /// to bench.jsonl and tune.jsonl, and the notes to runs.jsonl, each in one step. Nobody writes meanwhile, so that
    /// an export never lacks what another process has already shown.
    void exportLines() const;

private:
    ResultStore(const std::filesystem::path& folder, sqlite::Access access);
    void importLines();
    /// @throws Error(Environment) when the file is no longer where it was: what is written now would be lost.
    void requireFile() const;
    void insert(const ResultKey& key, const std::string& record, const std::vector<std::string>& pictures);
    void insertNote(const std::string& call, const std::string& text);

    std::filesystem::path m_folder;
    sqlite::Database m_database;
    std::pair<std::uint64_t, std::uint64_t> m_identity;  ///< of the file: its device and number there
};

/// Kind of a comparison's results: records of the schema ombrage/record/1.
inline constexpr const char* kCompareKind = "compare";
/// Kind of a bench's results: groups of the schema ombrage/bench/1.
inline constexpr const char* kBenchKind = "bench";
/// Kind of a search's results: records of the schema ombrage/record/1 without pictures.
inline constexpr const char* kTuneKind = "tune";

}  // namespace ombrage
