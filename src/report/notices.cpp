// SPDX-License-Identifier: MIT
#include "report/notices.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <set>

#include "core/strings.h"
#include "report/html_text.h"
#include "report/record_groups.h"

namespace ombrage {

namespace {

/// Fewer frames than this say little about how times scatter.
constexpr std::size_t kFramesForTimes = 30;

std::string notice(const std::string& text) {
    return "<p class=\"notice\">" + escapeHtml(text) + "</p>\n";
}

std::string list(const std::set<std::string>& items) {
    return join({items.begin(), items.end()}, "; ");
}

std::string pictureNotices(const Previews& previews, const std::vector<std::string>& missing) {
    std::string html;
    if (!previews.leftOut.empty())
        html += notice("Too many pictures for one file: the kinds " + join(previews.leftOut, ", ") +
                       " are left out. All of them are in the folder images.");
    if (previews.shrunk)
        html +=
            notice(fmt::format("Pictures are shrunk to {} pixels of width so that this file stays below 8 MB; "
                               "the probe then reads means. 'ombrage report DIR --full' embeds them as they are.",
                               previews.width_px));
    if (!missing.empty())
        html += notice(fmt::format("{} picture(s) of the records could not be read, such as {}.", missing.size(),
                                   missing.front()));
    return html;
}

/// What the numbers of this report cannot carry.
std::string timeNotices(const std::vector<RunRecord>& records) {
    std::string html;
    if (std::any_of(records.begin(), records.end(), [](const RunRecord& r) { return r.device.software; }))
        html += notice("Times are those of a software renderer. They are not a GPU's, and their order may differ.");
    std::size_t fewest = kFramesForTimes;
    for (const RunRecord& r : records)
        if (!r.frames_ms.empty()) fewest = std::min(fewest, r.frames_ms.size());
    if (fewest < kFramesForTimes)
        html +=
            notice(fmt::format("Times are medians of {} frame{}, enough to rank what differs greatly. "
                               "'ombrage bench' measures differences and their intervals.",
                               fewest, fewest == 1 ? "" : "s"));
    return html;
}

/// Each warning once, with how many runs it is about.
std::string runWarnings(const std::vector<RunRecord>& records) {
    std::map<std::string, int> counts;
    for (const RunRecord& r : records)
        for (const std::string& warning : r.warnings) ++counts[warning];
    if (counts.empty()) return {};
    std::string html = "<div class=\"notice\"><p>Warnings of the runs:</p>\n<ul>\n";
    for (const auto& [warning, count] : counts)
        html += "<li>" + escapeHtml(warning) + fmt::format(" ({} run{})</li>\n", count, count == 1 ? "" : "s");
    return html + "</ul></div>\n";
}

}  // namespace

std::string notices(const ReportData& data) {
    std::string html;
    std::vector<std::string> gates;
    bool interrupted = false;
    for (const RunNote& note : data.notes) {
        for (const std::string& gate : note.failedGates)
            if (std::find(gates.begin(), gates.end(), gate) == gates.end()) gates.push_back(gate);
        interrupted = note.interrupted;
    }
    if (interrupted) html += notice("The last run was interrupted: some of what was asked for is missing.");
    if (!gates.empty()) {
        html += "<div class=\"notice bad\"><p>Gates that failed:</p>\n<ul>\n";
        for (const std::string& gate : gates) html += "<li>" + escapeHtml(gate) + "</li>\n";
        html += "</ul></div>\n";
    }
    return html + timeNotices(data.records) + pictureNotices(data.previews, data.missingPictures) +
           runWarnings(data.records);
}

std::string environment(const ReportData& data) {
    std::set<std::string> devices, versions, clocks, sizes, seeds;
    for (const RunRecord& r : data.records) {
        devices.insert(r.device.renderer + ", OpenGL " + r.device.version +
                       (r.device.software ? " (software: times are not a GPU's)" : ""));
        versions.insert(r.version);
        clocks.insert(r.clock);
        sizes.insert(fmt::format("{}x{}", r.width, r.height));
        seeds.insert(std::to_string(r.seed));
    }
    std::string html = "<section id=\"environment\">\n<h2>Where the numbers come from</h2>\n<dl class=\"facts\">\n";
    const auto fact = [&](const char* name, const std::set<std::string>& items) {
        html += std::string("<dt>") + name + "</dt><dd>" + escapeHtml(list(items)) + "</dd>\n";
    };
    fact("Device", devices);
    fact("Clock of the GPU times", clocks);
    fact("Picture size", sizes);
    fact("Seed", seeds);
    fact("Ombrage", versions);
    std::set<std::string> commands;
    for (const RunNote& note : data.notes) {
        std::vector<std::string> words;
        for (const std::string& word : note.command) words.push_back(shellQuoted(word));
        if (!words.empty() && commands.insert(join(words, " ")).second)
            html += "<dt>Command</dt><dd class=\"command\"><code>" + escapeHtml(join(words, " ")) +
                    "</code> <button type=\"button\" class=\"copy\">Copy</button></dd>\n";
    }
    return html +
           "</dl>\n<p><button type=\"button\" id=\"download\">Download the records (JSON)</button> They stand in this "
           "file too, in the script element \"records\".</p>\n</section>\n";
}

std::string skippedTable(const std::vector<RunNote>& notes) {
    std::vector<RunNote::Skipped> skipped;
    for (const RunNote& note : notes)
        for (const RunNote::Skipped& s : note.skipped)
            if (std::find(skipped.begin(), skipped.end(), s) == skipped.end()) skipped.push_back(s);
    if (skipped.empty()) return {};
    std::string html =
        "<section id=\"skipped\">\n<h2>Skipped</h2>\n<div class=\"wide\" tabindex=\"0\" role=\"region\" "
        "aria-label=\"Skipped\"><table><thead><tr><th scope=\"col\">scene</th><th scope=\"col\" "
        "class=\"text\">technique</th><th scope=\"col\" class=\"text\">reason</th></tr></thead><tbody>\n";
    for (const RunNote::Skipped& s : skipped)
        html += "<tr><td>" + escapeHtml(s.scene) + "</td><td class=\"text\"><code>" + escapeHtml(s.technique) +
                "</code></td><td class=\"text\">" + escapeHtml(s.reason) + "</td></tr>\n";
    return html + "</tbody></table></div>\n</section>\n";
}

}  // namespace ombrage
