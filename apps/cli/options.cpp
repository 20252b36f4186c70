// SPDX-License-Identifier: MIT
#include "options.h"

#include <ombrage/error.h>
#include <ombrage/json_lines.h>
#include <unistd.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "pipelines.h"
#include "progress.h"

namespace ombrage::cli {

namespace {

std::string shortest(double value) {
    char buffer[64];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

std::vector<std::string> splitAt(const std::string& text, char separator) {
    std::vector<std::string> parts(1);
    for (char c : text)
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

/// A value of a state file in the form of the command line; arrays of numbers take the separator of their option.
std::string stateText(const nlohmann::json& value, const std::string& key, const std::string& where) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_integer()) return value.dump();
    if (value.is_number()) return shortest(value.get<double>());
    if (value.is_array()) {
        std::string text;
        for (const auto& element : value)
            text += (text.empty() ? "" : key == "size" ? "x" : ",") + stateText(element, key, where);
        return text;
    }
    throw Error(ErrorCode::Usage, "the state's \"" + key + "\" is neither text nor a number",
                "write it as on the command line", where);
}

/// Refuses a picture that this machine has no memory for: the system would end the program halfway, and others with it.
void requireMemory(int width, int height) {
    // Measured: 98 bytes a pixel for a render with software OpenGL at 8192 x 8192.
    constexpr double kBytesPerPixel = 100, kGiB = 1024.0 * 1024 * 1024;
    const double needed_GiB = double(width) * double(height) * kBytesPerPixel / kGiB;
    double available_GiB = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE)) / kGiB;
    std::ifstream info("/proc/meminfo");
    for (std::string key, unit, value; info >> key >> value && std::getline(info, unit);)
        if (key == "MemAvailable:") available_GiB = parseNumber(value, key) / (1024.0 * 1024);
    if (needed_GiB <= available_GiB) return;
    const auto rounded = [](double gib) { return shortest(std::round(gib * 10) / 10) + " GiB"; };
    throw Error(ErrorCode::Environment,
                "a picture of " + std::to_string(width) + " x " + std::to_string(height) + " needs about " +
                    rounded(needed_GiB) + " of memory, and " + rounded(available_GiB) + " are free",
                "ask for a smaller --size");
}

}  // namespace

double parseNumber(const std::string& text, const std::string& what) {
    double value = 0;
    const char* begin = text.data() + (text.size() > 1 && text[0] == '+' ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        throw Error(ErrorCode::Usage, what + ": '" + text + "' is not a number",
                    "write it with a decimal point, as in 0.5");
    return value;
}

void Options::add(const std::string& names, const std::string& help, Take take) {
    auto made = std::make_unique<Entry>();
    made->take = take;
    made->positional = names[0] != '-';
    const std::size_t dashes = names.rfind("--");
    const std::string key = made->positional ? names : names.substr(dashes + 2);
    if (!made->positional && dashes > 0) made->shortName = names.substr(0, dashes - 1);
    if (take == Take::Flag) {
        m_app.add_flag(names, made->flag, help);
    } else {
        // One value an occurrence, so that "--set a=1 SCENE" does not swallow the scene.
        Entry* target = made.get();
        CLI::Option* option = take == Take::Many
                                  ? m_app.add_option(names, target->values, help)
                                  : m_app.add_option_function<std::string>(
                                        names, [target](const std::string& value) { target->values = {value}; }, help);
        if (take == Take::Many && made->positional) option->expected(-1);
        if (take == Take::Many && !made->positional)
            option->expected(1)->allow_extra_args(false)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
        option->type_name(made->positional ? "" : "TEXT");
    }
    m_entries.emplace(key, std::move(made));
}

const Options::Entry& Options::entry(const std::string& key) const {
    return *m_entries.at(key);
}

bool Options::has(const std::string& key) const {
    const auto found = m_entries.find(key);
    return found != m_entries.end() && (found->second->flag || !found->second->values.empty());
}

std::string Options::text(const std::string& key, const std::string& otherwise) const {
    return has(key) ? entry(key).values.front() : otherwise;
}

std::vector<std::string> Options::texts(const std::string& key) const {
    return has(key) ? entry(key).values : std::vector<std::string>{};
}

std::int64_t Options::integer(const std::string& key, std::int64_t otherwise, std::int64_t minimum,
                              std::int64_t maximum) const {
    if (!has(key)) return otherwise;
    const std::string value = text(key);
    std::int64_t result = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), result);
    const bool whole = error == std::errc() && end == value.data() + value.size();
    if (!whole || result < minimum || result > maximum)
        throw Error(ErrorCode::Usage, "--" + key + ": '" + value + "' is not a whole number from " +
                                          std::to_string(minimum) + " to " + std::to_string(maximum));
    return result;
}

