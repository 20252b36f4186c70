// SPDX-License-Identifier: MIT
#pragma once

namespace ombrage {

/// The style sheet and the script of the report: plain text that stands inside <style> and <script>.
extern const char* const kReportStyle;
extern const char* const kReportScript;

}  // namespace ombrage
