#pragma once
// For tests that use deal.II and PETSc: both run while the tests do.

#include <gtest/gtest.h>

#include <memory>

#include "coarse_balloon.hpp"
#include "turgor/fem/session.hpp"

namespace turgor {

class FemEnvironment : public testing::Environment {
 public:
  void SetUp() override { session_ = std::make_unique<FemSession>(); }
  void TearDown() override { session_.reset(); }

 private:
  std::unique_ptr<FemSession> session_;
};

inline const auto* const fem_environment = testing::AddGlobalTestEnvironment(new FemEnvironment);  // NOLINT: gtest's

}  // namespace turgor