double Options::number(const std::string& key, double otherwise, double minimum, double maximum) const {
    if (!has(key)) return otherwise;
    const double value = parseNumber(text(key), "--" + key);
    if (value < minimum || value > maximum)
        throw Error(ErrorCode::Usage,
                    "--" + key + ": " + text(key) + " is not from " + shortest(minimum) + " to " + shortest(maximum));
    return value;
}

std::size_t Options::choice(const std::string& key, const std::vector<std::string>& choices,
                            std::size_t otherwise) const {
    if (!has(key)) return otherwise;
    const auto found = std::find(choices.begin(), choices.end(), text(key));
    if (found == choices.end()) throw unknownName("value of --" + key, text(key), choices);
    return std::size_t(found - choices.begin());
}

std::optional<glm::dvec3> Options::point(const std::string& key) const {
    if (!has(key)) return {};
    const std::vector<std::string> parts = splitAt(text(key), ',');
    if (parts.size() != 3)
        throw Error(ErrorCode::Usage, "--" + key + ": '" + text(key) + "' is not a point", "write it as X,Y,Z");
    return glm::dvec3(parseNumber(parts[0], "--" + key), parseNumber(parts[1], "--" + key),
                      parseNumber(parts[2], "--" + key));
}

void Options::checkArguments(const std::vector<std::string>& arguments, const std::string& command) const {
    const std::string hint = "'ombrage " + command + " --help' shows what it takes";
    std::vector<std::string> names{"--help"};
    std::size_t room = 0, positionals = 0;
    for (const auto& [key, entry] : m_entries) {
        if (!entry->positional) names.push_back("--" + key);
        if (entry->positional) room += entry->take == Take::Many ? arguments.size() : 1;
    }
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& argument = arguments[i];
        if (argument.size() < 2 || argument[0] != '-') {
            if (++positionals > room)
                throw Error(ErrorCode::Usage, "'" + argument + "' is one argument too many", hint);
            continue;
        }
        if (argument == "--help" || argument == "-h") return;
        if (argument == "--") return;
        const std::size_t equals = argument.find('=');
        const std::string name = argument.substr(0, equals);
        const auto found = std::find_if(m_entries.begin(), m_entries.end(), [&](const auto& pair) {
            const Entry& e = *pair.second;
            return !e.positional &&
                   (name == "--" + pair.first || (!e.shortName.empty() && argument.rfind(e.shortName, 0) == 0));
        });
        if (found == m_entries.end()) {
            const Error unknown = unknownName("option", name, names);
            throw Error(ErrorCode::Usage, unknown.message(), nearestName(name, names).empty() ? hint : unknown.hint());
        }
        // The value is the next argument, whatever it looks like.
        const Entry& option = *found->second;
        const bool attached =
            equals != std::string::npos || (name != "--" + found->first && argument.size() > option.shortName.size());
        if (option.take == Take::Flag || attached) continue;
        if (++i == arguments.size()) throw Error(ErrorCode::Usage, name + " needs a value", hint);
    }
}

void Options::refuseEmptyValues() const {
    for (const auto& [key, given] : m_entries)
        for (const std::string& value : given->values)
            if (value.empty())
                throw Error(ErrorCode::Usage, (given->positional ? key : "--" + key) + " is given an empty text",
                            "leave it out for its default");
}

void Options::readState() {
    if (!has("state")) return;
    const std::string file = text("state");
    std::error_code failed;
    std::ifstream in;
    // A pipe would make the reading wait for ever, a device may have no end.
    if (std::filesystem::is_regular_file(file, failed)) in.open(file, std::ios::binary);
    if (!in.is_open() || !in) throw Error(ErrorCode::Input, "cannot read the state file '" + file + "'", "", file);
    const std::string content{std::istreambuf_iterator<char>(in), {}};
    const JsonLines lines(file, content);
    const auto json = nlohmann::json::parse(content);
    if (!json.is_object())
        throw Error(ErrorCode::Input, "the state file is not a JSON object", "write {\"size\": [640, 360]}", file);
    std::vector<std::string> keys;
    for (const auto& [key, entry] : m_entries)
        if (key != "state") keys.push_back(key);
    for (const auto& [key, value] : json.items()) {
        const std::string where = lines.where("/" + escapedKey(key));
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
            const Error unknown = unknownName("key", key, keys);
            throw Error(ErrorCode::Usage, unknown.message(), unknown.hint(), where);
        }
        Entry& target = *m_entries.at(key);
        if (has(key)) continue;  // the command line wins
        if (target.take == Take::Flag) {
            if (!value.is_boolean()) throw Error(ErrorCode::Usage, "\"" + key + "\" is true or false", "", where);
            target.flag = value.get<bool>();
        } else if (target.take == Take::Many && value.is_array()) {
            for (const auto& element : value) target.values.push_back(stateText(element, key, where));
        } else {
            target.values.push_back(stateText(value, key, where));
        }
    }
}

