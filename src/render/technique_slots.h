// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "render/technique.h"

namespace ombrage {

/// The technique objects of a renderer: one per place of each pipeline, kept between frames and calls as long as the place
/// asks for the same technique, and told to prepare when what they depend on changed.
class TechniqueSlots {
public:
    /// Techniques of a pipeline at `place` ("shadow of light 0"), ready to render.
    const std::vector<std::unique_ptr<Technique>>& get(const std::string& place, const Pipeline& pipeline, FrameContext& frame);

    /// Everything must be prepared again: the size, the scene or the G-buffer changed.
    void invalidate() { ++m_generation; }

    /// Instances moved: techniques are told so (Technique::sceneMoved) before they render again.
    void sceneMoved() { ++m_moves; }

    /// Destroys every technique that is at no place of `places`.
    void keepOnly(const std::vector<std::string>& places);

    /// Destroys the techniques at `place`; they are made anew when they are asked for again.
    void release(const std::string& place) { m_places.erase(place); }

    void clear() { m_places.clear(); }

    /// What is at `place` must be prepared again before it is used.
    void invalidate(const std::string& place);

    bool has(const std::string& place) const { return m_places.count(place) > 0; }

    std::uint64_t gpuBytes() const;
    std::uint64_t gpuBytes(const std::string& place) const;

private:
    struct Place {
        Pipeline pipeline;
        std::vector<std::unique_ptr<Technique>> techniques;
        std::uint64_t generation = 0, moves = 0;
    };
    std::map<std::string, Place> m_places;
    std::uint64_t m_generation = 1, m_moves = 0;
};

}  // namespace ombrage
