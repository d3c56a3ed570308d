// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <memory>
#include <set>

#include "app/commands.h"
#include "app/hear_signals.h"
#include "app/number_option.h"
#include "app/terminal.h"
#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/log.h"
#include "pipeline/base/text.h"
#include "pipeline/mesh/formats/mesh_file.h"
#include "pipeline/mesh/formats/mesh_write.h"
#include "pipeline/mesh/levels/collapse_record_file.h"
#include "pipeline/mesh/levels/level_normals.h"
#include "pipeline/mesh/levels/model_mesh.h"
#include "pipeline/mesh/weld.h"

namespace inkbench {
namespace {

struct DecimateOptions {
  std::string mesh, faces, out, format = "ply", normals = "smooth";
  float weld = 0.0F;
};

size_t parse_face_count(const std::string& text) {
  size_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  const bool is_count = error == std::errc() && end == text.data() + text.size() && count > 0;
  if (!is_count) throw input_error("--faces", "bad face count '" + text + "'", "a whole number, 1 or more");
  return count;
}

/// In the order given.
std::vector<size_t> parse_face_counts(const std::string& list) {
  std::vector<size_t> counts;
  std::set<size_t> seen;
  for (const std::string& item : split(list, ',')) {
    counts.push_back(parse_face_count(std::string(trim(item))));
    if (!seen.insert(counts.back()).second)
      throw input_error("--faces", std::to_string(counts.back()) + " stands there twice", "each count once");
  }
  return counts;
}

LevelNormals parse_normals(const std::string& name) {
  size_t i = 0;
  while (ChoiceNames<LevelNormals>::names[i] != name) ++i;  // CLI11 lets only these pass
  return static_cast<LevelNormals>(i);
}

/// What became of the asked count, for people.
std::string remark(size_t asked, size_t reached, size_t loaded) {
  if (asked > loaded) return " (the mesh has no more: as loaded)";
  if (reached > asked) return " (decimation ends there)";
  return "";
}

void decimate(const DecimateOptions& options) {
  const std::vector<size_t> counts = parse_face_counts(options.faces);
  // Smooth where the file gives no normals: levels have as many vertices as points.
  Mesh mesh = load_mesh_file(mesh_path(options.mesh), {.smooth_below_deg = 180.0});
  if (options.weld > 0.0F) mesh = weld(mesh, options.weld).mesh;
  for (const std::string& note : mesh.notes) log_note(options.mesh + ": " + note);
  const CollapseRecord record = cached_collapse_record(mesh);
  const std::string stem = options.mesh == kRabbit ? options.mesh : fs::path(options.mesh).stem().string();
  const LevelNormals normals = parse_normals(options.normals);
  make_folder(options.out);
  for (const size_t asked : counts) {
    const Mesh level = level_with_normals(mesh, record, asked, normals);
    const size_t reached = level.triangles.size();
    const fs::path path = fs::path(options.out) / fmt::format("{}_{}.{}", stem, asked, options.format);
    write_mesh_file(level, path, options.format == "obj" ? MeshFileFormat::obj : MeshFileFormat::ply,
                    fmt::format("inkbench decimate: {} of {} faces", reached, mesh.triangles.size()));
    print_out("{} asked, {} reached{}: {}\n", asked, reached, remark(asked, reached, mesh.triangles.size()),
              path.string());
  }
}

}  // namespace

void add_decimate_command(CLI::App& app) {
  auto options = std::make_shared<DecimateOptions>();
  CLI::App* command =
      app.add_subcommand("decimate", "Write a mesh with fewer faces, at one or more face counts");
  command->add_option("MESH", options->mesh, "Mesh file (OBJ, PLY, OFF, STL, glTF, FBX and more), or rabbit")
      ->required();
  command
      ->add_option("--faces", options->faces, "Face counts, comma-separated; each level has at most as many")
      ->required();
  command->add_option("--out", options->out, "Folder for MESH_FACES.ply, made if missing")->required();
  command->add_option("--format", options->format, "ply (binary) or obj")
      ->check(CLI::IsMember({"ply", "obj"}));
  command
      ->add_option("--normals", options->normals,
                   "smooth, flat, or nearest: from the full mesh's surface, as baked ones")
      ->check(CLI::IsMember({"smooth", "flat", "nearest"}));
  command
      ->add_option("--weld", options->weld,
                   "Merge vertices at most this far apart first, in the mesh's units; equal ones need none")
      ->check(finite_not_negative());
  command->footer("Example:\n  inkbench decimate rabbit --faces 20000,5000,1000 --out out/levels");
  command->callback([options] {
    hear_signals();
    decimate(*options);
  });
}

}  // namespace inkbench
