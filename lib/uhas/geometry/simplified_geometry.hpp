// Fewer triangles of nearly the same shape: for pictures.
#pragma once

#include <cstddef>

#include "uhas/geometry/hand_geometry.hpp"

namespace uhas {

/// `geometry` with at most `max_triangles` triangles, by quadric edge collapse. All links are held to one distance from
/// their surface, the least that is enough, so that triangles stay where the shape needs them. Vertices at one place
/// become one. Unchanged in shape when it has no more triangles than that. A link may be left with none when even a
/// coarse shape of it is too much.
HandGeometry simplified_geometry(const HandGeometry& geometry, std::size_t max_triangles);

}  // namespace uhas
