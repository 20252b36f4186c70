// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <ombrage/reference.h>

namespace ombrage {

/// The error e = v - v* of one frame at the points of the first one.
struct ErrorFrame {
    std::vector<float> error;
    std::vector<bool> valid;  ///< whether the point is seen and measured in this frame
};

/// What changed from frame to frame: abs(e_t - e_(t-1)) over all pairs of consecutive frames and the points that are
/// valid in both. A change that is not a number counts as 1.
struct Flicker {
    std::optional<double> mean, p99;      ///< nearest rank; nothing where no point is valid in two frames
    std::optional<std::size_t> patch_px;  ///< points of the largest patch of one pair (largestPatch)
    std::vector<float> largest;           ///< per point, the largest change
    std::vector<bool> seen;               ///< per point, whether it is in any pair
};

/// Takes the frames of a script one by one.
class FlickerMeter {
public:
    /// @param tolerance  changes above it make patches
    FlickerMeter(int width, int height, double tolerance);

    /// @throws Error(Usage) for a frame of another size.
    void add(ErrorFrame frame);
    Flicker result() const;

private:
    const int m_width, m_height;
    const double m_tolerance;
    std::optional<ErrorFrame> m_last;
    std::vector<float> m_changes;  ///< that are not 0; the others are counted
    std::size_t m_unchanged = 0, m_patch = 0;
    Flicker m_points;  ///< its arrays
};

/// Points of the largest set of marked ones that hang together by their edges and corners; 0 where none is marked.
std::size_t largestPatch(const std::vector<bool>& marked, int width, int height);

/// How long an answer takes to follow a jump.
struct Lag {
    int frames = 0;       ///< 0: right in the frame of the jump itself
    bool settled = true;  ///< false: not even in the last frame, `frames` is the number of all of them
};

/// The least number of frames after which, to the end, at most one in a hundred points is more than the tolerance off.
/// @param answers  per frame from that of the jump on, the visibility at the points that the jump concerns
/// @param settled  the same of an answer for which the jump had always happened
/// Nothing where there is no point. @throws Error(Usage) for frames that do not match.
std::optional<Lag> lagOf(const std::vector<std::vector<float>>& answers, const std::vector<std::vector<float>>& settled,
                         double tolerance);

/// For every receiver of one picture the pixel of another that shows the same triangle nearest to where the receiver's
/// point stands in it; -1 where none of the nine pixels around does. Pixel (0,0) has its centre at (0.5, 0.5).
/// @param places_px  of the receivers' points in the other picture; not finite behind the camera
std::vector<std::ptrdiff_t> nearestOfTriangle(const Receivers& receivers, std::span<const glm::dvec2> places_px,
                                              std::span<const std::uint32_t> instance,
                                              std::span<const std::uint32_t> triangle);

}  // namespace ombrage
