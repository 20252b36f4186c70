// SPDX-License-Identifier: MIT
#include "lab/compare_keys.h"

#include "core/hash.h"
#include "core/strings.h"
#include "lab/store.h"

namespace ombrage {

namespace {

std::string textOf(const Camera& c) {
    std::string text;
    for (const double value :
         {c.position.x, c.position.y, c.position.z, c.target.x, c.target.y, c.target.z, double(c.up.x), double(c.up.y),
          double(c.up.z), double(c.fovY_rad), double(c.orthoHeight_m.value_or(0.0f))})
        text += formatNumber(value) + " ";
    return text;
}

}  // namespace

CompareKeys::CompareKeys(const Scene& scene, const CompareRequest& request, const DeviceInfo& device,
                         const std::string& program)
    : m_scene(scene), m_request(request), m_device(device), m_program(program), m_sceneHash(contentHash(scene)) {}

ResultKey CompareKeys::common(const std::string& kind, int light) const {
    const RenderSettings& base = m_request.base;
    ResultKey key(kind);
    // The hash leaves out names, the record has them.
    key.add("scene", m_scene.name).add("scene_hash", m_sceneHash);
    key.add("camera", m_scene.cameras[std::size_t(m_scene.cameraIndex(base.camera))].name);
    key.add("light", light < 0 ? "" : m_scene.lights[std::size_t(light)].name).add("light_index", light);
    key.add("width", base.width).add("height", base.height).add("time_s", base.time_s).add("seed", base.seed);
    key.add("normals", int(base.normals)).add("shading", int(base.shading)).add("ambient", int(base.ambient));
    key.add("composite", int(base.composite)).add("overlay_opacity", base.overlayOpacity);
    // Beside what is compared stands what the caller put into the other places.
    for (const Pipeline* place : {&base.shadow, &base.ao, &base.indirect, &base.aa})
        key.add("beside", toString(*place));
    Hasher given;
    for (const auto& [index, image] : base.givenVisibility) {
        given.value(index);
        for (const float value : image.plane(0)) given.value(value);
    }
    key.add("given", given.hex());
    key.add("frames", base.frames).add("warmup_frames", base.warmupFrames).add("timing", int(base.timing));
    key.add("first_frame", base.firstFrame).add("fit_camera", base.fitCamera ? textOf(*base.fitCamera) : "");
    key.add("spp", m_request.truthSamples);
    key.add("renderer", m_device.renderer).add("driver", m_device.version).add("vendor", m_device.vendor);
    return key.add("program", m_program);
}

ResultKey CompareKeys::record(const PlannedRun& planned, std::optional<TruthKind> kind) const {
    return common(kCompareKind, planned.light)
        .add("family", familyName(planned.family))
        .add("pipeline", toString(planned.pipeline))
        .add("truth", kind ? truthKindName(*kind) : "")
        .add("motion", planned.motion ? toString(*planned.motion) : "");
}

ResultKey CompareKeys::truth(int light, TruthKind kind, const std::string& claimed) const {
    return common("truth", light).add("truth", truthKindName(kind)).add("claimed", claimed);
}

}  // namespace ombrage
