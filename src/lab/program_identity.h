// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace ombrage {

/// What measures, for the keys of stored results: the version, a digest of all code and shaders that measure and of the
/// compiler that built them, and the content of the shader folder where one is in use. Two programs of one identity
/// give the same results; a program that differs in a single line below the report does not take over any.
/// @param shaderDir as RendererOptions::shaderDir
std::string programIdentity(const std::string& shaderDir);

}  // namespace ombrage
