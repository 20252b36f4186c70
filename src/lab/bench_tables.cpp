// SPDX-License-Identifier: MIT
// What a bench says to people and to spreadsheets.
#include <ombrage/bench.h>
#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "core/strings.h"
#include "lab/bench_json.h"
#include "lab/bench_plan.h"
#include "lab/log_plot.h"
#include "lab/pictures.h"

namespace ombrage {

namespace {

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
}

std::string sayDifference(const std::optional<BenchDifference>& d) {
    if (!d) return "–";
    return fmt::format("{}: {:+.1f} % [{:+.1f}, {:+.1f}]", d->verdict, 100 * d->change, 100 * d->low, 100 * d->high);
}

std::string titleOf(const BenchGroup& group) {
    std::string title = fmt::format("{}, camera {}", group.scene, group.camera);
    if (!group.light.empty()) title += ", light " + group.light;
    title += fmt::format(", {}x{}, {} frames", group.width, group.height,
                         group.runs.empty() ? 0 : group.runs.front().gpu_ms.samples.size());
    if (!group.axis.empty()) title += fmt::format(", {} {}", group.axis, group.value);
    return title;
}

/// In a cell of a table a bar would end the cell.
std::string cell(const std::string& text) {
    std::string result;
    for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
    return result;
}

/// The points of a sweep on one scene, a curve for each pipeline.
struct Sweep {
    std::string scene, axis;
    std::vector<std::string> values;
    std::vector<Curve> curves;
    std::map<std::string, std::set<std::string>> pipelines;  ///< by the name of their curve
    bool isNumeric = true;                                   ///< every value is a positive number: it has a logarithm
};

std::map<std::string, Sweep> sweepsOf(const BenchResult& result) {
    std::map<std::string, Sweep> sweeps;
    for (const BenchGroup& group : result.groups) {
        if (group.axis.empty()) continue;
        Sweep& sweep = sweeps[fileSlug(group.axis) + "-" + fileSlug(group.scene)];
        sweep.scene = group.scene;
        sweep.axis = group.axis;
        sweep.values.push_back(group.value);
        double number = 0;
        sweep.isNumeric = sweep.isNumeric && parseDouble(group.value, number) && number > 0;
        for (const BenchRun& run : group.runs) {
            auto curve = std::find_if(sweep.curves.begin(), sweep.curves.end(),
                                      [&](const Curve& known) { return known.name == run.label; });
            if (curve == sweep.curves.end()) curve = sweep.curves.insert(curve, {run.label, {}, {}});
            sweep.pipelines[run.label].insert(run.pipeline);
            curve->x.push_back(group.x);
            // What takes no measurable time still has a place on the paper.
            curve->y.push_back(std::max(decidingFigures(result, run).median, 1e-4));
        }
    }
    return sweeps;
}

/// Nothing grows in a pipeline that does not have the parameter, whatever its times do.
std::string growthText(const Sweep& sweep, const Curve& curve) {
    const bool isOfScene = sweep.axis == kSizeAxis || sweep.axis == kTrianglesAxis || sweep.axis == kLightsAxis;
    const bool varies = isOfScene || sweep.pipelines.at(curve.name).size() > 1;
    if (!sweep.isNumeric || curve.x.size() < 2 || !varies) return "–";
    return fmt::format("x^{:.2f}", fittedExponent(curve.x, curve.y));
}

std::string passTable(const BenchGroup& group) {
    std::string text =
        "| technique | pass | median | p95 | MAD | draws | triangles | MiB of images "
        "|\n|---|---|--:|--:|--:|--:|--:|--:|\n";
    for (const BenchRun& run : group.runs)
        for (const BenchPass& pass : run.passes)
            text += fmt::format("| {} | {} | {:.3f} | {:.3f} | {:.3f} | {} | {} | {:.1f} |\n", cell(run.label),
                                cell(pass.name), pass.gpu_ms.median, pass.gpu_ms.p95, pass.gpu_ms.mad, pass.draws,
                                pass.triangles, double(pass.bytes) / (1024 * 1024));
    return text;
}

}  // namespace

