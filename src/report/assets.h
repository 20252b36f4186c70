// SPDX-License-Identifier: MIT
#pragma once

namespace ombrage {

/// The style sheet and the script of the report: plain text that stands inside <style> and <script>. The build makes
/// them of the files in src/report/assets.
extern const char* const kReportStyle;
extern const char* const kReportScript;

}  // namespace ombrage
