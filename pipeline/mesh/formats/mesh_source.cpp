// SPDX-License-Identifier: MIT
#include "pipeline/mesh/formats/mesh_source.h"

#include <cassert>

namespace inkbench {

MeshSource prepare_mesh(MeshFormat format, const std::string& name, std::string_view raw) {
  switch (format) {
    case MeshFormat::obj:
      return prepare_obj(name, raw);
    case MeshFormat::ply:
      return prepare_ply(name, raw);
    case MeshFormat::off:
      return prepare_off(name, raw);
    case MeshFormat::stl:
      return prepare_stl(name, raw);
  }
  assert(false && "unknown mesh format");
  return {};
}

}  // namespace inkbench
