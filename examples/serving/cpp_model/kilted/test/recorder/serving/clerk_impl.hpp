// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef RECORDER__SERVING__CLERK_IMPL_HPP_
#define RECORDER__SERVING__CLERK_IMPL_HPP_

#include <iostream>
#include <string>

#include "serving/clerk_interface.hpp"

namespace serving
{

/// Stands in for the logic of clerk: it writes its calls to stdout, for the test to read.
///
/// It refuses nothing, publishes every output, and fulfils every request at once.
class ClerkImpl
{
public:
  explicit ClerkImpl(
    [[maybe_unused]] const ClerkPassthrough & passthrough)
  {
  }

  bool configure(
    [[maybe_unused]] const ClerkConfig & config)
  {
    record("configure");
    record_changes(config);
    return true;
  }

  bool activate()
  {
    record("activate");
    return true;
  }

  void serve_greet(
    const clerk_types::GreetService::Request & /* request */,
    clerk_types::GreetService::Response & /* response */)
  {
    record("serve_greet");
  }

  void serve_open(
    const clerk_types::OpenService::Request & /* request */,
    clerk_types::OpenService::Response & /* response */)
  {
    record("serve_open");
  }

  void execute_count(
    Goal<clerk_types::CountAction> & goal)
  {
    record("execute_count");
    goal.succeed();
  }

  void deactivate()
  {
    record("deactivate");
  }

  void cleanup() {record("cleanup");}

private:
  static void record(const std::string & call)
  {
    std::cout << "called " + call + "\n" << std::flush;
  }

  /// Record the parameters that have changed; at first, those that differ from the spec.
  void record_changes(
    [[maybe_unused]] const ClerkConfig & config)
  {
    if (config.greeting != config_.greeting) {
      record("config.greeting");
    }
    if (config.patience != config_.patience) {
      record("config.patience");
    }
    config_ = config;
  }

  ClerkConfig config_;
};

}  // namespace serving

#endif  // RECORDER__SERVING__CLERK_IMPL_HPP_
