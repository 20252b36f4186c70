// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <ombrage/compare.h>

#include "lab/run_record.h"

namespace ombrage {

/// The sentence that says how the record meets the gate (and so fails the comparison), or nothing. A null metric meets
/// no gate.
std::optional<std::string> metGate(const Gate& gate, const RunRecord& record);

}  // namespace ombrage
