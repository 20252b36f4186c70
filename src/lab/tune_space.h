// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <ombrage/technique.h>

#include "lab/tune_search.h"

namespace ombrage::tuning {

/// The parameters of a pipeline that have a tuning range, are switches or have choices, as dimensions of a search.
class Space {
public:
    /// @param keep "key" or "ID.key": what stays as it is
    /// @throws Error(Usage) for an unknown one, and where nothing is left to vary.
    Space(const Pipeline& start, const std::vector<std::string>& keep);

    const std::vector<Dimension>& dimensions() const { return m_dimensions; }
    /// "ID.key" of each dimension.
    std::vector<std::string> names() const;

    /// The pipeline's own values, which may lie outside of the tuning ranges.
    Point start() const;
    /// The same pipeline with the defaults of what may vary.
    Point defaults() const;

    /// The pipeline with these values; checked.
    Pipeline at(const Point& point) const;

private:
    struct Place {
        std::size_t element = 0;
        ParamInfo info;
    };
    Point valuesOf(const Pipeline& pipeline) const;
    Pipeline m_start;
    std::vector<Dimension> m_dimensions;
    std::vector<Place> m_places;
};

}  // namespace ombrage::tuning
