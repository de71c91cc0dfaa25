// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef SUPPORT__RECORDER__ALL_KINDS__OBSERVER_IMPL_HPP_
#define SUPPORT__RECORDER__ALL_KINDS__OBSERVER_IMPL_HPP_

#include <chrono>
#include <iostream>
#include <string>

#include "all_kinds/observer_interface.hpp"

namespace all_kinds
{

/// Stands in for the logic of observer: it writes its calls to stdout, for the test to read.
///
/// It refuses nothing, publishes every output, and fulfils every request at once.
class ObserverImpl
{
public:
  explicit ObserverImpl(
    [[maybe_unused]] const ObserverPassthrough & passthrough)
  {
  }

  bool configure(
    [[maybe_unused]] const ObserverConfig & config)
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
    [[maybe_unused]] ObserverData & data,
    [[maybe_unused]] const ObserverConfig & config)
  {
    if (++updates_ == 1) {
      record("update");
    }
    if (data.in_status_updated) {
      record("in_status");
    }
    record_changes(config);
  }

  void deactivate()
  {
    const std::chrono::duration<double> seconds = Clock::now() - start_;
    record("rate " + std::to_string(updates_ / seconds.count()));
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
    const ObserverConfig & config)
  {
    if (config.limit != config_.limit) {
      record("config.limit");
    }
    config_ = config;
  }

  ObserverConfig config_;
  int updates_ = 0;
  Clock::time_point start_;
};

}  // namespace all_kinds

#endif  // SUPPORT__RECORDER__ALL_KINDS__OBSERVER_IMPL_HPP_
