// SPDX-License-Identifier: MIT
#include "gl/shader_library.h"

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>

#include <fmt/format.h>
#include <ombrage/error.h>

#include "core/strings.h"
#include "core/trace.h"
#include "gl/object_label.h"
#include "gl/program_cache.h"
#include "gl/shader_source.h"

namespace ombrage::gl {

namespace {

std::string describe(const ProgramDesc& desc) {
    std::vector<std::string> parts;
    for (const ShaderStage& stage : desc.stages) parts.push_back(stage.path);
    std::string text = join(parts, " + ");
    if (desc.defines.empty()) return text;
    parts.clear();
    for (const auto& [name, value] : desc.defines) parts.push_back(name + "=" + value);
    return text + " with " + join(parts, ", ");
}

/// Deletes a shader or program that an exception leaves behind.
struct ShaderName {
    GLuint id;
    explicit ShaderName(GLenum stage) : id(glCreateShader(stage)) {}
    ~ShaderName() { glDeleteShader(id); }
    ShaderName(const ShaderName&) = delete;
    ShaderName& operator=(const ShaderName&) = delete;
};

std::string shaderLog(GLuint shader) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(std::size_t(length), '\0');
    if (length > 0) glGetShaderInfoLog(shader, length, nullptr, log.data());
    return log;
}

std::string programLog(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(std::size_t(length), '\0');
    if (length > 0) glGetProgramInfoLog(program, length, nullptr, log.data());
    return log;
}

constexpr const char* kCompileHint =
    "If the source is unchanged, this is a driver fault: report it with the output of "
    "'ombrage doctor'.";

// "path:line" that a mapped log starts with.
std::string firstPlace(const std::string& log) {
    const std::size_t end = log.find(": ");
    const std::string place = log.substr(0, end);
    return end != std::string::npos && place.find(':') != std::string::npos ? place : std::string();
}

// Attaches one stage. The program keeps the shader alive: Program looks names up in its source.
void attachStage(GLuint program, const ShaderStage& stage, const ExpandedSource& source, const ProgramDesc& desc,
                 bool compile) {
    const ShaderName shader(stage.stage);
    const char* text = source.text.c_str();
    glShaderSource(shader.id, 1, &text, nullptr);
    if (!compile) {
        glAttachShader(program, shader.id);
        return;
    }
    glCompileShader(shader.id);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.id, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_FALSE) {
        const std::string log = mapLog(shaderLog(shader.id), source.lines);
        throw Error(ErrorCode::Environment,
                    fmt::format("{} does not compile ({}):\n{}", stage.path, describe(desc), log), kCompileHint,
                    firstPlace(log));
    }
    glAttachShader(program, shader.id);
}

#ifdef NDEBUG
constexpr bool kKeepsSources = false;
#else
constexpr bool kKeepsSources = true;
#endif

// From the cache: nothing is compiled, and the sources are attached only where assertions look names up in them.
std::optional<Program> fromCache(const ProgramCache* cache, const ProgramDesc& desc,
                                 const std::vector<ExpandedSource>& expanded, const std::vector<StageSource>& stages) {
    if (cache == nullptr || !cache->isOn()) return std::nullopt;
    const TraceScope trace("look in the program cache", isTracing() ? describe(desc) : std::string());
    Program program(glCreateProgram());
    if (!cache->load(program.id(), stages)) return std::nullopt;
    for (std::size_t i = 0; kKeepsSources && i < stages.size(); ++i)
        attachStage(program.id(), desc.stages[i], expanded[i], desc, false);
    labelObject(GL_PROGRAM, program.id(), describe(desc).c_str());
    return program;
}

