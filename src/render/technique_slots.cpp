// SPDX-License-Identifier: MIT
#include "render/technique_slots.h"

#include <algorithm>

#include "core/trace.h"
#include "render/frame_context.h"

namespace ombrage {

const std::vector<std::unique_ptr<Technique>>& TechniqueSlots::get(const std::string& place, const Pipeline& pipeline,
                                                                   FrameContext& frame) {
    Place& slot = m_places[place];
    if (slot.techniques.empty() || slot.pipeline != pipeline) {
        // Made whole or not at all: a wrong parameter leaves the place empty, not half filled.
        slot.techniques.clear();
        std::vector<std::unique_ptr<Technique>> made;
        for (const TechniqueSpec& spec : pipeline) made.push_back(createTechnique(spec));
        slot.pipeline = pipeline;
        slot.techniques = std::move(made);
        slot.generation = 0;
    }
    if (slot.generation != m_generation) {
        for (const auto& technique : slot.techniques) {
            const TraceScope trace("prepare", technique->entry().id());
            technique->prepare(frame);
        }
        slot.generation = m_generation;
        slot.moves = m_moves;
    }
    if (slot.moves != m_moves) {
        for (const auto& technique : slot.techniques) {
            const TraceScope trace("follow the scene", technique->entry().id());
            technique->sceneMoved(frame);
        }
        slot.moves = m_moves;
    }
    return slot.techniques;
}

void TechniqueSlots::keepOnly(const std::vector<std::string>& places) {
    for (auto place = m_places.begin(); place != m_places.end();) {
        const bool kept = std::find(places.begin(), places.end(), place->first) != places.end();
        place = kept ? std::next(place) : m_places.erase(place);
    }
}

void TechniqueSlots::invalidate(const std::string& place) {
    if (const auto found = m_places.find(place); found != m_places.end()) found->second.generation = 0;
}

std::uint64_t TechniqueSlots::gpuBytes() const {
    std::uint64_t bytes = 0;
    for (const auto& [name, place] : m_places) bytes += gpuBytes(name);
    return bytes;
}

std::uint64_t TechniqueSlots::gpuBytes(const std::string& place) const {
    const auto found = m_places.find(place);
    if (found == m_places.end()) return 0;
    std::uint64_t bytes = 0;
    for (const auto& technique : found->second.techniques) bytes += technique->gpuBytes();
    return bytes;
}

}  // namespace ombrage
