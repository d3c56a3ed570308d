// SPDX-License-Identifier: MIT
// Mesh files of Debian packages by name.
#include "pipeline/mesh/formats/package_mesh.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "pipeline/mesh/formats/mesh_file.h"
#include "tests/unit/support.h"

namespace inkbench {
namespace {

using testing::HasSubstr;

TEST(PackageMesh, is_the_file_that_the_package_brings) {
  EXPECT_EQ(find_package_mesh("glmark2-data/bunny.obj"), find_rabbit());
}

TEST(PackageMesh, in_an_archive_is_unpacked_once) {
  const TemporaryFolder cache;
  const char* const before = std::getenv("INKBENCH_CACHE");
  const std::string kept = before == nullptr ? "" : before;
  setenv("INKBENCH_CACHE", cache.path().c_str(), 1);
  const std::filesystem::path first = find_package_mesh("libcgal-demo/fandisk.off");
  EXPECT_TRUE(first.string().starts_with(cache.path().string())) << first;
  const auto time = std::filesystem::last_write_time(first.parent_path());
  EXPECT_EQ(find_package_mesh("libcgal-demo/fandisk.off"), first);
  EXPECT_EQ(std::filesystem::last_write_time(first.parent_path()), time);
  EXPECT_EQ(load_mesh_file(first, {}).triangles.size(), 12946U);
  before == nullptr ? unsetenv("INKBENCH_CACHE") : setenv("INKBENCH_CACHE", kept.c_str(), 1);
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