std::string BenchResult::csv() const {
    std::string text =
        "scene,camera,light,width,height,axis,value,x,technique,pipeline,clock,gpu_ms,gpu_p95_ms,gpu_mad_ms,process_ms,"
        "process_p95_ms,process_mad_ms,cpu_ms,draws,triangles,gpu_bytes,change,change_low,change_high,verdict\n";
    for (const BenchGroup& g : groups)
        for (const BenchRun& r : g.runs) {
            text += fmt::format(
                "{},{},{},{},{},{},{},{},{},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{},{},{}",
                quoted(g.scene), quoted(g.camera), quoted(g.light), g.width, g.height, quoted(g.axis), quoted(g.value),
                g.x, quoted(r.label), quoted(r.pipeline), device.clock, r.gpu_ms.median, r.gpu_ms.p95, r.gpu_ms.mad,
                r.process_ms.median, r.process_ms.p95, r.process_ms.mad, r.cpu_ms.median, r.draws, r.triangles,
                r.gpuBytes);
            if (r.toFirst)
                text += fmt::format(",{:.5f},{:.5f},{:.5f},{}\n", r.toFirst->change, r.toFirst->low, r.toFirst->high,
                                    r.toFirst->verdict);
            else
                text += ",,,,\n";
        }
    return text;
}

std::string BenchResult::markdown() const {
    const bool byProcess = decidedBy == "process_ms";
    std::string text = fmt::format(
        "Device: {}{}. Frames by the {} clock; at least {} rounds by turns, frames in each: {}. Differences are of {}, "
        "with "
        "99 % "
        "intervals.\n",
        device.renderer, device.software ? " (software: these are not a GPU's times)" : "", device.clock, rounds,
        framesPerRound, byProcess ? "the processor time of the whole process" : "the GPU time");
    for (const BenchGroup& group : groups) {
        const bool hasBaseline = std::any_of(group.runs.begin(), group.runs.end(),
                                             [](const BenchRun& run) { return run.toBaseline.has_value(); });
        text += fmt::format(
            "\n### {}\n\n| technique | frame, ms | p95 | MAD | process, ms | p95 | MAD | CPU, ms | draws | triangles | "
            "MiB | against the first |{}\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|---|{}\n",
            titleOf(group), hasBaseline ? " against the baseline |" : "", hasBaseline ? "---|" : "");
        for (const BenchRun& r : group.runs)
            text += fmt::format(
                "| {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {} | {} | {:.1f} | {} |{}\n",
                cell(r.label), r.gpu_ms.median, r.gpu_ms.p95, r.gpu_ms.mad, r.process_ms.median, r.process_ms.p95,
                r.process_ms.mad, r.cpu_ms.median, r.draws, r.triangles, double(r.gpuBytes) / (1024 * 1024),
                sayDifference(r.toFirst), hasBaseline ? " " + sayDifference(r.toBaseline) + " |" : "");
        text += fmt::format("\nPasses, timed apart, ms by the {} clock:\n\n{}", device.clock, passTable(group));
    }
    for (const auto& [name, sweep] : sweepsOf(*this)) {
        text += fmt::format("\n### Growth of {} with {}\n\n| technique |", sweep.scene, sweep.axis);
        std::string rule = "|---|";
        for (const std::string& value : sweep.values) {
            text += " " + cell(value) + " |";
            rule += "--:|";
        }
        text += " cost grows as |\n" + rule + "---|\n";
        for (const Curve& curve : sweep.curves) {
            text += "| " + cell(curve.name) + " |";
            for (const double cost : curve.y) text += fmt::format(" {:.3f} |", cost);
            text += " " + growthText(sweep, curve) + " |\n";
        }
    }
    return text;
}

std::map<std::string, std::string> BenchResult::plots() const {
    std::map<std::string, std::string> pictures;
    for (auto& [name, sweep] : sweepsOf(*this)) {
        if (!sweep.isNumeric || sweep.values.size() < 2) continue;
        std::vector<Curve> curves = sweep.curves;
        for (Curve& curve : curves) curve.name += "  " + growthText(sweep, curve);
        pictures["bench-" + name + ".svg"] = logPlot("Frame of " + sweep.scene + " against " + sweep.axis, sweep.axis,
                                                     decidedBy == "process_ms" ? "ms of processor time" : "ms", curves);
    }
    return pictures;
}

}  // namespace ombrage
