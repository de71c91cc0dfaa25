// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef SERVING__CLERK_IMPL_HPP_
#define SERVING__CLERK_IMPL_HPP_

#include "serving/clerk_interface.hpp"

namespace serving
{

/// The logic of clerk.
///
/// Edit this file: clerk_interface.hpp declares what the logic can use.
class ClerkImpl
{
public:
  /// Store the passthrough.
  explicit ClerkImpl(
    const ClerkPassthrough & passthrough);

  /// Prepare the logic; return false to reject the configuration.
  bool configure(
    const ClerkConfig & config);

  /// Start operating; return false to refuse activation.
  bool activate();

  // Service greet
  /// Fill in the response, in a thread of its own.
  void serve_greet(
    const clerk_types::GreetService::Request & request,
    clerk_types::GreetService::Response & response);

  // Service ~/open
  /// Fill in the response, in a thread of its own.
  void serve_open(
    const clerk_types::OpenService::Request & request,
    clerk_types::OpenService::Response & response);

  // Action count
  /// Execute a goal and set its outcome, in a thread of its own; the stub only succeeds.
  void execute_count(
    Goal<clerk_types::CountAction> & goal);

  /// Stop everything that moves; publishers, service calls and goals still work here.
  void deactivate();

  /// Release everything created in configure.
  void cleanup();

private:
  ClerkPassthrough passthrough_;
};

}  // namespace serving

#endif  // SERVING__CLERK_IMPL_HPP_
