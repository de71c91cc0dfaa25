// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef IDLER_HARNESS_HPP_
#define IDLER_HARNESS_HPP_

#include <cstdint>
#include <string>
#include <vector>

#include "serving/idler_impl.hpp"

namespace serving
{

/// The logic of idler, fakes in the place of ROS, and a clock.
///
/// Callbacks are called as `harness.impl.serve_NAME(request, response)`.
struct IdlerHarness
{
  IdlerHarness()
  : impl(connected())
  {
  }

  IdlerHarness(const IdlerHarness &) = delete;

  Time time;
  bool stopped = false;
  std::vector<std::string> log;
  IdlerConfig config;
  IdlerPassthrough passthrough;
  IdlerImpl impl;

private:
  const IdlerPassthrough & connected()
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

#endif  // IDLER_HARNESS_HPP_
