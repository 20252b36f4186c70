// SPDX-License-Identifier: MIT
#include "gl/shader_source.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <ombrage/error.h>

#include "core/strings.h"

namespace ombrage::gl {

namespace {

constexpr const char* kPreludeName = "<version and defines>";

/// "#name rest" of a line, or an empty name.
struct Directive {
    std::string name;
    std::string rest;
};

Directive parseDirective(const std::string& line) {
    const std::string text = trim(line);
    if (text.empty() || text[0] != '#') return {};
    const std::string body = trim(text.substr(1));
    const auto end = std::find_if_not(body.begin(), body.end(), [](unsigned char c) { return std::isalpha(c); });
    return {std::string(body.begin(), end), trim(std::string(end, body.end()))};
}

/// Follows /* */ over lines, so that directives inside comments stay what they are.
class CommentTracker {
public:
    /// @returns whether the line starts inside a comment
    bool advance(const std::string& line) {
        const bool startsInside = m_inside;
        for (std::size_t i = 0; i < line.size(); ++i) {
            const auto isPair = [&](char a, char b) { return line[i] == a && i + 1 < line.size() && line[i + 1] == b; };
            if (m_inside && isPair('*', '/')) {
                m_inside = false;
                ++i;
            } else if (!m_inside && isPair('/', '*')) {
                m_inside = true;
                ++i;
            } else if (!m_inside && isPair('/', '/')) {
                break;
            }
        }
        return startsInside;
    }

private:
    bool m_inside = false;
};

/// Expansion of one stage.
class Expander {
public:
    Expander(const ShaderFiles& files, const ProgramDesc& desc, Dependencies& dependencies)
        : m_files(files), m_desc(desc), m_dependencies(dependencies) {}

    ExpandedSource run(const std::string& path) {
        include(path, {});
        std::string text = "#version 450 core\n";
        for (const auto& [name, value] : m_desc.defines) text += fmt::format("#define {} {}\n", name, value);
        for (const std::string& extension : m_extensions) text += extension;

        // Everything in front shifts the lines of the body.
        std::vector<SourceLine> lines;
        const auto count = std::count(text.begin(), text.end(), '\n');
        for (int i = 1; i <= int(count); ++i) lines.push_back({kPreludeName, i});
        lines.insert(lines.end(), m_lines.begin(), m_lines.end());
        return {text + m_body, std::move(lines)};
    }

private:
    /// Appends the text of `path`, asked for at `where` ("" for the stage itself).
    void include(const std::string& path, const std::string& where) {
        checkCycle(path, where);
        if (m_always.count(path) != 0) return;
        const std::string text = read(path, where);

        // An include inside #if may never reach the compiler, so a later one must bring the text again; guards keep it
        // from coming twice.
        const bool conditional = !m_conditions.empty() || m_guardDepth > 0;
        const bool guarded = conditional || m_guards.count(path) != 0;
        if (guarded) {
            const auto number = m_guards.emplace(path, m_guards.size() + 1).first->second;
            addLine(fmt::format("#ifndef OMBRAGE_INCLUDED_{}", number), {path, 1});
            addLine(fmt::format("#define OMBRAGE_INCLUDED_{}", number), {path, 1});
            ++m_guardDepth;
        }
        if (!conditional) m_always.insert(path);

        m_stack.push_back(path);
        appendLines(path, text);
        m_stack.pop_back();

        if (guarded) {
            addLine("#endif", {path, 1});
            --m_guardDepth;
        }
    }

    void appendLines(const std::string& path, const std::string& text) {
        const std::size_t outerConditions = m_conditions.size();
        CommentTracker comments;
        int number = 0;
        for (const std::string& line : split(text, '\n')) {
            ++number;
            const Directive directive = comments.advance(line) ? Directive{} : parseDirective(line);
            const std::string where = fmt::format("{}:{}", path, number);
            if (directive.name == "include") {
                include(includePath(directive.rest, where), where);
            } else if (directive.name == "extension") {
                hoistExtension(directive.rest);
            } else if (directive.name == "version") {
                throw Error(ErrorCode::Usage, "a shader source holds a #version line",
                            "Remove it: '#version 450 core' is put in front of every stage.", where);
            } else {
                followCondition(directive, where, outerConditions);
                addLine(line, {path, number});
            }
        }
        if (m_conditions.size() != outerConditions)
            throw Error(ErrorCode::Usage, "a shader source ends inside #if", "Add the missing #endif.", path);
    }

    void addLine(const std::string& line, SourceLine origin) {
        m_body += line + '\n';
        m_lines.push_back(std::move(origin));
    }

    static std::string includePath(const std::string& rest, const std::string& where) {
        const std::size_t end = rest.find('"', 1);
        if (rest.empty() || rest[0] != '"' || end == std::string::npos || end == 1)
            throw Error(ErrorCode::Usage, "malformed #include", "Write #include \"ombrage/frame.glsl\".", where);
        return rest.substr(1, end - 1);
    }