void addSceneOptions(Options& options) {
    options.add("--size", "WxH: size of the picture in pixels (640x360)");
    options.add("--camera", "NAME: a camera of the scene (its first)");
    options.add("--light", "NAME: one light of the scene (all of them)");
    options.add("--time", "S: time of the scene's animations in seconds (0)");
    options.add("--seed", "N: seed of everything random (1)");
    options.add("--state", "FILE: JSON object with these options as keys; the command line wins");
    options.add("--shader-dir", "DIR: read the shaders from here instead of the built-in ones");
    options.add("--device", "software, or the index of an EGL device (the best, with a fallback)");
    options.add("--ground", "add a floor under a model file", Take::Flag);
    options.add("--eye", "X,Y,Z: the camera's position");
    options.add("--target", "X,Y,Z: the point that the camera looks at");
    options.add("--allow-outside", "let a scene file name models outside its folder", Take::Flag);
}

void addNormalsOption(Options& options) {
    options.add("--normals", "geometry, bump or map (map)");
}

NormalSource normalSource(const Options& options) {
    return NormalSource(options.choice("normals", {"geometry", "bump", "map"}, std::size_t(RenderSettings{}.normals)));
}

void addRenderOptions(Options& options) {
    const auto id = [](Family family) { return "ID[:key=value,...]: as in " + exampleId(family); };
    options.add("--shadow", id(Family::Shadow));
    options.add("--ao", id(Family::Ao));
    options.add("--filter", id(Family::Filter) + "; cleans the occlusion, or the shadow where there is no --ao");
    options.add("--indirect", id(Family::Indirect));
    options.add("--aa", id(Family::Aa));
    options.add("--set", "ID.param=value: a parameter of a technique in use; may be repeated", Take::Many);
    addNormalsOption(options);
    options.add("--shading", "phong, blinn or pbr (blinn)");
    options.add("--composite", "lighting, modulate or overlay[:opacity] (lighting)");
    options.add("--ambient", "constant, ao or off (ao)");
}

SceneOptions sceneOptions(const Options& options) {
    SceneOptions result;
    result.allowOutside = options.flag("allow-outside");
    result.ground = options.flag("ground");
    result.eye = options.point("eye");
    result.target = options.point("target");
    result.cancelled = [] { return interrupted(); };
    return result;
}

RendererOptions rendererOptions(const Options& options) {
    RendererOptions result;
    result.device = options.text("device");
    result.shaderDir = options.text("shader-dir");
    return result;
}

RenderSettings frameSettings(const Options& options) {
    RenderSettings settings;
    if (options.has("size")) {
        const std::vector<std::string> parts = splitAt(options.text("size"), 'x');
        const auto side = [&](const std::string& text) {
            int value = 0;
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
            if (error != std::errc() || end != text.data() + text.size() || value < 1 || value > 16384)
                throw Error(ErrorCode::Usage, "--size: '" + options.text("size") + "' is not a size",
                            "write WxH, as in 640x360, with 1 to 16384 pixels a side");
            return value;
        };
        settings.width = side(parts[0]);
        settings.height = side(parts.size() == 2 ? parts[1] : "");
        requireMemory(settings.width, settings.height);
    }
    settings.camera = options.text("camera");
    settings.light = options.text("light");
    settings.time_s = options.number("time", 0, 0, 1e9);
    settings.seed = std::uint64_t(options.integer("seed", 1, 0, std::numeric_limits<std::int64_t>::max()));
    return settings;
}

RenderSettings renderSettings(const Options& options) {
    RenderSettings settings = frameSettings(options);
    setPipelines(options, settings);
    settings.normals = normalSource(options);
    settings.shading = Shading(options.choice("shading", {"phong", "blinn", "pbr"}, std::size_t(settings.shading)));
    settings.ambient = AmbientTerm(options.choice("ambient", {"constant", "ao", "off"}, std::size_t(settings.ambient)));
    if (options.has("composite")) {
        const std::string value = options.text("composite");
        const std::size_t colon = value.find(':');
        const std::vector<std::string> names{"lighting", "modulate", "overlay"};
        const auto found = std::find(names.begin(), names.end(), value.substr(0, colon));
        if (found == names.end()) throw unknownName("value of --composite", value.substr(0, colon), names);
        settings.composite = Composite(found - names.begin());
        if (colon != std::string::npos) {
            settings.overlayOpacity = parseNumber(value.substr(colon + 1), "--composite");
            if (settings.composite != Composite::Overlay || settings.overlayOpacity < 0 || settings.overlayOpacity > 1)
                throw Error(ErrorCode::Usage, "--composite: '" + value + "' is not a way of composing",
                            "overlay alone takes an opacity, from 0 to 1");
        }
    }
    return settings;
}

std::string exampleId(Family family) {
    std::string id;
    for (const TechniqueInfo& info : techniques()) {
        if (info.family != family) continue;
        // The baseline comes first; any other one says more.
        const bool baseline = id.empty();
        id = info.id;
        if (!baseline) break;
    }
    return id;
}

}  // namespace ombrage::cli
