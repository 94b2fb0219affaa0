#pragma once

#include "map/map_header.h"
#include "map/map_records.h"

namespace glide {

// What a record of a map file may hold, as far as it can be said without the others. Each returns
// what is wrong.

MapFault checkKeyframe(const KeyframeRecord& record);
MapFault checkRetired(const RetiredRecord& record);
MapFault checkLandmark(const LandmarkRecord& record);
/// Also that the landmark, if any, is in the file.
MapFault checkFeature(const FeatureRecord& record, const MapHeader& header);
MapFault checkPatch(const PatchRecord& record);

}  // namespace glide