Program build(const ShaderFiles& files, const ProgramCache* cache, const ProgramDesc& desc,
              Dependencies& dependencies) {
    std::vector<ExpandedSource> expanded;
    std::vector<StageSource> stages;
    for (const ShaderStage& stage : desc.stages) {
        expanded.push_back(expandSource(files, stage.path, desc, dependencies));
        stages.push_back({stage.stage, expanded.back().text});
    }
    if (std::optional<Program> kept = fromCache(cache, desc, expanded, stages)) return std::move(*kept);

    const TraceScope trace("compile shaders", isTracing() ? describe(desc) : std::string());
    Program program(glCreateProgram());
    for (std::size_t i = 0; i < desc.stages.size(); ++i)
        attachStage(program.id(), desc.stages[i], expanded[i], desc, true);
    if (cache != nullptr) cache->prepare(program.id());
    glLinkProgram(program.id());
    GLint linked = GL_FALSE;
    glGetProgramiv(program.id(), GL_LINK_STATUS, &linked);
    if (linked == GL_FALSE)
        throw Error(ErrorCode::Environment,
                    fmt::format("{} does not link:\n{}", describe(desc), mapLog(programLog(program.id()), {})),
                    kCompileHint);
    labelObject(GL_PROGRAM, program.id(), describe(desc).c_str());
    if (cache != nullptr) cache->store(program.id(), stages);
    return program;
}

auto key(const ShaderStage& stage) {
    return std::tie(stage.stage, stage.path);
}

}  // namespace

bool ProgramDesc::operator<(const ProgramDesc& other) const {
    const auto isStageLess = [](const ShaderStage& a, const ShaderStage& b) { return key(a) < key(b); };
    const auto compare = [&](const ProgramDesc& a, const ProgramDesc& b) {
        return std::lexicographical_compare(a.stages.begin(), a.stages.end(), b.stages.begin(), b.stages.end(),
                                            isStageLess);
    };
    if (compare(*this, other)) return true;
    if (compare(other, *this)) return false;
    return std::tie(defines, virtuals) < std::tie(other.defines, other.virtuals);
}

struct ShaderLibrary::Impl {
    struct Entry {
        Program program;
        Dependencies dependencies;
    };

    Impl(std::string directory, const ProgramCache* kept) : files(std::move(directory)), cache(kept) {}

    void remember(const Dependencies& dependencies) { stamps.insert(dependencies.begin(), dependencies.end()); }

    ShaderFiles files;
    const ProgramCache* cache;
    std::map<ProgramDesc, Entry> programs;
    Dependencies stamps;
};

ShaderLibrary::ShaderLibrary(std::string directory, const ProgramCache* cache)
    : m_impl(std::make_unique<Impl>(std::move(directory), cache)) {}

ShaderLibrary::~ShaderLibrary() = default;

const Program& ShaderLibrary::program(const ProgramDesc& desc) {
    const auto known = m_impl->programs.find(desc);
    if (known != m_impl->programs.end()) return known->second.program;
    Impl::Entry entry;
    entry.program = build(m_impl->files, m_impl->cache, desc, entry.dependencies);
    m_impl->remember(entry.dependencies);
    return m_impl->programs.emplace(desc, std::move(entry)).first->second.program;
}

std::vector<std::string> ShaderLibrary::reload() {
    std::set<std::string> changed;
    for (auto& [path, stamp] : m_impl->stamps) {
        const std::uint64_t now = m_impl->files.stamp(path);
        if (now != stamp) changed.insert(path);
        stamp = now;
    }
    if (changed.empty()) return {};

    std::vector<std::string> errors;
    for (auto& [desc, entry] : m_impl->programs) {
        const auto isChanged = [&](const auto& dependency) { return changed.count(dependency.first) != 0; };
        if (std::none_of(entry.dependencies.begin(), entry.dependencies.end(), isChanged)) continue;
        Dependencies dependencies;
        try {
            entry.program = build(m_impl->files, m_impl->cache, desc, dependencies);
            entry.dependencies = dependencies;
        } catch (const Error& error) {
            // Keep the old program. Its old sources still count, and so do those that the failed one reached for.
            errors.push_back(error.what());
            entry.dependencies.insert(dependencies.begin(), dependencies.end());
        }
        m_impl->remember(entry.dependencies);
    }
    return errors;
}

std::string ShaderLibrary::expand(const std::string& path, const ProgramDesc& desc) const {
    Dependencies dependencies;
    return expandSource(m_impl->files, path, desc, dependencies).text;
}

std::vector<std::string> ShaderLibrary::embeddedPaths() {
    std::vector<std::string> paths;
    for (std::size_t i = 0; i < kEmbeddedShaderCount; ++i) paths.emplace_back(kEmbeddedShaders[i].path);
    return paths;
}

}  // namespace ombrage::gl
