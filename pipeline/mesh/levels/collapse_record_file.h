// SPDX-License-Identifier: MIT
// Collapse records on disk, by the content of their mesh. In: a mesh. Out: its record, read where an earlier
// run left it, else made and left for the next.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "pipeline/base/key.h"
#include "pipeline/base/stop.h"
#include "pipeline/mesh/levels/collapse_record.h"
#include "pipeline/mesh/mesh.h"

namespace inkbench {

/// Names what a record depends on: the mesh's positions and triangles, and the way of decimating.
Key collapse_record_key(const Mesh& mesh);

/// The record as the bytes of a cache file (of this machine's byte order, which the file names).
std::string write_collapse_record(const CollapseRecord& record, const Key& key);

/// The record back from `bytes`, or nothing where they are not the whole and unharmed record of this mesh,
/// whatever they are: checked are the format, the key, each size before it is used, a hash of the content,
/// and `is_record_of`.
std::optional<CollapseRecord> read_collapse_record(std::string_view bytes, const Mesh& mesh, const Key& key);

/// The file of a key in `cache_folder()`.
std::filesystem::path collapse_record_path(const Key& key);

/// The mesh's record, from its file or by `record_collapses`; then it is written, all or nothing, so that
/// processes may race. A damaged file is made anew; a folder that cannot be written to costs only the time
/// next time. Throws `Stopped` once `stop` says so; no file is left then.
CollapseRecord cached_collapse_record(const Mesh& mesh, const StopAsked& stop = {});

}  // namespace inkbench
