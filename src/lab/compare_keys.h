// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <ombrage/compare.h>

#include "lab/plan.h"
#include "lab/result_key.h"

namespace ombrage {

/// Names what a comparison finds on one scene: scene, camera, light, time, size, seed, pipeline, truth, device,
/// program. Of the device's clock nothing is said: which one it trusts may change from call to call.
class CompareKeys {
public:
    /// @param program  programIdentity()
    CompareKeys(const Scene& scene, const CompareRequest& request, const DeviceInfo& device,
                const std::string& program);

    const std::string& sceneHash() const { return m_sceneHash; }

    /// @param kind  nothing: the family has no truth
    ResultKey record(const PlannedRun& planned, std::optional<TruthKind> kind) const;

    /// Of the pictures that the records of one truth share.
    /// @param claimed  of TruthKind::Own: the technique that claims the integral
    ResultKey truth(int light, TruthKind kind, const std::string& claimed) const;

private:
    ResultKey common(const std::string& kind, int light) const;

    const Scene& m_scene;
    const CompareRequest& m_request;
    const DeviceInfo& m_device;
    std::string m_program, m_sceneHash;
};

}  // namespace ombrage
