// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/failure.hpp"

#include <gtest/gtest.h>

#include <Kokkos_Core.hpp>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "src/engine/errors.hpp"

namespace sphk {
namespace {

Failure failure_of(const std::function<void()>& act) {
  try {
    act();
  } catch (...) {
    return current_failure();
  }
  return {ExitCode::done, ""};
}

TEST(Failure, HasTheExitCodeOfItsKind) {
  EXPECT_EQ(failure_of([] { throw InputError("a"); }).exit_code, 2);
  EXPECT_EQ(failure_of([] { throw NumericsError("a"); }).exit_code, 3);
  EXPECT_EQ(failure_of([] { throw std::invalid_argument("no such kernel"); }).exit_code, 2);
  EXPECT_EQ(failure_of([] { std::filesystem::create_directory("/nonexistent/folder/inside"); }).exit_code, 2);
  EXPECT_EQ(failure_of([] { throw std::runtime_error("the device is lost"); }).exit_code, 4);
  EXPECT_EQ(failure_of([] { throw std::runtime_error("the device is lost"); }).message, "the device is lost");
}

// As Kokkos does in every memory space; that it is still so is what the test is for.
TEST(Failure, OfMemoryIsToldWithTheWayToNeedLess) {
  for (const auto& act : std::vector<std::function<void()>>{
           [] { throw std::bad_alloc(); }, [] { Kokkos::Impl::throw_bad_alloc("Host", std::size_t{1} << 60, "x"); }}) {
    const Failure failure = failure_of(act);
    EXPECT_EQ(failure.exit_code, 4);
    EXPECT_TRUE(failure.message.starts_with("out of memory")) << failure.message;
    EXPECT_NE(failure.message.find("-n"), std::string::npos) << failure.message;
    EXPECT_NE(failure.message.find("--dry-run"), std::string::npos) << failure.message;
  }
}

TEST(Failure, IsOneLineOfJson) {
  const std::string line = Failure{2, "no \"such\" file\n\xff"}.json();
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const auto json = nlohmann::json::parse(line);
  EXPECT_EQ(json["exit_code"], 2);
  EXPECT_TRUE(json["error"].get<std::string>().starts_with("no \"such\" file\n"));
}

}  // namespace
}  // namespace sphk