    // Extensions must come before any other code. Those inside #if keep the conditions around them, which can depend on
    // the defines only.
    void hoistExtension(const std::string& rest) {
        std::string text;
        for (const std::string& condition : m_conditions) text += condition;
        text += fmt::format("#extension {}\n", rest);
        for (std::size_t i = 0; i < m_conditions.size(); ++i) text += "#endif\n";
        if (std::find(m_extensions.begin(), m_extensions.end(), text) == m_extensions.end())
            m_extensions.push_back(text);
    }

    void followCondition(const Directive& directive, const std::string& where, std::size_t outerConditions) {
        const std::string text = fmt::format("#{} {}\n", directive.name, directive.rest);
        if (directive.name == "if" || directive.name == "ifdef" || directive.name == "ifndef") {
            m_conditions.push_back(text);
        } else if (directive.name == "elif" || directive.name == "else" || directive.name == "endif") {
            if (m_conditions.size() == outerConditions)
                throw Error(ErrorCode::Usage, "#" + directive.name + " without #if in a shader source", {}, where);
            if (directive.name == "endif")
                m_conditions.pop_back();
            else
                m_conditions.back() += text;
        }
    }

    void checkCycle(const std::string& path, const std::string& where) const {
        const auto first = std::find(m_stack.begin(), m_stack.end(), path);
        if (first == m_stack.end()) return;
        std::vector<std::string> chain(first, m_stack.end());
        chain.push_back(path);
        throw Error(ErrorCode::Usage, "shader sources include each other in a circle: " + join(chain, " -> "),
                    "Move what both need to a file of its own.", where);
    }

    std::string read(const std::string& path, const std::string& where) {
        for (const auto& [name, text] : m_desc.virtuals)
            if (name == path) return text;
        m_dependencies.emplace(path, m_files.stamp(path));
        if (auto text = m_files.find(path)) return *std::move(text);
        std::vector<std::string> known = m_files.paths();
        for (const auto& entry : m_desc.virtuals) known.push_back(entry.first);
        const Error error = unknownName("shader source", path, known);
        throw Error(error.code(), error.message(), error.hint(), where);
    }

    const ShaderFiles& m_files;
    const ProgramDesc& m_desc;
    Dependencies& m_dependencies;
    std::string m_body;
    std::vector<SourceLine> m_lines;  // of m_body
    std::vector<std::string> m_extensions;
    std::vector<std::string> m_stack;             // files being included, outermost first
    std::vector<std::string> m_conditions;        // lines of the #if that are open, one text per level
    std::set<std::string> m_always;               // included outside every #if
    std::map<std::string, std::size_t> m_guards;  // number of the guard of files that were included inside an #if
    int m_guardDepth = 0;
};

// Reads digits at `position` and moves behind them.
bool takeNumber(const std::string& text, std::size_t& position, std::size_t& value) {
    const std::size_t start = position;
    value = 0;
    while (position < text.size() && position - start < 9 && std::isdigit(static_cast<unsigned char>(text[position])))
        value = value * 10 + std::size_t(text[position++] - '0');
    return position > start;
}

bool takeChar(const std::string& text, std::size_t& position, char c) {
    if (position >= text.size() || text[position] != c) return false;
    ++position;
    return true;
}

std::string mapLogLine(const std::string& line, const std::vector<SourceLine>& lines) {
    std::string prefix;
    std::size_t position = 0;
    for (const char* word : {"ERROR: ", "WARNING: "})
        if (line.rfind(word, 0) == 0) prefix = word;
    position = prefix.size();

    // "SOURCE:LINE" with an optional "(COLUMN)", or "SOURCE(LINE)"; there is only one source.
    std::size_t source = 0, number = 0, column = 0;
    if (!takeNumber(line, position, source)) return line;
    if (takeChar(line, position, ':')) {
        if (!takeNumber(line, position, number)) return line;
        if (takeChar(line, position, '(') && !(takeNumber(line, position, column) && takeChar(line, position, ')')))
            return line;
    } else if (!takeChar(line, position, '(') || !takeNumber(line, position, number) ||
               !takeChar(line, position, ')')) {
        return line;
    }
    while (takeChar(line, position, ' ')) continue;
    if (!takeChar(line, position, ':') || number == 0 || number > lines.size()) return line;
    const SourceLine& origin = lines[number - 1];
    return fmt::format("{}:{}: {}{}", origin.path, origin.line, prefix, trim(line.substr(position)));
}

}  // namespace

ExpandedSource expandSource(const ShaderFiles& files, const std::string& path, const ProgramDesc& desc,
                            Dependencies& dependencies) {
    return Expander(files, desc, dependencies).run(path);
}

std::string mapLog(const std::string& log, const std::vector<SourceLine>& lines) {
    std::vector<std::string> mapped;
    for (const std::string& line : split(log, '\n')) {
        // Drivers end the log with a zero byte.
        const std::string text = trim(std::string(line.c_str()));
        if (!text.empty()) mapped.push_back(mapLogLine(text, lines));
    }
    return join(mapped, "\n");
}

}  // namespace ombrage::gl
