// SPDX-License-Identifier: MIT
// Mesh files of Debian packages by name.
#include "pipeline/mesh/formats/package_mesh.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <optional>

#include "pipeline/mesh/formats/mesh_file.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

using testing::HasSubstr;

TEST(PackageMesh, is_the_file_that_the_package_brings) {
  EXPECT_EQ(find_package_mesh("glmark2-data/bunny.obj"), find_rabbit());
}

/// Packages are unpacked into a folder of the test's own.
class PackedMesh : public testing::Test {
 protected:
  PackedMesh() { setenv("INKBENCH_CACHE", cache_.path().c_str(), 1); }
  ~PackedMesh() override { kept_ ? setenv("INKBENCH_CACHE", kept_->c_str(), 1) : unsetenv("INKBENCH_CACHE"); }

  const TemporaryFolder cache_;

 private:
  const char* const before_ = std::getenv("INKBENCH_CACHE");
  const std::optional<std::string> kept_ =
      before_ == nullptr ? std::nullopt : std::optional<std::string>(before_);
};

TEST_F(PackedMesh, is_unpacked_once) {
  const std::filesystem::path first = find_package_mesh("libcgal-demo/fandisk.off");
  EXPECT_TRUE(first.string().starts_with(cache_.path().string())) << first;
  const auto time = std::filesystem::last_write_time(first.parent_path());
  EXPECT_EQ(find_package_mesh("libcgal-demo/fandisk.off"), first);
  EXPECT_EQ(std::filesystem::last_write_time(first.parent_path()), time);
  EXPECT_EQ(load_mesh_file(first, {}).triangles.size(), 12946U);
}

TEST_F(PackedMesh, that_is_not_there_and_resembles_none_is_told_with_its_folder) {
  EXPECT_THAT(error_of([] { find_package_mesh("libcgal-demo/of_another_kind.xyz"); }),
              HasSubstr("brings no such file; its meshes lie in " + cache_.path().string()));
}

TEST(PackageMesh, names_what_is_wrong_and_what_would_be_right) {
  EXPECT_THAT(error_of([] { find_package_mesh("libcgal/fandisk.off"); }), HasSubstr("libcgal-demo"));
  EXPECT_THAT(error_of([] { find_package_mesh("glmark2-data/buny.obj"); }),
              HasSubstr("did you mean 'bunny.obj'"));
  EXPECT_THAT(error_of([] { find_package_mesh("glmark2-data"); }), HasSubstr("no such file"));
  EXPECT_THAT(error_of([] { find_package_mesh("glmark2-data/../models/bunny.obj"); }),
              HasSubstr("no such file"));
}

}  // namespace
}  // namespace inkbench
