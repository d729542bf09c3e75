#include "turgor/fem/checkpoint.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../support/program.hpp"
#include "turgor/base/errors.hpp"

namespace turgor {
namespace {

using test::Folder;

Checkpoint sample(double value) {
  Checkpoint c;
  c.case_hash = 0xFEDC'BA98'7654'3210;
  c.history_rows = 7;
  c.solver_rows = 123;
  c.field_times = {0, 0.5};
  c.step = 123;
  c.time = 0.75;
  c.wall_seconds = 3.5;
  c.times = {0.75, 0.7};
  c.arrays["velocity"] = {value, -0.0, std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()};
  c.arrays["empty"] = {};
  return c;
}

/// Why bytes are refused; empty when they are not.
std::string refusal(const std::string& bytes) {
  try {
    (void)parse_checkpoint(bytes);
    return "";
  } catch (const ComputationFailed& error) {
    return error.what();
  }
}

TEST(Checkpoint, ReadsBackExactly) {
  const Checkpoint written = sample(0.1);
  const Checkpoint read = parse_checkpoint(checkpoint_bytes(written));
  EXPECT_EQ(read.case_hash, written.case_hash);
  EXPECT_EQ(read.history_rows, 7U);
  EXPECT_EQ(read.solver_rows, 123U);
  EXPECT_EQ(read.field_times, written.field_times);
  EXPECT_EQ(read.step, 123);
  EXPECT_EQ(read.time, 0.75);
  EXPECT_EQ(read.wall_seconds, 3.5);
  EXPECT_EQ(read.times, written.times);
  EXPECT_EQ(read.arrays, written.arrays);
  EXPECT_TRUE(std::signbit(read.arrays.at("velocity")[1]));
  EXPECT_EQ(checkpoint_bytes(read), checkpoint_bytes(written));
}

// CRC-64/XZ of "123456789", from the catalogue of CRC algorithms.
TEST(Checkpoint, FingerprintIsTheStandardOne) { EXPECT_EQ(fingerprint("123456789"), 0x995D'C9BB'DF19'39FA); }

TEST(Checkpoint, EveryCutAndEveryWrongByteIsNoticed) {
  const std::string bytes = checkpoint_bytes(sample(0.1));
  for (std::size_t size = 0; size < bytes.size(); ++size) EXPECT_NE(refusal(bytes.substr(0, size)), "") << size;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string wrong = bytes;
    wrong[at] = static_cast<char>(wrong[at] ^ 0x10);
    EXPECT_NE(refusal(wrong), "") << at;
  }
  EXPECT_NE(refusal(std::string(1000, '\0')).find("no checkpoint of turgor"), std::string::npos);
}

TEST(Checkpoint, WhatIsNotFiniteIsNotKept) {
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    try {
      (void)checkpoint_bytes(sample(value));
      FAIL();
    } catch (const ComputationFailed& error) {
      EXPECT_NE(std::string(error.what()).find("\"velocity\""), std::string::npos) << error.what();
    }
  }
}

TEST(CheckpointFiles, KeepTheLastTwo) {
  const Folder folder;
  const CheckpointFiles files(folder.path());
  for (const double value : {1.0, 2.0, 3.0}) files.save(sample(value));
  const auto newest = files.load();
  EXPECT_EQ(newest.checkpoint.arrays.at("velocity")[0], 3);
  EXPECT_EQ(newest.warning, "");
  EXPECT_FALSE(std::filesystem::exists(folder / "checkpoint.bin.part"));

  const std::string bytes = test::contents(folder / "checkpoint.bin");
  test::write(folder / "checkpoint.bin", bytes.substr(0, bytes.size() / 2));
  const auto previous = files.load();
  EXPECT_EQ(previous.checkpoint.arrays.at("velocity")[0], 2);
  EXPECT_NE(previous.warning.find("checkpoint.bin cannot be used: "), std::string::npos) << previous.warning;
  EXPECT_NE(previous.warning.find("going on from checkpoint.previous.bin"), std::string::npos);

  test::write(folder / "checkpoint.previous.bin", "");
  EXPECT_THROW((void)files.load(), InvalidInput);
}

// Killed between its two renames, save() leaves no newest one.
TEST(CheckpointFiles, PreviousOneIsEnough) {
  const Folder folder;
  const CheckpointFiles files(folder.path());
  files.save(sample(1));
  std::filesystem::rename(folder / "checkpoint.bin", folder / "checkpoint.previous.bin");
  EXPECT_EQ(files.load().checkpoint.arrays.at("velocity")[0], 1);
  files.save(sample(2));
  EXPECT_EQ(files.load().checkpoint.arrays.at("velocity")[0], 2);
  files.remove();
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_THROW((void)files.load(), InvalidInput);
}

}  // namespace
}  // namespace turgor
