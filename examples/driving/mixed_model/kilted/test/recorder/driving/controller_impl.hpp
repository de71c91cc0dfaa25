// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef RECORDER__DRIVING__CONTROLLER_IMPL_HPP_
#define RECORDER__DRIVING__CONTROLLER_IMPL_HPP_

#include <chrono>
#include <iostream>
#include <string>

#include "driving/controller_interface.hpp"

namespace driving
{

/// Stands in for the logic of controller: it writes its calls to stdout, for the test to read.
///
/// It refuses nothing, publishes every output, and fulfils every request at once.
class ControllerImpl
{
public:
  explicit ControllerImpl(
    [[maybe_unused]] const ControllerPassthrough & passthrough)
  {
  }

  bool configure(
    [[maybe_unused]] const ControllerConfig & config)
  {
    record("configure");
    record_changes(config);
    return true;
  }

  bool activate()
  {
    updates_ = 0;
    start_ = Clock::now();
    record("activate");
    return true;
  }

  void update(
    [[maybe_unused]] ControllerData & data,
    [[maybe_unused]] const ControllerConfig & config)
  {
    if (++updates_ == 1) {
      record("update");
    }
    if (data.in_target_speed_updated) {
      record("in_target_speed");
    }
    record_changes(config);
  }

  void serve_stop(
    const controller_types::StopService::Request & /* request */,
    controller_types::StopService::Response & /* response */)
  {
    record("serve_stop");
  }

  void deactivate()
  {
    const std::chrono::duration<double> seconds = Clock::now() - start_;
    record("rate " + std::to_string(updates_ / seconds.count()));
    updates_ = 0;
    record("deactivate");
  }

  void cleanup() {record("cleanup");}

private:
  using Clock = std::chrono::steady_clock;

  static void record(const std::string & call)
  {
    std::cout << "called " + call + "\n" << std::flush;
  }

  /// Record the parameters that have changed; at first, those that differ from the spec.
  void record_changes(
    [[maybe_unused]] const ControllerConfig & config)
  {
    if (config.speed_limit != config_.speed_limit) {
      record("config.speed_limit");
    }
    config_ = config;
  }

  ControllerConfig config_;
  int updates_ = 0;
  Clock::time_point start_;
};

}  // namespace driving

#endif  // RECORDER__DRIVING__CONTROLLER_IMPL_HPP_
