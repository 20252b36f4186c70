// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/picture_files.h"
#include "report/record_groups.h"

namespace ombrage {

/// A window of a picture where techniques differ.
struct CropWindow {
    int x = 0, y = 0, size = 0;  ///< pixels of the full picture, row 0 at the top
    double spread = 0;           ///< mean standard deviation among the images within it
};

/// Up to `count` windows that do not overlap, the greatest spread first. Windows whose spread is below half a grey
/// level of 8 bits show nothing and are left out. Only the first plane counts.
/// @param images    of one size
/// @param measured  per pixel; what is not measured differs in nothing. Empty: everything is
std::vector<CropWindow> cropsWhereTheyDiffer(const std::vector<Image>& images, const std::vector<bool>& measured,
                                             int count);

/// Of each group, crops of the visibility of every technique and the truth, in the pictures' own pixels.
/// The windows are those where the better half of the techniques differ, as the worse half differs everywhere; where
/// the better half agrees, those of all.
/// @param budget  bytes that the crops of the group may take; it is lessened by what they take, and none are made
///                where it is too small
std::string cropFigures(const PictureFiles& pictures, const RecordGroup& group, std::size_t& budget);

}  // namespace ombrage
