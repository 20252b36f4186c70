// SPDX-License-Identifier: MIT
#include "gl/program_cache.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <span>

#include "core/hash.h"

namespace ombrage::gl {

namespace {

constexpr const char* kExtension = ".program";

/// A file: this, the key, the binary.
struct Head {
    char magic[8] = {'O', 'M', 'B', 'P', 'R', 'O', 'G', '1'};
    std::uint64_t keyBytes = 0, binaryBytes = 0;
    std::uint64_t checksum = 0;  ///< of the format, key and binary
    std::uint32_t format = 0, padding = 0;
};
static_assert(sizeof(Head) == 40);

std::uint64_t checksumOf(std::uint32_t format, std::span<const std::byte> content) {
    Hasher hasher;
    hasher.value(format);
    hasher.bytes(content.data(), content.size());
    return hasher.digest();
}

std::string nameOf(const std::string& key) {
    Hasher hasher;
    hasher.text(key);
    return hasher.hex();
}

struct Binary {
    GLenum format;
    std::span<const std::byte> bytes;
};

/// The binary of a file that is whole and of this key.
std::optional<Binary> binaryIn(std::span<const std::byte> file, const std::string& key) {
    Head head;
    const Head expected;
    if (file.size() < sizeof head) return std::nullopt;
    std::memcpy(&head, file.data(), sizeof head);
    const std::span<const std::byte> content = file.subspan(sizeof head);
    if (std::memcmp(head.magic, expected.magic, sizeof head.magic) != 0) return std::nullopt;
    if (head.keyBytes != key.size() || head.keyBytes > content.size()) return std::nullopt;
    if (head.binaryBytes == 0 || head.binaryBytes != content.size() - head.keyBytes) return std::nullopt;
    if (std::memcmp(content.data(), key.data(), key.size()) != 0) return std::nullopt;
    if (checksumOf(head.format, content) != head.checksum) return std::nullopt;
    return Binary{head.format, content.subspan(key.size())};
}

std::string driverText() {
    std::string text;
    for (const GLenum name : {GL_VENDOR, GL_RENDERER, GL_VERSION, GL_SHADING_LANGUAGE_VERSION}) {
        const GLubyte* const value = glGetString(name);
        text += value != nullptr ? reinterpret_cast<const char*>(value) : "";
        text += '\0';
    }
    return text;
}

}  // namespace

bool offersProgramBinaries() {
    GLint formats = 0;
    glGetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
    return formats > 0;
}

ProgramCache::ProgramCache(const std::string& asked, CacheFolder::Bounds bounds) {
    const std::filesystem::path folder = CacheFolder::locate(asked, "programs");
    if (folder.empty() || !offersProgramBinaries()) return;
    m_folder = CacheFolder(folder, kExtension, bounds);
    m_driver = driverText();
}

ProgramCache::~ProgramCache() {
    if (m_stored) m_folder.evict();
}

std::string ProgramCache::keyOf(const std::vector<StageSource>& stages) const {
    std::string key = m_driver;
    for (const StageSource& stage : stages) {
        key += std::to_string(stage.stage) + ' ' + std::to_string(stage.text.size()) + '\0';
        key += stage.text;
    }
    return key;
}

bool ProgramCache::load(GLuint program, const std::vector<StageSource>& stages) const {
    if (!isOn()) return false;
    const std::string key = keyOf(stages);
    const std::optional<CachedBytes> file = m_folder.read(nameOf(key));
    if (!file) return false;
    const std::optional<Binary> binary = binaryIn(file->span(), key);
    if (!binary) return false;
    // A format that the driver does not offer would be a GL error, a host's too: it is asked about first.
    GLint count = 0;
    glGetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &count);
    std::vector<GLint> formats(std::size_t(count), 0);
    if (count > 0) glGetIntegerv(GL_PROGRAM_BINARY_FORMATS, formats.data());
    if (std::find(formats.begin(), formats.end(), GLint(binary->format)) == formats.end()) return false;

    glProgramBinary(program, binary->format, binary->bytes.data(), GLsizei(binary->bytes.size()));
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    return linked == GL_TRUE;
}

void ProgramCache::prepare(GLuint program) const {
    if (isOn()) glProgramParameteri(program, GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
}

void ProgramCache::store(GLuint program, const std::vector<StageSource>& stages) const {
    if (!isOn()) return;
    GLint size = 0;
    glGetProgramiv(program, GL_PROGRAM_BINARY_LENGTH, &size);
    if (size <= 0) return;
    const std::string key = keyOf(stages);
    std::vector<std::byte> file(sizeof(Head) + key.size() + std::size_t(size));
    GLenum format = 0;
    GLsizei written = 0;
    glGetProgramBinary(program, size, &written, &format, file.data() + sizeof(Head) + key.size());
    if (written <= 0) return;
    file.resize(sizeof(Head) + key.size() + std::size_t(written));

    std::memcpy(file.data() + sizeof(Head), key.data(), key.size());
    Head head;
    head.keyBytes = key.size();
    head.binaryBytes = std::uint64_t(written);
    head.format = format;
    head.checksum = checksumOf(format, std::span<const std::byte>(file).subspan(sizeof(Head)));
    std::memcpy(file.data(), &head, sizeof head);
    m_folder.write(nameOf(key), file);
    m_stored = true;
}

}  // namespace ombrage::gl
