// SPDX-License-Identifier: MIT
// One OpenGL context for the whole run, made before the first test and given back after the last.
#include <gtest/gtest.h>

#include <memory>

#include "pipeline/gl/context.h"

namespace inkbench {
namespace {

class GlEnvironment : public testing::Environment {
 public:
  void SetUp() override { context_ = std::make_unique<HeadlessContext>(); }
  void TearDown() override { context_.reset(); }

 private:
  std::unique_ptr<HeadlessContext> context_;
};

const testing::Environment* const kEnvironment = testing::AddGlobalTestEnvironment(new GlEnvironment);

}  // namespace
}  // namespace inkbench
