// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef CLERK_HARNESS_HPP_
#define CLERK_HARNESS_HPP_

#include <cstdint>
#include <string>
#include <vector>

#include "./fakes.hpp"
#include "serving/clerk_impl.hpp"

namespace serving
{

/// The logic of clerk, fakes in the place of ROS, and a clock.
///
/// Callbacks are called as `harness.impl.serve_NAME(request, response)`.
struct ClerkHarness
{
  ClerkHarness()
  : impl(connected())
  {
  }

  ClerkHarness(const ClerkHarness &) = delete;

  Time time;
  bool stopped = false;
  std::vector<std::string> log;
  ClerkConfig config;
  ClerkPassthrough passthrough;
  ClerkImpl impl;

private:
  const ClerkPassthrough & connected()
  {
    passthrough.log = Logger(
      [this](Logger::Level, const std::string & text, const Logger::Place &) {
        log.push_back(text);
      });
    passthrough.now = [this] {return time;};
    passthrough.sleep = [this](double seconds) {
        if (!stopped) {
          time = Time(time.nanoseconds() + static_cast<std::int64_t>(seconds * 1e9));
        }
        return !stopped;
      };
    return passthrough;
  }
};

}  // namespace serving

#endif  // CLERK_HARNESS_HPP_
