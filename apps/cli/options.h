// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <ombrage/renderer.h>

namespace CLI {
class App;
}

namespace ombrage::cli {

/// How often an option may stand on the command line, and whether it takes a value.
enum class Take { Flag, One, Many };

/// The options of one command as text, from the command line and from `--state FILE`. Everything is checked when it is
/// asked for, by the same rules wherever it came from.
class Options {
public:
    explicit Options(CLI::App& app) : m_app(app) {}

    /// Declares an option ("--size", or "-o,--output") or a positional ("scene").
    void add(const std::string& names, const std::string& help, Take take = Take::One);

    /// @throws Error(Usage) for an option that is given as "".
    void refuseEmptyValues() const;

    /// Adds what the state file says where the command line says nothing. @throws Error(Input) for unreadable files,
    /// Error(Usage) for keys that this command does not have.
    void readState();

    bool has(const std::string& key) const;
    bool flag(const std::string& key) const { return has(key); }
    std::string text(const std::string& key, const std::string& otherwise = {}) const;
    std::vector<std::string> texts(const std::string& key) const;
    /// @throws Error(Usage) stating the range.
    std::int64_t integer(const std::string& key, std::int64_t otherwise, std::int64_t minimum,
                         std::int64_t maximum) const;
    double number(const std::string& key, double otherwise, double minimum, double maximum) const;
    /// Index of the value among the choices. @throws Error(Usage) with a suggestion.
    std::size_t choice(const std::string& key, const std::vector<std::string>& choices, std::size_t otherwise) const;
    /// "X,Y,Z". @throws Error(Usage)
    std::optional<glm::dvec3> point(const std::string& key) const;

    /// Looks for options and positionals that do not exist, before the parser does: its messages know no suggestions.
    /// @param arguments  what stands behind the command
    /// @throws Error(Usage)
    void checkArguments(const std::vector<std::string>& arguments, const std::string& command) const;

private:
    struct Entry {
        Take take = Take::One;
        bool positional = false;
        bool flag = false;
        std::string shortName;   ///< "-o", or ""
        std::vector<std::string> values;
    };

    CLI::App& m_app;
    std::map<std::string, std::unique_ptr<Entry>> m_entries;  ///< by long name without dashes
    const Entry& entry(const std::string& key) const;
};

/// The whole text as a number, whatever the locale. @throws Error(Usage) naming `what`.
double parseNumber(const std::string& text, const std::string& what);

/// --size --camera --light --time --seed --state --shader-dir --device --ground --eye --target --allow-outside
void addSceneOptions(Options& options);
/// --shadow --ao --filter --indirect --aa --set --normals --shading --composite --ambient
void addRenderOptions(Options& options);

SceneOptions sceneOptions(const Options& options);
RendererOptions rendererOptions(const Options& options);
/// --normals
void addNormalsOption(Options& options);
NormalSource normalSource(const Options& options);
/// Size, camera, light, time and seed.
RenderSettings frameSettings(const Options& options);
/// Pipelines with their parameters, shading and composing as well.
RenderSettings renderSettings(const Options& options);

/// An id for examples and hints: the family's first technique beside its baseline.
std::string exampleId(Family family);

}  // namespace ombrage::cli
