// SPDX-License-Identifier: MIT
// Readers of mesh files, one a format. In: a file's name, for messages, and its whole content. Out: a polygon
// soup, checked while it is read: room is made for no more than the bytes at hand can hold, and what the file
// announces is compared with what is there. Corners may still name points that do not exist.
#pragma once

#include <string>
#include <string_view>

#include "pipeline/mesh/polygon_soup.h"

namespace inkbench {

// Errors (input) of all: not of that format, truncated, unreadable; with the line where there is one.

/// Wavefront OBJ: points, normals by corner, faces, smoothing groups; lines joined by a backslash.
PolygonSoup read_obj(const std::string& name, std::string_view raw);

/// PLY, text or binary: points (numbers of any type), their normals, faces and triangle strips.
PolygonSoup read_ply(const std::string& name, std::string_view raw);

/// Object File Format, the text kind with points of 3 dimensions: points, their normals, faces.
PolygonSoup read_off(const std::string& name, std::string_view raw);

/// STL, text or binary. Facet normals are left out, since they repeat the corners' order.
PolygonSoup read_stl(const std::string& name, std::string_view raw);

}  // namespace inkbench
